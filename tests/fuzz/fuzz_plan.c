/* The input is a house file: read, written, read again and, if small, built. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"
#include "fuzz.h"
#include "space/freespace.h"
#include "space/outline.h"
#include "plan/plan.h"

enum { LARGEST_FILE = 1 << 24, MOST_POINTS = 500 };
static const double MOST_CELLS = 3e5; /* 1, of the grid: a few ms of work */

static char *written(const Plan *plan) {
    char path[64];
    size_t size;
    snprintf(path, sizeof path, "/dev/shm/clearance-fuzz-%ld.json", (long)getpid());
    fuzz_expect(plan_write(plan, path) == 0, "a plan is written");
    char *text = text_read_file(path, LARGEST_FILE, &size);
    unlink(path);
    return text;
}

static void round_trip(const Plan *plan) {
    char *once = written(plan);
    Plan again = {0};
    Fault fault = {0};
    bool good = plan_read(&again, fuzz_file((const uint8_t *)once, strlen(once)), NULL, 0, &fault);
    for (size_t i = 0; i < fault.count; i++)
        fprintf(stderr, "%s\n", fault.lines[i]);
    fuzz_expect(good, "a plan that was written is read");
    char *twice = written(&again);
    fuzz_expect(strcmp(once, twice) == 0, "a plan survives writing");
    memory_free(once);
    memory_free(twice);
    plan_free(&again);
}

static size_t points_of(const Plan *plan) {
    size_t points = 4 * plan->furniture_count + 4 * plan->door_count;
    for (size_t w = 0; w < plan->wall_count; w++)
        points += plan->walls[w].points.count;
    return points;
}

static void look_about(const FreeSpace *space, Vec2 at) {
    int face;
    double reach = 0.3, distance = freespace_distance(space, at), exact = freespace_exact(space, at, 1, &face);
    fuzz_expect(fabs(distance) <= FREESPACE_FARTHEST + 1e-6, "a distance is at most the farthest");
    fuzz_expect(exact >= 0 && exact <= 1 && face < (int)space->outline->face_count, "an exact distance is in reach");
    double clearance = freespace_clearance(space, at, vec2_heading(1), 0.55, 0.3, reach, NULL);
    double growth = freespace_growth(space, at, vec2_heading(1), 0.55, 0.3, reach, NULL);
    fuzz_expect(clearance <= reach && clearance > -FREESPACE_FARTHEST - 1, "a clearance is in reach");
    fuzz_expect((clearance > 1e-9) == (growth > 1e-9) || fabs(clearance) < 1e-6, "clearance and growth agree");
}

static void build(const Plan *plan) {
    Outline outline = {0};
    FreeSpace space = {0};
    Fault fault = {0};
    fuzz_expect(outline_build(&outline, plan, &fault), "walls are united");
    for (size_t f = 0; f < outline.face_count; f++) {
        const Face *face = &outline.faces[f];
        fuzz_expect(isfinite(face->a.x + face->a.y + face->b.x + face->b.y), "a face is somewhere");
        fuzz_expect(fabs(vec2_length(face->normal) - 1) < 1e-9, "a normal is a unit vector");
    }
    Vec2 size = vec2_sub(outline.box.high, outline.box.low);
    double more = 2 * FREESPACE_MARGIN, cell = plan->run.cell;
    if ((size.x + more) * (size.y + more) / (cell * cell) < MOST_CELLS) {
        freespace_build(&space, &outline, cell);
        for (size_t p = 0; p < plan->person_count && p < 20; p++)
            look_about(&space, plan->people[p].at);
        for (size_t c = 0; c < outline.corner_count && c < 20; c++)
            look_about(&space, outline.corners[c].at);
        freespace_free(&space);
    }
    outline_free(&outline);
    fault_clear(&fault);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Plan plan = {0};
    Fault fault = {0};
    bool good = plan_read(&plan, path, NULL, 0, &fault);
    fuzz_expect_faults(good, &fault, path);
    if (good) {
        round_trip(&plan);
        if (points_of(&plan) < MOST_POINTS)
            build(&plan);
    }
    plan_free(&plan);
    return 0;
}
