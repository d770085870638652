#include "study/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "base/text.h"
#include "check.h"
#include "scratch.h"
#include "study/montecarlo.h"
#include "study/study_csv.h"
#include "study/store.h"
#include "study/summary.h"
#include "toy.h"

static Study sweep(const Experiment *experiment, double from, double to, size_t steps) {
    return (Study){.experiment = experiment,
                   .axes = {{"x", from, to, steps}},
                   .axis_count = 1,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = 1};
}

static uint64_t results_in_one_go(int jobs) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = toy_study(&experiment);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = jobs});
    CHECK(study_done(&study) == study.trial_count && study.trial_count == 3 * 3 * 7 * 3);
    uint64_t digest = summary_digest(&study);
    study_clear(&study);
    return digest;
}

static void new_path(char path[SCRATCH_PATH]) {
    scratch_write(path, "");
}

TEST(an_axis_has_both_its_ends_and_equal_steps) {
    StudyAxis axis = {"x", 0.7, 1.0, 31};
    CHECK(study_value(&axis, 0) == 0.7 && study_value(&axis, 30) == 1.0);
    CHECK_NEAR(study_value(&axis, 14), 0.84, 1e-15);
    StudyAxis one = {"x", 5, 5, 1};
    CHECK(study_value(&one, 0) == 5);
}

TEST(a_sweep_gives_the_closed_form_at_every_value) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 4, 17);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    for (size_t i = 0; i < 17; i++) {
        const Trial *trial = study_trial(&study, 0, 0, 0, i);
        double x = 0.25 * (double)i;
        CHECK(trial->done && trial->at[0] == x && trial->observed[TOY_SUM] == x + 20);
        CHECK(trial->observed[TOY_MEMORY] == 0 && trial->series_count == (size_t)x + 1);
    }
    study_clear(&study);
}

TEST(carried_passes_go_up_and_down_each_from_its_own_end) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 1, 3, 3);
    study.passes[0] = STUDY_DOWN;
    study.passes[1] = STUDY_UP;
    study.pass_count = 2;
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 2});
    static const double memory[2][3] = {{5, 3, 0}, {0, 1, 3}};
    for (size_t pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < 3; i++)
            CHECK_NEAR(study_trial(&study, pass, 0, 0, i)->observed[TOY_MEMORY], memory[pass][i], 0);
    study_clear(&study);
}

TEST(any_number_of_jobs_gives_the_same_bits) {
    uint64_t one = results_in_one_go(1);
    CHECK(results_in_one_go(2) == one);
    CHECK(results_in_one_go(4) == one);
    CHECK(results_in_one_go(64) == one);
}

TEST(values_that_cannot_be_run_are_faults_of_their_runs_alone) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 40, 60, 3);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    SummaryCount count = summary_count(&study);
    CHECK(count.done == 3 && count.faults == 1 && count.irregular == 2);
    CHECK_TEXT(study.trials[2].fault, "x is \"60\", at most 50");
    CHECK(isnan(study.trials[2].observed[TOY_SUM]));
    study_clear(&study);
}

/* Runs with interruptions, each time with a new store, until complete. Returns the number of starts. */
static int run_in_pieces(Study *study, Toy *toy, const char *path, int piece, int jobs) {
    int begun = 0;
    for (size_t done = 0; done < study->trial_count || !begun; begun++) {
        study_clear(study);
        study_begin(study);
        Fault fault = {0};
        StoreFound found;
        Store *store = store_open(path, STORE_ALONE, study, study_digest(study, 7), &found, &fault);
        CHECK(store && found.done == done);
        if (!store)
            break;
        *toy = (Toy){.interrupted_after = piece};
        study_run(study, &(StudyOptions){.jobs = jobs, .stop = &toy->stop, .keep = store_write, .keeper = store});
        CHECK(store_close(store, &fault));
        CHECK(study_done(study) >= done);
        done = study_done(study);
    }
    return begun;
}

TEST(a_study_that_was_stopped_ends_as_one_of_one_go_bit_for_bit) {
    uint64_t expected = results_in_one_go(1);
    for (int jobs = 1; jobs <= 4; jobs *= 2) {
        char path[SCRATCH_PATH];
        new_path(path);
        Toy toy = {0};
        Experiment experiment = toy_experiment(&toy);
        Study study = toy_study(&experiment);
        study_begin(&study);
        CHECK(run_in_pieces(&study, &toy, path, 20, jobs) > 5);
        CHECK(summary_digest(&study) == expected);
        study_clear(&study);
        unlink(path);
    }
}

