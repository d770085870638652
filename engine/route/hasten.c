#include "route/hasten.h"

#include <stdint.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"
#include "route/field.h"
#include "route/pace.h"
#include "route/speeds.h"

/* Descent on the time itself (speeds.c), or rather on the cost, which is the time and its prices.
 *
 * The price of the personal space (pace_price) is asked for last, of the way that is quickest: hasten_centre lowers the
 * sum with it, but takes no more than CENTRED of the time. So the price chooses among ways that take the same time, and
 * how long a way takes, and whether more room can make it longer, does not depend on the price.
 *
 * A trial moves the stations about one of them along their normals (a bump, of 0.1 m to a room's length), or a joint,
 * or the end, all faded over some stations; each place has its own length of step. Where something stops the way, a
 * bump that fades as far to either side would press it there, so that the way beside it stays where it is: bumps that
 * are steep on one side are tried, too. A trial is kept when the sum falls and no clearance is below the margin, at the
 * stations and between them. The speeds are computed again only as far as they change.
 *
 * A step h that succeeds grows. Where the sum rises by u and d with h and -h, the parabola through the three sums is
 * least at h (d - u) / (2 (u + d)), by (d - u)^2 / (8 (u + d)): that is the next step, or, if it gains next to nothing,
 * the place is left alone. Where something is in the way the step shrinks. */

#define CENTRED 2e-3   /* 1, share of the time that the middle may cost */
#define FIRST 0.01     /* m, first length of a trial */
#define SHORTEST 2e-4  /* m: shorter ones are not tried */
#define LONGEST 0.08   /* m */
#define GAIN 1e-6      /* s */
#define LONG_GAIN 0.02 /* s, by bumps longer than a metre: less is not worth that a straight way bends */
#define NOTHING 1e-5   /* s: places where less is to be gained are left alone */
#define SHRINK 0.4     /* 1, of a step before an obstacle */
#define STOPPED 0.03   /* m above the margin, where something may stop the way */
#define STRAIGHT 1e-3  /* 1/m */
#define MIDDLE 1e-2    /* m */

enum {
    LEVELS = 7,
    SKEWS = 3,        /* bumps that fade as far to either side, and those that are STEEPER before or after */
    LEAST_SKEWED = 2, /* level */
    STEEPER = 4,
    SHORTEST_BUMP = 2,
    REACHES = 4,
    LONG_RUN = 32,
    LEAST_CENTRING = 2,
    LONG_LEVEL = 5
};

static const int joint_reaches[REACHES] = {2, 4, 8, 16};

typedef struct Hasten {
    Way *way;
    Course course; /* of that way; while it centres, the time has a bound */
    Speeds now, tried;
    Station *kept; /* (count) */
    double sum;    /* s, of the costs */
    double spare;  /* s, by which the way may still become slower, while centring */
    double worth;  /* s: trials that gain less are undone */
    double gained; /* s, by the latest trial; minus infinity if it was not possible */
} Hasten;

/* Judges a trial that has moved the stations low to high (the kept ones hold low - 1 to high + 1) and, if
 * `joint` < piece_count, that joint. Undoes it unless it gains. */
static bool judge(Hasten *hasten, size_t low, size_t high, size_t joint, Joint joint_before) {
    Way *way = hasten->way;
    size_t begin = low > 0 ? low - 1 : 0, end = high + 1 < way->count ? high + 1 : high;
    size_t first = 0, last = 0;
    hasten->gained = -HUGE_VAL;
    way_set_axes(way, begin, end);
    size_t from = begin > 0 ? begin - 1 : 0, to = end + 1 < way->count ? end + 1 : end;
    bool good = way_reaches_goals(way) && way_is_smooth(way, from, to) &&
                way_stays_even(way, hasten->kept, begin, end) &&
                speeds_look(&hasten->course, &hasten->now, &hasten->tried, begin, end);
    double spots_before = 0, spots = 0;
    if (good && joint < way->piece_count) {
        spots = speeds_at_joint(&hasten->course, joint);
        Joint now = way->joints[joint];
        way->joints[joint] = joint_before;
        spots_before = speeds_at_joint(&hasten->course, joint);
        way->joints[joint] = now;
        good = way_spot_clearance(way, joint, hasten->course.space, hasten->course.body, hasten->course.margin) >=
               hasten->course.margin;
    }
    double gain = 0;
    if (good) {
        speeds_run(&hasten->course, &hasten->now, &hasten->tried, begin, end, &first, &last);
        gain = speeds_sum(hasten->now.cost, first, last) - speeds_sum(hasten->tried.cost, first, last) + spots_before -
               spots;
        hasten->gained = gain;
        good = gain > hasten->worth;
    }
    double longer = 0; /* s, by which the trial makes the way slower */
    if (good && hasten->course.centring) {
        longer = speeds_sum(hasten->tried.time, first, last) - speeds_sum(hasten->now.time, first, last) + spots -
                 spots_before;
        good = longer <= 0 || longer <= hasten->spare;
    }
    if (!good) {
        memcpy(way->stations + begin, hasten->kept + begin, (end - begin + 1) * sizeof *way->stations);
        if (joint < way->piece_count)
            way->joints[joint] = joint_before;
        return false;
    }
    speeds_take(&hasten->course, &hasten->now, &hasten->tried, first, last);
    hasten->sum -= gain;
    hasten->spare -= longer;
    return true;
}

