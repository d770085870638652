#include "route/field.h"

#include <pthread.h>
#include <stdint.h>

#include "base/memory.h"
#include "plan/plan_geometry.h"
#include "route/buckets.h"
#include "space/outline.h"

/* 1, cells: the grid rounds a disc's place by at most this, so discs pass passages that are this much narrower. */
#define ROUNDING 0.75

/* Cells on either side of a closed door's line that are examined more closely. */
#define DOOR_BAND 2.5

/* m: nobody leaves nearer than this to an end of an exit's line, where a step straight across could miss the line. */
#define EXIT_END 1e-3

/* The lowest speed assumed by the search, m/s, which keeps times finite. */
#define SLOWEST 0.02

/* m: more than sums of distances are rounded by. */
#define ROUNDED 1e-6

/* Below FIELD_COMFORT of clearance, time counts up to 1 + DISCOMFORT times: chosen so that a chair keeps some 5 cm off
 * a wall where there is room, without detours of more than a few metres. */
#define DISCOMFORT 2.0

double field_speed(const Profile *profile, double distance) {
    double free = profile->free_speed, least = fmax(fmin(profile->minimum_speed, free), SLOWEST);
    double room = 2 * distance - profile->width;
    double speed = profile->steering_time > 0 ? room / profile->steering_time : free;
    return speed > free ? free : speed < least ? least : speed;
}

double field_discomfort(double clearance) {
    double lack = fmin(fmax(1 - clearance / FIELD_COMFORT, 0), 1);
    return 1 + DISCOMFORT * lack * lack;
}

/* Returns a distance of the nearest obstacle, m, from which on nothing slows a driver down. */
static double free_distance(const Profile *profile) {
    double swift = (profile->free_speed * profile->steering_time + profile->width) / 2;
    return fmax(profile->width / 2 + FIELD_COMFORT, swift) + ROUNDED;
}

static void mark_doors(Ground *ground) {
    const FreeSpace *space = ground->space;
    size_t count = 0;
    for (size_t d = 0; d < ground->plan->door_count; d++)
        count += outline_door_moves(&ground->plan->doors[d]);
    if (!count)
        return;
    ground->lines = memory_zeroed(count, sizeof *ground->lines);
    ground->doors = memory_zeroed((size_t)space->nx * (size_t)space->ny, 1);
    for (size_t d = 0; d < ground->plan->door_count; d++) {
        const Door *door = &ground->plan->doors[d];
        if (!outline_door_moves(door))
            continue;
        DoorLine *line = &ground->lines[ground->line_count++];
        plan_geometry_door_ends(ground->plan, door, &line->from, &line->to);
        line->delay = door->opening_time;
        freespace_mark(space,
                       box_expand(box_include(box_include(box_empty(), line->from), line->to), DOOR_BAND * space->cell),
                       ground->doors);
    }
}

void field_ground_init(Ground *ground, const Plan *plan, const FreeSpace *space, const Profile *profile,
                       double radius) {
    field_ground_init_exact(ground, plan, space, profile, fmax(radius - ROUNDING * space->cell, 0));
}

void field_ground_init_exact(Ground *ground, const Plan *plan, const FreeSpace *space, const Profile *profile,
                             double radius) {
    size_t points = (size_t)space->nx * (size_t)space->ny;
    *ground = (Ground){.plan = plan, .space = space, .profile = profile};
    ground->slowness = memory_zeroed(points, sizeof *ground->slowness);
    double far = fmax(free_distance(profile), radius + ROUNDED);
    ground->free_from = far;
    float least = (float)(1 / profile->free_speed);
    for (size_t i = 0; i < points; i++) {
        double distance = (double)space->distance[i];
        if (distance >= far)
            ground->slowness[i] = least;
        else if (distance > radius)
            ground->slowness[i] =
                (float)(field_discomfort(distance - profile->width / 2) / field_speed(profile, distance));
    }
    mark_doors(ground);
}

/* Gives the columns and rows of the grid that a box touches; none where the last is before the first. */
static void list_points(const FreeSpace *space, Box box, int *first_x, int *last_x, int *first_y, int *last_y) {
    double nx = space->nx, ny = space->ny;
    *first_x = (int)fmin(fmax((box.low.x - space->origin.x) / space->cell, 0), nx);
    *last_x = (int)fmax(fmin((box.high.x - space->origin.x) / space->cell, nx - 1), -1);
    *first_y = (int)fmin(fmax((box.low.y - space->origin.y) / space->cell, 0), ny);
    *last_y = (int)fmax(fmin((box.high.y - space->origin.y) / space->cell, ny - 1), -1);
}

