#include "route/way.h"

#include <string.h>

#include "base/digest.h"
#include "base/memory.h"
#include "base/real.h"
#include "plan/plan_geometry.h"

#define HAIR 0.02            /* m: the way ends this far behind the exit's line */
#define EXIT_END 1e-3        /* m: and at least this far from the line's ends */
#define SPOT_STEP radians(5) /* rad, between poses on the spot */
#define SPOT_FINEST 0.002    /* rad, least step between the headings at which a turn on the spot is measured */
#define SHORTEST_MOTION 1e-6 /* m: a motion that is not worth a piece */
#define LITTLE 5e-4          /* m: a body that turns and moves by less comes no nearer */
#define LITTLE_TURN 0.012    /* rad, which moves a corner of the body by a centimetre */
#define MOST_TURN 0.25       /* rad, of a step */
#define LEAST_STEP 0.4       /* 1, of the piece's step */
#define MOST_STEP 2.0        /* 1 */
#define MOST_SLIP 0.05       /* 1, of a step to the side of the body */
#define FINEST 1e-4          /* m: motions are not halved further than this */

static void add_station(Way *way, size_t *capacity, const Pose *pose) {
    way->stations = memory_reserve(way->stations, capacity, way->count + 1, sizeof *way->stations);
    way->stations[way->count++] = (Station){pose->at, vec2_heading(pose->heading), way->piece_count - 1};
}

/* Makes each run of motions in one direction a piece, whose stations are the poses as they are. */
static void add_pieces(Way *way, const SearchTrack *track) {
    size_t capacity = 0, piece_capacity = 0, joint_capacity = 0;
    double in = track->poses[0].heading;
    for (size_t low = 0; low + 1 < track->count;) {
        size_t high = low + 1;
        int direction = track->poses[high].direction;
        double length = vec2_distance(track->poses[low].at, track->poses[high].at);
        for (; high + 1 < track->count && track->poses[high + 1].direction == direction; high++)
            length += vec2_distance(track->poses[high].at, track->poses[high + 1].at);
        if (direction != 0 && length > SHORTEST_MOTION) {
            size_t k = way->piece_count++;
            way->pieces = memory_reserve(way->pieces, &piece_capacity, k + 1, sizeof *way->pieces);
            way->joints = memory_reserve(way->joints, &joint_capacity, k + 1, sizeof *way->joints);
            double out = track->poses[low].heading;
            way->joints[k] = (Joint){in, out, fabs(out - in) > 1e-9};
            way->pieces[k] = (WayPiece){.first = way->count, .direction = direction, .step = length};
            for (size_t i = low; i <= high; i++)
                add_station(way, &capacity, &track->poses[i]);
            way->pieces[k].last = way->count - 1;
            in = track->poses[high].heading;
        }
        low = high;
    }
}

/* Puts the last station on the line, a hair behind it, and drops those beyond. */
static void end_behind(Way *way) {
    const Exit *exit = way->exit;
    Vec2 along = vec2_unit(vec2_sub(exit->to, exit->from)), out = vec2_left(along);
    WayPiece *piece = &way->pieces[way->piece_count - 1];
    while (piece->last > piece->first + 1 &&
           !plan_geometry_leads_out(exit, way->stations[piece->last - 1].at, way->stations[piece->last].at))
        piece->last--;
    way->count = piece->last + 1;
    Station *end = &way->stations[piece->last];
    const Station *before = &way->stations[piece->last - 1];
    double low, high, side = vec2_dot(out, vec2_sub(end->at, before->at)) < 0 ? -1 : 1;
    double ahead = vec2_dot(out, vec2_sub(end->at, exit->from)), back = vec2_dot(out, vec2_sub(before->at, exit->from));
    double part = ahead != back ? real_clamp((side * HAIR - back) / (ahead - back), 0, 1) : 1;
    Vec2 crossing = vec2_along(before->at, part, vec2_sub(end->at, before->at));
    way_exit_range(way, &low, &high);
    double at = real_clamp(vec2_dot(along, vec2_sub(crossing, exit->from)), low, high);
    end->at = vec2_along(vec2_along(exit->from, at, along), side * HAIR, out);
}

