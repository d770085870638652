#include "draw/palette.h"

#include <math.h>

static const unsigned palette[ROLE_COUNT][THEME_COUNT] = {
    /*                      paper     board */
    [ROLE_PAPER] = {0xFFFFFF, 0x14171B},          [ROLE_PANEL] = {0xF4F5F6, 0x1E2227},
    [ROLE_GRID] = {0xE6E8EA, 0x262B31},           [ROLE_ROOM] = {0x666D73, 0x98A1A8},
    [ROLE_WALL] = {0x24262B, 0xE8EAED},           [ROLE_FURNITURE] = {0xE7E2DA, 0x2C3036},
    [ROLE_FURNITURE_LINE] = {0x6F675C, 0x8A8276}, [ROLE_DOOR] = {0x8A5200, 0xC9A26B},
    [ROLE_CHAIR] = {0x0068A8, 0x56B4E9},          [ROLE_RING] = {0x0068A8, 0x56B4E9},
    [ROLE_LOCUS] = {0x0068A8, 0x56B4E9},          [ROLE_LOCUS_SECOND] = {0x7B3F8C, 0xC9A0DC},
    [ROLE_LOCUS_THIRD] = {0x3C4650, 0xE8EAED},    [ROLE_LOCUS_FOURTH] = {0x007285, 0x5CC8D7},
    [ROLE_GHOST] = {0xCC79A7, 0xB5639B},          [ROLE_WALKER] = {0x59636A, 0xA9B3BA},
    [ROLE_DANGER_LOW] = {0xFFD166, 0xFFE27A},     [ROLE_DANGER_MIDDLE] = {0xE07A00, 0xF08A24},
    [ROLE_DANGER_HIGH] = {0x8C0F1F, 0xD3202F},    [ROLE_EXIT] = {0x009E73, 0x35DDA8},
    [ROLE_EXIT_TAG] = {0x007A59, 0x35DDA8},       [ROLE_TEXT] = {0x1B1D21, 0xE8EAED},
    [ROLE_DIM_TEXT] = {0x4A5056, 0xA9B3BA},       [ROLE_ERROR] = {0xB00020, 0xFF8C94},
};

Colour palette_colour(Theme theme, Role role) {
    unsigned code = palette[role][theme];
    return (Colour){(code >> 16) / 255.0, (code >> 8 & 255) / 255.0, (code & 255) / 255.0};
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
    Colour ground = palette_colour(theme, role);
    Colour black = {0, 0, 0}, white = {1, 1, 1};
    return palette_contrast(ground, black) > palette_contrast(ground, white) ? black : white;
}
