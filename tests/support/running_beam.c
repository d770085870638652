#include "running_beam.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digest.h"
#include "check.h"
#include "scratch.h"

void *running_beam_open(const char *name, const char *const *settings, size_t count) {
    char path[100];
    Fault fault = {0};
    LaboratoryOptions options = {.settings = settings, .setting_count = count, .driving = -1, .jobs = 2};
    snprintf(path, sizeof path, "assets/beams/%s.json", name);
    void *session = beam_laboratory.open(scratch_source(path), &options, &fault);
    CHECK(session != NULL);
    check_say(&fault);
    return session;
}

/* True once the session has shown times up to the given one, s, as far as reachable. */
void running_beam_show_at(void *session, double time) {
    while (beam_laboratory.reach(session, time) <= time && !beam_laboratory.span(session).complete) {
    }
    beam_laboratory.show(session, fmin(time, beam_laboratory.span(session).end));
}

void running_beam_play(void *session, double from, double to, double step) {
    for (size_t i = 0; from + (double)i * step < to; i++) {
        beam_laboratory.update(session, from + (double)i * step);
        running_beam_show_at(session, from + (double)i * step);
    }
    running_beam_show_at(session, to);
}

static uint64_t digest_scene(uint64_t digest, const Scene *scene) {
    for (size_t p = 0; p < scene->count; p++) {
        const Primitive *primitive = &scene->primitives[p];
        for (size_t i = 0; i < primitive->count; i++)
            digest = digest_pair(digest, primitive->points[i]);
        if (primitive->text)
            digest = digest_text(digest, primitive->text);
    }
    return digest;
}

uint64_t running_beam_digest_picture(void *session) {
    return digest_scene(digest_scene(DIGEST_START, beam_laboratory.still(session)), beam_laboratory.moving(session));
}

size_t running_beam_find_plot(const char *name) {
    static const char *const names[] = {"phase", "poincare", "force", "spectrum", "orbit"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0)
            return i;
    return 0;
}

uint64_t running_beam_digest_plot(void *session, const char *name, double time) {
    size_t index = running_beam_find_plot(name);
    LaboratoryPlot plot = beam_laboratory.plot(session, index);
    uint64_t digest = DIGEST_START;
    CHECK_TEXT(plot.name, name);
    for (size_t s = 0; s < plot.plot->series_count; s++) {
        size_t count = beam_laboratory.points_until(session, index, s, time);
        CHECK(count <= plot.plot->series[s].count);
        for (size_t i = 0; i < count; i++)
            digest = digest_pair(digest, plot_value(&plot.plot->series[s], i));
    }
    return digest;
}
