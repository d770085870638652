/* A walker follows the direction in which the time to the goal falls (floor_field.h) at the speed
 *
 *     v = min(v_0, s / T)
 *
 *     v_0  free speed, m/s                 s  free path to the nearest body, m
 *     T    time gap, s                     l  sum of both radii, m
 *
 * which is the collision-free speed model of Tordeux, Chraibi and Seyfried (2016): the slope of speed against spacing
 * is what single files of people show. s is measured along the walking direction,
 *
 *                   .-.
 *        me  o--s--( o )            s = x - sqrt(l^2 - y^2) for bodies with |y| < l, x ahead and y across the path,
 *                   '-'             each at its position a moment later
 *
 * and when it is too short to walk freely, other headings to both sides are tried (Moussaid, Helbing and Theraulaz
 * 2011): the one with the most progress is chosen. Straight ahead only people nearer to the goal count: the person
 * ahead goes first. Of two people who meet in front of a door one therefore always goes, and no arch is permanent. The
 * contact law handles pushing. */
#include "house/walk.h"

#include "base/real.h"
#include "house/observation.h"
#include "house/phase.h"
#include "house/world.h"
#include "plan/plan_geometry.h"

/* All constants below are assumed. */

/* s: other people are considered at their positions after this time. */
static const double FORESIGHT = 0.3;
/* m: distance to people ahead or passed. */
static const double BERTH = 0.045;
/* m/s: a chair with at least this speed counts as moving. */
static const double ROLLING = 0.5;
/* m/s: bound of the speed difference until the next decision, so that farther bodies do not matter yet. */
static const double FASTER = 0.6;
/* m: free floor required ahead of a heading to one side. */
static const double STEP = 0.4;
/* 1 and m/s: a heading to one side must exceed the progress of the earlier ones by this factor and this amount. */
static const double BETTER = 1.05, BETTER_BY = 0.10;
/* 1: cosine of the angle to one's path beyond which a person is oncoming, and the share of the free speed that a
 * heading to the left is then worth. */
static const double ONCOMING = -0.5, KEEP_LEFT = 0.3;
/* m: distances ahead, and to either side, at which oncoming people are searched. */
static const double farther[] = {2.5, 4.0, 5.5}, BESIDE = 1.0;
/* s, 1 and m/s: a person held up for HELD turns the shoulders (width x SQUEEZE) and passes oncoming people at up to
 * SQUEEZING. */
static const double HELD = 0.5, SQUEEZE = 0.1, SQUEEZING = 0.5;
/* s: a smaller gain of time does not count as progress. */
static const double PROGRESS = 0.05;
/* m: distance from a shut door's line at which a person reaches the handle. */
static const double ARMS_REACH = 0.45;

/* Headings to the left and right of the path in turn, as cosine and sine. */
enum { HEADINGS = 9 };
static const Vec2 headings[HEADINGS] = {
    {1, 0},
    {0.93969262078590843, 0.34202014332566871},
    {0.93969262078590843, -0.34202014332566871},
    {0.76604444311897801, 0.64278760968653936},
    {0.76604444311897801, -0.64278760968653936},
    {0.5, 0.86602540378443860},
    {0.5, -0.86602540378443860},
    {0.17364817766693041, 0.98480775301220802},
    {0.17364817766693041, -0.98480775301220802},
};

enum { SEEN_MOST = 128 };

/* A disc ahead. */
typedef struct Seen {
    Vec2 at;                 /* m, relative to oneself, a moment later */
    Vec2 now;                /* m, present position */
    double together;         /* m, sum of the radii and the berth */
    bool oncoming;           /* True if it faces the other way */
    signed char seen, first; /* visible, and nearer to the goal: 1, 0, or -1 for not computed yet */
} Seen;

typedef struct View {
    const World *world;
    const FloorField *field;
    Vec2 at, way;
    double radius, time, speed, gap; /* m, s, m/s, s */
    double sight;                    /* m: farther bodies do not matter */
    bool oncoming;                   /* True if a person comes the other way */
    bool squeezes;                   /* True if passing them sideways */
    Seen seen[SEEN_MOST];
    int count;
} View;

/* Adds a disc at `from` relative to oneself that moves with `velocity`, and its berth. */
static void see_disc(View *view, Vec2 from, Vec2 velocity, double radius, double berth, bool oncoming) {
    double together = view->radius + radius + berth, far = view->sight + together;
    view->oncoming |= oncoming && vec2_dot(from, view->way) > 0;
    if (oncoming && view->squeezes)
        together = SQUEEZE * (view->radius + radius);
    if (vec2_dot(from, view->way) >= -together && vec2_dot(from, from) <= far * far && view->count < SEEN_MOST)
        view->seen[view->count++] = (Seen){vec2_along(from, FORESIGHT, velocity), from, together, oncoming, -1, -1};
}

static bool is_seen(const View *view, Seen *seen) {
    if (seen->seen < 0)
        seen->seen = freespace_sees(&view->world->house->space, view->at, vec2_add(view->at, seen->now));
    return seen->seen;
}