void field_ground_bar(Ground *ground, const FieldBars *bars) {
    const FreeSpace *space = ground->space;
    ground->bars = *bars;
    for (size_t b = 0; b < bars->count; b++) {
        const FieldBar *bar = &bars->all[b];
        int first_x, last_x, first_y, last_y;
        list_points(space, box_around(bar->at, bar->radius), &first_x, &last_x, &first_y, &last_y);
        for (int j = first_y; j <= last_y; j++)
            for (int i = first_x; i <= last_x; i++) {
                Vec2 at = {space->origin.x + i * space->cell, space->origin.y + j * space->cell};
                if (vec2_distance(at, bar->at) <= bar->radius)
                    ground->slowness[(size_t)j * (size_t)space->nx + (size_t)i] = 0;
            }
    }
}

void field_ground_clear(Ground *ground) {
    memory_free(ground->slowness);
    memory_free(ground->doors);
    memory_free(ground->lines);
    *ground = (Ground){0};
}

/* True if the motion from one place to another crosses a door's line. The line belongs to its left side: a path that
 * has a point on it crosses it once. */
static bool crosses(Vec2 from, Vec2 to, Vec2 a, Vec2 b) {
    Vec2 line = vec2_sub(b, a), motion = vec2_sub(to, from);
    double before = vec2_cross(line, vec2_sub(from, a)), after = vec2_cross(line, vec2_sub(to, a));
    if ((before < 0) == (after < 0))
        return false;
    double one = vec2_cross(motion, vec2_sub(a, from)), other = vec2_cross(motion, vec2_sub(b, from));
    return (one <= 0 && other >= 0) || (one >= 0 && other <= 0);
}

/* Returns the grid point nearest to a place, or SIZE_MAX outside. */
static size_t grid_point(const FreeSpace *space, Vec2 at) {
    double x = (at.x - space->origin.x) / space->cell + 0.5, y = (at.y - space->origin.y) / space->cell + 0.5;
    if (!(x >= 0 && y >= 0 && x < space->nx && y < space->ny))
        return SIZE_MAX;
    return (size_t)y * (size_t)space->nx + (size_t)x;
}

double field_delay(const Ground *ground, Vec2 from, Vec2 to) {
    if (!ground->doors)
        return 0;
    size_t one = grid_point(ground->space, from), other = grid_point(ground->space, to);
    if ((one == SIZE_MAX || !ground->doors[one]) && (other == SIZE_MAX || !ground->doors[other]))
        return 0;
    double delay = 0;
    for (size_t i = 0; i < ground->line_count; i++)
        if (crosses(from, to, ground->lines[i].from, ground->lines[i].to))
            delay += ground->lines[i].delay;
    return delay;
}

bool field_exit_usable(const Goal *goal, const Plan *plan, size_t exit) {
    return (goal->exit == SIZE_MAX || goal->exit == exit) && plan->exits[exit].closes > goal->time &&
           !(goal->opens_before > 0 && plan->exits[exit].opens >= goal->opens_before);
}

Goal field_exit_goal(size_t exit, double time, double opens_before) {
    return (Goal){.exit = exit, .time = time, .opens_before = opens_before};
}

bool field_goal_reached(const Goal *goal, const Plan *plan, Vec2 from, Vec2 to, size_t *exit) {
    *exit = SIZE_MAX;
    if (goal->radius > 0)
        return vec2_distance(to, goal->at) <= goal->radius;
    for (size_t e = 0; e < plan->exit_count; e++)
        if (field_exit_usable(goal, plan, e) && plan_geometry_leads_out(&plan->exits[e], from, to)) {
            *exit = e;
            return true;
        }
    return false;
}

/* A step from a grid point to one of 16 around it. */
typedef struct Move {
    int x, y;
    float length;         /* m, half of it: the slowness is the sum of those at both ends */
    float in_the_open;    /* s, that it takes where nothing slows a driver down */
    ptrdiff_t to;         /* from the point to there, in points of the grid */
    ptrdiff_t half, rest; /* to the two points between which a knight's move passes, which must be free; 0: neither */
} Move;

