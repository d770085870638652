#include "classroom/hands.h"

#include <math.h>

#include "base/text.h"

/* Design points. */
#define COUNT 46.0 /* width of the number */
#define HATCH 7.0  /* between two lines of a pattern */

/* Draws a line of a pattern, cut at the box's sides; `slope` 1 or -1. */
static void draw_hatch_line(Ui *ui, Box box, double x, int slope) {
    double height = box_height(box);
    double from = fmax(x, box.low.x), to = fmin(x + height, box.high.x);
    if (from >= to)
        return;
    double low = slope > 0 ? box.high.y - (from - x) : box.low.y + (from - x);
    double high = slope > 0 ? box.high.y - (to - x) : box.low.y + (to - x);
    ui_draw_line(ui, vec2(from, low), vec2(to, high), ROLE_DIM_TEXT, 1.5);
}

/* Draws a bar: hatched one way for the first vote, both ways for the second. */
static void draw_bar(Ui *ui, Box box, int vote) {
    for (double x = box.low.x - box_height(box); x < box.high.x; x += HATCH) {
        draw_hatch_line(ui, box, x, 1);
        if (vote)
            draw_hatch_line(ui, box, x, -1);
    }
    ui_draw_frame(ui, box, ROLE_DIM_TEXT, 1.5);
}

void hands_draw(Ui *ui, const PlayStep *guesses, int vote, size_t option, Box box, Arena *arena) {
    int most = 1;
    for (size_t o = 0; o < LESSON_OPTIONS_MOST; o++)
        for (int v = 0; v < PLAY_VOTES; v++)
            most = guesses->hands[v][o] > most ? guesses->hands[v][o] : most;
    int hands = guesses->hands[vote][option];
    Box bar = box;
    bar.high.x = box.low.x + (box_width(box) - COUNT) * hands / most;
    if (hands)
        draw_bar(ui, bar, vote);
    ui_draw_text(ui, UI_BOLD, ROLE_TEXT, vec2(box.high.x, (box.low.y + box.high.y) / 2), 1,
                 text_in_arena(arena, "%d", hands));
}
