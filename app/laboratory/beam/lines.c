#include "laboratory/beam/lines.h"

#include <math.h>

#include "beam/beam_cycle.h"
#include "experiment/beam_follow.h"

/* Adds the parts of a branch that are stable, or those that are not, followed by a break. A located point belongs to
 * both. */
static void add_line(MachineSweepPoints *points, const FollowBranch *branch, bool stable) {
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        bool in = point->kind != FOLLOW_STEP || point->stable == stable;
        machine_sweep_points_add(points, point->value, in ? point->peak : (double)NAN);
    }
    machine_sweep_points_add(points, NAN, NAN);
}

static void add_located(MachineLines *lines, const FollowBranch *branch, bool listed) {
    for (size_t i = 0; i < branch->count; i++) {
        const FollowPoint *point = &branch->points[i];
        if (point->kind == FOLLOW_STEP || point->kind == FOLLOW_TOUCH)
            continue;
        machine_sweep_points_add(&lines->points[MACHINE_LINE_LOCATED], point->value, point->peak);
        if (listed && lines->located_count < MACHINE_LOCATED_MOST)
            lines->located[lines->located_count++] =
                (MachineLocated){follow_kind_name(point->kind), point->value, point->peak};
    }
}

static void take(MachineLines *lines, const BeamFollow *follow) {
    lines->period = follow->branches[0].period;
    for (size_t b = 0; b < follow->count; b++) {
        add_line(&lines->points[MACHINE_LINE_STABLE], &follow->branches[b], true);
        add_line(&lines->points[MACHINE_LINE_UNSTABLE], &follow->branches[b], false);
        add_located(lines, &follow->branches[b], b == 0);
    }
}

bool beam_lines_follow(const Machine *machine, const double *state, size_t count, const char *name, double from,
                       double to, MachineLines *lines, const Stop *stop) {
    const Beam *beam = &machine->beam;
    BeamFamily family;
    BeamFollow follow = {.count = 0};
    Response response;
    Fault fault = {0};
    *lines = (MachineLines){.why = "This number cannot be followed over its range"};
    bool opened = beam_family_open(&family, beam, name, from, to, beam->name, &fault);
    fault_clear(&fault);
    if (!opened)
        return true;
    double value = beam_family_value(&family);
    lines->why = "The present value is outside the diagram";
    if (value > from && value < to) {
        bool fits = count == family.rig.free.states;
        lines->why = "The motion has no stable orbit to follow";
        beam_cycle_respond(&response, &family.rig, beam, fits ? state : NULL, stop);
        if (response.orbit.period &&
            beam_follow_run(&follow, &family, response.orbit.point, response.orbit.period, stop))
            take(lines, &follow);
        response_clear(&response);
    }
    beam_follow_clear(&follow);
    beam_family_close(&family);
    return !stop_requested(stop);
}