Way way_of_track(const SearchTrack *track, const Exit *exit, const Goal *pins, size_t pin_count, double spacing) {
    Way way = {.exit = exit};
    add_pieces(&way, track);
    if (!way.piece_count)
        return way;
    way.pin_count = pin_count;
    way.pins = memory_zeroed(pin_count, sizeof *way.pins);
    for (size_t p = 0; p < pin_count; p++)
        way.pins[p] = (WayPin){.at = pins[p].at, .radius = pins[p].radius};
    end_behind(&way);
    way_resample(&way, spacing);
    for (size_t k = 0; k < way.piece_count; k++)
        if (!(way.pieces[k].step > SHORTEST_MOTION)) {
            way_free(&way);
            break;
        }
    return way;
}

static double piece_length(const Way *way, const WayPiece *piece) {
    double length = 0;
    for (size_t s = piece->first; s < piece->last; s++)
        length += vec2_distance(way->stations[s].at, way->stations[s + 1].at);
    return length;
}

static void *copied(const void *block, size_t count, size_t size) {
    void *copy = memory_zeroed(count, size);
    if (count)
        memcpy(copy, block, count * size);
    return copy;
}

Way way_copy(const Way *way) {
    Way copy = *way;
    copy.stations = copied(way->stations, way->count, sizeof *way->stations);
    copy.pieces = copied(way->pieces, way->piece_count, sizeof *way->pieces);
    copy.joints = copied(way->joints, way->piece_count, sizeof *way->joints);
    copy.pins = copied(way->pins, way->pin_count, sizeof *way->pins);
    return copy;
}

uint64_t way_digest(const Way *way) {
    uint64_t digest = DIGEST_START;
    for (size_t s = 0; s < way->count; s++)
        digest = digest_pair(digest_pair(digest, way->stations[s].at), way->stations[s].axis);
    for (size_t k = 0; k < way->piece_count; k++) {
        const Joint *joint = &way->joints[k];
        digest = digest_mix(digest, (double)way->pieces[k].first);
        digest = digest_mix(digest, way->pieces[k].direction);
        digest = digest_mix(digest_pair(digest, vec2(joint->in, joint->out)), joint->turns);
    }
    return digest;
}

bool way_join(Way *way) {
    size_t joined = 0;
    for (size_t k = 1; k < way->piece_count; k++) {
        WayPiece *last = &way->pieces[joined], *piece = &way->pieces[k];
        if (piece->direction == last->direction) {
            last->last = piece->last;
        } else {
            way->joints[++joined] = way->joints[k];
            way->pieces[joined] = *piece;
        }
    }
    bool any = joined + 1 < way->piece_count;
    way->piece_count = joined + 1;
    return any;
}

bool way_straighten_cusps(Way *way, double share) {
    bool any = false;
    for (size_t k = 1; k < way->piece_count; k++) {
        Joint *joint = &way->joints[k];
        size_t before = way->pieces[k - 1].last, after = way->pieces[k].first;
        if (!joint->turns || way->pieces[k].direction == way->pieces[k - 1].direction)
            continue;
        double heading = joint->in + share * (joint->out - joint->in);
        *joint = (Joint){heading, heading, false};
        way->stations[before].axis = way->stations[after].axis = vec2_heading(heading);
        any = true;
    }
    return any;
}

bool way_drop(Way *way, size_t k, double most) {
    if (k + 1 >= way->piece_count || piece_length(way, &way->pieces[k]) > most)
        return false;
    bool merges = k > 0 && way->pieces[k - 1].direction == way->pieces[k + 1].direction;
    Joint *joint = &way->joints[k];
    const Joint *next = &way->joints[k + 1];
    bool turns = joint->turns || next->turns;
    double heading = k > 0 ? (joint->in + next->out) / 2 : joint->in;
    *joint = turns ? (Joint){joint->in, next->out, true} : (Joint){heading, heading, false};
    size_t first = way->pieces[k].first, after = way->pieces[k + 1].first, gap = after - first;
    if (!merges)
        way->stations[after].at = way->stations[k > 0 ? first - 1 : 0].at;
    memmove(&way->stations[first], &way->stations[after], (way->count - after) * sizeof *way->stations);
    way->count -= gap;
    if (merges)
        way->pieces[k - 1].last = way->pieces[k + 1].last - gap;
    size_t dropped = merges ? 2 : 1;
    for (size_t j = k; j + dropped < way->piece_count; j++) {
        way->pieces[j] = way->pieces[j + dropped];
        way->pieces[j].first -= gap;
        way->pieces[j].last -= gap;
        if (merges || j > k)
            way->joints[j] = way->joints[j + dropped];
    }
    way->piece_count -= dropped;
    return true;
}

