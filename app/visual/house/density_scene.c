#include "visual/house/density_scene.h"

#include <math.h>
#include <stdio.h>

#include "base/memory.h"

#define FINE 0.25              /* m, between the points at which the density is taken */
#define OPACITY 0.8            /* walls stay visible below */
#define REACH sqrt(1.0 / M_PI) /* m, radius of a disc of 1 m2 */

/* Shares of the box. */
#define KEY_HEIGHT 0.035
#define KEY_LEFT 0.28   /* where the numbers begin; words stand to their left */
#define KEY_WIDTH 0.132 /* of a level; the scale of the view has room to the right of the last */
#define KEY_TEXT 16.0   /* design points */

/* m, of a box whose cells are WIDE: narrow ones would be 3 pixels large, four times as many, and take the time that
 * moving pictures need. */
#define LARGE 60.0

enum {
    LEVELS = 5,
    NARROW = 2, /* fine points on a cell's side */
    WIDE = 4,
    MOST_CELLS = 4000000,
};

static const double levels[LEVELS] = {0.5, 1, 1.5, 2, 3}; /* 1/m2 */
static const Role roles[LEVELS] = {ROLE_DENSITY_FIRST, ROLE_DENSITY_SECOND, ROLE_DENSITY_THIRD, ROLE_DENSITY_FOURTH,
                                   ROLE_DENSITY_FIFTH};

/* Returns the level of a density, -1: below the first. */
static int level_of(double density) {
    int level = -1;
    while (level + 1 < LEVELS && density >= levels[level + 1])
        level++;
    return level;
}

/* Counts, at each fine point, the people in its disc. */
static void count_people(unsigned short *counts, size_t columns, size_t rows, Vec2 low, const Vec2 *places,
                         size_t count) {
    for (size_t i = 0; i < count; i++) {
        Vec2 at = vec2_scale(vec2_sub(places[i], low), 1 / FINE);
        double reach = REACH / FINE;
        long first = (long)fmax(0, ceil(at.y - reach - 0.5)), last = (long)floor(at.y + reach - 0.5);
        for (long r = first; r <= last && r < (long)rows; r++) {
            double up = (double)r + 0.5 - at.y, half = sqrt(fmax(0, reach * reach - up * up));
            long left = (long)fmax(0, ceil(at.x - half - 0.5)), right = (long)floor(at.x + half - 0.5);
            for (long c = left; c <= right && c < (long)columns; c++)
                counts[(size_t)r * columns + (size_t)c]++;
        }
    }
}

/* The fine points of a box in square cells of `side` by `side` of them. */
typedef struct Grid {
    Vec2 low; /* m */
    size_t side, columns, rows;
    unsigned short *counts; /* (rows, columns) of people, of fine points */
} Grid;

/* Returns counts that the caller frees; NULL: there is nobody, or the box is too large. */
static Grid make_grid(Box box, size_t side, const Vec2 *places, size_t count) {
    Grid grid = {.low = box.low,
                 .side = side,
                 .columns = side * (size_t)ceil(box_width(box) / ((double)side * FINE)),
                 .rows = side * (size_t)ceil(box_height(box) / ((double)side * FINE))};
    if (!count || grid.columns * grid.rows > MOST_CELLS)
        return grid;
    grid.counts = memory_zeroed(grid.columns * grid.rows, sizeof *grid.counts);
    count_people(grid.counts, grid.columns, grid.rows, box.low, places, count);
    return grid;
}

/* Returns the mean density of a cell, 1/m2. */
static double cell_density(const Grid *grid, size_t row, size_t column) {
    unsigned sum = 0;
    for (size_t r = row * grid->side; r < (row + 1) * grid->side; r++)
        for (size_t c = column * grid->side; c < (column + 1) * grid->side; c++)
            sum += grid->counts[r * grid->columns + c];
    return (double)sum / (double)(grid->side * grid->side);
}

