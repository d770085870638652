#include "experiment/house_experiment.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "scratch.h"
#include "base/stop.h"
#include "experiment/drivers.h"
#include "house/run.h"
#include "study/study.h"
#include "study/summary.h"

/* A corridor of 6 m, 1.2 m clear, with a door across its middle, a cupboard behind the person and the exit at its
 * end. */
static const char corridor[] = "{'format': 'clearance-house', 'version': 1, 'name': 'corridor', 'walls': ["
                               "{'id': 'south', 'points': [[0, -0.05], [6, -0.05]], 'thickness': 0.1},"
                               "{'id': 'north', 'points': [[0, 1.25], [6, 1.25]], 'thickness': 0.1},"
                               "{'id': 'west', 'points': [[-0.05, -0.05], [-0.05, 1.25]], 'thickness': 0.1},"
                               "{'id': 'middle', 'points': [[3, 0], [3, 1.2]], 'thickness': 0.1}],"
                               "'doors': [{'id': 'd1', 'wall': 'middle', 'at': 0.6, 'width': 1}],"
                               "'furniture': [{'id': 'f1', 'centre': [0.2, 0.2], 'size': [0.2, 0.2]}],"
                               "'exits': [{'id': 'e1', 'from': [5, 0], 'to': [5, 1.2]}],"
                               "'people': [{'id': 'p1', 'profile': 'manual-chair', 'at': [1, 0.6]}],"
                               "'routes': [{'id': 'A', 'people': ['p1'], 'exit': 'e1'}]}";

static const char crowd[] =
    "{'format': 'clearance-house', 'version': 1, 'name': 'crowd', 'walls': ["
    "{'id': 'w1', 'points': [[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]], 'thickness': 0.1}],"
    "'doors': [{'id': 'd1', 'wall': 'w1', 'segment': 1, 'at': 2, 'width': 1}],"
    "'exits': [{'id': 'e1', 'from': [6, 1.5], 'to': [6, 2.5]}],"
    "'crowds': [{'id': 'c1', 'profile': 'adult', 'count': 8, 'area': [[0.5, 0.5], [4, 0.5], [4, 3.5], [0.5, 3.5]]}]}";

typedef struct Case {
    char path[SCRATCH_PATH], profiles[4096];
    Experiment experiment;
} Case;

static HouseOptions options_of(const Case *made) {
    return (HouseOptions){.profiles = made->profiles, .seed = 1, .driving = -1};
}

static void open_case(Case *made, const char *text) {
    scratch_write(made->path, text);
    snprintf(made->profiles, sizeof made->profiles, "%s/assets/profiles", check_source());
    Fault fault = {0};
    HouseOptions options = options_of(made);
    CHECK(house_experiment_open(&made->experiment, made->path, &options, NULL, &fault));
    check_say(&fault);
}

static void close_case(Case *made) {
    house_experiment_close(&made->experiment);
    unlink(made->path);
}

static Study sweep(const Case *made, const char *name, double from, double to, size_t steps) {
    return (Study){.experiment = &made->experiment,
                   .axes = {{name, from, to, steps}},
                   .axis_count = 1,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = 1};
}

static void run_study(Study *study, int jobs) {
    Fault fault = {0};
    CHECK(study_check(study, &fault));
    check_say(&fault);
    study_begin(study);
    study_run(study, &(StudyOptions){.jobs = jobs});
    CHECK(study_done(study) == study->trial_count);
}

/* Runs the same as `run --set`. */
static Observation run_alone(const Case *made, House *house, const char *setting, uint64_t seed) {
    HouseOptions options = options_of(made);
    Fault fault = {0};
    Observation observation;
    options.settings = &setting;
    options.setting_count = setting ? 1 : 0;
    options.seed = seed;
    *house = (House){.seed = 0};
    CHECK(house_read(house, made->path, &options, &fault));
    run_house(&observation, house, &(RunOptions){.route = SIZE_MAX, .jobs = 1});
    return observation;
}

TEST(a_wider_door_lets_the_chair_out_and_costs_less_time) {
    Case made;
    open_case(&made, corridor);
    Study study = sweep(&made, "door.d1.width", 0.55, 1.15, 7);
    run_study(&study, 2);
    CHECK_TEXT(made.experiment.observables[made.experiment.measure].unit, "s");
    size_t count;
    SummaryRange *ranges = summary_ranges(&study, 0, 0, &count);
    CHECK(count == 2 && ranges[0].state == SUMMARY_IRREGULAR && ranges[1].state == SUMMARY_REGULAR);
    /* the chair is 0.63 m wide */
    CHECK(count == 2 && study_value(&study.axes[0], ranges[0].last) < 0.75);
    CHECK(count == 2 && study_value(&study.axes[0], ranges[1].first) > 0.63);
    const double *narrow = study.trials[ranges[count - 1].first].observed, *wide = study.trials[6].observed;
    CHECK(wide[HOUSE_TIME] < narrow[HOUSE_TIME] && wide[HOUSE_NARROWEST] > narrow[HOUSE_NARROWEST]);
    CHECK(isnan(study.trials[0].observed[HOUSE_TIME]) && study.trials[0].observed[HOUSE_NOT_OUT] == 1);
    memory_free(ranges);
    study_clear(&study);
    close_case(&made);
}

