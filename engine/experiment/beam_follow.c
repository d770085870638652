#include "experiment/beam_follow.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/parameters_number.h"

/* Share of the range within which two pitchforks are one: that of an orbit, and that of the pair beside it. */
static const double ONE_FORK = 1e-5;

/* True if the same pitchfork is on another of the first `count` branches. */
static bool is_known(const BeamFollow *follow, const BeamFamily *family, size_t b, const FollowPoint *point,
                     size_t count) {
    double near = ONE_FORK * (family->follow.to - family->follow.from);
    for (size_t c = 0; c < count && point->kind == FOLLOW_PITCHFORK; c++)
        for (size_t i = 0; i < follow->branches[c].count && c != b; i++) {
            const FollowPoint *other = &follow->branches[c].points[i];
            if (other->kind == FOLLOW_PITCHFORK && fabs(other->value - point->value) <= near &&
                follow->branches[c].period == follow->branches[b].period)
                return true;
        }
    return false;
}

static bool begins_another(const BeamFollow *follow, const BeamFamily *family, size_t b, const FollowPoint *point) {
    return point->kind == FOLLOW_FLIP ||
           (point->kind == FOLLOW_PITCHFORK && !is_known(follow, family, b, point, follow->count));
}

/* Follows the orbits that begin at flips and pitchforks of those that are known, as many as there is room for. */
static void follow_others(BeamFollow *follow, BeamFamily *family, const Stop *stop) {
    for (size_t b = 0; b < follow->count; b++)
        for (size_t i = 0; i < follow->branches[b].count && follow->count < BEAM_FOLLOW_BRANCHES; i++)
            if (begins_another(follow, family, b, &follow->branches[b].points[i]) && !stop_requested(stop)) {
                FollowBranch *next = &follow->branches[follow->count];
                if (follow_branch_off(next, &family->follow, &follow->branches[b], i, BEAM_FOLLOW_STEP, stop))
                    follow->count++;
                else
                    follow_clear(next);
            }
}

bool beam_follow_run(BeamFollow *follow, BeamFamily *family, const double *point, size_t period, const Stop *stop) {
    *follow = (BeamFollow){0};
    bool good = follow_run(&follow->branches[0], &family->follow, beam_family_value(family), point, period,
                           BEAM_FOLLOW_STEP, stop);
    if (good) {
        follow->count = 1;
        follow_others(follow, family, stop);
    } else {
        follow_clear(&follow->branches[0]);
    }
    follow->interrupted = stop_requested(stop);
    return good;
}

/* Curves ------------------------------------------------------------------------------------------------------------
 */

bool beam_follow_check(const BeamFamily *family, const BeamPlane *plane, const char *place, Fault *fault) {
    const Parameter *row = parameters_find(beam_table(), plane->name);
    Beam beam = family->beam;
    if (!row || row->kind != PARAMETER_NUMBER || row == family->row)
        fault_add(fault, "%s: %s is not another number that changes continuously; joint.clearance is one", place,
                  plane->name);
    else if (!(plane->least < plane->most) || plane->steps < 2 || plane->steps > BEAM_FOLLOW_STEPS)
        fault_add(fault, "%s: the curves over %s need a range and 2 to %d steps", place, plane->name,
                  BEAM_FOLLOW_STEPS);
    else if (parameters_number_get(row, &beam) < plane->least || parameters_number_get(row, &beam) > plane->most)
        fault_add(fault, "%s: %s is %g, outside the range %g to %g; set it with --set", place, plane->name,
                  parameters_number_get(row, &beam), plane->least, plane->most);
    else
        return parameters_set_number(row, &beam, plane->least, fault) && beam_check(&beam, place, fault) &&
               parameters_set_number(row, &beam, plane->most, fault) && beam_check(&beam, place, fault);
    return false;
}

/* A family whose other number is set. */
typedef struct Other {
    BeamFamily family;
    const Parameter *row;
} Other;

static bool set_other(void *context, double value) {
    Other *other = context;
    return beam_family_set(&other->family, other->row, value);
}