enum { MOVES = 16, MOVE_REACH = 2 /* cells */ };

/* Lists the moves by their angle. */
static void list_moves(Move moves[MOVES], int nx, double cell, float least) {
    static const signed char steps[MOVES][2] = {{1, 0},  {2, 1},  {1, 1},  {1, 2},   {0, 1},   {-1, 2},
                                                {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2},
                                                {0, -1}, {1, -2}, {1, -1}, {2, -1}};
    for (int m = 0; m < MOVES; m++) {
        int x = steps[m][0], y = steps[m][1], half_x = x / 2, half_y = y / 2;
        float length = (m % 2 ? 2.23607f : m % 4 ? 1.41421f : 1) * (0.5f * (float)cell);
        moves[m] = (Move){x, y, length, length * (least + least), (ptrdiff_t)y * nx + x, 0, 0};
        if (m % 2 == 0)
            continue;
        moves[m].half = (ptrdiff_t)half_y * nx + half_x;
        moves[m].rest = (ptrdiff_t)(y - half_y) * nx + (x - half_x);
    }
}

/* In the open, where nothing within OPEN_REACH cells slows a driver down, a quickest path consists of moves in two
 * neighbouring directions: any two others are longer, by 5 % or more, than moves in directions between them, which lead
 * to the same place past free points. So a point in the open that was reached by a move need only go on by that move
 * and by the two beside it. All times are the same, to the last bit, as with all moves. */
#define OPEN_REACH 4.3

/* The marks of points: CRAMPED unless the point is in the open, and REACHED times one more than the number of the move
 * by which it was last reached. */
enum { CRAMPED = 1, REACHED = 2 };

/* Times spread from the goal in their order, as far as somebody asks. A time is known, and will not change, once the
 * buckets before its own are done. Threads that only read known times need no lock. */
typedef struct Spread {
    const Ground *ground;
    float *time; /* of the field */
    Move moves[MOVES];
    Buckets queue;
    unsigned char *marks; /* (ny x nx) */
    size_t number;        /* of the next bucket */
    float known;          /* s: all times up to this one are known; infinite at the end */
    pthread_mutex_t lock; /* of all but `known` and the known times */
} Spread;

/* 1, share of a bucket's first time, which rounding does not reach. */
#define BEFORE 0.999999

static void seed_point(Spread *spread, int i, int j) {
    const FreeSpace *space = spread->ground->space;
    if (i < 0 || j < 0 || i >= space->nx || j >= space->ny)
        return;
    size_t point = (size_t)j * (size_t)space->nx + (size_t)i;
    if (spread->ground->slowness[point] > 0 && spread->time[point] > 0) {
        spread->time[point] = 0;
        buckets_put(&spread->queue, (int)point, 0);
    }
}

/* Seeds the points within `reach` m of a line, on it and on both sides, that lie at least `end` m before its ends. */
static void seed_line(Spread *spread, Vec2 from, Vec2 to, double reach, double end) {
    const FreeSpace *space = spread->ground->space;
    int first_x, last_x, first_y, last_y;
    list_points(space, box_expand(box_include(box_include(box_empty(), from), to), reach), &first_x, &last_x, &first_y,
                &last_y);
    for (int j = first_y; j <= last_y; j++)
        for (int i = first_x; i <= last_x; i++) {
            Vec2 at = {space->origin.x + i * space->cell, space->origin.y + j * space->cell};
            Vec2 on = vec2_nearest_on_segment(at, from, to);
            if (vec2_distance(at, on) <= reach && vec2_distance(on, from) >= end && vec2_distance(on, to) >= end)
                seed_point(spread, i, j);
        }
}

/* Seeds the points about an exit's line, but none that are beyond its ends, unless the line may be too short to have
 * others. */
static void seed_exit(Spread *spread, const Exit *exit) {
    double cell = spread->ground->space->cell;
    bool is_short = vec2_distance(exit->from, exit->to) < 2 * cell;
    seed_line(spread, exit->from, exit->to, cell, is_short ? 0 : EXIT_END);
}

