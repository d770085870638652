#include "route/speeds.h"

#include <string.h>

#include "base/memory.h"
#include "base/real.h"
#include "route/field.h"
#include "route/foresight.h"
#include "route/pace.h"
#include "space/passage.h"

/* At each station the pace (pace.h) gives a limit for the speed; the largest speed that keeps it, starts from rest,
 * rests at joints, and needs no more than the initial acceleration a_0 and the planned deceleration a_d, both within
 * the driver's strength, follows by one pass from the end and one from the beginning. Then
 *
 *     T = sum of 2 h / (v_i + v_(i+1)) + |turns on the spot| / turn rate + changes of direction * their time
 *
 * The pace takes the greatest of the curvature averaged over four steps and of those of the two steps at the station,
 * and the greater of the average's change and, at PACE_OWN_MOMENT, that from step to step, as on the way (track.c).
 *
 * What a step costs has two prices beside its time: near obstacles time counts more, half as much as in the search
 * (field_discomfort), and the change of the turn from step to step, of which the averages see little, costs
 * ROUGHNESS. While the way is centred, the pressed personal space has its price (pace_price), too. */

#define PRICE 0.5     /* 1, share of the search's price of discomfort: more costs more than 3 % of the time */
#define ROUGHNESS 5.0 /* s/rad2 */
/* s/rad2, while the way is centred: the price of the personal space ends at its reach, where bumps leave edges. */
#define CENTRED_ROUGHNESS 100.0
#define BETWEEN 0.06  /* m: with more clearance than this at both ends the motion between is not looked at */
#define DIP 0.85      /* 1, share of the margin that is kept between the places that are looked at */
#define SHORTEST 5e-3 /* m: steps are not taken as shorter, as on the way (track.c) */

enum {
    ROOMS = 17,
    SPAN = 2 /* stations on either side of one over which its curvature is the mean */
};

Speeds speeds_make(size_t count) {
    double *room = memory_zeroed(ROOMS * count, sizeof(double));
    return (Speeds){room,
                    room + count,
                    room + 2 * count,
                    room + 3 * count,
                    room + 4 * count,
                    room + 5 * count,
                    room + 6 * count,
                    room + 7 * count,
                    room + 8 * count,
                    room + 9 * count,
                    room + 10 * count,
                    room + 11 * count,
                    room + 12 * count,
                    room + 13 * count,
                    room + 14 * count,
                    room + 15 * count,
                    room + 16 * count};
}

void speeds_free(Speeds *speeds) {
    memory_free(speeds->own); /* where the room of all of them begins */
    *speeds = (Speeds){0};
}

static double body_clearance(const Course *course, const Station *station, double reach) {
    return freespace_clearance(course->space, vec2_along(station->at, course->body->ahead, station->axis),
                               station->axis, course->body->half_length, course->body->half_width, reach, NULL);
}

static bool rests(const Way *way, size_t s) {
    size_t k = way->stations[s].piece;
    return s == way->pieces[k].first || (s == way->pieces[k].last && k + 1 < way->piece_count);
}

double speeds_turn(const Speeds *speeds, size_t a, size_t b) {
    return vec2_wrap_angle(speeds->heading[b] - speeds->heading[a]);
}

/* Returns the length of the step from a station to the next one of its piece, m. */
static double step_length(const Way *way, size_t s) {
    return vec2_distance(way->stations[s].at, way->stations[s + 1].at);
}

/* Returns the length of the steps between two stations of a piece, m. */
static double length_between(const Speeds *speeds, size_t low, size_t high) {
    double length = 0;
    for (size_t s = low; s < high; s++)
        length += speeds->length[s];
    return real_max(length, SHORTEST);
}

/* True if the step from a station to the next one of its piece is too short, or too sharp, to be rolled: it is turned
 * on the spot, as on the way (track.c). */
