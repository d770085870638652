#include "result/shake_findings.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "pens.h"
#include "result/shake.h"
#include "scratch.h"
#include "experiment/house_experiment.h"
#include "visual/house/shake_plots.h"
#include "visual/house/shake_scene.h"

/* A corridor of 6 m, 1.2 m clear, with a shelf that bars it when it falls and another that falls into a corner. */
#define CORRIDOR                                                                                                       \
    "{'format': 'clearance-house', 'version': 1, 'name': 'corridor', 'walls': ["                                       \
    "{'id': 'south', 'points': [[0, -0.05], [6, -0.05]], 'thickness': 0.1},"                                           \
    "{'id': 'north', 'points': [[0, 1.25], [6, 1.25]], 'thickness': 0.1},"                                             \
    "{'id': 'west', 'points': [[-0.05, -0.05], [-0.05, 1.25]], 'thickness': 0.1}],"                                    \
    "'furniture': [{'id': 'shelf', 'name': 'shelf', 'centre': [3, 0.15], 'size': [0.5, 0.3], 'height': 0.9,"           \
    "'topples': 'back'}, {'id': 'stand', 'centre': [0.1, 1.15], 'size': [0.1, 0.1], 'height': 0.1,"                    \
    "'topples': 'left'}],"                                                                                             \
    "'exits': [{'id': 'e1', 'from': [5, 0], 'to': [5, 1.2]}],"

typedef struct Case {
    char path[SCRATCH_PATH], profiles[4096];
    HouseOptions options;
    Experiment experiment;
    Study study;
    ShakeFindings findings;
} Case;

static void open_case(Case *made, const char *text, size_t shakes, int jobs) {
    *made = (Case){.path = ""};
    scratch_write(made->path, text);
    snprintf(made->profiles, sizeof made->profiles, "%s/assets/profiles", check_source());
    made->options = (HouseOptions){.profiles = made->profiles, .seed = 1, .driving = -1, .shake = true};
    Fault fault = {0};
    CHECK(house_experiment_open(&made->experiment, made->path, &made->options, NULL, &fault));
    made->study = (Study){.experiment = &made->experiment, .pass_count = 1, .runs = shakes, .seed = 1};
    CHECK(study_check(&made->study, &fault));
    check_say(&fault);
    study_begin(&made->study);
    study_run(&made->study, &(StudyOptions){.jobs = jobs});
    made->findings = shake_findings_make(&made->study);
}

static void close_case(Case *made) {
    shake_findings_free(&made->findings);
    study_clear(&made->study);
    house_experiment_close(&made->experiment);
    unlink(made->path);
}

static bool has_label(const Scene *scene, const char *text) {
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_LABEL && strcmp(scene->primitives[i].text, text) == 0)
            return true;
    return false;
}

LONG_TEST(what_falls_across_the_only_way_is_what_stops_people) {
    Case made;
    open_case(&made, CORRIDOR "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [1, 0.6]}]}", 12, 2);
    const ShakeFindings *findings = &made.findings;
    const ShakePiece *shelf = &findings->pieces[0], *stand = &findings->pieces[1];
    CHECK(findings->shakes == 12 && findings->party_count == 1 && findings->piece_count == 2);
    CHECK(shelf->index == 0 && shelf->stops.good == shelf->toppled && shelf->with_loss == shelf->toppled);
    CHECK(shelf->toppled > 0 && shelf->toppled < 12 && stand->toppled > 0 && stand->stops.good == 0);
    CHECK(findings->all_out.good == 12 - shelf->toppled && findings->time.count == findings->all_out.good);
    CHECK(findings->parties[0].out.good == findings->all_out.good && findings->elsewhere.good == 0);
    CHECK(findings->worst && strstr(findings->made_by, "--set furniture.shelf.toppled=true"));
    close_case(&made);
}

TEST(the_picture_and_the_plot_say_it) {
    Case made;
    open_case(&made, CORRIDOR "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [1, 0.6]}]}", 8, 1);
    shake_findings_run_calm(&made.findings, SIZE_MAX, 1, NULL);
    CHECK(made.findings.calm == SHAKE_CALM_OUT && made.findings.calm_time > 0);
    Scene scene;
    char text[64];
    shake_scene_make(&scene, &made.findings);
    const ShakePiece *shelf = &made.findings.pieces[0];
    snprintf(text, sizeof text, "shelf blocks in %.0f %%", 100 * shelf->stops.value);
    CHECK(has_label(&scene, text));
    snprintf(text, sizeof text, "A: out in %zu of 8", made.findings.all_out.good);
    CHECK(has_label(&scene, text));
    CHECK(scene.title_role == ROLE_ERROR && strstr(scene.title, "of 8 shakes"));
    scene_clear(&scene);
    Arena arena = {0};
    Plot plot;
    CHECK(shake_plots_times(&plot, &made.findings, &arena) && plot.series_count == 1);
    const PlotSeries *series = &plot.series[0];
    CHECK_NEAR(series->y[series->count - 1], 100 * made.findings.all_out.value, 1e-9);
    CHECK(series->y[0] == 0);
    arena_clear(&arena);
    close_case(&made);
}

TEST(each_fact_of_shakes_is_printed_by_all_pens) {
    Case made;
    open_case(&made, CORRIDOR "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [1, 0.6]}]}", 8, 1);
    shake_findings_run_calm(&made.findings, SIZE_MAX, 1, NULL);
    ResultTable people = result_shake_people(&made.findings), pieces = result_shake_furniture(&made.findings),
                answer = result_shake_answer(&made.findings);
    pens_check(&people, 8);
    pens_check(&pieces, 6);
    pens_check(&answer, 8);
    CHECK_NEAR(result_find(&people, 0, "out.share")->number, made.findings.all_out.value, 1e-12);
    CHECK(result_find(&pieces, 0, "toppled")->number == (double)made.findings.pieces[0].toppled);
    result_clear(&people);
    result_clear(&pieces);
    result_clear(&answer);
    close_case(&made);
}

TEST(of_a_crowd_those_who_are_caught_are_not_out) {
    Case made;
    open_case(&made,
              CORRIDOR "'crowds': [{'id': 'c', 'profile': 'adult', 'count': 8,"
                       "'area': [[1, 0.3], [4, 0.3], [4, 0.9], [1, 0.9]]}]}",
              6, 2);
    const ShakeParty *crowd = &made.findings.parties[0];
    CHECK(made.findings.party_count == 1 && crowd->people == 8 && crowd->out.all == 6);
    CHECK(made.findings.caught.good > 0 && crowd->out.good < 6);
    CHECK(crowd->members > crowd->out.value && crowd->members < 1);
    CHECK_TEXT(made.findings.made_by, ""); /* a house with a person inside furniture cannot be read */
    close_case(&made);
}

TEST(shakes_are_the_same_for_any_number_of_threads) {
    Case one, two;
    const char *text = CORRIDOR "'people': [{'id': 'p1', 'profile': 'adult', 'at': [1, 0.6]}]}";
    open_case(&one, text, 10, 1);
    open_case(&two, text, 10, 3);
    CHECK(one.experiment.observable_count == two.experiment.observable_count);
    for (size_t t = 0; t < 10; t++)
        CHECK(memcmp(one.study.trials[t].observed, two.study.trials[t].observed,
                     one.experiment.observable_count * sizeof(double)) == 0);
    close_case(&one);
    close_case(&two);
}
