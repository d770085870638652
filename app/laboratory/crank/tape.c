#include "laboratory/crank/tape.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "visual/crank/crank_scene.h"

enum { SHRINKS = 16 /* revolutions with a smaller extent before the room shrinks */ };

static const double SMALL = 0.6; /* 1, the room shrinks if the extent is below this share of it */

/* Parts -------------------------------------------------------------------------------------------------------------*/

static CrankPart *make_part(CrankTape *tape, const Crank *crank) {
    CrankPart *part = memory_zeroed(1, sizeof *part);
    *part = (CrankPart){.crank = *crank, .tree = tree_of(crank), .serial = ++tape->part_serial};
    return part;
}

/* Forgets the oldest part with its revolutions. */
static void forget_part(CrankTape *tape) {
    memory_free(tape->parts[0]);
    tape->part_count--;
    memmove(tape->parts, tape->parts + 1, tape->part_count * sizeof *tape->parts);
    if (tape->first < tape->parts[0]->first)
        tape->first = tape->parts[0]->first;
}

static CrankTapeCycle *slot(const CrankTape *tape, size_t cycle) {
    return &tape->cycles[cycle % (CRANK_TAPE_CYCLES + 1)];
}

static CrankReturn *return_slot(const CrankTape *tape, size_t cycle) {
    return &tape->returns[cycle % (CRANK_TAPE_RETURNS + 1)];
}

const CrankPart *crank_tape_part(const CrankTape *tape, size_t cycle) {
    size_t p = tape->part_count;
    while (p > 1 && tape->parts[p - 1]->first > cycle)
        p--;
    return p ? tape->parts[p - 1] : tape->next;
}

const CrankTapeCycle *crank_tape_cycle(const CrankTape *tape, size_t cycle) {
    return slot(tape, cycle);
}

const CrankReturn *crank_tape_return(const CrankTape *tape, size_t cycle) {
    return return_slot(tape, cycle);
}

size_t crank_tape_first_return(const CrankTape *tape) {
    size_t part = tape->parts[tape->part_count - 1]->first;
    size_t kept = tape->front > CRANK_TAPE_RETURNS ? tape->front - CRANK_TAPE_RETURNS : 0;
    return part > kept ? part : kept;
}

size_t crank_tape_cycle_at(const CrankTape *tape, double time, size_t *row) {
    size_t low = tape->first, high = tape->front > tape->first ? tape->front - 1 : tape->first;
    while (low < high) {
        size_t middle = low + (high - low + 1) / 2;
        if (crank_tape_return(tape, middle)->begin <= time)
            low = middle;
        else
            high = middle - 1;
    }
    const CrankTapeCycle *cycle = slot(tape, low);
    double period = crank_tape_part(tape, low)->tree.period;
    double rows = (time - crank_tape_return(tape, low)->begin) / period * CRANK_TAPE_ROWS;
    double most = cycle->row_count ? (double)(cycle->row_count - 1) : 0;
    *row = rows > 0 ? (size_t)fmin(rows, most) : 0;
    return low;
}

/* Recording ---------------------------------------------------------------------------------------------------------*/

/* Notes the motion at the beginning of the front's revolution. */
static void note_front(CrankTape *tape) {
    CrankReturn *at = return_slot(tape, tape->front);
    CrankTapeCycle *cycle = slot(tape, tape->front);
    TreePose pose = turn_pose(&tape->turn);
    double tip[2];
    crank_cycle_tip(&tape->turn, tip);
    *at = (CrankReturn){.begin = tape->front_time, .along = tip[0], .along_rate = tip[1]};
    for (size_t i = 0; i < 3; i++) {
        at->across += pose.apart[i] * pose.across[i];
        at->up += pose.apart[i] * pose.up[i];
    }
    cycle->begin = tape->turn;
    cycle->row_count = 0;
}

