/* The record of a run in JuPedSim's trajectory format, version 2 (SQLite), which PedPy opens with heading.
 *
 *   trajectory_data (frame, id, pos_x, pos_y, ori_x, ori_y)   m and a unit vector; id is a person's place by id, from 1
 *   metadata        version 2, fps, xmin, xmax, ymin, ymax
 *   geometry        WKT of the walkable area; frame_data refers to it frame by frame
 */
#pragma once

#include "house/house.h"
#include "house/observation.h"

/* Writes a temporary file in the same folder, then renames it. Returns 0, or errno. */
int jupedsim_write(const House *house, const Observation *observation, const char *path);