static void keep(Hasten *hasten, size_t low, size_t high) {
    size_t begin = low > 0 ? low - 1 : 0, end = high + 1 < hasten->way->count ? high + 1 : high;
    memcpy(hasten->kept + begin, hasten->way->stations + begin, (end - begin + 1) * sizeof *hasten->kept);
}

static double faded(double distance, double reach) {
    double shape = real_max(1 - distance / reach, 0);
    return shape * shape * (3 - 2 * shape);
}

/* Moves the stations about one of them, fading over `before` and `after` stations. */
static bool try_bump(Hasten *hasten, size_t centre, int before, int after, double by) {
    Way *way = hasten->way;
    const WayPiece *piece = &way->pieces[way->stations[centre].piece];
    size_t low = centre >= piece->first + (size_t)before ? centre - (size_t)before + 1 : piece->first + 1;
    size_t high = centre + (size_t)after <= piece->last ? centre + (size_t)after - 1 : piece->last - 1;
    keep(hasten, low, high);
    for (size_t s = low; s <= high; s++) {
        double shape = faded(fabs((double)s - (double)centre), s < centre ? before : after);
        way->stations[s].at = vec2_along(hasten->kept[s].at, by * shape, vec2_left(hasten->kept[s].axis));
    }
    return judge(hasten, low, high, SIZE_MAX, (Joint){0});
}

/* Moves a joint by `move` and turns its headings, and with them the stations near it. `in` and `out`: which headings.
 */
static bool try_joint(Hasten *hasten, size_t k, int reach, Vec2 move, double turn, bool in, bool out) {
    Way *way = hasten->way;
    const WayPiece *after = &way->pieces[k];
    size_t centre = after->first, steps = (size_t)reach;
    size_t high = centre + steps < after->last ? centre + steps : after->last - 1, low = centre;
    if (k > 0) {
        const WayPiece *before = &way->pieces[k - 1];
        low = before->last - before->first > steps ? before->last - steps : before->first + 1;
    }
    keep(hasten, low, high);
    Vec2 pivot = way->stations[centre].at, axis = vec2_heading(turn);
    for (size_t s = low; s <= high; s++) {
        bool behind = k > 0 && s < centre;
        double away = behind ? (double)(centre - 1 - s) : (double)(s - centre), shape = faded(away, reach + 1);
        Vec2 arm = vec2_sub(hasten->kept[s].at, pivot);
        Vec2 turned = (behind ? in : out) ? vec2_sub(vec2_turn(arm, axis), arm) : vec2(0, 0);
        way->stations[s].at = vec2_along(hasten->kept[s].at, shape, vec2_add(move, turned));
    }
    Joint before = way->joints[k];
    way->joints[k].in += in ? turn : 0;
    way->joints[k].out += out ? turn : 0;
    return judge(hasten, low, high, k, before);
}

static bool try_end(Hasten *hasten, int reach, double by) {
    Way *way = hasten->way;
    const WayPiece *piece = &way->pieces[way->piece_count - 1];
    size_t high = piece->last, steps = (size_t)reach;
    size_t low = high - piece->first > steps ? high - steps : piece->first + 1;
    Vec2 line = vec2_unit(vec2_sub(way->exit->to, way->exit->from));
    double least, most, at = vec2_dot(vec2_sub(way->stations[high].at, way->exit->from), line);
    way_exit_range(way, &least, &most);
    by = real_clamp(at + by, least, most) - at;
    keep(hasten, low, high);
    for (size_t s = low; s <= high; s++)
        way->stations[s].at = vec2_along(hasten->kept[s].at, by * faded((double)(high - s), reach + 1), line);
    return judge(hasten, low, high, SIZE_MAX, (Joint){0});
}

