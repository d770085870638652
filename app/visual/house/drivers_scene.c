#include "visual/house/drivers_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "result/names.h"

/* m: touches nearer to each other than this are one place; the radius of a disc for all drivers, and the least one. */
static const double NEAR = 0.4, LARGEST = 0.5, SMALLEST = 0.08;
/* m: a smaller disc has no letter in the picture, which would stand beside it; the list has all. */
static const double LETTERED = 0.1;
/* m/s, assumed: from here on a touch is a knock, and a blow. */
static const double KNOCK = 0.1, BLOW = 0.3;
/* design points */
static const double LETTERS = 12;

enum { LISTED = 6 };

static const char *const letters[] = {"F", "S", "T"}; /* of the body's parts */

typedef struct TouchPlace {
    Vec2 at; /* m, of its fastest impact */
    size_t touches;
    double fastest; /* m/s */
    int part;       /* BodyPart, of the fastest */
} TouchPlace;

/* All places of one name. */
typedef struct TouchRow {
    const char *name;
    size_t touches;
    double fastest; /* m/s */
    int part;       /* BodyPart, of the fastest */
} TouchRow;

static Role role_of(double speed) {
    return speed >= BLOW ? ROLE_DANGER_HIGH : speed >= KNOCK ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
}

/* Gathers the fastest touch of each driver of each person. Returns the number of places. */
static size_t gather(const Drivers *drivers, TouchPlace *places) {
    size_t count = 0;
    for (size_t r = 0; r < drivers->count * drivers->person_count; r++) {
        const DriverRun *run = &drivers->runs[r];
        if (!run->varies || !(run->impact > 0))
            continue;
        size_t p = 0;
        while (p < count && vec2_distance(places[p].at, run->impact_at) > NEAR)
            p++;
        if (p == count)
            places[count++] = (TouchPlace){.at = run->impact_at};
        places[p].touches++;
        if (run->impact > places[p].fastest) {
            places[p].fastest = run->impact;
            places[p].part = run->part;
        }
    }
    return count;
}

static int by_touches(const void *a, const void *b) {
    const TouchPlace *one = a, *other = b;
    return (one->touches < other->touches) - (one->touches > other->touches);
}

static int rows_by_touches(const void *a, const void *b) {
    const TouchRow *one = a, *other = b;
    return (one->touches < other->touches) - (one->touches > other->touches);
}

/* Names a place and adds it to the list, or to the row of that name: both jambs of a door are one thing. Returns the
 * new number of rows. */
static size_t list_place(Scene *scene, const House *house, const TouchPlace *place, TouchRow *rows, size_t count) {
    char words[96];
    size_t r = 0;
    outline_place_name(&house->outline, &house->plan, place->at, words, sizeof words);
    const char *name = names_text(house, words, &scene->arena);
    while (r < count && strcmp(rows[r].name, name) != 0)
        r++;
    if (r == count)
        rows[count++] = (TouchRow){.name = name, .part = place->part};
    rows[r].touches += place->touches;
    if (place->fastest > rows[r].fastest) {
        rows[r].fastest = place->fastest;
        rows[r].part = place->part;
    }
    return count;
}

/* Shows a row next to the plan: its name, its fastest impact, its share. */
static void show_row(Scene *scene, const TouchRow *listed, size_t drivers) {
    SceneRow *row = scene_add_row(scene, ROW_DISC, listed->name);
    row->role = role_of(listed->fastest);
    row->mark = letters[listed->part];
    row->cells[1] = scene_text(scene, "%.2f m/s", listed->fastest);
    row->cells[2] = scene_text(scene, "%.0f %%", 100 * (double)listed->touches / (double)drivers);
}

void drivers_scene_add(Scene *scene, const House *house, const Drivers *drivers) {
    TouchPlace *places = memory_zeroed(drivers->count * drivers->person_count, sizeof *places);
    size_t count = gather(drivers, places), row_count = 0;
    TouchRow *rows = memory_zeroed(count + 1, sizeof *rows);
    if (count)
        scene_add_row(scene, ROW_HEADING, scene_text(scene, "Touches of %zu drivers", drivers->count));
    qsort(places, count, sizeof *places, by_touches);
    for (size_t p = 0; p < count; p++) {
        double share = (double)places[p].touches / (double)drivers->count;
        double radius = fmax(LARGEST * sqrt(fmin(share, 1)), SMALLEST);
        const char *letter = letters[places[p].part];
        scene_add_discs(scene, role_of(places[p].fastest), radius, &places[p].at, 1);
        if (radius >= LETTERED) {
            Primitive *label = scene_add_label(scene, ROLE_TEXT, LETTERS, places[p].at, letter);
            label->bold = label->fixed = true; /* within its disc; names give way */
            label->shape = LABEL_TAG;          /* over the leaders of other labels */
            label->fill = role_of(places[p].fastest);
        }
        row_count = list_place(scene, house, &places[p], rows, row_count);
    }
    qsort(rows, row_count, sizeof *rows, rows_by_touches);
    for (size_t r = 0; r < row_count && r < LISTED; r++)
        show_row(scene, &rows[r], drivers->count);
    if (count) {
        SceneRow *row = scene_add_row(scene, ROW_PLAIN, "F front");
        row->cells[1] = "S side";
        row->cells[2] = "T tail";
    }
    memory_free(rows);
    memory_free(places);
}
