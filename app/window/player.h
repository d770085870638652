/* The transport: which moment is shown. Wall time moves it on while it plays; what is simulated never sees the clock on
 * the wall. When the record does not come as fast as it is played, the picture waits at its end, and the achieved speed
 * says so. */
#pragma once

#include <stdbool.h>

#include "laboratory/laboratory.h"

enum { PLAYER_SLOWEST = -4 /* powers of two: 1/16 */ };

typedef struct Player {
    bool playing;
    int power;      /* it is asked to play 2^power times as fast as the laboratory's pace */
    double time;    /* s, shown */
    double in, out; /* s, the stretch that is played again and again; NAN: from the beginning, to the end */
    bool loops;
    double achieved;       /* the speed that was reached in the last moments; NAN: not known yet */
    double watched, moved; /* s on the wall, and as many of `moved` at speed 1, since the last look */
} Player;

Player player_start(void);

/* The speed asked for. */
double player_speed(const Player *player);

/* One step faster or slower, within the ladder of what is played; or back to 1. */
void player_change_speed(Player *player, int steps, const RecordSpan *span);
void player_normal_speed(Player *player);

/* The moment that is wanted after so many s on the wall, which `reach` may not have. */
double player_wish(const Player *player, double seconds, const RecordSpan *span);

/* Moves there, as far as the record goes, and measures what came of it. At the end of what is complete it goes round or
 * stops. */
void player_advance(Player *player, double seconds, double wish, const RecordSpan *span);

/* Play, or pause on a whole frame; at the end, from the beginning. */
void player_toggle(Player *player, const RecordSpan *span);
void player_pause(Player *player, const RecordSpan *span);

/* To a time within the span; and by so many frames, which pauses. */
void player_seek(Player *player, double time, const RecordSpan *span);
void player_step(Player *player, int frames, const RecordSpan *span);
