#include "visual/house/drivers_scene.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "experiment/danger.h"
#include "house/world.h"
#include "result/names.h"

/* m: the radius of a disc for all drivers, and the least one. */
static const double LARGEST = 0.5, SMALLEST = 0.08;
/* m: a smaller disc has no letter in the picture, which would stand beside it; the list has all. */
static const double LETTERED = 0.1;
/* m: the same for a ring, which its dashes tell already and which the letter would hide. */
static const double RING_LETTERED = 0.25;
/* design points */
static const double LETTERS = 12, RING_WIDTH = 2.5;

enum { LISTED = 6, RING_POINTS = 48 };

static const char *const letters[] = {"F", "S", "T", "H"}; /* of the body's parts */

/* All places of one name. */
typedef struct TouchRow {
    const char *name;
    bool *by;       /* (number of drivers) True for those who touch there, shared with its first place */
    double energy;  /* J, expected in a run */
    double speed95; /* m/s, the greatest of its places */
    double fastest; /* m/s */
    int part;       /* BodyPart, of the fastest */
} TouchRow;

static Role role_of(double speed) {
    return speed >= DANGER_BLOW ? ROLE_DANGER_HIGH : speed >= DANGER_KNOCK ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
}

static int by_energy(const void *a, const void *b) {
    const TouchRow *one = a, *other = b;
    int hands = (one->part == PART_HAND) - (other->part == PART_HAND);
    return hands ? hands : (one->energy < other->energy) - (one->energy > other->energy);
}

/* Adds a place to the list, or to the row of its name: both jambs of a door are one thing, but hands stand apart.
 * Returns the new number of rows. */
static size_t list_place(Scene *scene, const House *house, const DangerPlace *place, size_t drivers, TouchRow *rows,
                         size_t count) {
    const char *name = names_thing(house, place->what, place->at, &scene->arena);
    size_t r = 0;
    while (r < count && (strcmp(rows[r].name, name) != 0 || (rows[r].part == PART_HAND) != (place->part == PART_HAND)))
        r++;
    if (r == count)
        rows[count++] = (TouchRow){.name = name, .by = place->by, .part = place->part};
    for (size_t k = 0; k < drivers; k++)
        rows[r].by[k] |= place->by[k];
    rows[r].speed95 = fmax(rows[r].speed95, place->speed95);
    rows[r].energy += place->energy;
    if (place->fastest > rows[r].fastest) {
        rows[r].fastest = place->fastest;
        rows[r].part = place->part;
    }
    return count;
}

/* Shows a row next to the plan: its name, the speed below which 95 % of its impacts stay, its share of the drivers. */
static void show_row(Scene *scene, const TouchRow *listed, size_t drivers) {
    SceneRow *row = scene_add_row(scene, ROW_DISC, listed->name);
    row->role = role_of(listed->fastest);
    row->mark = letters[listed->part];
    size_t touching = 0;
    for (size_t k = 0; k < drivers; k++)
        touching += listed->by[k];
    row->cells[1] = scene_text(scene, "%.2f m/s", listed->speed95);
    row->cells[2] = scene_text(scene, "%.0f %%", 100 * (double)touching / (double)drivers);
}

/* Tells the letters, and the order and columns of the rows. */
static void add_heading(Scene *scene, size_t drivers) {
    scene_add_row(scene, ROW_HEADING, scene_text(scene, "Touches of %zu drivers", drivers));
    SceneRow *letters_row = scene_add_row(scene, ROW_PLAIN, "F front");
    letters_row->cells[1] = "S side, T tail";
    letters_row->cells[2] = "H hand (ring)";
    scene_add_row(scene, ROW_PLAIN, "worst first: speed that 95 % of the touches stay below, share of drivers");
}

/* Adds a letter that stays within its disc, or on its ring; names give way to it. */
static void add_letter(Scene *scene, const DangerPlace *place, Vec2 at) {
    Primitive *label = scene_add_label(scene, ROLE_TEXT, LETTERS, at, letters[place->part]);
    label->bold = label->fixed = true;
    label->shape = LABEL_TAG; /* over the leaders of other labels */
    label->fill = role_of(place->fastest);
}

/* Adds a dashed ring for the hands that meet something, through which the discs of bodies are seen. Its letter stands
 * on its upper right, since a body may touch at the same place. */
static void add_ring(Scene *scene, const DangerPlace *place, double radius) {
    Vec2 points[RING_POINTS + 1];
    for (int i = 0; i <= RING_POINTS; i++)
        points[i] = vec2_along(place->at, radius, vec2_heading(2 * M_PI * i / RING_POINTS));
    Primitive *ring = scene_add_line(scene, role_of(place->fastest), RING_WIDTH, points, RING_POINTS + 1);
    ring->style = LINE_DASHED;
    if (radius >= RING_LETTERED)
        add_letter(scene, place, points[RING_POINTS / 8]);
}

/* Adds the heat of a place: a disc whose area is the share of drivers who touch there, in the shade of their speed; of
 * hands, a ring of that size. */
static void add_heat(Scene *scene, const DangerPlace *place, size_t drivers) {
    double share = (double)place->share.good / (double)drivers;
    double radius = fmax(LARGEST * sqrt(fmin(share, 1)), SMALLEST);
    if (place->part == PART_HAND) {
        add_ring(scene, place, radius);
        return;
    }
    scene_add_discs(scene, role_of(place->fastest), radius, &place->at, 1);
    if (radius >= LETTERED)
        add_letter(scene, place, place->at);
}

void drivers_scene_add(Scene *scene, const House *house, const Drivers *drivers) {
    Danger danger = danger_of_drivers(house, drivers, SIZE_MAX);
    TouchRow *rows = memory_zeroed(danger.count + 1, sizeof *rows);
    size_t row_count = 0;
    if (danger.count)
        add_heading(scene, drivers->count);
    for (size_t p = 0; p < danger.count; p++)
        row_count = list_place(scene, house, &danger.places[p], drivers->count, rows, row_count);
    for (size_t p = danger.count; p > 0; p--) /* hands stand last, and lie below */
        add_heat(scene, &danger.places[p - 1], drivers->count);
    qsort(rows, row_count, sizeof *rows, by_energy);
    for (size_t r = 0; r < row_count && r < LISTED; r++)
        show_row(scene, &rows[r], drivers->count);
    memory_free(rows);
    danger_free(&danger);
}
