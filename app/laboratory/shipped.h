/* The files that come with the program: houses, beams, profiles, furniture, rules, help. The assets folder is the
 * first of these folders that contains profiles:
 *   1. $CLEARANCE_ASSETS, and no other if it is set
 *   2. share/clearance next to the folder of the program, so that an installed tree can be moved
 *   3. assets next to the build folder, if the program lies in a build folder
 *   4. clearance in $XDG_DATA_HOME and in each of $XDG_DATA_DIRS, or in their default folders
 *   5. the folder that the build was configured to install to
 * The houses lie in the assets folder or next to it. */
#pragma once

typedef struct Shipped {
    const char *profiles, *furniture, *beams, *houses, *help, *rules; /* folders */
    const char *missing; /* one line that names the searched places if none contains profiles; NULL otherwise */
} Shipped;

/* Returns the places of the shipped files. They are searched once and stay valid as long as the program. Any thread
 * may call it. */
const Shipped *shipped_places(void);