void way_free(Way *way) {
    memory_free(way->stations);
    memory_free(way->pieces);
    memory_free(way->joints);
    memory_free(way->pins);
    *way = (Way){0};
}

/* Returns the place on the cubic between two stations. */
static Vec2 between(const Station *a, const Station *b, int direction, double part) {
    double length = vec2_distance(a->at, b->at) * direction, s = part, r = 1 - part;
    Vec2 at = vec2_add(vec2_scale(a->at, r * r * (1 + 2 * s)), vec2_scale(b->at, s * s * (1 + 2 * r)));
    return vec2_along(vec2_along(at, r * r * s * length, a->axis), -s * s * r * length, b->axis);
}

/* Places the inner stations of a piece of `steps` steps along an old one. */
static void space_piece(const Way *old, const WayPiece *from, Station *stations, size_t steps, double step) {
    double passed = 0;
    size_t s = from->first;
    double length = vec2_distance(old->stations[s].at, old->stations[s + 1].at);
    for (size_t i = 1; i < steps; i++) {
        while (s + 2 <= from->last && passed + length < (double)i * step) {
            passed += length;
            s++;
            length = vec2_distance(old->stations[s].at, old->stations[s + 1].at);
        }
        double part = length > 0 ? real_clamp(((double)i * step - passed) / length, 0, 1) : 0;
        stations[i].at = between(&old->stations[s], &old->stations[s + 1], from->direction, part);
    }
}

static void find_pins(Way *way) {
    size_t from = 0;
    for (size_t p = 0; p < way->pin_count; p++) {
        double least = HUGE_VAL;
        for (size_t s = from; s < way->count; s++) {
            double distance = vec2_distance(way->stations[s].at, way->pins[p].at);
            if (distance < least) {
                least = distance;
                way->pins[p].station = s;
            }
            if (least <= way->pins[p].radius && distance > way->pins[p].radius)
                break; /* later it may come by again */
        }
        from = way->pins[p].station;
    }
}

void way_resample(Way *way, double spacing) {
    Way old = *way;
    size_t capacity = 0;
    way->stations = NULL;
    way->count = 0;
    way->pieces = memory_zeroed(old.piece_count, sizeof *way->pieces);
    for (size_t k = 0; k < old.piece_count; k++) {
        const WayPiece *from = &old.pieces[k];
        WayPiece *piece = &way->pieces[k];
        double length = piece_length(&old, from);
        size_t steps = (size_t)fmax(round(length / spacing), WAY_SHORTEST);
        *piece = (WayPiece){way->count, way->count + steps, from->direction, length / (double)steps};
        way->stations = memory_reserve(way->stations, &capacity, way->count + steps + 1, sizeof *way->stations);
        Station *stations = way->stations + way->count;
        for (size_t i = 0; i <= steps; i++)
            stations[i] = (Station){.piece = k};
        stations[0].at = old.stations[from->first].at;
        stations[steps].at = old.stations[from->last].at;
        space_piece(&old, from, stations, steps, piece->step);
        way->count += steps + 1;
    }
    memory_free(old.stations);
    memory_free(old.pieces);
    way_set_axes(way, 0, way->count - 1);
    find_pins(way);
}

void way_set_axes(Way *way, size_t low, size_t high) {
    for (size_t s = low; s <= high; s++) {
        Station *station = &way->stations[s];
        size_t k = station->piece;
        const WayPiece *piece = &way->pieces[k];
        if (s == piece->first)
            station->axis = vec2_heading(way->joints[k].out);
        else if (s == piece->last && k + 1 < way->piece_count)
            station->axis = vec2_heading(way->joints[k + 1].in);
        else
            station->axis =
                vec2_scale(vec2_unit(vec2_sub(station[s < piece->last ? 1 : 0].at, station[-1].at)), piece->direction);
    }
}

Station way_between(const Way *way, size_t station, double part) {
    const Station *a = &way->stations[station], *b = a + 1;
    Vec2 axis = vec2_along(vec2_scale(a->axis, 1 - part), part, b->axis);
    return (Station){between(a, b, way->pieces[a->piece].direction, part), vec2_unit(axis), a->piece};
}

int way_places(const Way *way, size_t station) {
    const Station *a = &way->stations[station];
    int places = (int)(fabs(vec2_cross(a->axis, a[1].axis)) / LITTLE_TURN);
    return places < 1 ? 1 : places > WAY_MOST_BETWEEN ? WAY_MOST_BETWEEN : places;
}