/* Returns which side of a station is pressed more: 1 the left, -1 the right, 0 neither. */
static int pressed_side(const Hasten *hasten, size_t s) {
    double more = hasten->now.right[s] - hasten->now.left[s];
    return more > MIDDLE ? 1 : more < -MIDDLE ? -1 : 0;
}

/* True if nothing is lost about a station: the way is straight there, and as fast as it can be. While centring: if
 * both sides are alike. */
static bool is_at_best(const Hasten *hasten, size_t low, size_t high) {
    for (size_t s = low; s <= high; s++)
        if (hasten->course.centring ? pressed_side(hasten, s) != 0
                                    : hasten->now.clearance[s] < hasten->course.sight ||
                                          hasten->now.limit[s] < hasten->course.profile->free_speed ||
                                          (s > low && fabs(speeds_turn(&hasten->now, s - 1, s)) > STRAIGHT * 0.05))
            return false;
    return true;
}

/* True if something stops the way at one of some stations. */
static bool is_stopped(const Hasten *hasten, size_t low, size_t high) {
    bool stopped = false;
    for (size_t s = low; s <= high && !stopped; s++)
        stopped = hasten->now.clearance[s] < hasten->course.margin + STOPPED;
    return stopped;
}

/* Moves the stations low to high by `by`, fading over `fade` stations on either side. */
static bool try_shift(Hasten *hasten, size_t low, size_t high, size_t fade, double by) {
    Way *way = hasten->way;
    const WayPiece *piece = &way->pieces[way->stations[low].piece];
    bool ends = high == way->count - 1;
    size_t begin = low > piece->first + fade ? low - fade : piece->first + 1;
    size_t end = ends ? high : high + fade < piece->last ? high + fade : piece->last - 1;
    double before = (double)(low > begin ? low - begin + 1 : 1), after = (double)(end > high ? end - high + 1 : 1);
    keep(hasten, begin, end);
    for (size_t s = begin; s <= end; s++) {
        double shape = s < low ? faded((double)(low - s), before) : s > high ? faded((double)(s - high), after) : 1;
        Vec2 move = vec2_scale(vec2_left(hasten->kept[s].axis), by * shape);
        if (ends && s == high) { /* along the exit's line */
            Vec2 line = vec2_unit(vec2_sub(way->exit->to, way->exit->from));
            double least, most, at = vec2_dot(vec2_sub(hasten->kept[s].at, way->exit->from), line);
            way_exit_range(way, &least, &most);
            move = vec2_scale(line, real_clamp(at + vec2_dot(move, line), least, most) - at);
        }
        way->stations[s].at = vec2_add(hasten->kept[s].at, move);
    }
    return judge(hasten, begin, end, SIZE_MAX, (Joint){0});
}

/* Tries to move the stations low to high by `by`, all but the first `later` ones, with a longer and longer fade. */
static bool try_shifts(Hasten *hasten, size_t low, size_t high, size_t later, double by) {
    const WayPiece *piece = &hasten->way->pieces[hasten->way->stations[low].piece];
    bool ends = high + 1 == hasten->way->count;
    for (size_t fade = LONG_RUN / 2; fade <= 2 * LONG_RUN; fade *= 2) {
        size_t from = (low > piece->first + fade ? low : piece->first + fade) + later;
        size_t to = ends || high + fade < piece->last ? high : piece->last - fade;
        if (piece->last - piece->first > 3 * fade && from < to && try_shift(hasten, from, to, fade, by))
            return true;
    }
    return false;
}

/* Moves the long parts of the way that are nearer to one side than to the other towards the middle: a bump is too short
 * for that, since its slopes press the body's corners to both sides. Where a part cannot leave the wall at once, as
 * beside a start, it does so later. */
static void sweep_shifts(Hasten *hasten) {
    const Way *way = hasten->way;
    for (size_t low = 0; low < way->count;) {
        const WayPiece *piece = &way->pieces[way->stations[low].piece];
        int side = pressed_side(hasten, low);
        size_t high = low;
        double least = HUGE_VAL;
        for (; high <= piece->last && side && pressed_side(hasten, high) == side; high++)
            least = real_min(least, fabs(hasten->now.left[high] - hasten->now.right[high]) / 2);
        bool done = high < low + LONG_RUN;
        for (size_t later = 0; later <= 4 * LONG_RUN && !done; later = later ? 2 * later : LONG_RUN)
            done = try_shifts(hasten, low, high - 1, later, -side * least);
        low = high > low ? high : low + 1;
    }
}

