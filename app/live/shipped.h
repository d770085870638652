/* What comes with the program: houses, beams, profiles, furniture. Its assets are where $CLEARANCE_ASSETS says,
 * otherwise beside the source that the program was built from, otherwise where it was installed; the houses are within
 * them or beside them. */
#pragma once

typedef struct Shipped {
    const char *profiles, *furniture, *beams, *houses; /* folders */
    const char *default_house;                         /* a file: what the window opens when nobody says what */
} Shipped;

/* Found once; lives as long as the program. Any thread may ask. */
const Shipped *shipped_places(void);
