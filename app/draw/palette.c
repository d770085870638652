#include "draw/palette.h"

#include <math.h>

static const unsigned palette[ROLE_COUNT][THEME_COUNT] = {
    /*                      paper     board */
    [ROLE_PAPER] = {0xFFFFFF, 0x14171B},          [ROLE_PANEL] = {0xF6F7F9, 0x1A1E23},
    [ROLE_GRID] = {0xE6E8EA, 0x262B31},           [ROLE_ROOM] = {0x5A636B, 0xA9B3BA},
    [ROLE_WALL] = {0x24262B, 0xE8EAED},           [ROLE_FURNITURE] = {0xEEEBE4, 0x2C3036},
    [ROLE_FURNITURE_LINE] = {0x7A7166, 0x8F877C}, [ROLE_DOOR] = {0x8A5200, 0xC9A26B},
    [ROLE_CHAIR] = {0x0068A8, 0x56B4E9},          [ROLE_RING] = {0x0068A8, 0x56B4E9},
    [ROLE_LOCUS] = {0x0068A8, 0x56B4E9},          [ROLE_LOCUS_SECOND] = {0x7A3E9D, 0xC89BE0},
    [ROLE_LOCUS_THIRD] = {0x3A4652, 0xD5DBE0},    [ROLE_LOCUS_FOURTH] = {0x00757A, 0x5CC7D0},
    [ROLE_GHOST] = {0xA8327D, 0xE58BC4},          [ROLE_WALKER] = {0x59636A, 0xA9B3BA},
    [ROLE_DANGER_LOW] = {0xFFD166, 0xFFE27A},     [ROLE_DANGER_MIDDLE] = {0xE07A00, 0xF08A24},
    [ROLE_DANGER_HIGH] = {0x8C0F1F, 0xD3202F},    [ROLE_EXIT] = {0x009E73, 0x35DDA8},
    [ROLE_EXIT_TAG] = {0x007A59, 0x35DDA8},       [ROLE_TEXT] = {0x1B1D21, 0xE8EAED},
    [ROLE_DIM_TEXT] = {0x4A5056, 0xA9B3BA},       [ROLE_ERROR] = {0xA80A24, 0xFF8A93},
    [ROLE_IMPACT] = {0xB34700, 0xF08A24},         [ROLE_SHADE] = {0xDDE4E9, 0x2E363D},
    [ROLE_BAND] = {0xA9C5D9, 0x3B5468},           [ROLE_CLASS_NONE] = {0xF1F2F3, 0x23282E},
    [ROLE_CLASS_FIRST] = {0xDCE9F2, 0xDCE9F2},    [ROLE_CLASS_SECOND] = {0xA6C8E0, 0xA6C8E0},
    [ROLE_CLASS_THIRD] = {0x6BA0CB, 0x6BA0CB},    [ROLE_CLASS_FOURTH] = {0x3F79B0, 0x3F79B0},
    [ROLE_CLASS_FIFTH] = {0x1F5590, 0x1F5590},    [ROLE_CLASS_SIXTH] = {0x0E3263, 0x0E3263},
    [ROLE_TYPE_FIRST] = {0xDCE9F2, 0xDCE9F2},     [ROLE_TYPE_SECOND] = {0xFFD166, 0xFFD166},
    [ROLE_TYPE_THIRD] = {0x8C0F1F, 0x8C0F1F},     [ROLE_DENSITY_FIRST] = {0xFDF0C4, 0x4A2410},
    [ROLE_DENSITY_SECOND] = {0xFBD277, 0x8F3D0C}, [ROLE_DENSITY_THIRD] = {0xF2A03D, 0xD8701B},
    [ROLE_DENSITY_FOURTH] = {0xD8590B, 0xF7B955}, [ROLE_DENSITY_FIFTH] = {0x8C0F1F, 0xFFF3C9},
};

/* Ordered from light to dark, without red. */
static const unsigned shades[] = {0xFFF8DA, 0xC4DFCF, 0x7DB5C6, 0x3C7EB2, 0x1D4C8C, 0x0E2450};
enum { SHADES = sizeof shades / sizeof *shades };

static Colour of_code(unsigned code) {
    return (Colour){(code >> 16) / 255.0, (code >> 8 & 255) / 255.0, (code & 255) / 255.0};
}

Colour palette_colour(Theme theme, Role role) {
    return of_code(palette[role][theme]);
}

Colour palette_shade(Theme theme, double part) {
    double place = (SHADES - 1) * fmin(fmax(theme == THEME_BOARD ? 1 - part : part, 0), 1);
    int below = (int)fmin(place, SHADES - 2);
    Colour from = of_code(shades[below]), to = of_code(shades[below + 1]);
    double way = place - below;
    return (Colour){from.red + way * (to.red - from.red), from.green + way * (to.green - from.green),
                    from.blue + way * (to.blue - from.blue)};
}

static double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : pow((channel + 0.055) / 1.055, 2.4);
}

static double luminance(Colour colour) {
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double palette_contrast(Colour a, Colour b) {
    double first = luminance(a), second = luminance(b);
    return (fmax(first, second) + 0.05) / (fmin(first, second) + 0.05);
}

Colour palette_ink(Theme theme, Role role) {
    return palette_ink_on(palette_colour(theme, role));
}

Colour palette_ink_on(Colour ground) {
    Colour black = {0, 0, 0}, white = {1, 1, 1};
    return palette_contrast(ground, black) > palette_contrast(ground, white) ? black : white;
}
