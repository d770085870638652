/* Measures the planning of one chair on one core: in a flat with 128 pieces of furniture whether there is a way at all,
 * the quickest one, and a no without and with its reasons; and in the shipped houses the whole planning. */

#include <stdio.h>

#include "bench.h"
#include "house/journey.h"
#include "houses.h"
#include "route/recall.h"

enum { TURNS = 7 };

typedef struct Asked {
    double whether, quickest; /* s, processor time */
    bool passes;
} Asked;

/* Plans from nothing, with a cache of its own each time. */
static Asked ask(const House *house) {
    double whether[TURNS], quickest[TURNS];
    bool passes = false;
    for (int turn = 0; turn < TURNS; turn++) {
        double begin = bench_now();
        passes = journey_possible(house, NULL, NULL) == JOURNEY_POSSIBLE;
        whether[turn] = bench_now() - begin;
        begin = bench_now();
        Journeys journeys = journey_plan_all(house, NULL, 1, NULL);
        quickest[turn] = bench_now() - begin;
        journey_free_all(&journeys);
    }
    return (Asked){bench_median(whether, TURNS), bench_median(quickest, TURNS), passes};
}

static void print(const char *name, const House *house) {
    Asked asked = ask(house);
    double people = (double)house->person_count;
    printf("%-34s  %-3s  %10.1f  %10.1f\n", name, asked.passes ? "yes" : "no", 1000 * asked.whether / people,
           1000 * asked.quickest / people);
}

enum { MOVES = 24 };

/* Moves a piece round a circle of 0.15 m radius and plans after each move, with the answers that are kept from the
 * moves before and without. */
static void print_moves(const char *name, const char *source, const char *piece, Vec2 at, bool flat) {
    double kept[MOVES], fresh[MOVES], most = 0;
    Recall *recall = recall_create();
    for (int move = -1; move < MOVES; move++) {
        Vec2 away = vec2_scale(vec2_heading(2 * M_PI * move / MOVES), 0.15);
        House house;
        Vec2 now = move < 0 ? at : vec2(at.x + away.x - 0.15, at.y + away.y);
        if (flat)
            houses_read_flat_moved(&house, source, 1.05, 0.80, vec2_sub(now, at));
        else
            houses_read_ube_moved(&house, source, piece, now);
        double begin = bench_now();
        Journeys journeys = journey_plan_recalling(&house, NULL, true, recall, NULL, 1, NULL);
        double between = bench_now();
        Journeys other = journey_plan_briefly(&house, NULL, 1, NULL);
        if (move >= 0) {
            kept[move] = between - begin;
            fresh[move] = bench_now() - between;
            most = fmax(most, kept[move]);
        }
        journey_free_all(&journeys);
        journey_free_all(&other);
        house_free(&house);
    }
    double usual = bench_median(kept, MOVES), before = bench_median(fresh, MOVES);
    printf("%-34s  %10.1f  %10.1f  %10.1f  %6.3f  %zu\n", name, 1000 * before, 1000 * usual, 1000 * most,
           usual / before, recall_found(recall));
    recall_destroy(recall);
}

int main(int argc, char **argv) {
    const char *source = argc > 1 ? argv[1] : ".";
    static const double sizes[][2] = {{1.20, 0.80}, {1.05, 0.80}, {1.00, 0.80}, {0.95, 0.85},
                                      {0.90, 0.85}, {0.80, 0.85}, {1.05, 0.60}}; /* m, corridor and door */
    printf("a chair, one core, processor time, ms, median of %d\n\n", TURNS);
    printf("%-34s  %-3s  %10s  %10s\n", "", "out", "whether", "with way, or reason");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        House house;
        char name[64];
        houses_read_flat(&house, source, sizes[i][0], sizes[i][1]);
        snprintf(name, sizeof name, "128 pieces, corridor %.2f, door %.2f", sizes[i][0], sizes[i][1]);
        print(name, &house);
        house_free(&house);
    }
    House ube;
    houses_read_ube(&ube, source);
    print("ube house, each of four", &ube);
    house_free(&ube);
    printf("\nafter a piece has moved, all people, ms\n\n%-34s  %10s  %10s  %10s  %6s  %s\n", "", "from nothing",
           "kept", "most", "ratio", "answers that still hold");
    print_moves("ube house, wardrobe", source, "wardrobe", vec2(9.2, 8.74), false);
    print_moves("ube house, bookshelf", source, "bookshelf", vec2(3.9, 3.87), false);
    print_moves("128 pieces, one in another room", source, "", vec2(0, 0), true);
    printf("\nreference (8 million dependent square roots): %.1f ms\n", 1000 * bench_reference());
    return 0;
}