/* Begins the next part, with the carried motion or at its start. */
static void begin_part(CrankTape *tape) {
    CrankPart *part = tape->next;
    const Tree *tree = &part->tree, *before = tape->part_count ? tape->turn.tree : NULL;
    double state[TREE_STATES_MOST];
    bool carries = before && before->coordinates == tree->coordinates && before->bending == tree->bending &&
                   tape->status == CYCLE_GOOD;
    if (carries)
        crank_cycle_state(&tape->turn, state);
    part->first = tape->front;
    part->begin = tape->front_time;
    tape->turn = turn_create(tree, TURN_QUICK);
    if (carries)
        crank_cycle_set_state(&tape->turn, state);
    while (tape->part_count && tape->parts[tape->part_count - 1]->first == part->first)
        memory_free(tape->parts[--tape->part_count]); /* it has no revolution */
    if (tape->part_count == CRANK_TAPE_PARTS)
        forget_part(tape);
    tape->parts[tape->part_count++] = part;
    tape->next = NULL;
    tape->status = CYCLE_GOOD;
    note_front(tape);
}

/* Stores a row of the motion within a step, on the cubic through its ends. */
static void store_row(CrankTapeCycle *cycle, const Turn *from, const Turn *to, double length, double part) {
    const Tree *tree = from->tree;
    size_t count = tree->coordinates;
    double state[TREE_STATES_MOST], a = part * part * (3 - 2 * part), b = part * (1 - part) * (1 - part),
                                    c = -part * part * (1 - part);
    for (size_t i = 0; i < count; i++) {
        double by = to->state[i] - from->state[i];
        if (tree->turns && i == count - 1 && to->cycle != from->cycle)
            by += 2 * M_PI;
        double first = from->state[count + i], last = to->state[count + i];
        state[i] = from->state[i] + a * by + length * (b * first + c * last);
        state[count + i] = first + part * (last - first);
    }
    double time = from->time + part * length, tip[2] = {0, 0}, across = 0, up = 0;
    TreePose pose = tree_pose(tree, time, state);
    for (size_t i = 0; i < 3; i++) {
        double turned = pose.turn[2] * pose.across[i] - pose.turn[1] * pose.up[i];
        tip[0] += pose.apart[i] * pose.along[i];
        tip[1] += pose.apart_rate[i] * pose.along[i] + pose.apart[i] * turned;
        across += pose.apart[i] * pose.across[i];
        up += pose.apart[i] * pose.up[i];
    }
    double push = from->place == BALL_CONTACT ? ball_read(tree, &pose).push : 0;
    cycle->width = CRANK_TAPE_COLUMNS + count;
    cycle->rows =
        memory_reserve(cycle->rows, &cycle->row_capacity, (cycle->row_count + 1) * cycle->width, sizeof *cycle->rows);
    float *row = cycle->rows + cycle->row_count++ * cycle->width;
    row[CRANK_TAPE_ALONG] = (float)tip[0];
    row[CRANK_TAPE_ALONG_RATE] = (float)tip[1];
    row[CRANK_TAPE_ACROSS] = (float)across;
    row[CRANK_TAPE_UP] = (float)up;
    row[CRANK_TAPE_FORCE] = (float)fmax(push, 0);
    row[CRANK_TAPE_ANGLE] = (float)pose.theta;
    row[CRANK_TAPE_SLIDER_OFF] = (float)(state[0] - tree_ideal_slider(tree, pose.theta));
    row[CRANK_TAPE_SLIDER_RATE] = (float)state[count];
    for (size_t i = 0; i < count; i++)
        row[CRANK_TAPE_COLUMNS + i] = (float)state[i];
    cycle->reach = fmax(cycle->reach, crank_scene_reach(tree, state));
}

/* Follows the motion to the end of the revolution as turn_cycle does, and stores its rows. */
static void follow_cycle(CrankTape *tape, CrankTapeCycle *cycle, double *duration) {
    Turn *turn = &tape->turn;
    size_t begun = turn->cycle;
    double interval = turn->tree->period / CRANK_TAPE_ROWS;
    turn->peak[0] = 0;
    *duration = 0;
    while (turn->status == CYCLE_GOOD && turn->cycle == begun) {
        Turn from = *turn;
        double length = turn_step(turn, HUGE_VAL), at;
        *duration = from.time + length;
        while (length > 0 && (at = (double)cycle->row_count * interval - from.time) < length)
            store_row(cycle, &from, turn, length, fmax(at, 0) / length);
    }
}