static bool is_turned(const Course *course, const Speeds *speeds, size_t s) {
    const WayPiece *piece = &course->way->pieces[course->way->stations[s].piece];
    double length = speeds->length[s];
    return (length < SHORTEST && (s == piece->first || s + 1 == piece->last)) ||
           fabs(speeds_turn(speeds, s, s + 1)) > length * course->agility.sharpest;
}

/* Finds the first and the last station over which the curvature at a station is the mean: SPAN to either side, but not
 * beyond a turn at an end of the piece. */
static void find_span(const Course *course, const Speeds *speeds, size_t s, size_t *low, size_t *high) {
    const WayPiece *piece = &course->way->pieces[course->way->stations[s].piece];
    *low = s >= piece->first + SPAN ? s - SPAN : piece->first;
    *high = s + SPAN <= piece->last ? s + SPAN : piece->last;
    if (*low == piece->first && s > *low && is_turned(course, speeds, *low))
        ++*low;
    if (*high == piece->last && s < *high && is_turned(course, speeds, *high - 1))
        --*high;
}

/* Returns the curvature at a station, rad/m. */
static double mean_curvature(const Course *course, const Speeds *speeds, size_t s) {
    size_t low, high;
    find_span(course, speeds, s, &low, &high);
    return speeds_turn(speeds, low, high) / length_between(speeds, low, high);
}

/* Returns the station `steps` before one, or after it, or the first or last one. */
static size_t before(size_t station, size_t steps) {
    return station > steps ? station - steps : 0;
}

static size_t after(const Way *way, size_t station, size_t steps) {
    return station + steps < way->count ? station + steps : way->count - 1;
}

static size_t lesser(size_t a, size_t b) {
    return a < b ? a : b;
}

static size_t greater(size_t a, size_t b) {
    return a > b ? a : b;
}

/* Returns the last station on one side (-1: before) that sees the passage at a station, or is seen from there: the one
 * that is next beyond the reach is seen, too, and begins at most two steps before it. */
static size_t in_sight(const Way *way, size_t station, int side) {
    double passed = 0;
    size_t s = station;
    for (int step = 0; passed <= FORESIGHT_REACH && (side > 0 ? s + 1 < way->count : s > 0); step++) {
        size_t next = side > 0 ? s + 1 : s - 1;
        passed += step < 2 ? 0 : vec2_distance(way->stations[s].at, way->stations[next].at);
        s = next;
    }
    return s;
}

/* True if the passage limits the speed at one of some stations. */
static bool is_narrow(const Speeds *speeds, size_t begin, size_t end) {
    bool narrow = false;
    for (size_t s = begin; s <= end; s++)
        narrow |= speeds->room_left[s] < HUGE_VAL;
    return narrow;
}

/* Finds the stations whose limits change where the stations begin to end have moved. */
static void find_range(const Course *course, const Speeds *from, const Speeds *to, size_t begin, size_t end,
                       size_t *low, size_t *high) {
    const Way *way = course->way;
    size_t first = in_sight(way, begin, -1), last = in_sight(way, end, 1);
    *low = before(begin, 2 * SPAN);
    *high = after(way, end, 2 * SPAN);
    if (is_narrow(from, first, last) || is_narrow(to, begin, end)) {
        *low = lesser(*low, first);
        *high = greater(*high, last);
    }
}

/* Returns the room beside the middle of the body up to which a passage can limit the speed, m. */
static double most_room(const Profile *profile) {
    return profile->width / 2 + 2 * pace_enough(profile);
}

/* Returns the room beside the middle of the body at a station, m; infinite where the clearance tells that it does not
 * limit the speed. */
static Passage find_room(const Course *course, const Station *station, double clearance) {
    const Profile *profile = course->profile;
    if (clearance >= pace_enough(profile))
        return (Passage){HUGE_VAL, HUGE_VAL};
    Vec2 middle = vec2_along(station->at, course->body->ahead, station->axis);
    return passage_within(course->space, middle, station->axis, most_room(profile));
}

