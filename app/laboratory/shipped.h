/* The files that come with the program: houses, beams, cranks, profiles, furniture, rules, help. The assets folder is
 * the first of these folders that contains profiles:
 *   1. $CLEARANCE_ASSETS, and no other if it is set
 *   2. share/clearance next to the folder of the program, so that an installed tree can be moved
 *   3. assets next to the build folder, if the program lies in a build folder
 *   4. clearance in $XDG_DATA_HOME and in each of $XDG_DATA_DIRS, or in their default folders
 *   5. the folder that the build was configured to install to
 * The houses lie in the assets folder or next to it.
 *
 * Profiles of a person or a site lie in clearance/profiles of $XDG_DATA_HOME and of each of $XDG_DATA_DIRS, houses,
 * beams and cranks likewise. They stand beside the shipped ones, which win where names are equal: a house keeps its
 * results. With $CLEARANCE_ASSETS there are none. */
#pragma once

#include <stddef.h>

typedef struct Shipped {
    const char *profiles; /* folders, one a line, the shipped one first */
    const char *populations, *furniture, *beams, *cranks, *houses, *help, *rules, *lessons; /* folders */
    const char *missing; /* one line that names the searched places if none contains profiles; NULL otherwise */
} Shipped;

/* Returns the i-th clearance folder of a person or a site, which exists and is not the assets folder; NULL: there is no
 * more. */
const char *shipped_own(size_t i);

/* Returns the places of the shipped files. They are searched once and stay valid as long as the program. Any thread
 * may call it. */
const Shipped *shipped_places(void);

/* Returns the title of a shipped machine from the name in its file: "Impact beam (set B)" for "ibs"; other names stay.
 */
const char *shipped_title(const char *name);
