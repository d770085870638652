/* The contents of a Sweet Home 3D file, unconverted: centimetres, y down, radians clockwise on the screen, x and y
 * of a piece at its centre. Private to sh3d.c. */
#pragma once

#include "exchange/house_builder.h"

typedef struct HomeWall {
    const char *level; /* id, or "" */
    Vec2 from, to;
    double thickness, height;
    double arc; /* rad, the arc's angle; 0: straight */
} HomeWall;

/* A leaf of a door or window, in fractions of the piece's width and depth from its back left corner. */
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
    size_t sash, sash_count; /* index of the first sash, number of sashes */
    int line;                /* line in Home.xml */
} HomePiece;

typedef struct HomeRoom {
    const char *level, *name;
    size_t point, point_count; /* index of the first point, number of points */
} HomeRoom;

typedef struct HomeLevel {
    const char *id, *name;
    double elevation;
} HomeLevel;

/* A zeroed value is empty; sh3d_home_clear releases it. */
typedef struct Home {
    HomeWall *walls; /* (wall_count), and likewise below */
    HomePiece *pieces;
    HomeSash *sashes;
    HomeRoom *rooms;
    Vec2 *points;
    HomeLevel *levels;
    size_t wall_count, piece_count, sash_count, room_count, point_count, level_count;
    size_t wall_capacity, piece_capacity, sash_capacity, room_capacity, point_capacity, level_capacity;
    size_t polylines, labels, dimensions, pictures; /* counts of other elements */
    Arena arena;
} Home;

/* Reads Home.xml from the zip file, in memory only. Returns false after an error, which the builder holds. */
bool sh3d_home_read(Home *home, HouseBuilder *builder);
void sh3d_home_clear(Home *home);
