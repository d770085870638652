/* A slider crank at one moment of its record as a scene, in metres of the drawing: the mechanism seen from a raised
 * viewpoint, next to it the socket with the path of the ball in a loupe, and the joint's force over
 * the crank angle as a polar diagram.
 *
 *        block (A)                 +--- loupe ---+     +-- polar diagram --+
 *             |  crank             |   ( path )  |     |   force outwards  |
 *           (pin)---- coupler      |  of the ball|     |  angle as the     |
 *                         \        +-------------+     |  crank's          |
 *      guide ===========[slider]===                    +-------------------+                                        */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "draw/scene.h"

/* Adds the whole picture of the moment of the largest recorded force. The trace must have a whole revolution. */
void crank_scene_make(Scene *scene, const Crank *crank, const Tree *tree, const Response *response);
