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
/* design points */
static const double LETTERS = 12;

enum { LISTED = 6 };

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

void drivers_scene_add(Scene *scene, const House *house, const Drivers *drivers) {
    Danger danger = danger_of_drivers(house, drivers, SIZE_MAX);
    TouchRow *rows = memory_zeroed(danger.count + 1, sizeof *rows);
    size_t row_count = 0;
    if (danger.count)
        scene_add_row(scene, ROW_HEADING, scene_text(scene, "Touches of %zu drivers", drivers->count));
    for (size_t p = 0; p < danger.count; p++) {
        const DangerPlace *place = &danger.places[p];
        double share = (double)place->share.good / (double)drivers->count;
        double radius = fmax(LARGEST * sqrt(fmin(share, 1)), SMALLEST);
        row_count = list_place(scene, house, place, drivers->count, rows, row_count);
        if (place->part == PART_HAND)
            continue;
        scene_add_discs(scene, role_of(place->fastest), radius, &place->at, 1);
        if (radius >= LETTERED) {
            Primitive *label = scene_add_label(scene, ROLE_TEXT, LETTERS, place->at, letters[place->part]);
            label->bold = label->fixed = true; /* within its disc; names give way */
            label->shape = LABEL_TAG;          /* over the leaders of other labels */
            label->fill = role_of(place->fastest);
        }
    }
    qsort(rows, row_count, sizeof *rows, by_energy);
    for (size_t r = 0; r < row_count && r < LISTED; r++)
        show_row(scene, &rows[r], drivers->count);
    if (danger.count) {
        SceneRow *row = scene_add_row(scene, ROW_PLAIN, "F front");
        row->cells[1] = "S side, T tail";
        row->cells[2] = "H hand";
    }
    memory_free(rows);
    danger_free(&danger);
}