/* The step from a station to the next one of its piece. */
typedef struct Step {
    const Course *course;
    size_t station;
} Step;

static double width_in_step(const void *context, double part) {
    const Step *step = context;
    const Course *course = step->course;
    Station between = way_between(course->way, step->station, part);
    Vec2 middle = vec2_along(between.at, course->body->ahead, between.axis);
    return passage_width(passage_within(course->space, middle, between.axis, most_room(course->profile)));
}

/* Returns the width of the passage at a station, m, as far as it limits the speed. */
static double limiting_width(const Course *course, const Speeds *speeds, size_t s) {
    double most = most_room(course->profile);
    return real_min(speeds->room_left[s], most) + real_min(speeds->room_right[s], most);
}

static double find_edge(const Course *course, const Speeds *speeds, size_t s) {
    return foresight_edge(limiting_width(course, speeds, s), limiting_width(course, speeds, s + 1), width_in_step,
                          &(Step){course, s});
}

/* Fills in what limits the speed at a station and on its way from and to it; the curvatures about it are known. */
static void find_limit(const Course *course, Speeds *speeds, size_t s) {
    const Profile *profile = course->profile;
    double clearance = speeds->clearance[s];
    speeds->braking[s] = pace_braking(profile, clearance);
    speeds->starting[s] = pace_starting(profile, clearance);
    speeds->limit[s] = 0;
    const WayPiece *piece = &course->way->pieces[course->way->stations[s].piece];
    if (rests(course->way, s) || (s > piece->first && is_turned(course, speeds, s - 1)) ||
        (s < piece->last && is_turned(course, speeds, s)))
        return;
    size_t low, high;
    find_span(course, speeds, s, &low, &high);
    double bend = speeds->bend[s], sharpest = fabs(bend);
    double bending = fabs(speeds->bend[high] - speeds->bend[low]) / length_between(speeds, low, high);
    double before_it = s > piece->first ? length_between(speeds, s - 1, s) : 0;
    double after_it = s < piece->last ? length_between(speeds, s, s + 1) : 0;
    double slope_before = before_it > 0 ? speeds_turn(speeds, s - 1, s) / before_it : 0;
    double slope_after = after_it > 0 ? speeds_turn(speeds, s, s + 1) / after_it : 0;
    sharpest = real_max(sharpest, real_max(fabs(slope_before), fabs(slope_after)));
    if (before_it > 0 && after_it > 0) {
        double own = 2 * (slope_after - slope_before) / (before_it + after_it);
        bending = real_max(bending, fabs(own) * (PACE_MOMENT / PACE_OWN_MOMENT));
    }
    double in_bend = pace_in_bend(course->agility.acceleration, bend);
    speeds->braking[s] = real_min(speeds->braking[s], in_bend);
    speeds->starting[s] = real_min(speeds->starting[s], in_bend);
    Foresight foresight = {speeds->room_left, speeds->room_right, speeds->heading,
                           speeds->length,    speeds->edge,       course->way->count};
    double passage =
        foresight_speed(&foresight, s, profile, profile->free_speed, speeds->starting[s], speeds->braking[s]);
    speeds->limit[s] = pace_at(profile, &course->agility, passage, clearance, sharpest, bending, piece->direction);
}

/* Returns the time of the step from a station to the next one, s; from rest to rest it is sped up and slowed down. */
static double time_of_step(const Course *course, const Speeds *speeds, size_t s, double step) {
    double sum = speeds->speed[s] + speeds->speed[s + 1];
    if (is_turned(course, speeds, s))
        return fabs(speeds_turn(speeds, s, s + 1)) / course->profile->turn_rate;
    return sum > 0 ? 2 * step / sum : sqrt(2 * step * (1 / speeds->starting[s] + 1 / speeds->braking[s]));
}

