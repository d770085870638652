/* What a Sweet Home 3D file holds, as it holds it: centimetres, y down, radians clockwise on the screen, x and y of a
 * piece its centre. Only for sh3d.c. */
#pragma once

#include "exchange/house_builder.h"

typedef struct HomeWall {
    const char *level; /* id, or "" */
    Vec2 from, to;
    double thickness, height;
    double arc; /* rad, the arc's angle; 0: straight */
} HomeWall;

/* A leaf of a door or window: shares of the piece's width and depth, from its left back corner. */
typedef struct HomeSash {
    double x_axis, y_axis, width;
    double start, end; /* rad */
} HomeSash;

typedef struct HomePiece {
    const char *level, *name, *catalog;
    Vec2 centre;
    double width, depth, height, elevation, angle;
    bool opens; /* a door or a window */
    bool visible, mirrored;
    size_t sash, sash_count; /* its sashes, in the list of all */
    int line;                /* of Home.xml */
} HomePiece;

typedef struct HomeRoom {
    const char *level, *name;
    size_t point, point_count; /* in the list of all */
} HomeRoom;

typedef struct HomeLevel {
    const char *id, *name;
    double elevation;
} HomeLevel;

/* Zero is empty; sh3d_home_clear releases what is read. */
typedef struct Home {
    HomeWall *walls; /* (wall_count), and so on */
    HomePiece *pieces;
    HomeSash *sashes;
    HomeRoom *rooms;
    Vec2 *points;
    HomeLevel *levels;
    size_t wall_count, piece_count, sash_count, room_count, point_count, level_count;
    size_t wall_capacity, piece_capacity, sash_capacity, room_capacity, point_capacity, level_capacity;
    size_t polylines, labels, dimensions, pictures; /* what is there besides */
    Arena arena;
} Home;

/* Reads Home.xml out of the zip file, in memory only. False: a fault, of the builder. */
bool sh3d_home_read(Home *home, HouseBuilder *builder);
void sh3d_home_clear(Home *home);