TEST(a_finished_study_is_read_back_without_a_run) {
    char path[SCRATCH_PATH];
    new_path(path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 30, 60, 16); /* some of them invalid */
    study_begin(&study);
    CHECK(run_in_pieces(&study, &toy, path, 0, 1) == 1);
    uint64_t expected = summary_digest(&study);
    study_clear(&study);
    study_begin(&study);
    StoreFound found;
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store && found.done == 16 && found.others == 0);
    CHECK(summary_digest(&study) == expected);
    CHECK(store_close(store, &fault));
    study_clear(&study);
    unlink(path);
}

TEST(a_changed_study_begins_anew_beside_the_old_one) {
    char path[SCRATCH_PATH];
    new_path(path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 1, 5), other = sweep(&experiment, 0, 1, 6);
    study_begin(&study);
    run_in_pieces(&study, &toy, path, 0, 1);
    study_begin(&other);
    StoreFound found;
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &other, study_digest(&other, 7), &found, &fault);
    CHECK(store && found.done == 0 && found.others == 1);
    CHECK(store_close(store, &fault));
    study_clear(&study);
    study_begin(&study);
    store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store && found.done == 5 && found.others == 1);
    CHECK(store_close(store, &fault));
    study_clear(&study);
    study_clear(&other);
    unlink(path);
}

TEST(everything_that_determines_a_study_is_in_its_digest) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy), another = experiment;
    another.identity = 1;
    Study study = toy_study(&experiment);
    uint64_t digest = study_digest(&study, 7);
    CHECK(study_digest(&study, 7) == digest);
    CHECK(study_digest(&study, 8) != digest);
    Study changed[8];
    for (size_t i = 0; i < 8; i++)
        changed[i] = study;
    changed[0].axes[0].from = 0.1;
    changed[1].axes[1].steps = 4;
    changed[2].axes[0].name = "n";
    changed[3].spreads[0].share = 0.06;
    changed[4].pass_count = 2;
    changed[5].runs = 4;
    changed[6].seed = 2;
    changed[7].experiment = &another;
    for (size_t i = 0; i < 8; i++)
        CHECK(study_digest(&changed[i], 7) != digest);
}

/* Writes the file of a finished sweep from 0. */
static void write_finished(char path[SCRATCH_PATH], double last, size_t steps) {
    new_path(path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, last, steps);
    study_begin(&study);
    run_in_pieces(&study, &toy, path, 0, 1);
    study_clear(&study);
}

static void check_store_fault(const char *path, const char *what) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 1, 5);
    study_begin(&study);
    StoreFound found;
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(!store && fault.count == 1);
    CHECK(fault.count && strstr(fault.lines[0], what));
    if (fault.count && !strstr(fault.lines[0], what))
        printf("%s\n", fault.lines[0]);
    CHECK(study_done(&study) == 0);
    fault_clear(&fault);
    study_clear(&study);
}

static void make_database(const char *path, const char *statements) {
    sqlite3 *database = NULL;
    CHECK(sqlite3_open(path, &database) == SQLITE_OK);
    CHECK(sqlite3_exec(database, statements, NULL, NULL, NULL) == SQLITE_OK);
    sqlite3_close(database);
}

TEST(a_file_that_is_no_study_is_told_of_and_stays_as_it_was) {
    char path[SCRATCH_PATH];
    static const char words[] = "This is a letter, not a study, and somebody wants to keep it.";
    scratch_write(path, words);
    check_store_fault(path, "is not a study database");
    char *kept = scratch_read(path);
    CHECK_TEXT(kept, words);
    memory_free(kept);
    unlink(path);
    make_database(path, "CREATE TABLE trajectory_data (frame INTEGER)");
    check_store_fault(path, "another program's database");
    unlink(path);
    check_store_fault("/nowhere/study.sqlite", "cannot be written");
}

TEST(a_damaged_row_is_not_taken_for_a_result) {
    char path[SCRATCH_PATH];
    write_finished(path, 1, 5);
    make_database(path, "UPDATE trial SET observed = zeroblob(24) WHERE trial = 3");
    check_store_fault(path, "is damaged");
    make_database(path, "UPDATE trial SET observed = zeroblob(8) WHERE trial = 3");
    check_store_fault(path, "is damaged");
    unlink(path);
    write_finished(path, 1, 5);
    make_database(path, "UPDATE trial SET note = 'door d2' WHERE trial = 3");
    check_store_fault(path, "is damaged");
    make_database(path, "DROP TABLE trial");
    check_store_fault(path, "is damaged");
    make_database(path, "PRAGMA user_version = 9");
    check_store_fault(path, "has format 9, must be 2");
    unlink(path);
}

