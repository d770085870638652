/* The colour of each role, in two themes: Okabe and Ito's colours on the dark board, darker relatives of them on
 * paper, so that every line has a contrast of 3 to its ground and every text of 4.5, also without red, green or any
 * hue; no role depends on its colour alone. */
#pragma once

#include "draw/scene.h"

typedef enum Theme { THEME_PAPER, THEME_BOARD, THEME_COUNT } Theme;

#define THEME_NAMES "paper|board"

typedef struct Colour {
    double red, green, blue; /* 0 to 1, sRGB */
} Colour;

Colour palette_colour(Theme theme, Role role);

/* Returns the colour of a quantity, from nearest to the paper (part 0) to farthest from it (1), ordered by brightness.
 */
Colour palette_shade(Theme theme, double part);

/* Returns black or white, whichever is more legible on the role or ground. */
Colour palette_ink(Theme theme, Role role);
Colour palette_ink_on(Colour ground);

/* Returns the contrast of two colours, 1 to 21, as WCAG 2 defines it. */
double palette_contrast(Colour a, Colour b);