static bool goes_first(const View *view, Seen *seen) {
    if (seen->first < 0)
        seen->first = floor_field_time(view->field, vec2_add(view->at, seen->now)) < view->time;
    return seen->first;
}

/* Adds a chair as a row of discs. A moving chair is passed like any person; a waiting chair keeps half of its personal
 * space, so that it has room to turn. */
static void see_chair(View *view, size_t j, Vec2 from) {
    const Body *body = &view->world->body[j];
    Vec2 axis = view->world->axis[j], velocity = view->world->velocity[j];
    double radius = body->half.y + body->radius, ends = real_max(body->half.x + body->radius - radius, 0);
    double berth = vec2_dot(velocity, velocity) > ROLLING * ROLLING ? BERTH : body->reach / 2;
    Vec2 middle = vec2_add(from, vec2_turn(body->middle, axis));
    for (int end = -1; end <= 1; end++)
        if (end == 0 || ends > 0)
            see_disc(view, vec2_along(middle, end * ends, axis), velocity, radius, berth, false);
}

static void look_around(View *view, uint32_t slot) {
    const Walkers *walkers = &view->world->walkers;
    const double far = view->sight + view->radius + walkers->widest + BERTH; /* m */
    CellRange range = cell_grid_around(&walkers->cells, view->at, far + WALKERS_SKIN);
    for (int y = range.y0; y <= range.y1; y++) {
        uint32_t end;
        for (uint32_t s = cell_grid_row(&walkers->cells, &range, y, &end); s < end; s++) {
            const WalkerKind *kind = &walkers->kinds[walkers->kind[s]];
            Vec2 from = vec2_sub(walkers->at[s], view->at);
            uint32_t j = walkers->cells.who[s];
            if (s == slot || vec2_dot(from, from) > far * far)
                continue;
            if (kind->walks)
                see_disc(view, from, walkers->velocity[s], kind->radius, BERTH,
                         vec2_dot(walkers->facing[s], view->way) < ONCOMING);
            else
                see_chair(view, j, from);
        }
    }
}

/* True if a person comes the other way farther ahead. */
static void look_ahead(View *view) {
    const Walkers *walkers = &view->world->walkers;
    for (size_t k = 0; k < sizeof farther / sizeof *farther && !view->oncoming; k++) {
        CellRange range = cell_grid_around(&walkers->cells, vec2_along(view->at, farther[k], view->way), BESIDE);
        for (int y = range.y0; y <= range.y1; y++) {
            uint32_t end;
            for (uint32_t s = cell_grid_row(&walkers->cells, &range, y, &end); s < end; s++) {
                Vec2 from = vec2_sub(walkers->at[s], view->at);
                view->oncoming |= vec2_dot(walkers->facing[s], view->way) < ONCOMING &&
                                  fabs(vec2_cross(view->way, from)) < BESIDE && vec2_dot(view->way, from) > 0 &&
                                  freespace_sees(&view->world->house->space, view->at, walkers->at[s]);
            }
        }
    }
}

/* Returns the free path along a heading, m: straight ahead only people who go first count, to one side all people. */
static double free_way(View *view, Vec2 heading, bool straight) {
    double least = view->sight;
    for (int k = 0; k < view->count; k++) {
        Seen *seen = &view->seen[k];
        double ahead = vec2_dot(seen->at, heading), beside = vec2_cross(heading, seen->at);
        double square = seen->together * seen->together - beside * beside;
        if (ahead <= 0 || square <= 0 || ahead - seen->together >= least)
            continue;
        double free = ahead - sqrt(square);
        if (free < least && (!straight || goes_first(view, seen)) && is_seen(view, seen))
            least = free;
    }
    return real_max(least, 0);
}

static double speed_along(View *view, Vec2 heading, bool straight) {
    return real_min(view->speed, free_way(view, heading, straight) / view->gap);
}

/* Returns the velocity with the most progress. Walkers who meet oncoming people keep slightly to the left, as in Japan,
 * so that both streams pass. */
static Vec2 choose(View *view) {
    Vec2 best = view->way;
    double speed = speed_along(view, best, true), good = speed;
    double better = view->oncoming ? 1 : BETTER, by = view->oncoming ? 0 : BETTER_BY;
    double left = view->oncoming ? KEEP_LEFT * view->speed : 0;
    if (speed >= view->speed && !view->oncoming)
        return vec2_scale(best, speed);
    const FreeSpace *space = &view->world->house->space;
    double least = real_min(view->radius, freespace_distance(space, view->at));
    for (int h = 1; h < HEADINGS; h++) {
        if (view->speed * headings[h].x + left <= good * better + by)
            break; /* even if free, this heading and the following ones are no better */
        Vec2 heading = vec2_turn(headings[h], view->way);
        double along = speed_along(view, heading, false), made = along * headings[h].x;
        if (headings[h].y > 0 && along > 0)
            made += left;
        if (made > good * better + by && freespace_distance(space, vec2_along(view->at, STEP, heading)) >= least) {
            best = heading;
            speed = along;
            good = made;
        }
    }
    return vec2_scale(best, speed);
}

