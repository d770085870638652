/* The request to end work early: by a signal handler, or by another thread that no longer needs the answer. Work polls
 * the request and ends with an answer that says "interrupted", which is neither a yes nor a no. */
#pragma once

#include <signal.h>
#include <stdbool.h>

/* A zeroed request is not made. A request lasts until it is withdrawn, so that work that has seen the request and work
 * that looks later agree. */
typedef struct Stop {
    volatile sig_atomic_t requested;
} Stop;

/* True if the end is requested. NULL: never. */
bool stop_requested(const Stop *stop);

/* Requests the end; may be called from a signal handler. */
void stop_request(Stop *stop);

/* Withdraws the request, once all work that could have seen it has ended. */
void stop_withdraw(Stop *stop);