static double room_for(double before, double now, double lately) {
    return now > before ? now : lately < SMALL * before ? lately : before;
}

/* Sets the room of the front's revolution: that of the one before, unless it is too small or for long too large. */
static void find_room(const CrankTape *tape, CrankTapeCycle *cycle) {
    size_t part_first = tape->parts[tape->part_count - 1]->first;
    size_t first = part_first > tape->first ? part_first : tape->first;
    double peak = return_slot(tape, tape->front)->peak, reach = cycle->reach, force = peak;
    cycle->reach_room = cycle->reach;
    cycle->force_room = peak;
    if (tape->front == first)
        return;
    const CrankTapeCycle *before = slot(tape, tape->front - 1);
    for (size_t back = 1; back < SHRINKS && back <= tape->front - first; back++) {
        reach = fmax(reach, slot(tape, tape->front - back)->reach);
        force = fmax(force, return_slot(tape, tape->front - back)->peak);
    }
    bool may = tape->front >= first + SHRINKS;
    cycle->reach_room = room_for(before->reach_room, cycle->reach, may ? reach : HUGE_VAL);
    cycle->force_room = room_for(before->force_room, peak, may ? force : HUGE_VAL);
}

bool crank_tape_advance(CrankTape *tape) {
    if (tape->next)
        begin_part(tape);
    if (tape->status != CYCLE_GOOD)
        return false;
    CrankTapeCycle *cycle = slot(tape, tape->front);
    const CrankPart *part = tape->parts[tape->part_count - 1];
    cycle->reach = 0;
    double duration;
    follow_cycle(tape, cycle, &duration);
    tape->status = tape->turn.status;
    if (tape->status != CYCLE_GOOD)
        return false;
    return_slot(tape, tape->front)->peak = tape->turn.peak[0];
    find_room(tape, cycle);
    tape->front++;
    tape->front_time = tape->turn.tree->turns ? tape->front_time + duration
                                              : part->begin + (double)(tape->front - part->first) * part->tree.period;
    if (tape->front - tape->first > CRANK_TAPE_CYCLES)
        tape->first++;
    while (tape->part_count > 1 && tape->parts[1]->first <= tape->first)
        forget_part(tape);
    note_front(tape);
    return true;
}

/* Changes -----------------------------------------------------------------------------------------------------------*/

void crank_tape_change(CrankTape *tape, const Crank *crank, size_t cycle) {
    CrankPart *part = make_part(tape, crank);
    if (cycle < tape->front || !tape->next) { /* otherwise the motion is carried already */
        tape->front_time = crank_tape_return(tape, cycle)->begin;
        tape->version += cycle < tape->front;
        tape->turn = slot(tape, cycle)->begin;
        tape->status = CYCLE_GOOD;
        tape->front = cycle;
    }
    while (tape->part_count && tape->parts[tape->part_count - 1]->first > cycle)
        memory_free(tape->parts[--tape->part_count]);
    memory_free(tape->next);
    tape->next = part;
}

static void forget_parts(CrankTape *tape) {
    while (tape->part_count)
        memory_free(tape->parts[--tape->part_count]);
    memory_free(tape->next);
    tape->next = NULL;
}

void crank_tape_restart(CrankTape *tape, const Crank *crank) {
    forget_parts(tape);
    tape->next = make_part(tape, crank);
    tape->first = tape->front = 0;
    tape->front_time = 0;
    tape->version++;
    begin_part(tape);
}

void crank_tape_open(CrankTape *tape, const Crank *crank) {
    *tape = (CrankTape){.cycles = memory_zeroed(CRANK_TAPE_CYCLES + 1, sizeof *tape->cycles),
                        .returns = memory_zeroed(CRANK_TAPE_RETURNS + 1, sizeof *tape->returns)};
    crank_tape_restart(tape, crank);
}

void crank_tape_close(CrankTape *tape) {
    forget_parts(tape);
    for (size_t i = 0; i <= CRANK_TAPE_CYCLES; i++)
        memory_free(tape->cycles[i].rows);
    memory_free(tape->cycles);
    memory_free(tape->returns);
    *tape = (CrankTape){0};
}
