/* The runs that a session has, by their roles. A run may have several roles, which are counted (HouseRun.roles): it is
 * released when the last one is taken from it.
 *
 *     role      job     asked for                                    dropped
 *     shown     run     -                                            when another run is displayed
 *     latest    run     after each edit, in brief; again in full     when its answer is displayed or no longer needed
 *                       when somebody cannot leave
 *     older     run     it was the latest when another was asked     when the latest is displayed, or after GRACE
 *     mixed     mixed   after an edit while people move              by the next edit
 *     clean     run     - the answer while a mixed run is shown      when a run of one plan is displayed
 *     early     run     - the latest, whose plan is drawn already    with its last other role
 *     before    run     - saved for comparison                       by clear, or when another run is saved
 *     rival     rival   while it is chosen as the ghost              when another run is displayed or needed
 *     routes    ways    while the widths are displayed               when another run is displayed or needed */
#pragma once

#include "laboratory/house/session_parts.h"

/* Events that take a run from its role: bits. */
enum { RUNS_EDIT = 1, RUNS_ANSWER = 2, RUNS_DISPLAY = 4, RUNS_CLOSE = 8 };

/* Gives a role to a run (NULL: to none), and takes it from the run that had it. */
void house_runs_set(HouseSession *session, HouseRunRole role, HouseRun *run);

/* The run stays good until house_runs_release, whatever roles it loses. */
void house_runs_retain(HouseRun *run);
void house_runs_release(HouseSession *session, HouseRun *run);

/* Takes the roles that end with an event from their runs. */
void house_runs_drop(HouseSession *session, unsigned event);

/* Asks for the run of a role with the draft as it is (mixed: with the whole history); `brief`: without the reasons why
 * somebody cannot leave, which take long. The role is vacant. */
void house_runs_ask(HouseSession *session, HouseRunRole role, bool brief);

/* True if the run of this role is over and that was noticed. */
bool house_runs_is_over(const HouseSession *session, HouseRunRole role);

/* The role (rival, routes) is wanted as the session is now. */
bool house_runs_wants(const HouseSession *session, HouseRunRole role);

/* The run that is displayed as a ghost; none: without an observation. */
Before house_runs_compared(const HouseSession *session);

/* The driving model that the displayed house does not have. */
int house_runs_other_driving(const HouseSession *session);

/* The run whose answer is the draft's: the displayed one, unless that is mixed. */
const HouseRun *house_runs_answering(const HouseSession *session);

/* True if the run is the result of these epochs (count) with the route and the driving model as they are. */
bool house_runs_is_of(const HouseSession *session, const HouseRun *run, const HouseEpoch *epochs, size_t count);

/* True if the only run in work finds out why somebody cannot leave: the answer is there. */
bool house_runs_seeks_reasons(const HouseSession *session);

/* s, up to where the record will not change any more. */
double house_runs_reach(const HouseSession *session);
