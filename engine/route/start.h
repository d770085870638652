/* Where a route begins that is planned in the middle of a run: clear of what the body presses on, and of the line of an
 * exit that has closed under it. */
#pragma once

#include <stdbool.h>

#include "route/route.h"
#include "route/search.h"

/* Finds out whether a body that overlaps something stands clear of it after a short way straight back or ahead, on
 * which it goes no deeper into anything but lines of closed exits, and its reference point crosses none of these.
 * Returns -1 or 1 and sets the place, or returns 0. */
int start_go_clear(const RouteQuery *query, const Rectangle *body, Vec2 *at);

/* Finds the start pose of the body. In the middle of a run it is moved away from obstacles that it presses on or stands
 * close to, because a chair whose flank is at a wall cannot turn away without its tail hitting the wall. The roomiest
 * of the places tried is chosen. Returns false if the body is not free. */
bool start_ease_off(const RouteQuery *query, const Rectangle *body, Vec2 *at);

/* Moves a disc off the obstacles that it overlaps, each in turn, until it is 2 mm clear of them. */
void start_push_off(const FreeSpace *space, double radius, Vec2 *at);