int way_reversals(const Way *way) {
    int count = 0;
    for (size_t k = 1; k < way->piece_count; k++)
        count += way->pieces[k].direction != way->pieces[k - 1].direction;
    return count;
}

bool way_is_smooth(const Way *way, size_t low, size_t high) {
    for (size_t s = low; s < high; s++) {
        const Station *a = &way->stations[s], *b = a + 1;
        if (a->piece != b->piece)
            continue;
        Vec2 motion = vec2_scale(vec2_sub(b->at, a->at), way->pieces[a->piece].direction);
        Vec2 mean = vec2_unit(vec2_add(a->axis, b->axis));
        double along = vec2_dot(mean, motion);
        if (fabs(vec2_cross(mean, motion)) > MOST_SLIP * along || fabs(vec2_cross(a->axis, b->axis)) > MOST_TURN ||
            vec2_dot(a->axis, b->axis) <= 0)
            return false;
    }
    return true;
}

bool way_reaches_goals(const Way *way) {
    for (size_t p = 0; p < way->pin_count; p++)
        if (vec2_distance(way->stations[way->pins[p].station].at, way->pins[p].at) > way->pins[p].radius)
            return false;
    for (size_t s = way->count - 1; s > 0; s--)
        if (plan_geometry_leads_out(way->exit, way->stations[s - 1].at, way->stations[s].at))
            return true;
    return false;
}

void way_exit_range(const Way *way, double *low, double *high) {
    double length = vec2_distance(way->exit->from, way->exit->to);
    *low = fmin(EXIT_END, length / 2);
    *high = length - *low;
}

static double clearance_at(const FreeSpace *space, const Rectangle *body, Vec2 at, Vec2 axis, double reach) {
    return freespace_clearance(space, vec2_along(at, body->ahead, axis), axis, body->half_length, body->half_width,
                               reach, NULL);
}

double way_clearance_between(const Way *way, size_t station, double part, const FreeSpace *space, const Rectangle *body,
                             double reach) {
    Station place = way_between(way, station, part);
    return clearance_at(space, body, place.at, place.axis, reach);
}

bool way_stays_clear(const Way *way, size_t station, const FreeSpace *space, const Rectangle *body, WayPlace from,
                     WayPlace to, double least, double reach) {
    const Station *begin = &way->stations[station];
    double turn = fabs(vec2_cross(begin->axis, begin[1].axis)) * (to.part - from.part);
    double moved = turn * search_farthest(body);
    if (from.clearance + to.clearance - 2 * least >= moved || moved < LITTLE)
        return true;
    double part = (from.part + to.part) / 2;
    WayPlace middle = {part, way_clearance_between(way, station, part, space, body, reach)};
    return middle.clearance >= least && way_stays_clear(way, station, space, body, from, middle, least, reach) &&
           way_stays_clear(way, station, space, body, middle, to, least, reach);
}

double way_clearance(const Way *way, const FreeSpace *space, const Rectangle *body, double reach) {
    double least = reach;
    for (size_t s = 0; s < way->count; s++) {
        const Station *station = &way->stations[s];
        least = fmin(least, clearance_at(space, body, station->at, station->axis, least));
        int places = s < way->pieces[station->piece].last ? way_places(way, s) : 0;
        for (int i = 1; i <= places; i++) {
            Station middle = way_between(way, s, (double)i / (places + 1));
            least = fmin(least, clearance_at(space, body, middle.at, middle.axis, least));
        }
    }
    for (size_t k = 0; k < way->piece_count; k++)
        least = way_spot_clearance(way, k, space, body, least);
    return least;
}

double way_spot_clearance(const Way *way, size_t piece, const FreeSpace *space, const Rectangle *body, double reach) {
    const Joint *joint = &way->joints[piece];
    double turn = joint->turns ? joint->out - joint->in : 0, radius = search_farthest(body), least = reach;
    for (double turned = 0; turned < fabs(turn);) {
        Vec2 axis = vec2_heading(joint->in + copysign(turned, turn));
        double clearance =
            clearance_at(space, body, way->stations[way->pieces[piece].first].at, axis, ROUTE_CLEARANCE_REACH);
        least = fmin(least, clearance);
        turned += fmax((clearance - least) / radius, SPOT_FINEST); /* until here no point of the body can be nearer */
    }
    return least;
}

