/* What comes with the program: houses, beams, profiles. Looked for in this order: $CLEARANCE_ASSETS, beside the source
 * that the program was built from, where it was installed. Paths are good as long as the program runs. */
#pragma once

/* The folder of a kind of asset: "profiles", "beams". */
const char *shipped_assets(const char *kind);

/* The folder of houses: $CLEARANCE_ASSETS/houses, if there is one, and so on. */
const char *shipped_houses(void);

/* What the window opens when nobody says what. */
const char *shipped_default_house(void);
