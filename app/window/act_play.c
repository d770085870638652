#include "window/act_play.h"

enum { STEPS_MANY = 10 };

void act_play_do(Tab *tab, Action action) {
    Player *player = &tab->player;
    RecordSpan span = tab_span(tab);
    double second = span.pace;
    switch (action) {
    case ACTION_PLAY:
        player_toggle(player, &span);
        break;
    case ACTION_STEP:
    case ACTION_STEP_BACK:
        player_step(player, action == ACTION_STEP ? 1 : -1, &span);
        break;
    case ACTION_STEP_TEN:
    case ACTION_STEP_BACK_TEN:
        player_step(player, action == ACTION_STEP_TEN ? STEPS_MANY : -STEPS_MANY, &span);
        break;
    case ACTION_SECOND:
    case ACTION_SECOND_BACK:
        player_seek(player, player->time + (action == ACTION_SECOND ? second : -second), &span);
        break;
    case ACTION_SLOWER:
    case ACTION_FASTER:
        player_change_speed(player, action == ACTION_FASTER ? 1 : -1, &span);
        break;
    case ACTION_NORMAL_SPEED:
        player_normal_speed(player);
        break;
    case ACTION_START:
        player_seek(player, span.begin, &span);
        break;
    case ACTION_NOW:
        player_seek(player, span.end, &span);
        break;
    case ACTION_LOOP:
        player->loops = !player->loops;
        break;
    case ACTION_MARK_IN:
        player->in = player->time;
        player->loops = true;
        break;
    case ACTION_MARK_OUT:
        player->out = player->time;
        player->loops = true;
        break;
    default:
        break;
    }
}

void act_play_again(Tab *tab) {
    RecordSpan span = tab_span(tab);
    bool plays = tab->player.playing || (span.complete && tab->player.time >= span.end);
    tab->laboratory->restart(tab->session);
    span = tab_span(tab);
    player_seek(&tab->player, span.begin, &span);
    tab->player.playing = plays;
}