/* A motion from one pose to another: along the cubic between them, or on the spot. */
typedef struct Motion {
    const FreeSpace *space;
    const Rectangle *body;
    double margin; /* m */
    int direction; /* 0: on the spot */
} Motion;

/* True if the motion between two poses, whose clearances are known, keeps the margin. */
static bool motion_swept(const Motion *motion, const Station *a, double at_a, const Station *b, double at_b) {
    const Rectangle *body = motion->body;
    if (vec2_dot(a->axis, b->axis) <= 0)
        return false;
    double turn = fabs(vec2_angle_between(a->axis, b->axis));
    double reach = 1.05 * vec2_distance(a->at, b->at) + turn * search_farthest(body);
    if (at_a + at_b - 2 * motion->margin >= reach)
        return true;
    if (fmin(at_a, at_b) < motion->margin || !(reach >= FINEST))
        return fmin(at_a, at_b) >= motion->margin;
    Station middle = {motion->direction ? between(a, b, motion->direction, 0.5) : a->at,
                      vec2_unit(vec2_add(a->axis, b->axis)), a->piece};
    double clearance = clearance_at(motion->space, body, middle.at, middle.axis, ROUTE_CLEARANCE_REACH);
    return motion_swept(motion, a, at_a, &middle, clearance) && motion_swept(motion, &middle, clearance, b, at_b);
}

bool way_swept(const Way *way, const FreeSpace *space, const Rectangle *body, double margin) {
    Motion motion = {space, body, margin, 0};
    double before = 0;
    for (size_t s = 0; s < way->count; s++) {
        const Station *station = &way->stations[s];
        double here = clearance_at(space, body, station->at, station->axis, ROUTE_CLEARANCE_REACH);
        if (here < margin)
            return false;
        const WayPiece *piece = &way->pieces[station->piece];
        const Joint *joint = &way->joints[station->piece];
        motion.direction = piece->direction;
        if (s > piece->first && !motion_swept(&motion, station - 1, before, station, here))
            return false;
        before = here;
        if (s > piece->first || !joint->turns)
            continue;
        motion.direction = 0;
        int parts = (int)ceil(fabs(joint->out - joint->in) / SPOT_STEP);
        Station from = {station->at, vec2_heading(joint->in), station->piece};
        double at_from = clearance_at(space, body, from.at, from.axis, ROUTE_CLEARANCE_REACH);
        for (int part = 1; part <= parts; part++) {
            Station to = from;
            to.axis = vec2_heading(joint->in + (joint->out - joint->in) * part / parts);
            double at_to = clearance_at(space, body, to.at, to.axis, ROUTE_CLEARANCE_REACH);
            if (!motion_swept(&motion, &from, at_from, &to, at_to))
                return false;
            from = to;
            at_from = at_to;
        }
    }
    return true;
}

void way_write(const Way *way, SearchTrack *track) {
    double heading = way->joints[0].in;
    track->direction = 0;
    for (size_t s = 0; s < way->count; s++) {
        const Station *station = &way->stations[s];
        const WayPiece *piece = &way->pieces[station->piece];
        const Joint *joint = &way->joints[station->piece];
        if (s == piece->first) {
            int parts = joint->turns ? (int)ceil(fabs(joint->out - joint->in) / SPOT_STEP) : 0;
            for (int part = 1; part <= parts; part++)
                search_track_add(track, (Pose){station->at, heading + (joint->out - joint->in) * part / parts, 0, 0});
            heading += joint->out - joint->in;
            continue;
        }
        heading += vec2_wrap_angle(real_atan2(station->axis.y, station->axis.x) - heading);
        search_track_add(track, (Pose){station->at, heading, 0, piece->direction});
        track->direction = piece->direction;
    }
    track->reversals = way_reversals(way);
}

bool way_stays_even(const Way *way, const Station *before, size_t low, size_t high) {
    for (size_t s = low; s < high; s++) {
        const Station *a = &way->stations[s], *b = a + 1;
        double step = way->pieces[a->piece].step, length = vec2_distance(a->at, b->at);
        double least = LEAST_STEP * step, most = MOST_STEP * step;
        if (a->piece != b->piece || (length >= least && length <= most))
            continue;
        double was = before ? vec2_distance(before[s].at, before[s + 1].at) : 0;
        if (!before || length < fmin(least, was) || length > fmax(most, was))
            return false;
    }
    return true;
}

bool way_is_even(const Way *way, size_t low, size_t high) {
    return way_stays_even(way, NULL, low, high);
}