typedef struct CurveTask {
    BeamFollow *follow;
    const BeamFamily *family;
    const BeamPlane *plane;
    const Stop *stop;
    size_t branch[BEAM_FOLLOW_CURVES], at[BEAM_FOLLOW_CURVES]; /* where each curve begins */
} CurveTask;

static void make_curve(void *context, size_t i) {
    const CurveTask *task = context;
    const FollowFamily *range = &task->family->follow;
    Other other = {.row = parameters_find(beam_table(), task->plane->name)};
    Fault fault = {0};
    if (stop_requested(task->stop) || !beam_family_open(&other.family, &task->family->beam, task->family->row->name,
                                                        range->from, range->to, "curve", &fault)) {
        fault_clear(&fault);
        return;
    }
    const FollowPlane plane = {.family = &other.family.follow,
                               .set = set_other,
                               .context = &other,
                               .other = parameters_number_get(other.row, &task->family->beam),
                               .least = task->plane->least,
                               .most = task->plane->most,
                               .steps = task->plane->steps};
    follow_curve_run(&task->follow->curves[i], &plane, &task->follow->branches[task->branch[i]], task->at[i],
                     task->stop);
    beam_family_close(&other.family);
}

/* Adds the clearances at which the motion without contact just touches. */
static void add_free_end(BeamFollow *follow, const BeamFamily *family, const BeamPlane *plane) {
    FollowCurve *curve = &follow->curves[follow->curve_count];
    enum { POINTS = 401 };
    bool any = false;
    *curve = (FollowCurve){.kind = FOLLOW_TOUCH, .period = 1};
    curve->value = memory_zeroed(POINTS, sizeof *curve->value);
    curve->other = memory_zeroed(POINTS, sizeof *curve->other);
    curve->off = memory_zeroed(POINTS, sizeof *curve->off);
    for (size_t i = 0; i < POINTS; i++) {
        const FollowFamily *range = &family->follow;
        double frequency = range->from + (range->to - range->from) * (double)i / (POINTS - 1);
        Rig own = rig_share(&family->rig, frequency, family->beam.force, family->beam.clearance);
        double amplitude = rig_free_amplitude(&own);
        rig_clear_shared(&own);
        bool inside = amplitude >= plane->least && amplitude <= plane->most;
        curve->value[i] = frequency;
        curve->other[i] = inside ? amplitude : (double)NAN;
        curve->off[i] = NAN;
        curve->count++;
        any |= inside;
    }
    if (any)
        follow->curve_count++;
    else
        follow_curve_clear(curve);
}

static bool is_curve(FollowKind kind) {
    return kind != FOLLOW_STEP && kind != FOLLOW_TOUCH;
}

void beam_follow_curves(BeamFollow *follow, const BeamFamily *family, const BeamPlane *plane, int jobs,
                        const Stop *stop) {
    CurveTask task = {follow, family, plane, stop, {0}, {0}};
    size_t begun = 0;
    bool known = strcmp(family->row->name, "drive.frequency") == 0 && strcmp(plane->name, "joint.clearance") == 0;
    for (size_t b = 0; b < follow->count; b++)
        for (size_t i = 0; i < follow->branches[b].count; i++) {
            const FollowPoint *point = &follow->branches[b].points[i];
            if (!is_curve(point->kind) || is_known(follow, family, b, point, b))
                continue;
            if (begun + known == BEAM_FOLLOW_CURVES) {
                follow->left_out++;
                continue;
            }
            task.branch[begun] = b;
            task.at[begun++] = i;
        }
    parallel_for(jobs, begun, make_curve, &task);
    for (size_t i = 0; i < begun; i++) { /* keeps those that lead on */
        FollowCurve made = follow->curves[i];
        follow->curves[i] = (FollowCurve){0};
        if (made.count > 1)
            follow->curves[follow->curve_count++] = made;
        else
            follow_curve_clear(&made);
    }
    if (known)
        add_free_end(follow, family, plane);
    follow->interrupted |= stop_requested(stop);
}

void beam_follow_clear(BeamFollow *follow) {
    for (size_t b = 0; b < follow->count; b++)
        follow_clear(&follow->branches[b]);
    for (size_t i = 0; i < follow->curve_count; i++)
        follow_curve_clear(&follow->curves[i]);
    *follow = (BeamFollow){0};
}
