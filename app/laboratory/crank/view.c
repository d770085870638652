#include "laboratory/crank/view.h"

#include <math.h>

#include "base/memory.h"

enum {
    PATH_TURNS = 2,  /* revolutions of the ball's path, */
    FORCE_TURNS = 8, /* and of the polar diagram; */
    FORCE_STEP = 2,  /* of which every so many-th row is drawn */
};

static bool same_scale(const CrankScale *a, const CrankScale *b) {
    return a->parts == b->parts && a->sight == b->sight && a->bend == b->bend && a->largest == b->largest;
}

/* Takes over the scale of a part and revolution. True: it has changed. */
static bool take_cycle(CrankView *view, MachinePicture *picture, const CrankPart *part, const CrankTapeCycle *cycle) {
    CrankScale scale = crank_scene_scale(&part->crank, &part->tree, cycle->reach_room, cycle->force_room);
    scale.parts = picture->parts;
    scale.sight = view->sight;
    if (picture->serial == part->serial && same_scale(&scale, &view->scale))
        return false;
    view->scale = scale;
    picture->serial = part->serial;
    crank_scene_still(machine_picture_begin(picture, scale.box), &part->crank, &part->tree, &scale);
    return true;
}

/* Copies a column of the rows up to a moment, every `step`-th of the last `turns` revolutions of the part; `present`:
 * the first one of the moment's revolution. */
static size_t copy_column(const CrankTape *tape, size_t cycle, size_t row, size_t turns, size_t step, size_t column,
                          double *values, size_t *present) {
    size_t first = crank_tape_part(tape, cycle)->first, count = 0;
    first = first > tape->first ? first : tape->first;
    if (cycle >= turns && first < cycle - turns + 1)
        first = cycle - turns + 1;
    for (size_t c = first; c <= cycle; c++) {
        const CrankTapeCycle *at = crank_tape_cycle(tape, c);
        size_t end = c == cycle ? row + 1 : at->row_count;
        if (c == cycle)
            *present = count;
        for (size_t r = 0; r < end; r += step)
            values[count++] = crank_tape_row(at, r)[column];
        if (c == cycle && row % step) /* the moment is the last one */
            values[count++] = crank_tape_row(at, row)[column];
    }
    return count;
}

bool crank_view_show(CrankView *view, MachinePicture *picture, const CrankTape *tape, double time) {
    size_t row, present, cycle = crank_tape_cycle_at(tape, time, &row);
    const CrankPart *part = crank_tape_part(tape, cycle);
    const CrankTapeCycle *at = crank_tape_cycle(tape, cycle);
    bool restarted = take_cycle(view, picture, part, at);
    size_t width = part->tree.coordinates, room = 0;
    if (!at->row_count)
        return restarted;
    for (size_t c = tape->first; c <= cycle; c++)
        if (c + FORCE_TURNS > cycle)
            room += crank_tape_cycle(tape, c)->row_count + 2;
    view->values = memory_reserve(view->values, &view->capacity, 5 * room, sizeof *view->values);
    double *columns[5], state[TREE_STATES_MOST] = {0};
    for (size_t i = 0; i < 5; i++)
        columns[i] = view->values + i * room;
    for (size_t i = 0; i < width; i++)
        state[i] = crank_tape_row(at, row)[CRANK_TAPE_COLUMNS + i];
    CrankMoment moment = {.time = (double)row / CRANK_TAPE_ROWS * part->tree.period,
                          .state = state,
                          .force = crank_tape_row(at, row)[CRANK_TAPE_FORCE],
                          .along = columns[0],
                          .across = columns[1],
                          .up = columns[2],
                          .angle = columns[3],
                          .forces = columns[4]};
    moment.path_count = copy_column(tape, cycle, row, PATH_TURNS, 1, CRANK_TAPE_ALONG, columns[0], &present);
    copy_column(tape, cycle, row, PATH_TURNS, 1, CRANK_TAPE_ACROSS, columns[1], &present);
    copy_column(tape, cycle, row, PATH_TURNS, 1, CRANK_TAPE_UP, columns[2], &present);
    copy_column(tape, cycle, row, FORCE_TURNS, FORCE_STEP, CRANK_TAPE_ANGLE, columns[3], &present);
    moment.force_count =
        copy_column(tape, cycle, row, FORCE_TURNS, FORCE_STEP, CRANK_TAPE_FORCE, columns[4], &moment.present);
    scene_reset(&picture->moving);
    crank_scene_moving(&picture->moving, &part->tree, &view->scale, &moment);
    return restarted;
}

void crank_view_close(CrankView *view) {
    memory_free(view->values);
}