TEST(each_point_has_the_same_drivers) {
    Case made;
    Population population = {0};
    Fault fault = {0};
    open_case(&made, corridor);
    uint64_t before = made.experiment.identity;
    CHECK(population_read(&population, scratch_source("assets/populations/manual-jp.json"), &fault));
    check_say(&fault);
    Drivers drivers;
    drivers_run(&drivers, house_experiment_house(&made.experiment), &population, 2, SIZE_MAX, 1, NULL);
    house_experiment_drive(&made.experiment, &population);
    CHECK(made.experiment.identity != before && !population.rows);
    Study study = sweep(&made, "person.p1.delay", 0, 2, 2);
    study.runs = 2;
    study.seed = 1;
    run_study(&study, 2);
    for (size_t r = 0; r < 2; r++) {
        const double *first = study.trials[study_index(&study, 0, r, 0, 0)].observed;
        const double *second = study.trials[study_index(&study, 0, r, 0, 1)].observed;
        CHECK_NEAR(first[HOUSE_TIME], drivers.runs[r].time, 0);
        CHECK_NEAR(first[HOUSE_NARROWEST], drivers.runs[r].narrowest, 0);
        CHECK_NEAR(second[HOUSE_TIME], first[HOUSE_TIME] + 2, 0.002);
    }
    CHECK(drivers.runs[0].time != drivers.runs[1].time);
    drivers_free(&drivers);
    study_clear(&study);
    close_case(&made);
}

TEST(each_run_is_the_one_that_run_makes) {
    static const char *const settings[] = {"door.d1.width=0.85", "door.d1.width=1", "door.d1.width=1.15"};
    Case made;
    open_case(&made, corridor);
    Study study = sweep(&made, "door.d1.width", 0.85, 1.15, 3);
    run_study(&study, 1);
    for (size_t i = 0; i < 3; i++) {
        House house;
        Observation alone = run_alone(&made, &house, settings[i], 1);
        const double *observed = study.trials[i].observed;
        CHECK(observed[HOUSE_TIME] == alone.time && observed[HOUSE_COMPLETED] == alone.completed);
        CHECK(observed[HOUSE_NARROWEST] == alone.people[0].narrowest);
        CHECK(observed[HOUSE_CONTACTS] == alone.people[0].contacts);
        CHECK(observed[HOUSE_PEAK_FORCE] == alone.people[0].peak_force);
        CHECK(observed[HOUSE_RING_TIME] == alone.people[0].ring_time);
        CHECK(observed[HOUSE_LOST_TIME] == alone.people[0].lost_time);
        observation_free(&alone);
        house_free(&house);
    }
    study_clear(&study);
    close_case(&made);
}

TEST(seeds_place_a_crowd_as_they_do_in_run) {
    Case made;
    open_case(&made, crowd);
    Study study = {.experiment = &made.experiment, .passes = {STUDY_RESET}, .pass_count = 1, .runs = 4};
    run_study(&study, 2); /* seeds 0 to 3 */
    for (uint64_t seed = 0; seed < 4; seed++) {
        House house;
        Observation alone = run_alone(&made, &house, NULL, seed ? seed : 1);
        CHECK(study.trials[seed].observed[HOUSE_TIME] == alone.time);
        observation_free(&alone);
        house_free(&house);
    }
    CHECK(study.trials[0].observed[HOUSE_TIME] == study.trials[1].observed[HOUSE_TIME]);
    CHECK(study.trials[1].observed[HOUSE_TIME] != study.trials[2].observed[HOUSE_TIME]);
    study_clear(&study);
    close_case(&made);
}

TEST(any_number_of_jobs_gives_the_same_house_study) {
    uint64_t digests[3];
    Case made;
    open_case(&made, crowd);
    for (int i = 0; i < 3; i++) {
        Study study = sweep(&made, "profile.adult.free_speed", 1, 1.5, 3);
        study.spreads[0] = (StudySpread){"door.d1.width", 0.05};
        study.spread_count = 1;
        study.runs = 2;
        study.seed = 1;
        run_study(&study, 1 << i);
        digests[i] = summary_digest(&study);
        study_clear(&study);
    }
    CHECK(digests[0] == digests[1] && digests[1] == digests[2]);
    close_case(&made);
}

