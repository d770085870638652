#include "classroom/dots.h"

#include <math.h>
#include <string.h>

#include "base/text.h"

/* Design points. */
#define DOT 4.5     /* radius */
#define COLUMN 12.0 /* width of a column of dots */
#define LABELS 24.0 /* height of the numbers below the axis */
#define LINE 2.0
#define SHARE 0.1 /* of the range, that is left free at each end */

enum { ROWS = 4 /* dots above each other; more of the same lie on the last one */, COLUMNS_MOST = 200 };

typedef struct Axis {
    double low, high; /* values */
    Box box;
} Axis;

double dots_height(const PlayStep *guesses) {
    return (guesses->vote + 1) * (ROWS * 2 * DOT + LINE) + LABELS;
}

static double place(const Axis *axis, double value) {
    return axis->box.low.x + (value - axis->low) / (axis->high - axis->low) * box_width(axis->box);
}

/* Returns an axis that holds all numbers, and the answer if it is told. */
static Axis axis_of(const LessonStep *step, const PlayStep *guesses, Box box, bool tells) {
    double low = tells ? step->answer : HUGE_VAL, high = tells ? step->answer : -HUGE_VAL;
    for (int vote = 0; vote <= guesses->vote; vote++)
        for (int n = 0; n < guesses->number_count[vote]; n++) {
            low = fmin(low, guesses->numbers[vote][n]);
            high = fmax(high, guesses->numbers[vote][n]);
        }
    double free = high > low ? SHARE * (high - low) : fmax(SHARE * fabs(high), SHARE);
    return (Axis){low - free, high + free, {{box.low.x + DOT, box.low.y}, {box.high.x - DOT, box.high.y}}};
}

/* Draws the dots of a vote above its line: discs for the first, diamonds for the second. */
static void draw_vote(Ui *ui, const Axis *axis, const PlayStep *guesses, int vote, double line) {
    int stacked[COLUMNS_MOST] = {0};
    ui_draw_line(ui, vec2(axis->box.low.x - DOT, line), vec2(axis->box.high.x + DOT, line), ROLE_DIM_TEXT, LINE);
    for (int n = 0; n < guesses->number_count[vote]; n++) {
        double x = place(axis, guesses->numbers[vote][n]);
        int column = (int)fmin(fmax(0, (x - axis->box.low.x) / COLUMN), COLUMNS_MOST - 1);
        int row = stacked[column] < ROWS ? stacked[column]++ : ROWS - 1;
        Vec2 at = {x, line - (2 * row + 1) * DOT};
        if (vote)
            ui_draw_diamond(ui, at, DOT, ROLE_TEXT);
        else
            ui_draw_disc(ui, at, DOT, ROLE_TEXT);
    }
}

static const char *number_text(const LessonStep *step, double value, Arena *arena) {
    bool bare = strcmp(step->unit, "1") == 0;
    return text_in_arena(arena, "%.6g%s%s", value, bare ? "" : " ", bare ? "" : step->unit);
}

void dots_draw(Ui *ui, const LessonStep *step, const PlayStep *guesses, Box box, bool tells, Arena *arena) {
    if (!play_hands(guesses, 0) && !play_hands(guesses, 1) && !tells)
        return;
    Axis axis = axis_of(step, guesses, box, tells);
    double part = (box_height(box) - LABELS) / (guesses->vote + 1), y = box.high.y - LABELS / 2;
    for (int vote = 0; vote <= guesses->vote; vote++)
        draw_vote(ui, &axis, guesses, vote, box.low.y + (vote + 1) * part);
    if (tells)
        ui_draw_line(ui, vec2(place(&axis, step->answer), box.low.y),
                     vec2(place(&axis, step->answer), box.high.y - LABELS), ROLE_EXIT_TAG, LINE);
    ui_draw_text(ui, UI_BODY, ROLE_DIM_TEXT, vec2(box.low.x, y), 0, number_text(step, axis.low, arena));
    ui_draw_text(ui, UI_BODY, ROLE_DIM_TEXT, vec2(box.high.x, y), 1, number_text(step, axis.high, arena));
}
