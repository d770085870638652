/* The files that come with the program: houses, beams, profiles, furniture, help. Their folder, the assets, is the
 * first of these that holds profiles:
 *   1. $CLEARANCE_ASSETS, and no other if it is set
 *   2. share/clearance beside the folder of the program, so that an installed tree can be moved
 *   3. assets beside the build folder, if the program lies in one
 *   4. clearance in $XDG_DATA_HOME and in each of $XDG_DATA_DIRS, or in the defaults of these
 *   5. the folder that the build was configured to install to
 * The houses are within the assets or beside them. */
#pragma once

typedef struct Shipped {
    const char *profiles, *furniture, *beams, *houses, *help; /* folders */
    const char *missing; /* one line that names the places, if none of them holds profiles; NULL otherwise */
} Shipped;

/* The places are looked for once and session as long as the program. Any thread may ask. */
const Shipped *shipped_places(void);