static Vec2 slower(Vec2 velocity, double most) {
    double speed = vec2_length(velocity);
    return speed > most ? vec2_scale(velocity, most / speed) : velocity;
}

/* True if the path from a place crosses the line within arm's reach. */
static bool leads_across(Vec2 at, Vec2 way, double reach, Vec2 from, Vec2 to) {
    Vec2 end = vec2_along(at, reach, way), line = vec2_sub(to, from);
    return (vec2_cross(line, vec2_sub(at, from)) < 0) != (vec2_cross(line, vec2_sub(end, from)) < 0) &&
           (vec2_cross(way, vec2_sub(from, at)) < 0) != (vec2_cross(way, vec2_sub(to, at)) < 0);
}

/* Returns the shut door that the path leads through within arm's reach, or -1. */
static int door_ahead(const World *world, Vec2 at, Vec2 way, double reach) {
    const Plan *plan = &world->house->plan;
    for (size_t d = 0; world->shut_doors && d < plan->door_count; d++) {
        Vec2 from, to;
        plan_geometry_door_ends(plan, &plan->doors[d], &from, &to);
        if (!world->door_open[d] && leads_across(at, way, reach, from, to))
            return (int)d;
    }
    return -1;
}

/* True if the path leads across an exit that is not open now. People there wait for it, or turn when it has closed. */
static bool exit_is_shut(const World *world, Vec2 at, Vec2 way, double reach) {
    const Plan *plan = &world->house->plan;
    double time = clock_time(&world->clock);
    for (size_t e = 0; e < plan->exit_count; e++) {
        const Exit *exit = &plan->exits[e];
        bool begins_on_it = plan_geometry_side(exit, at) == 0; /* whom it does not hold */
        if (!begins_on_it && plan_geometry_leads_out(exit, at, vec2_along(at, reach, way)) &&
            plan_geometry_bars(plan, e, time))
            return true;
    }
    return false;
}

/* Holds a shut door's handle and waits. Opening a door counts as progress; waiting for space for its leaf does not. */
static void stand_before(const World *world, Walk *walk, const View *view) {
    double reach = view->radius + ARMS_REACH;
    int door = door_ahead(world, view->at, view->way, reach);
    walk->handle = door >= 0 && door == walk->door ? walk->handle + WALK_PERIOD : 0;
    walk->door = door;
    if (door >= 0 && walk->handle < world->house->plan.doors[door].opening_time)
        walk->stalled = 0;
    if (door >= 0 || exit_is_shut(world, view->at, view->way, reach))
        walk->wish = vec2(0, 0);
}

static void watch_progress(const World *world, Walk *walk, double time) {
    if (time < walk->best - PROGRESS || walk->departures != world->departures ||
        clock_time(&world->clock) < world->last_opening) {
        walk->best = real_min(walk->best, time);
        walk->departures = world->departures;
        walk->stalled = 0;
    } else {
        walk->stalled += WALK_PERIOD;
    }
}

void walk_decide(World *world, size_t i, uint32_t slot) {
    const Journey *journey = &world->journeys[i];
    const Inhabitant *person = &world->house->people[i];
    const Walkers *walkers = &world->walkers;
    Walk *walk = &world->walk[i];
    View view = {.world = world,
                 .field = journey->legs[walk->leg],
                 .at = walkers->at[slot],
                 .radius = person->profile->width / 2,
                 .speed = person->speed,
                 .gap = person->profile->time_gap};
    view.squeezes = walk->held > HELD;
    double soon = real_min(view.speed, vec2_length(walkers->velocity[slot]) + FASTER);
    view.sight = soon * view.gap + view.speed * FORESIGHT;
    while ((size_t)walk->leg + 1 < journey->leg_count &&
           vec2_distance(view.at, view.field->goal.at) <= view.field->goal.radius &&
           freespace_sees(&world->house->space, view.at, view.field->goal.at)) {
        view.field = journey->legs[++walk->leg];
        walk->best = HUGE_VAL;
    }
    if (walk->stalled > world->house->plan.run.patience) {
        phase_give_up(world, i, REASON_BLOCKED);
        return;
    }
    view.way = floor_field_direction(view.field, view.at);
    view.time = floor_field_time(view.field, view.at);
    watch_progress(world, walk, view.time);
    look_around(&view, slot);
    look_ahead(&view);
    walk->wish = vec2_dot(view.way, view.way) > 0 ? choose(&view) : vec2(0, 0);
    if (view.squeezes && view.oncoming)
        walk->wish = slower(walk->wish, SQUEEZING);
    walk->held = vec2_length(walkers->velocity[slot]) < SQUEEZING / 2 ? walk->held + WALK_PERIOD : 0;
    stand_before(world, walk, &view);
    if (vec2_dot(walk->wish, walk->wish) > 0) {
        world->axis[i] = vec2_unit(walk->wish);
        world->heading[i] = real_atan2(world->axis[i].y, world->axis[i].x);
    }
}