/* Returns the next step after one that gained too little in either direction: `there`, and `back` s. */
static double next_step(double step, double there, double back) {
    double loss = -(there + back);
    if (!(loss > 0) || loss == HUGE_VAL)
        return SHRINK * step;
    if ((there - back) * (there - back) < NOTHING * 8 * loss)
        return 0;
    double least = step * (there - back) / (2 * loss);
    return copysign(real_max(fabs(least), SHORTEST), least);
}

/* Tries a step in its direction, then the opposite one; adapts it. */
#define TRY(step, trial)                                                                                               \
    do {                                                                                                               \
        double there;                                                                                                  \
        if (trial(step))                                                                                               \
            (step) = copysign(real_min(2 * fabs(step), LONGEST), step);                                                \
        else if (there = hasten->gained, trial(-(step)))                                                               \
            (step) = -(step);                                                                                          \
        else                                                                                                           \
            (step) = next_step(step, there, hasten->gained);                                                           \
    } while (0)

typedef struct Steps {
    double *bumps;                /* (LEVELS x SKEWS x count) m */
    double (*joints)[REACHES][5]; /* m or rad: along, across, both headings, in, out */
    double end[REACHES];          /* m */
} Steps;

static void sweep_bumps(Hasten *hasten, Steps *steps, int round) {
    Way *way = hasten->way;
    /* while centring, short bumps hardly move the body's sides, and sweep_shifts makes long moves */
    bool centring = hasten->course.centring;
    int least = centring ? LEAST_CENTRING : 0, most = centring ? LONG_LEVEL - 1 : LEVELS - 1;
    for (int trial = SKEWS * (most + 1) - 1; trial >= SKEWS * least; trial--) {
        int level = trial / SKEWS, skew = trial % SKEWS;
        if (skew > 0 && level < LEAST_SKEWED)
            continue;
        hasten->worth = level < LONG_LEVEL ? GAIN : LONG_GAIN;
        int half = SHORTEST_BUMP << level, steep = half / STEEPER;
        size_t stride = (size_t)half / 2;
        for (size_t k = 0; k < way->piece_count; k++) {
            const WayPiece *piece = &way->pieces[k];
            if (piece->last - piece->first < (size_t)half)
                continue;
            for (size_t s = piece->first + 1 + (size_t)round % stride; s < piece->last; s += stride) {
                double *step = &steps->bumps[(size_t)trial * way->count + s];
                size_t low = s >= piece->first + (size_t)half ? s - (size_t)half : piece->first;
                size_t high = s + (size_t)half <= piece->last ? s + (size_t)half : piece->last;
                if (fabs(*step) < SHORTEST || is_at_best(hasten, low, high) ||
                    (skew > 0 && !is_stopped(hasten, low, high)))
                    continue;
#define BUMP(by) try_bump(hasten, s, skew == 1 ? steep : half, skew == 2 ? steep : half, by)
                TRY(*step, BUMP);
#undef BUMP
            }
        }
    }
    hasten->worth = GAIN;
}

static void sweep_joints(Hasten *hasten, Steps *steps) {
    Way *way = hasten->way;
    for (size_t k = 0; k < way->piece_count; k++)
        for (int r = 0; r < REACHES; r++) {
            double *step = steps->joints[k][r];
            const Joint *joint = &way->joints[k];
            Vec2 along = vec2_heading(joint->in), across = vec2_left(along), none = {0, 0};
#define ALONG(by) try_joint(hasten, k, joint_reaches[r], vec2_scale(along, by), 0, false, false)
#define ACROSS(by) try_joint(hasten, k, joint_reaches[r], vec2_scale(across, by), 0, false, false)
#define BOTH(by) try_joint(hasten, k, joint_reaches[r], none, by, true, true)
#define IN(by) try_joint(hasten, k, joint_reaches[r], none, by, true, false)
#define OUT(by) try_joint(hasten, k, joint_reaches[r], none, by, false, true)
            if (k > 0 && fabs(step[0]) >= SHORTEST)
                TRY(step[0], ALONG);
            if (k > 0 && fabs(step[1]) >= SHORTEST)
                TRY(step[1], ACROSS);
            if (k > 0 && fabs(step[2]) >= SHORTEST)
                TRY(step[2], BOTH);
            if (k > 0 && joint->turns && fabs(step[3]) >= SHORTEST)
                TRY(step[3], IN);
            if (joint->turns && fabs(step[4]) >= SHORTEST)
                TRY(step[4], OUT);
#undef ALONG
#undef ACROSS
#undef BOTH
#undef IN
#undef OUT
        }
}

