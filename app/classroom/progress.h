/* Keeps the guesses of a class and its place in a lesson, so that neither a crash nor the end of the program loses
 * them, in
 *
 *     FOLDER/lessons.json    of the last PROGRESS_LESSONS lessons: path, digest of the file, step, counts and answers
 *
 * A lesson whose file has changed since restarts. Counts of hands are kept, no names. */
#pragma once

#include <stdint.h>

#include "classroom/play.h"

enum { PROGRESS_LESSONS = 20 };

/* The place and the guesses of an earlier session. */
typedef struct Progress {
    size_t step; /* from 0 */
    PlayStep steps[LESSON_STEPS_MOST];
    int64_t when; /* s since 1970 */
} Progress;

/* Reads what is kept of the lesson. False: nothing. An invalid file is renamed to lessons.json.bad, and `notes` gets a
 * line that says so. */
bool progress_read(Progress *progress, const Lesson *lesson, const char *folder, Fault *notes);

/* Writes the state of a play in place of the lesson's older one; forgets it. Both return 0, or errno, and then the file
 * is as it was. */
int progress_write(const Play *play, const char *folder, int64_t when);
int progress_forget(const Lesson *lesson, const char *folder);

/* Returns the hands that were counted in all steps. */
int progress_hands(const Progress *progress);
