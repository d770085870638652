/* The runs of a session, by their roles. A run may have several roles, which are counted (HouseRun.roles): it is
 * released when it loses the last one.
 *
 *     role      job     requested                                    dropped
 *     shown     run     -                                            when another run is displayed
 *     latest    run     after each edit, in brief; then in full      when its answer is displayed or no longer needed
 *                       if a person cannot leave
 *     older     run     the latest, when another was requested       when the latest is displayed, or after GRACE
 *     mixed     mixed   after an edit while people move, if edits    by the next edit
 *                       apply on the way
 *     early     run     - the latest, whose plan is drawn already    with its last other role
 *     before    run     - saved for comparison                       by clear, or when another run is saved
 *     rival     rival   while it is chosen as the ghost              when another run is displayed or needed
 *     routes    routes  while the widths are displayed               when another run is displayed or needed
 *     grades    grades  when all who are displayed are out           by the next edit or another displayed run
 *     crew      crew    while the drivers are displayed              by the next edit or another displayed run
 *     shakes    shakes  when the outcome of an earthquake is         by another house, route or driving model, but not
 *                       displayed                                    by another earthquake of the same house */
#pragma once

#include "laboratory/house/session_state.h"

/* Events that take a run from its role: bits. */
enum { RUNS_EDIT = 1, RUNS_ANSWER = 2, RUNS_DISPLAY = 4, RUNS_CLOSE = 8 };

/* Gives a role to a run (NULL: to none), and takes it from the run that had it. */
void house_runs_set(HouseSession *session, HouseRunRole role, HouseRun *run);

/* Keep the run valid until house_runs_release, even if it loses all roles. */
void house_runs_retain(HouseRun *run);
void house_runs_release(HouseSession *session, HouseRun *run);

/* Takes from their runs the roles that end with an event. */
void house_runs_drop(HouseSession *session, unsigned event);

/* Requests the run of a role with the present draft (mixed: with the whole history); `brief`: without the slow
 * search for the reasons why a person cannot leave. The role must be vacant. */
void house_runs_ask(HouseSession *session, HouseRunRole role, bool brief);

/* True if the run of this role is over and the session has noticed its end. */
bool house_runs_is_over(const HouseSession *session, HouseRunRole role);

/* True if the answer has a grade: those who do not get out are told why; a crowd, and a plan that changed on the way,
 * have none. */
bool house_runs_has_grade(const HouseSession *session);

/* True if the role (rival, routes, grades, crew, shakes) is wanted in the present state of the session. */
bool house_runs_wants(const HouseSession *session, HouseRunRole role);

/* Returns the run that is displayed as a ghost; none: without an observation. */
Before house_runs_compared(const HouseSession *session);

/* Returns the driving model that the displayed house does not have. */
int house_runs_other_driving(const HouseSession *session);

/* Returns a number that is the same for runs of the same plans, route, driving model and seed only; NULL: 0. */
uint64_t house_runs_identity(const HouseRun *run);

/* True from a change until its run is displayed: the displayed run is of an older plan. */
bool house_runs_is_working(const HouseSession *session);

/* True if the run has the present route and driving model. */
bool house_runs_is_wished(const HouseSession *session, const HouseRun *run);

/* True if the run is the result of these epochs (count) with the present route and driving model. */
bool house_runs_is_of(const HouseSession *session, const HouseRun *run, const HouseEpoch *epochs, size_t count);

/* True if the only run in progress searches for the reasons why a person cannot leave: the answer is known. */
bool house_runs_seeks_reasons(const HouseSession *session);

/* Returns the time up to which the record is final, s. */
double house_runs_reach(const HouseSession *session);