TEST(a_file_of_the_version_without_notes_is_read_and_goes_on) {
    char path[SCRATCH_PATH];
    write_finished(path, 1, 5);
    make_database(path, "ALTER TABLE trial DROP COLUMN note; PRAGMA user_version = 1");
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 1, 5);
    study_begin(&study);
    StoreFound found;
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store && found.done == 5 && study_done(&study) == 5 && !study.trials[3].note);
    CHECK(store_close(store, &fault) && fault.count == 0);
    study_clear(&study);
    unlink(path);
}

TEST(a_row_that_is_there_twice_is_a_fault) {
    char path[SCRATCH_PATH];
    write_finished(path, 1, 5);
    make_database(path, "CREATE TABLE twice AS SELECT * FROM trial; INSERT INTO twice SELECT * FROM trial;"
                        "DROP TABLE trial; ALTER TABLE twice RENAME TO trial");
    check_store_fault(path, "is damaged");
    unlink(path);
}

TEST(pages_that_were_overwritten_are_a_fault) {
    char path[SCRATCH_PATH];
    write_finished(path, 40, 400);
    struct stat status;
    CHECK(stat(path, &status) == 0 && status.st_size > 8192);
    FILE *file = fopen(path, "r+b");
    fseek(file, 4096, SEEK_SET);
    for (off_t i = 4096; i < status.st_size; i++)
        fputc(0x55, file);
    fclose(file);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study again = sweep(&experiment, 0, 40, 400);
    study_begin(&again);
    StoreFound found;
    Fault fault = {0};
    CHECK(!store_open(path, STORE_ALONE, &again, study_digest(&again, 7), &found, &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "is damaged"));
    fault_clear(&fault);
    study_clear(&again);
    unlink(path);
}

TEST(two_programs_do_not_write_one_file) {
    char path[SCRATCH_PATH];
    new_path(path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 1, 5);
    study_begin(&study);
    StoreFound found;
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &study, study_digest(&study, 7), &found, &fault);
    CHECK(store);
    check_store_fault(path, "is in use by another program");
    CHECK(store_close(store, &fault));
    study_clear(&study);
    unlink(path);
}

TEST(quantiles_and_errors_are_those_of_the_textbook) {
    double numbers[101];
    for (int i = 0; i <= 100; i++)
        numbers[i] = (double)((i * 37) % 101); /* 0 to 100 in some order */
    Distribution d = montecarlo_distribution(numbers, 101);
    CHECK(d.count == 101 && d.mean == 50 && d.low == 5 && d.median == 50 && d.high == 95);
    CHECK(d.quarters[0] == 25 && d.quarters[1] == 75);
    CHECK_NEAR(d.deviation, sqrt(101 * 102 / 12.0), 1e-12);
    CHECK_NEAR(d.error, d.deviation / sqrt(101), 1e-15);
    const double few[] = {1, NAN, 2};
    d = montecarlo_distribution(few, 3);
    CHECK(d.count == 2 && d.mean == 1.5 && d.median == 1.5 && d.least == 1 && d.greatest == 2);
    CHECK_NEAR(d.low, 1.05, 1e-15);
    d = montecarlo_distribution(few + 1, 1);
    CHECK(d.count == 0 && isnan(d.mean) && isnan(d.low));
    d = montecarlo_distribution(few, 1);
    CHECK(d.count == 1 && d.mean == 1 && isnan(d.deviation) && d.high == 1);
}

