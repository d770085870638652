#include "running_house.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "case.h"
#include "check.h"
#include "house/run.h"

static const Laboratory *const laboratory = &house_laboratory;

/* s, of all threads, that closing may take; more when every access is checked. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
static const double AT_ONCE = 15;
#else
static const double AT_ONCE = 1;
#endif

static double clock_of(clockid_t which) {
    struct timespec time;
    clock_gettime(which, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

double running_house_clock(void) {
    return clock_of(CLOCK_MONOTONIC);
}

/* Closes the session without waiting for its work. */
void running_house_close_at_once(void *session) {
    double begun = clock_of(CLOCK_PROCESS_CPUTIME_ID);
    laboratory->close(session);
    CHECK(clock_of(CLOCK_PROCESS_CPUTIME_ID) - begun < AT_ONCE);
}

void *running_house_open(const char *name, const char *const *settings, size_t setting_count, const char *route) {
    char path[4096], profiles[4096];
    snprintf(path, sizeof path, "%s/houses/%s.json", check_source(), name);
    snprintf(profiles, sizeof profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    LaboratoryOptions options = {.profiles = profiles,
                                 .settings = settings,
                                 .setting_count = setting_count,
                                 .route = route,
                                 .driving = -1,
                                 .seed = 1,
                                 .jobs = 2};
    void *session = laboratory->open(path, &options, &fault);
    check_say(&fault);
    return session;
}

void running_house_rest(void) {
    nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
}

size_t running_house_find_choice(void *session, const char *name, const char *option, size_t *place) {
    size_t count;
    const PanelChoice *all = laboratory->choices(session, &count);
    for (size_t c = 0; c < count; c++)
        for (size_t w = 0; strcmp(all[c].name, name) == 0 && w < all[c].count; w++)
            if (strcmp(all[c].options[w], option) == 0) {
                *place = w;
                return c;
            }
    CHECK(!"the choice is there");
    return 0;
}

void running_house_choose(void *session, const char *name, const char *option) {
    size_t place = 0, choice = running_house_find_choice(session, name, option, &place);
    laboratory->choose(session, choice, place);
    size_t count;
    CHECK(laboratory->choices(session, &count)[choice].chosen == place);
}

/* Waits until no work remains; returns all change flags. */
unsigned running_house_finish(void *session, double time) {
    unsigned changed = 0;
    double begun = running_house_clock();
    do {
        changed |= laboratory->update(session, time);
        running_house_rest();
    } while ((!laboratory->span(session).complete || laboratory->answer(session).stale ||
              laboratory->answer(session).doing) &&
             running_house_clock() - begun < 120);
    changed |= laboratory->update(session, time);
    CHECK(laboratory->span(session).complete && !laboratory->answer(session).stale);
    return changed;
}

uint64_t running_house_digest_of(const char *name, const char *const *settings, const char *route, int driving) {
    House house;
    case_house(&house, name, driving, settings);
    Observation observation;
    run_house(&observation, &house,
              &(RunOptions){.route = route ? plan_find_route(&house.plan, route) : SIZE_MAX, .jobs = 1});
    uint64_t digest = observation.digest;
    observation_free(&observation);
    house_free(&house);
    return digest;
}

bool running_house_set(void *session, const char *name, double value) {
    Fault fault = {0};
    bool good = laboratory->set(session, name, value, &fault);
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    CHECK(good == !fault.total);
    fault_clear(&fault);
    return good;
}

const PanelParameter *running_house_parameter(void *session, const char *name) {
    size_t count;
    const PanelParameter *all = laboratory->parameters(session, &count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(all[i].name, name) == 0)
            return &all[i];
    return NULL;
}

void running_house_add_scene(Text *text, const Scene *scene) {
    for (size_t i = 0; i < scene->count; i++) {
        const Primitive *primitive = &scene->primitives[i];
        text_format(text, "%d %d %d %.9f %.9f", primitive->kind, primitive->fill, primitive->edge, primitive->radius,
                    primitive->begun);
        for (size_t p = 0; p < primitive->count; p++)
            text_format(text, " %.9f,%.9f", primitive->points[p].x, primitive->points[p].y);
        text_format(text, " %s\n", primitive->text);
    }
}

/* Returns the input of a painter as text: the whole static and moving layers. */
char *running_house_picture_at(void *session, double time) {
    laboratory->update(session, time);
    laboratory->set_camera(session, (Camera){.zoom = 1}); /* everything is added again */
    laboratory->update(session, time);
    CHECK(!laboratory->show(session, time));
    Text text = {0};
    running_house_add_scene(&text, laboratory->added(session));
    running_house_add_scene(&text, laboratory->moving(session));
    return text.text;
}