static void mark_cramped(const Spread *spread) {
    const Ground *ground = spread->ground;
    const FreeSpace *space = ground->space;
    int nx = space->nx, ny = space->ny;
    double open = ground->free_from + OPEN_REACH * space->cell;
    for (int j = 0; j < ny; j++) {
        size_t row = (size_t)j * (size_t)nx;
        bool edge = j < MOVE_REACH || j >= ny - MOVE_REACH;
        for (int i = 0; i < nx; i++)
            spread->marks[row + (size_t)i] = edge || (double)space->distance[row + (size_t)i] < open ? CRAMPED : 0;
        for (int i = 0; i < MOVE_REACH && i < nx; i++)
            spread->marks[row + (size_t)i] = spread->marks[row + (size_t)(nx - 1 - i)] = CRAMPED;
    }
    for (size_t i = 0; i < ground->line_count; i++) {
        Box box = box_include(box_include(box_empty(), ground->lines[i].from), ground->lines[i].to);
        freespace_mark(space, box_expand(box, (DOOR_BAND + OPEN_REACH) * space->cell), spread->marks);
    }
    for (size_t b = 0; b < ground->bars.count; b++) {
        const FieldBar *bar = &ground->bars.all[b];
        freespace_mark(space, box_around(bar->at, bar->radius + OPEN_REACH * space->cell), spread->marks);
    }
}

static void reach(Spread *spread, size_t point, int move, float time) {
    unsigned char *mark = &spread->marks[point];
    __atomic_store(&spread->time[point], &time, __ATOMIC_RELAXED);
    *mark = (unsigned char)((*mark & CRAMPED) | (REACHED * (move + 1)));
    buckets_put(&spread->queue, (int)point, time);
}

/* Goes on from a point by the moves from `first` to `last`, which count on past MOVES. */
static void go_on_in_the_open(Spread *spread, size_t point, int first, int last) {
    const float *times = spread->time + point;
    for (int k = first; k <= last; k++) {
        const Move *move = &spread->moves[k % MOVES];
        float reached = *times + move->in_the_open;
        if (reached < times[move->to])
            reach(spread, (size_t)((ptrdiff_t)point + move->to), k % MOVES, reached);
    }
}

static void go_on_among_obstacles(Spread *spread, size_t point) {
    const Ground *ground = spread->ground;
    const FreeSpace *space = ground->space;
    const float *here = ground->slowness + point, *times = spread->time + point;
    int nx = space->nx, ny = space->ny, x = (int)point % nx, y = (int)point / nx;
    bool amid = x >= MOVE_REACH && y >= MOVE_REACH && x < nx - MOVE_REACH && y < ny - MOVE_REACH;
    for (int m = 0; m < MOVES; m++) {
        const Move *move = &spread->moves[m];
        int i = x + move->x, j = y + move->y;
        if (!amid && (i < 0 || j < 0 || i >= nx || j >= ny))
            continue;
        float there = here[move->to];
        if (!(there > 0))
            continue;
        float reached = *times + move->length * (*here + there);
        if (reached >= times[move->to] || !(here[move->half] > 0) || !(here[move->rest] > 0))
            continue;
        size_t to = (size_t)((ptrdiff_t)point + move->to);
        if (ground->doors && ground->doors[point] && ground->doors[to]) {
            Vec2 from = {space->origin.x + x * space->cell, space->origin.y + y * space->cell};
            Vec2 end = {space->origin.x + i * space->cell, space->origin.y + j * space->cell};
            reached += (float)field_delay(ground, from, end);
            if (reached >= times[move->to])
                continue;
        }
        reach(spread, to, m, reached);
    }
}

static void go_on(Spread *spread, size_t point) {
    int mark = spread->marks[point], move = mark / REACHED - 1 + MOVES;
    if (mark & CRAMPED)
        go_on_among_obstacles(spread, point);
    else if (mark >= REACHED)
        go_on_in_the_open(spread, point, move - 1, move + 1);
    else
        go_on_in_the_open(spread, point, 0, MOVES - 1);
}

static double longest_delay(const Ground *ground) {
    double longest = 0;
    for (size_t i = 0; i < ground->line_count; i++)
        longest += ground->lines[i].delay;
    return fmin(longest, 2000);
}

