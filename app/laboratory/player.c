#include "laboratory/player.h"

#include <math.h>

#include "base/text.h"

#define LOOK 0.5          /* s of wall time over which the achieved speed is measured */
#define LONGEST 0.1       /* s of wall time per frame, at most: playback does not jump after a delay */
#define LEAST_SPEED 0.005 /* 1: slower playback waits for its record */
#define WHOLE_FRAME 1e-6  /* frames: a time this close to a whole frame is on it */

Player player_start(void) {
    return (Player){.playing = true, .in = NAN, .out = NAN, .achieved = NAN};
}

double player_speed(const Player *player) {
    return ldexp(1, player->power);
}

const char *player_speed_text(const Player *player, Arena *arena) {
    double speed = player_speed(player);
    const char *asked = speed < 1 ? text_in_arena(arena, "1/%.0fx", 1 / speed) : text_in_arena(arena, "%.0fx", speed);
    if (!player->playing || isnan(player->achieved))
        return asked;
    if (player->achieved < LEAST_SPEED)
        return text_in_arena(arena, "%s (waits)", asked);
    return text_in_arena(arena, "%s (%.2gx)", asked, player->achieved);
}

void player_change_speed(Player *player, int steps, const RecordSpan *span) {
    int fastest = (int)lround(log2(span->fastest));
    int power = player->power + steps;
    player->power = power < PLAYER_SLOWEST ? PLAYER_SLOWEST : power > fastest ? fastest : power;
    player->achieved = NAN;
    player->watched = player->moved = 0;
}

void player_normal_speed(Player *player) {
    player->power = 0;
    player->achieved = NAN;
    player->watched = player->moved = 0;
}

/* Returns the beginning of the loop. */
static double loop_begin(const Player *player, const RecordSpan *span) {
    return isnan(player->in) ? span->begin : fmax(player->in, span->begin);
}

static double loop_end(const Player *player, const RecordSpan *span) {
    return isnan(player->out) ? span->end : fmin(player->out, span->end);
}

double player_wish(const Player *player, double seconds, const RecordSpan *span) {
    if (!player->playing)
        return fmax(player->time, span->begin);
    double wish = fmax(player->time, span->begin) + fmin(seconds, LONGEST) * player_speed(player) * span->pace;
    if (player->loops && !isnan(player->out) && player->time <= player->out)
        wish = fmin(wish, player->out);
    return wish;
}

/* Measures the achieved speed, and restarts the measurement after LOOK seconds. */
static void measure(Player *player, double seconds, double moved) {
    player->watched += seconds;
    player->moved += moved;
    if (player->watched < LOOK)
        return;
    player->achieved = player->moved / player->watched;
    player->watched = player->moved = 0;
}

void player_advance(Player *player, double seconds, double wish, const RecordSpan *span) {
    double before = player->time;
    player->time = fmax(fmin(wish, span->end), span->begin);
    if (!player->playing)
        return;
    measure(player, seconds, (player->time - before) / span->pace);
    bool over = span->complete && player->time >= span->end;
    if (player->loops && (over || player->time >= loop_end(player, span)) && (!span->endless || !isnan(player->out))) {
        player->time = loop_begin(player, span);
    } else if (over) {
        player->playing = false;
        player->achieved = NAN;
        player->watched = player->moved = 0;
    }
}

bool player_looks_other(const Player *before, const Player *now) {
    bool same_speed = now->achieved == before->achieved || (isnan(now->achieved) && isnan(before->achieved));
    return now->time != before->time || now->playing != before->playing || !same_speed;
}

void player_pause(Player *player, const RecordSpan *span) {
    player->playing = false;
    player->achieved = NAN;
    player->watched = player->moved = 0;
    if (player->time < span->end)
        player->time = fmax(span->begin, span->step * floor(player->time / span->step + WHOLE_FRAME));
}

void player_toggle(Player *player, const RecordSpan *span) {
    if (player->playing) {
        player_pause(player, span);
        return;
    }
    if (span->complete && player->time >= span->end)
        player->time = loop_begin(player, span);
    player->playing = true;
}

void player_seek(Player *player, double time, const RecordSpan *span) {
    player->time = fmax(span->begin, fmin(time, span->end));
}

void player_step(Player *player, int frames, const RecordSpan *span) {
    player_pause(player, span);
    double frame = player->time / span->step;
    double whole = frames > 0 ? floor(frame + WHOLE_FRAME) : ceil(frame - WHOLE_FRAME);
    player->time = fmax(span->begin, span->step * (whole + frames));
    if (!span->endless)
        player->time = fmin(player->time, span->end);
}
