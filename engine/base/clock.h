/* How long something takes: for progress, for what must not keep anybody waiting, for how often a disk is asked to
 * write. No answer depends on it. */
#pragma once

/* s, of a clock that only goes on; its zero means nothing. */
double clock_now(void);
