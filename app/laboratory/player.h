/* The transport: the moment that is shown. While it plays, wall time advances it; the simulation itself never reads the
 * wall clock. If the simulation is slower than playback, the view waits at the end of the record, and the achieved
 * speed shows it. */
#pragma once

#include <stdbool.h>

#include "laboratory/laboratory.h"

enum { PLAYER_SLOWEST = -4 /* powers of two: 1/16 */ };

typedef struct Player {
    bool playing;
    int power;      /* requested speed: 2^power times the laboratory's pace */
    double time;    /* s, of the moment shown */
    double in, out; /* s, ends of the loop; NAN: the beginning, the end */
    bool loops;
    double achieved;       /* speed reached recently; NAN: not known yet */
    double watched, moved; /* s of wall time, and of playback at speed 1, since the last measurement */
} Player;

Player player_start(void);

/* Returns the requested speed. */
double player_speed(const Player *player);

/* Returns the requested speed and, while it plays, the achieved one: "2x (1.9x)", "1/4x"; "2x (waits)" for a record
 * that does not grow. */
const char *player_speed_text(const Player *player, Arena *arena);

/* Change the speed by steps of a factor 2, within the span's limits; reset it to 1. */
void player_change_speed(Player *player, int steps, const RecordSpan *span);
void player_normal_speed(Player *player);

/* Returns the time wanted after `seconds` of wall time, which may lie beyond the record. */
double player_wish(const Player *player, double seconds, const RecordSpan *span);

/* Advances to `wish` as far as the record goes and measures the speed. At the end of a complete record it loops or
 * stops. */
void player_advance(Player *player, double seconds, double wish, const RecordSpan *span);

/* True if the player, its time or the speed that it achieves would be shown otherwise than before. */
bool player_looks_other(const Player *before, const Player *now);

/* Play, from the beginning if it is at the end, or pause on a whole frame. */
void player_toggle(Player *player, const RecordSpan *span);
void player_pause(Player *player, const RecordSpan *span);

/* Go to a time within the span; step by frames, which pauses. */
void player_seek(Player *player, double time, const RecordSpan *span);
void player_step(Player *player, int frames, const RecordSpan *span);