TEST(a_tolerance_is_normal_and_the_same_at_every_point) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 1, 3, 2);
    study.spreads[0] = (StudySpread){"x", 0.02};
    study.spreads[1] = (StudySpread){"y", 0.1};
    study.spread_count = 2;
    study.runs = 20000;
    study.seed = 1;
    study_begin(&study);
    CHECK(study.name_count == 2);
    double *x = memory_zeroed(study.runs, sizeof *x), *y = memory_zeroed(study.runs, sizeof *y), product = 0;
    for (size_t run = 0; run < study.runs; run++) {
        const Trial *first = study_trial(&study, 0, run, 0, 0), *second = study_trial(&study, 0, run, 0, 1);
        CHECK(fabs(3 * first->at[0] - second->at[0]) < 1e-14 && first->at[1] == second->at[1]);
        x[run] = first->at[0];
        y[run] = first->at[1];
        product += (x[run] - 1) * (y[run] - 2) / (double)study.runs;
    }
    Distribution of_x = montecarlo_distribution(x, study.runs), of_y = montecarlo_distribution(y, study.runs);
    CHECK_NEAR(of_x.mean, 1, 4 * of_x.error);
    CHECK_NEAR(of_y.mean, 2, 4 * of_y.error);
    CHECK_NEAR(of_x.deviation, 0.02, 4 * 0.02 / sqrt(2 * (double)study.runs));
    CHECK_NEAR(of_y.deviation, 0.2, 4 * 0.2 / sqrt(2 * (double)study.runs));
    CHECK_NEAR(of_x.high, 1 + 1.6449 * 0.02, 0.002);
    CHECK_NEAR(product, 0, 4 * 0.02 * 0.2 / sqrt((double)study.runs)); /* one deviates independently of the other */
    memory_free(x);
    memory_free(y);
    study_clear(&study);
}

TEST(seed_nought_is_the_nominal_run) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 1, 3, 2);
    study.spreads[0] = (StudySpread){"y", 0.1};
    study.spread_count = 1;
    study.runs = 2;
    study_begin(&study);
    CHECK(study_trial(&study, 0, 0, 0, 0)->at[1] == 2 && study_trial(&study, 0, 1, 0, 0)->at[1] != 2);
    study_clear(&study);
}

TEST(a_point_of_many_runs_has_a_share_and_its_error) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 2, 6, 2);
    study.spreads[0] = (StudySpread){"x", 0.1};
    study.spread_count = 1;
    study.runs = 1000;
    study.seed = 1;
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 2});
    MontecarloPoint point = montecarlo_point(&study, 0, 0, 0);
    CHECK(point.done == 1000 && point.decided == 1000 && point.faults == 0);
    CHECK_NEAR(point.share, 0.5, 4 * sqrt(0.25 / 1000)); /* x < 2 half of the time */
    CHECK_NEAR(point.share_high - point.share_low, 2 * 1.96 * sqrt(0.25 / 1000), 0.0005);
    CHECK(summary_point(&study, 0, 0, 0) == SUMMARY_MIXED && summary_point(&study, 0, 0, 1) == SUMMARY_IRREGULAR);
    montecarlo_clear(&point);
    study_clear(&study);
}

TEST(all_of_ten_is_not_certainty) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 4, 2);
    study.runs = 10;
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    MontecarloPoint all = montecarlo_point(&study, 0, 0, 0), none = montecarlo_point(&study, 0, 0, 1);
    CHECK(all.share == 1 && all.share_high == 1);
    CHECK_NEAR(all.share_low, 0.7225, 5e-5); /* 1 / (1 + 1.96^2 / 10) */
    CHECK(none.share == 0 && none.share_low == 0);
    CHECK_NEAR(none.share_high, 0.2775, 5e-5);
    montecarlo_clear(&all);
    montecarlo_clear(&none);
    study_clear(&study);
}

TEST(passes_that_end_in_different_answers_are_seen) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    experiment.outcome = TOY_REGULAR;
    Study study = sweep(&experiment, 1, 3, 3);
    study.passes[0] = STUDY_UP;
    study.passes[1] = STUDY_DOWN;
    study.pass_count = 2;
    study_begin(&study);
    CHECK(!summary_passes_differ(&study, 0, 0)); /* nothing is done */
    study_run(&study, &(StudyOptions){.jobs = 1});
    CHECK(summary_passes_differ(&study, 0, 0)); /* memory 0 and 5: regular and not */
    CHECK(!summary_passes_differ(&study, 0, 1) && !summary_passes_differ(&study, 0, 2));
    study_clear(&study);
}

TEST(ranges_say_where_the_answer_changes) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 0, 60, 61);
    study_begin(&study);
    size_t count;
    SummaryRange *ranges = summary_ranges(&study, 0, 0, &count);
    CHECK(count == 1 && ranges[0].state == SUMMARY_NOTHING);
    memory_free(ranges);
    study_run(&study, &(StudyOptions){.jobs = 1});
    ranges = summary_ranges(&study, 0, 0, &count);
    CHECK(count == 3 && ranges[0].state == SUMMARY_REGULAR && ranges[0].last == 1);
    CHECK(ranges[1].state == SUMMARY_IRREGULAR && ranges[1].first == 2 && ranges[1].last == 50);
    CHECK(ranges[2].state == SUMMARY_NOTHING && ranges[2].last == 60);
    CHECK(summary_extreme(&study, false) == 0 && summary_extreme(&study, true) == 50);
    memory_free(ranges);
    study_clear(&study);
}