static Spread *spread_make(const Ground *ground, float *time) {
    const FreeSpace *space = ground->space;
    Spread *spread = memory_zeroed(1, sizeof *spread);
    /* No step takes less than one bucket's width, so the times in a bucket are final except for their order. */
    double longest = 2.3 * space->cell * field_discomfort(0) / field_speed(ground->profile, 0) + longest_delay(ground);
    spread->ground = ground;
    spread->time = time;
    spread->queue = buckets_make(space->cell / ground->profile->free_speed, longest);
    spread->marks = memory_zeroed((size_t)space->nx * (size_t)space->ny, 1);
    list_moves(spread->moves, space->nx, space->cell, (float)(1 / ground->profile->free_speed));
    mark_cramped(spread);
    pthread_mutex_init(&spread->lock, NULL);
    return spread;
}

/* Tells how far the times are known now. */
static void note_known(Spread *spread) {
    float known = HUGE_VALF;
    if (spread->queue.held > 0)
        known = (float)((double)spread->number / spread->queue.per_second * BEFORE);
    __atomic_store(&spread->known, &known, __ATOMIC_RELEASE);
}

/* Goes on from all points of the next bucket. */
static void spread_on(Spread *spread) {
    BucketEntry entry;
    while (buckets_take(&spread->queue, spread->number, &entry))
        if (entry.time <= spread->time[entry.point])
            go_on(spread, (size_t)entry.point);
    spread->number++;
    note_known(spread);
}

static bool is_known(const Field *field, size_t point) {
    float known, time;
    __atomic_load(&field->spread->known, &known, __ATOMIC_ACQUIRE);
    __atomic_load(&field->time[point], &time, __ATOMIC_RELAXED);
    return time <= known || !(field->ground->slowness[point] > 0);
}

static void know(const Field *field, size_t point) {
    if (is_known(field, point))
        return;
    pthread_mutex_lock(&field->spread->lock);
    while (!is_known(field, point))
        spread_on(field->spread);
    pthread_mutex_unlock(&field->spread->lock);
}

void field_init(Field *field, const Ground *ground, const Goal *goal) {
    const Plan *plan = ground->plan;
    size_t points = (size_t)ground->space->nx * (size_t)ground->space->ny;
    *field = (Field){.ground = ground, .time = memory_zeroed(points, sizeof *field->time)};
    for (size_t i = 0; i < points; i++)
        field->time[i] = HUGE_VALF;
    Spread *spread = field->spread = spread_make(ground, field->time);
    if (goal->radius > 0)
        seed_line(spread, goal->at, goal->at, fmax(goal->radius / 2, ground->space->cell), 0);
    for (size_t e = 0; goal->radius <= 0 && e < plan->exit_count; e++)
        if (field_exit_usable(goal, plan, e))
            seed_exit(spread, &plan->exits[e]);
    note_known(spread);
}

void field_clear(Field *field) {
    if (field->spread) {
        buckets_clear(&field->spread->queue);
        memory_free(field->spread->marks);
        pthread_mutex_destroy(&field->spread->lock);
    }
    memory_free(field->spread);
    memory_free(field->time);
    *field = (Field){0};
}

void field_know(const Field *field, int low_x, int low_y, int high_x, int high_y) {
    for (int j = low_y; j < high_y; j++)
        for (int i = low_x; i < high_x; i++)
            know(field, (size_t)j * (size_t)field->ground->space->nx + (size_t)i);
}

double field_time(const Field *field, Vec2 at) {
    const FreeSpace *space = field->ground->space;
    double x = (at.x - space->origin.x) / space->cell, y = (at.y - space->origin.y) / space->cell;
    if (!(x >= 0 && y >= 0 && x < space->nx - 1 && y < space->ny - 1))
        return HUGE_VAL;
    int i = (int)x, j = (int)y;
    field_know(field, i, j, i + 2, j + 2);
    const float *low = field->time + (size_t)j * (size_t)space->nx + (size_t)i, *high = low + space->nx;
    double u = x - i, v = y - j;
    double time = (1 - v) * ((1 - u) * (double)low[0] + u * (double)low[1]) +
                  v * ((1 - u) * (double)high[0] + u * (double)high[1]);
    if (isfinite(time))
        return time;
    return (double)fminf(fminf(low[0], low[1]), fminf(high[0], high[1]));
}

void field_note_time(const Field *field, Vec2 at, Reads *reads) {
    const FreeSpace *space = field->ground->space;
    double x = (at.x - space->origin.x) / space->cell, y = (at.y - space->origin.y) / space->cell;
    if (x >= 0 && y >= 0 && x < space->nx - 1 && y < space->ny - 1)
        reads_note_point(reads, (int)x, (int)y);
}