TEST(whatever_can_be_set_to_a_number_can_be_varied) {
    Case made;
    open_case(&made, corridor);
    const Experiment *experiment = &made.experiment;
    const struct {
        const char *name, *unit;
        double nominal;
    } names[] = {
        {"door.d1.width", "m", 1},
        {"person.p1.x", "m", 1},
        {"person.p1.at.y", "m", 0.6},
        {"person.p1.delay", "s", 0},
        {"furniture.f1.angle", "degree", 0},
        {"furniture.f1.centre.x", "m", 0.2},
        {"exit.e1.from.y", "m", 0},
        {"wall.middle.thickness", "m", 0.1},
        {"run.dt", "s", 0.001},
        {"run.reversals", "1", 6},
        {"profile.manual-chair.width", "m", 0.63},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const Parameter *row = experiment->parameter(experiment->given, names[i].name);
        CHECK(row);
        CHECK_TEXT(row ? row->unit : names[i].name, names[i].unit);
        CHECK_NEAR(experiment->nominal(experiment->given, names[i].name), names[i].nominal, 0);
    }
    close_case(&made);
}

TEST(what_cannot_be_varied_is_told_with_what_would_be_right) {
    static const char *const wrong[][2] = {
        {"door.d2.width", "there is no door \"d2\""},
        {"door.d1.widht", "door has no parameter \"widht\", did you mean \"width\"?"},
        {"door.d1.state", "state is not a number"},
        {"person.p1.at", "at is a point, must be at.x or at.y"},
        {"furniture.f1.x", "furniture parameter \"x\" must be centre.x or size.x"},
        {"wall.west.points", "points is not a number"},
        {"profile.adult.width", "no person has the profile \"adult\""},
        {"profile.manual-chair.widht", "profile has no parameter \"widht\", did you mean \"width\"?"},
        {"profile.manual-chair.driving", "driving is not a number"},
        {"profile.manual-chair.time_gap",
         "drive.time_gap does not apply to manual-chair: people of this profile drive"},
        {"crowds", "\"crowds\" is not a parameter name: it must be run.NAME, or KIND.ID.NAME such as door.d1.width or "
                   "profile.manual-chair.width"},
    };
    Case made;
    open_case(&made, corridor);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Fault fault = {0};
        CHECK(!made.experiment.parameter(made.experiment.given, wrong[i][0]));
        made.experiment.unknown(made.experiment.given, wrong[i][0], "", &fault);
        CHECK(fault.count == 1);
        CHECK_TEXT(fault.count ? fault.lines[0] : "", wrong[i][1]);
        fault_clear(&fault);
    }
    close_case(&made);
}

TEST(a_value_that_the_house_does_not_allow_is_a_fault_of_its_run_alone) {
    Case made;
    open_case(&made, corridor);
    Study study = sweep(&made, "person.p1.x", 1, 3, 3); /* the last stands in the door's wall */
    run_study(&study, 2);
    CHECK(!study.trials[0].fault && study.trials[0].observed[HOUSE_COMPLETED] == 1);
    Study wide = sweep(&made, "door.d1.width", 1, 1.4, 2); /* wider than its wall */
    run_study(&wide, 1);
    CHECK(!wide.trials[0].fault && wide.trials[1].fault && isnan(wide.trials[1].observed[HOUSE_COMPLETED]));
    CHECK(wide.trials[1].fault && strstr(wide.trials[1].fault, "door d1"));
    study_clear(&study);
    study_clear(&wide);
    close_case(&made);
}

TEST(a_start_nearer_to_the_exit_is_sooner_out) {
    Case made;
    open_case(&made, corridor);
    Study study = sweep(&made, "person.p1.x", 0.8, 1.6, 3);
    run_study(&study, 1);
    for (size_t i = 0; i < 2; i++)
        CHECK(study.trials[i + 1].observed[HOUSE_TIME] < study.trials[i].observed[HOUSE_TIME]);
    study_clear(&study);
    close_case(&made);
}

TEST(a_run_that_is_stopped_is_not_done) {
    Case made;
    open_case(&made, corridor);
    Study study = sweep(&made, "door.d1.width", 0.9, 1, 2);
    study_begin(&study);
    const Stop stop = {1};
    made.experiment.run(made.experiment.given, study.names, 1, study.trials, 2, false, &stop);
    CHECK(study_done(&study) == 0);
    study_clear(&study);
    close_case(&made);
}

TEST(a_route_that_is_not_there_is_told_of) {
    Case made;
    open_case(&made, corridor);
    Experiment experiment = {0};
    HouseOptions options = options_of(&made);
    Fault fault = {0};
    CHECK(house_experiment_open(&experiment, made.path, &options, "A", &fault));
    CHECK(experiment.identity != made.experiment.identity);
    house_experiment_close(&experiment);
    CHECK(!house_experiment_open(&experiment, made.path, &options, "B", &fault));
    CHECK(fault.count && strstr(fault.lines[0], "has no route \"B\", its routes are A"));
    fault_clear(&fault);
    close_case(&made);
}