TEST(tables_have_a_header_with_units_and_a_row_a_trial) {
    char path[SCRATCH_PATH];
    new_path(path);
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = sweep(&experiment, 2, 52, 2);
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = 1});
    CHECK(study_csv_write_trials(&study, path) == 0);
    char *text = scratch_read(path);
    CHECK_TEXT(text, "x [m],pass [1],seed [1],regular [1],sum [m],memory [m],fault [1]\r\n"
                     "2,reset,0,0,22,0,\r\n"
                     "52,reset,0,,,,\"x is \"\"52\"\", at most 50\"\r\n");
    memory_free(text);
    CHECK(study_csv_write_series(&study, path) == 0);
    text = scratch_read(path);
    CHECK_TEXT(text, "x [m],pass [1],seed [1],place [1],square [m2]\r\n"
                     "2,reset,0,1,0\r\n2,reset,0,2,1\r\n2,reset,0,3,4\r\n");
    memory_free(text);
    CHECK(study_csv_write_points(&study, path) == 0);
    text = scratch_read(path);
    CHECK(strstr(text, "x [m],pass [1],runs [1],faults [1],regular [1],share_regular [1],share_q025 [1],share_q975 "
                       "[1],regular_mean") == text);
    memory_free(text);
    study_clear(&study);
    unlink(path);
}

static void check_fault(Study study, const char *what) {
    Fault fault = {0};
    CHECK(!study_check(&study, &fault));
    CHECK(fault.total == 1 && strstr(fault.lines[0], what));
    if (!fault.count || !strstr(fault.lines[0], what))
        printf("%s, expected %s\n", fault.count ? fault.lines[0] : "no fault", what);
    fault_clear(&fault);
}

TEST(what_cannot_be_studied_is_told_of) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy), fresh = experiment;
    fresh.carries = false;
    Study good = sweep(&experiment, 0, 1, 2), study = good;
    Fault fault = {0};
    CHECK(study_check(&good, &fault));
    study.axes[0].name = "z";
    check_fault(study, "--vary z: unknown parameter of a toy");
    check_fault(sweep(&experiment, 0, 1, 0), "0 steps, must be from 1 to 100000");
    check_fault(sweep(&experiment, 101, 102, 0), "0 steps, must be from 1 to 100000");
    check_fault(sweep(&experiment, 0, 1, 100001), "100001 steps");
    check_fault(sweep(&experiment, 0, 1, 1), "one step cannot be at 0 and at 1");
    check_fault(sweep(&experiment, 1, 1, 2), "FROM and TO must differ");
    check_fault(sweep(&experiment, 0, 101, 2), "101 is out of range, must be from -10 to 100 m");
    check_fault(sweep(&experiment, (double)NAN, 1, 2), "out of range");
    study = good;
    study.axes[0] = (StudyAxis){"n", 0, 4, 4};
    check_fault(study, "must be an integer; use 5 steps");
    study = good;
    study.axes[1] = study.axes[0];
    study.axis_count = 2;
    check_fault(study, "is given twice");
    study.axes[0].steps = study.axes[1].steps = 100000;
    study.axes[1].name = "y";
    check_fault(study, "the study has 10000000000 runs");
    study = good;
    study.seed = INT64_MAX;
    check_fault(study, "--seed 9223372036854775807: is too large");
    study = good;
    study.runs = 0;
    check_fault(study, "--runs 0");
    study = good;
    study.passes[0] = STUDY_UP;
    study.experiment = &fresh;
    check_fault(study, "--sweep up: runs of a toy always restart");
    study.experiment = &experiment;
    study.axis_count = 0;
    check_fault(study, "needs --vary");
    study = good;
    study.spread_count = 1;
    study.spreads[0] = (StudySpread){"y", 0.1};
    check_fault(study, "--runs must be at least 2");
    study.runs = 2;
    CHECK(study_check(&study, &fault));
    study.spreads[0] = (StudySpread){"nothing", 0.1};
    check_fault(study, "the value is 0");
    study.spreads[0] = (StudySpread){"n", 0.1};
    check_fault(study, "is an integer");
    study.spreads[0] = (StudySpread){"y", 2};
    check_fault(study, "must be greater than 0 and at most 1");
    fault_clear(&fault);
}
