/* Tests playback: clock time becomes shown time, and steps are whole frames. */

#include "laboratory/player.h"

#include "check.h"

static const RecordSpan RUN = {.begin = 0, .end = 10, .complete = true, .pace = 1, .step = 1.0 / 30, .fastest = 16};

static void play(Player *player, double seconds, const RecordSpan *span) {
    player_advance(player, seconds, player_wish(player, seconds, span), span);
}

TEST(at_speed_one_a_second_is_a_second) {
    Player player = player_start();
    for (int i = 0; i < 60; i++)
        play(&player, 1.0 / 60, &RUN);
    CHECK_NEAR(player.time, 1, 1e-12);
}

TEST(the_pace_and_the_speed_multiply) {
    RecordSpan slow = RUN;
    slow.pace = 0.002;
    Player player = player_start();
    player_change_speed(&player, 2, &slow);
    play(&player, 0.05, &slow);
    CHECK_NEAR(player.time, 0.05 * 4 * 0.002, 1e-15);
}

TEST(the_ladder_of_speeds_ends) {
    Player player = player_start();
    player_change_speed(&player, 100, &RUN);
    CHECK_NEAR(player_speed(&player), 16, 0);
    player_change_speed(&player, -100, &RUN);
    CHECK_NEAR(player_speed(&player), 1.0 / 16, 0);
    player_normal_speed(&player);
    CHECK_NEAR(player_speed(&player), 1, 0);
}

TEST(a_hitch_does_not_leap) {
    Player player = player_start();
    play(&player, 5, &RUN);
    CHECK(player.time < 0.2);
}

TEST(the_picture_waits_for_the_record_and_the_achieved_speed_says_so) {
    RecordSpan growing = RUN;
    growing.complete = false;
    growing.end = 0;
    Player player = player_start();
    for (int i = 0; i < 100; i++) {
        growing.end += 0.005;
        play(&player, 0.02, &growing);
        CHECK(player.time <= growing.end);
    }
    CHECK(player.playing);
    CHECK_NEAR(player.achieved, 0.25, 1e-9);
}

TEST(the_speed_is_told_as_it_is_achieved_and_a_record_that_does_not_grow_is_waited_for) {
    RecordSpan span = RUN;
    span.complete = false;
    Arena arena = {0};
    Player player = player_start();
    CHECK_TEXT(player_speed_text(&player, &arena), "1x");
    for (int i = 0; i < 30; i++)
        play(&player, 0.02, &span);
    CHECK_TEXT(player_speed_text(&player, &arena), "1x (1x)");
    player.time = span.end;
    for (int i = 0; i < 60; i++)
        play(&player, 0.02, &span);
    CHECK_TEXT(player_speed_text(&player, &arena), "1x (waits)");
    player_pause(&player, &span);
    player_change_speed(&player, -2, &span);
    CHECK_TEXT(player_speed_text(&player, &arena), "1/4x");
    arena_clear(&arena);
}

TEST(at_the_end_it_stops_and_plays_again_from_the_beginning) {
    Player player = player_start();
    player_seek(&player, 9.99, &RUN);
    play(&player, 0.05, &RUN);
    CHECK(!player.playing);
    CHECK_NEAR(player.time, 10, 0);
    player_toggle(&player, &RUN);
    CHECK(player.playing);
    CHECK_NEAR(player.time, 0, 0);
}

TEST(a_loop_goes_round_between_its_marks) {
    Player player = player_start();
    player.in = 2;
    player.out = 3;
    player.loops = true;
    player_seek(&player, 2.98, &RUN);
    play(&player, 0.05, &RUN);
    CHECK_NEAR(player.time, 2, 0);
    CHECK(player.playing);
}

TEST(ten_steps_on_and_ten_back_are_the_same_moment) {
    Player player = player_start();
    play(&player, 0.0777, &RUN);
    player_pause(&player, &RUN);
    double time = player.time;
    for (int i = 0; i < 10; i++)
        player_step(&player, 1, &RUN);
    CHECK_NEAR(player.time, time + 10 * RUN.step, 1e-12);
    for (int i = 0; i < 10; i++)
        player_step(&player, -1, &RUN);
    CHECK_NEAR(player.time, time, 0);
}

TEST(steps_end_where_the_record_does) {
    Player player = player_start();
    player_step(&player, -1, &RUN);
    CHECK_NEAR(player.time, 0, 0);
    player_seek(&player, 10, &RUN);
    player_step(&player, 10, &RUN);
    CHECK_NEAR(player.time, 10, 0);
    CHECK(!player.playing);
}

TEST(a_record_that_loses_its_beginning_takes_the_time_along) {
    RecordSpan moved = RUN;
    moved.begin = 4;
    Player player = player_start();
    player.playing = false;
    play(&player, 0.02, &moved);
    CHECK_NEAR(player.time, 4, 0);
}
