/* Builds a plan element by element for the importers: gives ids, rounds and checks coordinates, fits doors into
 * their walls and enforces limits. All lengths are in metres, angles as in a house file.
 *
 * The first invalid element adds an error, and the builder ignores all later ones: house_finish_plan then fails. The
 * limits bound time and memory for any file. Private to the importers. */
#pragma once

#include "exchange/import.h"

enum {
    HOUSE_BUILDER_POINTS = 100000, /* in all walls */
    HOUSE_BUILDER_THINGS = 10000,  /* of each other kind except doors and people */
    HOUSE_BUILDER_FEW = 2000,      /* doors, people: each is searched for among all walls */
    HOUSE_BUILDER_CROWD = 20000,   /* people in all crowds */
};

typedef struct HouseBuilder {
    Plan plan; /* its lists grow as elements are added */
    size_t wall_capacity, door_capacity, furniture_capacity, room_capacity, exit_capacity, person_capacity,
        crowd_capacity, route_capacity;
    size_t points; /* in all walls */
    size_t crowd;  /* people in all crowds */
    const char *path;
    int line; /* line in the file, where the format has lines, for errors in the next element */
    const ImportOptions *options;
    ImportReport *report;
    Fault *fault;
    bool failed;
} HouseBuilder;

void house_builder_init(HouseBuilder *builder, const char *path, const ImportOptions *options, ImportReport *report,
                        Fault *fault);
void house_builder_clear(HouseBuilder *builder);

/* Adds the error `path:line:1: what`, once. Returns false. */
bool house_builder_fail(HouseBuilder *builder, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* True if the point lies on Earth and the builder has not failed; adds an error otherwise. */
bool house_builder_good(HouseBuilder *builder, Vec2 at);

/* Rounds to the nanometre, for readable files. */
Vec2 house_builder_rounded(Vec2 at);

/* Functions that add an element return its index in the plan's list, or SIZE_MAX if nothing was added or the builder
 * has failed. */

/* Drops repeated points; a closed wall repeats its first point. */
size_t house_builder_wall(HouseBuilder *builder, const Vec2 *points, size_t count, double thickness, double height);

/* Adds a door with the given wall_index, segment, at, width, kind, hinge and swing. The door is shifted along its
 * segment by at most half its width to fit; SIZE_MAX if it does not fit or overlaps another door. */
size_t house_builder_door(HouseBuilder *builder, const Door *door);

/* Finds the wall segment nearest to the point among those parallel to the unit vector `along`; false if none lies
 * within `reach`. */
bool house_builder_nearest(const HouseBuilder *builder, Vec2 at, Vec2 along, double reach, size_t *wall, int *segment);

size_t house_builder_piece(HouseBuilder *builder, const char *name, Vec2 centre, Vec2 size, double angle,
                           double height);

/* Adds furniture: the smallest rectangle around an outline. */
size_t house_builder_piece_around(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count,
                                  double height);

size_t house_builder_room(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count);
size_t house_builder_exit(HouseBuilder *builder, Vec2 from, Vec2 to);

/* Adds a person; `heading` in degrees, speed 0 for the profile's speed. */
size_t house_builder_person(HouseBuilder *builder, Vec2 at, double heading, double speed);
size_t house_builder_crowd(HouseBuilder *builder, const Vec2 *area, size_t points, size_t count, double delay);

/* Assigns a route to a person, sharing an existing route with the same points: `via` (count) are passed in order;
 * exit SIZE_MAX means any exit. */
void house_builder_route(HouseBuilder *builder, const char *who, const Vec2 *via, size_t count, size_t exit);

/* Names the house; without a name it has the file's name. */
void house_builder_name(HouseBuilder *builder, const char *name);