static void add_run(Scene *scene, const Grid *grid, size_t row, size_t first, size_t end, int level) {
    double size = (double)grid->side * FINE, y = grid->low.y + (double)row * size;
    double left = grid->low.x + (double)first * size, right = grid->low.x + (double)end * size;
    Vec2 corners[] = {{left, y}, {right, y}, {right, y + size}, {left, y + size}};
    Primitive *cells = scene_add_polygon(scene, roles[level], corners, 4);
    cells->fill_opacity = OPACITY;
    cells->edge_opacity = 0;
    cells->width = 0;
    cells->joined = true;
}

double density_scene_area(Box box, const Vec2 *places, size_t count, double least) {
    Grid grid = make_grid(box, NARROW, places, count);
    size_t cells = 0;
    for (size_t r = 0; grid.counts && r < grid.rows / grid.side; r++)
        for (size_t c = 0; c < grid.columns / grid.side; c++)
            cells += cell_density(&grid, r, c) >= least;
    memory_free(grid.counts);
    double size = NARROW * FINE;
    return (double)cells * size * size;
}

void density_scene_add(Scene *scene, Box box, const Vec2 *places, size_t count) {
    Grid grid = make_grid(box, fmax(box_width(box), box_height(box)) > LARGE ? WIDE : NARROW, places, count);
    size_t columns = grid.columns / grid.side;
    for (size_t r = 0; grid.counts && r < grid.rows / grid.side; r++) {
        size_t first = 0;
        int level = -1;
        for (size_t c = 0; c <= columns; c++) {
            int now = c < columns ? level_of(cell_density(&grid, r, c)) : -1;
            if (now == level)
                continue;
            if (level >= 0)
                add_run(scene, &grid, r, first, c, level);
            first = c;
            level = now;
        }
    }
    memory_free(grid.counts);
}

/* Adds words about the numbers where they have room; false-coloured numbers alone would say nothing, so a short form
 * takes their place in a small picture. */
static void add_words(Scene *scene, double right, double y) {
    static const char *const forms[] = {"people on a square metre", "people/m\u00b2", "per m\u00b2"};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        Primitive *label =
            scene_add_label(scene, ROLE_TEXT, KEY_TEXT, vec2((scene->box.low.x + right) / 2, y), forms[i]);
        label->fixed = label->optional = true;
        label->fill = ROLE_PAPER;
    }
}

/* Adds the number of a level in its box; where not all five have room, the ends of the scale are seen, then its middle.
 */
static void add_number(Scene *scene, int level, Vec2 at, double width) {
    const char *number = scene_text(scene, level + 1 < LEVELS ? "%g" : "%g+", levels[level]); /* the last: or more */
    Primitive *label = scene_add_label(scene, ROLE_TEXT, KEY_TEXT, at, number);
    label->shape = LABEL_TAG;
    label->fill = roles[level];
    label->fixed = label->bold = label->optional = true;
    label->widest = width;
}

void density_scene_key(Scene *scene) {
    static const int order[LEVELS] = {0, LEVELS - 1, LEVELS / 2, 1, LEVELS - 2};
    double width = box_width(scene->box), height = KEY_HEIGHT * width, each = KEY_WIDTH * width;
    double y = scene->box.low.y - 0.5 * height, begin = scene->box.low.x + KEY_LEFT * width;
    for (int i = 0; i < LEVELS; i++) {
        double left = begin + i * each;
        Vec2 corners[] = {{left, y - height}, {left + each, y - height}, {left + each, y}, {left, y}};
        Primitive *box = scene_add_polygon(scene, roles[i], corners, 4);
        box->edge_opacity = 0;
        box->fill_opacity = OPACITY;
    }
    for (int i = 0; i < LEVELS; i++)
        add_number(scene, order[i], vec2(begin + (order[i] + 0.5) * each, y - height / 2), each);
    add_words(scene, begin, y - height / 2);
    scene->box.low.y = y - height;
    scene->keyed = true;
    scene->key_end = begin + LEVELS * each;
}