/* Fills in the time and the cost of the step from station s to the next one. */
static void count_step(const Course *course, Speeds *speeds, size_t s) {
    const WayPiece *piece = &course->way->pieces[course->way->stations[s].piece];
    double step = step_length(course->way, s), time = time_of_step(course, speeds, s, step);
    double clearance = real_min(speeds->clearance[s], speeds->clearance[s + 1]);
    double rough = 0, price = 0, weight = course->centring ? CENTRED_ROUGHNESS : ROUGHNESS;
    if (s > piece->first)
        rough = speeds_turn(speeds, s, s + 1) - speeds_turn(speeds, s - 1, s);
    if (course->centring)
        price = (pace_price(course->profile, speeds->left[s], speeds->right[s]) +
                 pace_price(course->profile, speeds->left[s + 1], speeds->right[s + 1])) /
                2;
    speeds->time[s] = time;
    speeds->cost[s] = time * (1 + PRICE * (field_discomfort(clearance) - 1)) + weight * rough * rough + step * price;
}

static double reachable(double speed, double acceleration, double step) {
    return sqrt(speed * speed + 2 * acceleration * step);
}

/* Takes over what a trial has not changed. */
static void take_over(Speeds *to, const Speeds *from, size_t s) {
    to->own[s] = from->own[s];
    to->clearance[s] = from->clearance[s];
    to->left[s] = from->left[s];
    to->right[s] = from->right[s];
    to->room_left[s] = from->room_left[s];
    to->room_right[s] = from->room_right[s];
    to->length[s] = from->length[s];
    to->edge[s] = from->edge[s];
    to->heading[s] = from->heading[s];
    to->braking[s] = from->braking[s];
    to->starting[s] = from->starting[s];
    to->limit[s] = from->limit[s];
}

void speeds_run(const Course *course, const Speeds *from, Speeds *to, size_t begin, size_t end, size_t *first,
                size_t *last) {
    const Way *way = course->way;
    size_t low, high, count = way->count, s;
    find_range(course, from, to, begin, end, &low, &high);
    for (s = before(low, SPAN); s <= after(way, high, SPAN); s++)
        to->bend[s] = mean_curvature(course, to, s);
    for (s = low; s <= high; s++)
        find_limit(course, to, s);
    for (s = high + 1; s-- > 0;) {
        if (s < low)
            take_over(to, from, s);
        double limit = to->limit[s];
        size_t piece = way->stations[s].piece;
        double next = s == high ? s + 1 < count ? from->back[s + 1] : limit : to->back[s + 1];
        if (s < way->pieces[piece].last)
            limit = real_min(limit, reachable(next, to->braking[s], real_max(step_length(way, s), SHORTEST)));
        to->back[s] = limit;
        if (s < low && limit == from->back[s])
            break;
    }
    *first = s < count ? s : 0;
    for (s = *first; s < count; s++) {
        if (s > high) {
            take_over(to, from, s);
            to->back[s] = from->back[s];
        }
        double back = to->back[s];
        const WayPiece *piece = &way->pieces[way->stations[s].piece];
        double slower = s == *first ? s > 0 ? from->speed[s - 1] : 0 : to->speed[s - 1];
        to->speed[s] =
            s > piece->first
                ? real_min(back, reachable(slower, to->starting[s], real_max(step_length(way, s - 1), SHORTEST)))
                : back;
        if (s > high && to->speed[s] == from->speed[s])
            break;
    }
    *last = s < count ? s : count - 1;
    for (s = *first; s < *last; s++)
        if (way->stations[s].piece == way->stations[s + 1].piece)
            count_step(course, to, s);
}

double speeds_at_joint(const Course *course, size_t k) {
    const Way *way = course->way;
    const Joint *joint = &way->joints[k];
    double time = joint->turns ? fabs(joint->out - joint->in) / course->profile->turn_rate : 0;
    if (k > 0 && way->pieces[k].direction != way->pieces[k - 1].direction)
        time += course->profile->reversing_time;
    return time;
}

