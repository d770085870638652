/* Schedules background runs and chooses which result is displayed. */
#pragma once

#include "laboratory/house/runs.h"

/* Takes the edits of the draft into account: requests its run, unless that run is displayed. */
void house_schedule_apply_edit(HouseSession *session);

/* Requests a run of the present wish and draft: the answer first, the reasons later. */
void house_schedule_request(HouseSession *session);

/* Saves the displayed run for comparison; false: the run is not over, or `by_itself` and a saved run exists already. */
bool house_schedule_store(HouseSession *session, bool by_itself);
void house_schedule_clear(HouseSession *session); /* forgets the saved run */

/* Restarts with the present plan from the beginning on. */
void house_schedule_restart(HouseSession *session);

/* Takes over new results; `time` is the displayed time. */
void house_schedule_update(HouseSession *session, double time);
void house_schedule_end(HouseSession *session);

/* Gives up the newest run and undoes the edits since the displayed one. */
void house_schedule_stop(HouseSession *session);
