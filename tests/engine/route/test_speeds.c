/* Tests that the speeds along a way that has changed, computed only where they change, are to the last bit those that
 * are computed from nothing: the descent adds up hundreds of such differences. */

#include "check.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/random.h"
#include "rooms.h"
#include "route/field.h"
#include "route/search.h"
#include "route/speeds.h"

enum {
    TRIALS = 400,
    COPIED = 8, /* stations on either side of a change, whose numbers speeds_look copies */
    BACK = 20   /* poses of the route that are driven back */
};

#define SPACING 0.05 /* m */
#define FARTHEST 0.3 /* m: larger clearances are not measured */
#define MOST 0.004   /* m, of a move */

typedef struct Drive {
    Rooms rooms;
    Rectangle body;
    Way way;
    Course course;
} Drive;

/* A drive about a corner; with `changes` it goes back for a while at the middle of its way, and forwards again. */
static void make_drive(Drive *drive, bool changes, bool centring) {
    rooms_make_corner(&drive->rooms, 0.85, 0.63, 1, 1, false);
    drive->rooms.profile.turning_moment = 20;
    drive->rooms.profile.radius_of_gyration = 0.3;
    drive->rooms.profile.acceleration = 0.03; /* m/s2: a change of the speed reaches far */
    Route route = route_drive(&drive->rooms.query);
    CHECK(route.answer == ROUTE_FOUND);
    SearchTrack track = {0};
    size_t middle = route.count / 2, again = changes ? middle - BACK : middle;
    for (size_t i = 0; i <= middle; i++)
        search_track_add(&track, route.poses[i]);
    for (size_t i = middle; i-- > again;)
        search_track_add(&track, (Pose){route.poses[i].at, route.poses[i].heading, 0, -1});
    for (size_t i = again + 1; i < route.count; i++)
        search_track_add(&track, route.poses[i]);
    drive->way = way_of_track(&track, &drive->rooms.plan.exits[route.exit], NULL, 0, SPACING);
    CHECK(drive->way.piece_count == (changes ? 3 : 1));
    search_track_clear(&track);
    route_free(&route);
    drive->body = search_body(&drive->rooms.profile);
    drive->course = (Course){.way = &drive->way,
                             .space = &drive->rooms.space,
                             .body = &drive->body,
                             .profile = &drive->rooms.profile,
                             .agility = pace_agility(&drive->rooms.profile),
                             .margin = -HUGE_VAL,
                             .sight = FARTHEST,
                             .centring = centring};
}

static void free_drive(Drive *drive) {
    way_free(&drive->way);
    rooms_free(&drive->rooms);
}

/* Moves some inner stations of a piece, and returns those that have moved or turned. */
static void move_some(Way *way, Random *random, size_t *begin, size_t *end) {
    const WayPiece *piece = &way->pieces[random_bits(random) % way->piece_count];
    size_t inner = piece->last - piece->first - 1, low = piece->first + 1 + random_bits(random) % inner;
    size_t high = low + random_bits(random) % 20;
    high = high < piece->last ? high : piece->last - 1;
    for (size_t s = low; s <= high; s++)
        way->stations[s].at = vec2_add(way->stations[s].at, vec2((2 * random_uniform(random) - 1) * MOST,
                                                                 (2 * random_uniform(random) - 1) * MOST));
    *begin = low - 1;
    *end = high + 1;
    way_set_axes(way, *begin, *end);
}

static size_t different(const double *a, const double *b, size_t count) {
    size_t found = 0;
    for (size_t i = 0; i < count; i++)
        found += a[i] != b[i];
    return found;
}

/* Returns how many numbers of the whole way differ from those computed from nothing. */
static size_t wrong_numbers(const Course *course, const Speeds *now) {
    size_t count = course->way->count, first, last;
    Speeds whole = speeds_make(count);
    speeds_look(course, &whole, &whole, 0, count - 1);
    speeds_run(course, &whole, &whole, 0, count - 1, &first, &last);
    size_t wrong = different(now->own, whole.own, count) + different(now->clearance, whole.clearance, count) +
                   different(now->left, whole.left, count) + different(now->right, whole.right, count) +
                   different(now->room_left, whole.room_left, count) +
                   different(now->room_right, whole.room_right, count) + different(now->length, whole.length, count) +
                   different(now->edge, whole.edge, count) + different(now->heading, whole.heading, count) +
                   different(now->braking, whole.braking, count) + different(now->starting, whole.starting, count) +
                   different(now->limit, whole.limit, count) + different(now->speed, whole.speed, count) +
                   different(now->time, whole.time, count) + different(now->cost, whole.cost, count);
    speeds_free(&whole);
    return wrong;
}

/* Half of the changes stay, the others are undone, as in a descent. */
static void check_changes(bool changes, bool centring) {
    Drive drive;
    make_drive(&drive, changes, centring);
    size_t count = drive.way.count, first, last, wrong = 0, begin, end, farther = 0;
    Speeds now = speeds_make(count), tried = speeds_make(count);
    speeds_look(&drive.course, &now, &now, 0, count - 1);
    speeds_run(&drive.course, &now, &now, 0, count - 1, &first, &last);
    Random random = random_seed(1, 0);
    for (int trial = 0; trial < TRIALS; trial++) {
        Way before = way_copy(&drive.way);
        move_some(&drive.way, &random, &begin, &end);
        CHECK(speeds_look(&drive.course, &now, &tried, begin, end));
        speeds_run(&drive.course, &now, &tried, begin, end, &first, &last);
        farther += last > end + 2 * COPIED;
        if (random_uniform(&random) < 0.5) {
            memcpy(drive.way.stations, before.stations, count * sizeof *before.stations);
        } else {
            speeds_take(&drive.course, &now, &tried, first, last);
            wrong += wrong_numbers(&drive.course, &now);
        }
        way_free(&before);
    }
    CHECK(wrong == 0);
    CHECK(farther > 0); /* the effect of some changes reached beyond what was copied for them */
    speeds_free(&now);
    speeds_free(&tried);
    free_drive(&drive);
}

TEST(changed_speeds_are_those_of_the_whole_way) {
    check_changes(false, false);
}

TEST(so_they_are_with_changes_of_direction) {
    check_changes(true, false);
}

TEST(so_they_are_while_the_way_is_centred) {
    check_changes(false, true);
}
