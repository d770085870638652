/* How urgent threads are that compute beside the one that paints: a frame waits for neither the answer nor for what
 * comes after it. Where the environment variable CLEARANCE_EQUAL_THREADS is set, as in tests, all are alike: several
 * windows on few processors would leave nothing to the threads that compute what they wait for. */
#pragma once

typedef enum Urgency { URGENCY_ANSWER, URGENCY_AFTERWARDS } Urgency;

/* Sets the urgency of the calling thread and of those that it will start. */
void urgency_set(Urgency urgency);