static void sweep_end(Hasten *hasten, Steps *steps) {
    for (int r = 0; r < REACHES; r++) {
#define END(by) try_end(hasten, 2 * joint_reaches[r], by)
        if (fabs(steps->end[r]) >= SHORTEST)
            TRY(steps->end[r], END);
#undef END
    }
}

/* Takes a way, of which nothing is too near yet: the margin is set by who makes trials. */
static void hasten_begin(Hasten *hasten, Way *way, const FreeSpace *space, const Rectangle *body,
                         const Profile *profile, bool centring) {
    size_t count = way->count, first, last;
    *hasten = (Hasten){.way = way,
                       .course = {.way = way,
                                  .space = space,
                                  .body = body,
                                  .profile = profile,
                                  .agility = pace_agility(profile),
                                  .margin = -HUGE_VAL,
                                  .sight = fmax(pace_enough(profile), centring ? profile->space_reach : FIELD_COMFORT),
                                  .centring = centring},
                       .now = speeds_make(count),
                       .tried = speeds_make(count),
                       .kept = memory_zeroed(count, sizeof(Station)),
                       .worth = GAIN};
    speeds_look(&hasten->course, &hasten->now, &hasten->now, 0, count - 1);
    speeds_run(&hasten->course, &hasten->now, &hasten->now, 0, count - 1, &first, &last);
    hasten->sum = speeds_sum(hasten->now.cost, 0, count - 1);
}

static void hasten_end(Hasten *hasten) {
    speeds_free(&hasten->now);
    speeds_free(&hasten->tried);
    memory_free(hasten->kept);
}

/* Returns the time of the whole way, s. */
static double whole_time(const Hasten *hasten) {
    double time = speeds_sum(hasten->now.time, 0, hasten->way->count - 1);
    for (size_t k = 0; k < hasten->way->piece_count; k++)
        time += speeds_at_joint(&hasten->course, k);
    return time;
}

double hasten_time(const Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile) {
    Way copy = way_copy(way);
    Hasten hasten;
    hasten_begin(&hasten, &copy, space, body, profile, false);
    double time = whole_time(&hasten);
    hasten_end(&hasten);
    way_free(&copy);
    return time;
}

/* Makes trials at all places, again and again while the sum falls. Returns false if interrupted. */
static bool descend(Hasten *hasten, int sweeps, const Stop *stop) {
    const Way *way = hasten->way;
    Steps steps = {.bumps = memory_zeroed((size_t)(LEVELS * SKEWS) * way->count, sizeof(double)),
                   .joints = memory_zeroed(way->piece_count, sizeof *steps.joints)};
    for (size_t i = 0; i < (size_t)(LEVELS * SKEWS) * way->count; i++)
        steps.bumps[i] = FIRST;
    for (size_t k = 0; k < way->piece_count; k++)
        for (int r = 0; r < REACHES; r++)
            for (int d = 0; d < 5; d++)
                steps.joints[k][r][d] = FIRST;
    for (int r = 0; r < REACHES; r++)
        steps.end[r] = FIRST;
    bool whole = true;
    for (int round = 0; round < sweeps && whole; round++) {
        double before = hasten->sum;
        if (hasten->course.centring)
            sweep_shifts(hasten);
        sweep_bumps(hasten, &steps, round);
        if (!hasten->course.centring)
            sweep_joints(hasten, &steps);
        sweep_end(hasten, &steps);
        whole = !stop_requested(stop);
        if (before - hasten->sum < 1e-4 * before)
            break;
    }
    memory_free(steps.bumps);
    memory_free(steps.joints);
    return whole;
}

static bool improve(Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile, bool centring,
                    double margin, int sweeps, const Stop *stop) {
    Hasten hasten;
    hasten_begin(&hasten, way, space, body, profile, centring);
    hasten.course.margin = margin;
    hasten.spare = CENTRED * whole_time(&hasten);
    bool whole = descend(&hasten, sweeps, stop);
    hasten_end(&hasten);
    return whole;
}

bool hasten_way(Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile, double margin,
                int sweeps, const Stop *stop) {
    return improve(way, space, body, profile, false, margin, sweeps, stop);
}

bool hasten_centre(Way *way, const FreeSpace *space, const Rectangle *body, const Profile *profile, double margin,
                   int sweeps, const Stop *stop) {
    return improve(way, space, body, profile, true, margin, sweeps, stop);
}
