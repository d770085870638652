#include "experiment/ablation.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "house/run.h"

const AblationRow ablation_rows[ABLATIONS] = {
    [ABLATION_WHOLE] = {"whole law", "the driver as described", {NULL, NULL}, -1},
    [ABLATION_NO_RING] = {"ring off", "no personal space: the line is held by sight alone", {"run.ring=off", NULL}, -1},
    [ABLATION_RING_PUSHES] = {"ring pushes",
                              "the personal space pushes the chair, with the forces of the paper",
                              {"run.ring=push", NULL},
                              -1},
    [ABLATION_NO_WANDER] = {"wander off", "no errors of steering", {"run.wander=off", NULL}, -1},
    [ABLATION_NO_HANDS] = {"hands off", "no room for hands at the rims", {"run.hands=off", NULL}, -1},
    [ABLATION_STRONG] = {"strength unlimited",
                         "as much push and turning moment as is wanted",
                         {"profile.%s.drive.push=5000", "profile.%s.drive.turning_moment=1000"},
                         -1},
    [ABLATION_PAPER] = {"miura", "the disc of the paper, with our lateral control", {NULL, NULL}, DRIVING_MIURA},
    [ABLATION_PAPER_NO_F4] = {"miura - F4",
                              "without the centripetal force F4",
                              {"run.centripetal=off", NULL},
                              DRIVING_MIURA},
    [ABLATION_PAPER_NO_LATERAL] = {"miura - lateral",
                                   "without our lateral control: as the paper is written",
                                   {"run.lateral=off", NULL},
                                   DRIVING_MIURA},
};

static bool read_variant(House *house, const char *path, const HouseOptions *options, const AblationRow *row,
                         const char *profile, Fault *fault) {
    Arena arena = {0};
    HouseOptions with = *options;
    const char **settings = memory_zeroed(options->setting_count + ABLATION_SETTINGS, sizeof *settings);
    for (size_t s = 0; s < options->setting_count; s++)
        settings[s] = options->settings[s];
    for (size_t s = 0; s < ABLATION_SETTINGS && row->settings[s]; s++) {
        const char *setting = row->settings[s], *gap = strstr(setting, "%s");
        settings[with.setting_count++] =
            gap ? text_in_arena(&arena, "%.*s%s%s", (int)(gap - setting), setting, profile, gap + 2) : setting;
    }
    with.settings = settings;
    if (row->driving >= 0)
        with.driving = row->driving;
    bool read = house_read(house, path, &with, fault);
    memory_free(settings);
    arena_clear(&arena);
    return read;
}

bool ablation_run(Ablation *ablation, const char *path, const HouseOptions *options, const Population *population,
                  size_t count, int jobs, const Stop *stop, Fault *fault) {
    *ablation = (Ablation){0};
    for (int v = 0; v < ABLATIONS && !ablation->interrupted; v++) {
        House house = {0};
        if (!read_variant(&house, path, options, &ablation_rows[v], population->profile, fault)) {
            ablation_free(ablation);
            return false;
        }
        drivers_run(&ablation->drivers[v], &house, population, count, SIZE_MAX, jobs, stop);
        ablation->interrupted |= ablation->drivers[v].interrupted;
        if (v > ABLATION_WHOLE) {
            house_free(&house);
            continue;
        }
        run_house(&ablation->nominal, &house,
                  &(RunOptions){.route = SIZE_MAX, .jobs = jobs, .stop = stop, .brief = true});
        ablation->interrupted |= ablation->nominal.interrupted;
        ablation->house = house;
        ablation->house.space.outline = &ablation->house.outline;
    }
    return true;
}

void ablation_free(Ablation *ablation) {
    for (int v = 0; v < ABLATIONS; v++)
        drivers_free(&ablation->drivers[v]);
    observation_free(&ablation->nominal);
    house_free(&ablation->house);
    *ablation = (Ablation){0};
}
