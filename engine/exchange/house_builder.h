/* A plan made piece by piece, by the importers: ids are given, coordinates rounded and checked, doors fitted into their
 * walls, limits kept. All lengths in metres, angles as in a house file.
 *
 * The first thing that cannot be adds a fault, and the builder takes no more: house_finish_plan then fails. Limits keep
 * time and memory bounded whatever a file says. Only for the importers. */
#pragma once

#include "exchange/import.h"

enum {
    HOUSE_BUILDER_POINTS = 100000, /* of all walls */
    HOUSE_BUILDER_THINGS = 10000,  /* of each other kind, but for doors and people */
    HOUSE_BUILDER_FEW = 2000,      /* of these: each is looked for among all walls */
    HOUSE_BUILDER_CROWD = 20000,   /* people in all crowds */
};

typedef struct HouseBuilder {
    Plan plan; /* its lists grow */
    size_t wall_capacity, door_capacity, furniture_capacity, room_capacity, exit_capacity, person_capacity,
        crowd_capacity, route_capacity;
    size_t points; /* of all walls */
    size_t crowd;  /* people in crowds */
    const char *path;
    int line; /* of the file, where it has lines: for faults about what is added next */
    const ImportOptions *options;
    ImportReport *report;
    Fault *fault;
    bool failed;
} HouseBuilder;

void house_builder_init(HouseBuilder *builder, const char *path, const ImportOptions *options, ImportReport *report,
                        Fault *fault);
void house_builder_clear(HouseBuilder *builder);

/* Adds the fault `path:line:1: what`, once. Returns false. */
bool house_builder_fail(HouseBuilder *builder, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Is the point somewhere on Earth, and has nothing failed? Otherwise that is the fault. */
bool house_builder_good(HouseBuilder *builder, Vec2 at);

/* To the nanometre, which reads well. */
Vec2 house_builder_rounded(Vec2 at);

/* Those that add something return its place in the plan's list, or SIZE_MAX where there is nothing to add or the
 * builder has failed. */

/* Points that repeat are dropped; a closed wall repeats its first point. */
size_t house_builder_wall(HouseBuilder *builder, const Vec2 *points, size_t count, double thickness, double height);

/* A door of which wall_index, segment, at, width, kind, hinge and swing are said. It is moved along its segment by up
 * to its half width to lie in it; SIZE_MAX also when it finds no place there or another door has it. */
size_t house_builder_door(HouseBuilder *builder, const Door *door);

/* The segment of a wall that is nearest to the point, of those that run along the unit vector `along` (or against it):
 * false when none is within `reach`. */
bool house_builder_nearest(const HouseBuilder *builder, Vec2 at, Vec2 along, double reach, size_t *wall, int *segment);

size_t house_builder_piece(HouseBuilder *builder, const char *name, Vec2 centre, Vec2 size, double angle,
                           double height);

/* A piece of furniture that is the smallest rectangle round an outline. */
size_t house_builder_piece_around(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count,
                                  double height);

size_t house_builder_room(HouseBuilder *builder, const char *name, const Vec2 *points, size_t count);
size_t house_builder_exit(HouseBuilder *builder, Vec2 from, Vec2 to);

/* `heading` in degrees; a speed of 0 is the profile's. */
size_t house_builder_person(HouseBuilder *builder, Vec2 at, double heading, double speed);
size_t house_builder_crowd(HouseBuilder *builder, const Vec2 *area, size_t points, size_t count, double delay);

/* Gives somebody a route, one that others have too where it leads the same way: `via` (count) are passed in order; exit
 * SIZE_MAX: any. */
void house_builder_route(HouseBuilder *builder, const char *who, const Vec2 *via, size_t count, size_t exit);

/* Names the house; otherwise it has the file's name. */
void house_builder_name(HouseBuilder *builder, const char *name);