/* Copies what is known of the places of the stations low to high. */
static void copy_places(const Course *course, Speeds *to, const Speeds *from, size_t low, size_t high) {
    size_t size = (high - low + 1) * sizeof(double);
    if (to == from)
        return;
    if (course->centring) {
        memcpy(to->left + low, from->left + low, size);
        memcpy(to->right + low, from->right + low, size);
    }
    memcpy(to->own + low, from->own + low, size);
    memcpy(to->room_left + low, from->room_left + low, size);
    memcpy(to->room_right + low, from->room_right + low, size);
    memcpy(to->length + low, from->length + low, size);
    memcpy(to->edge + low, from->edge + low, size);
    memcpy(to->clearance + low, from->clearance + low, size);
    memcpy(to->heading + low, from->heading + low, size);
}

bool speeds_look(const Course *course, const Speeds *from, Speeds *to, size_t begin, size_t end) {
    const Way *way = course->way;
    for (size_t s = begin; s <= end; s++) {
        const Station *station = &way->stations[s];
        Vec2 middle = vec2_along(station->at, course->body->ahead, station->axis);
        to->own[s] = course->centring
                         ? freespace_sides(course->space, middle, station->axis, course->body->half_length,
                                           course->body->half_width, course->sight, &to->left[s], &to->right[s])
                         : body_clearance(course, station, course->sight);
        if (to->own[s] < course->margin)
            return false;
        Passage room = find_room(course, station, to->own[s]);
        to->room_left[s] = room.left;
        to->room_right[s] = room.right;
    }
    size_t low, high;
    find_range(course, from, to, begin, end, &low, &high);
    size_t first = lesser(before(low, 2 * SPAN), in_sight(way, low, -1));
    size_t last = greater(after(way, high, 2 * SPAN), in_sight(way, high, 1));
    if (first < begin)
        copy_places(course, to, from, first, begin - 1);
    if (last > end)
        copy_places(course, to, from, end + 1, last);
    for (size_t s = before(begin, 1); s <= end; s++) {
        to->clearance[s] = to->own[s];
        to->length[s] = 0;
        to->edge[s] = 0;
        if (s == way->pieces[way->stations[s].piece].last)
            continue;
        to->length[s] = step_length(way, s);
        to->edge[s] = find_edge(course, to, s);
        double least = real_min(to->own[s], to->own[s + 1]);
        int places = least < BETWEEN ? way_places(way, s) : 0;
        WayPlace before_it = {0, to->own[s]};
        for (int i = 1; i <= places + (places > 0); i++) {
            WayPlace here = {(double)i / (places + 1), to->own[s + 1]};
            if (i <= places)
                here.clearance = way_clearance_between(way, s, here.part, course->space, course->body, BETWEEN);
            least = real_min(least, here.clearance);
            if (least < course->margin ||
                !way_stays_clear(way, s, course->space, course->body, before_it, here, DIP * course->margin, BETWEEN))
                return false;
            before_it = here;
        }
        to->clearance[s] = least;
    }
    for (size_t s = begin; s <= end; s++)
        to->heading[s] = real_atan2(way->stations[s].axis.y, way->stations[s].axis.x);
    return true;
}

void speeds_take(const Course *course, Speeds *to, const Speeds *from, size_t first, size_t last) {
    size_t stations = (last - first + 1) * sizeof(double), steps = (last - first) * sizeof(double);
    copy_places(course, to, from, first, last);
    memcpy(to->braking + first, from->braking + first, stations);
    memcpy(to->starting + first, from->starting + first, stations);
    memcpy(to->limit + first, from->limit + first, stations);
    memcpy(to->back + first, from->back + first, stations);
    memcpy(to->speed + first, from->speed + first, stations);
    memcpy(to->time + first, from->time + first, steps);
    memcpy(to->cost + first, from->cost + first, steps);
}

double speeds_sum(const double *steps, size_t low, size_t high) {
    double sum = 0;
    for (size_t s = low; s < high; s++)
        sum += steps[s];
    return sum;
}
