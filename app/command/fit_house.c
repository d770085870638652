#include "command/fit_house.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "command/house_file.h"
#include "exchange/table.h"
#include "experiment/house_experiment.h"
#include "laboratory/shipped.h"
#include "plan/observed_times.h"
#include "report/report_loci.h"

void fit_house_add_row(FitJob *job, FitRow row) {
    Fit *fit = &job->fit;
    fit->rows = memory_reserve(fit->rows, &job->row_capacity, fit->row_count + 1, sizeof *fit->rows);
    fit->rows[fit->row_count++] = row;
}

#define TIME_DEVIATION 0.5    /* s, of a measured time without one: assumed */
#define OFFSET_DEVIATION 0.03 /* m, of a place of a measured locus, across it: assumed */
#define SPEED_DEVIATION 0.1   /* m/s, of the speed there: assumed */

enum { HEADING = 4096 /* bytes of a row of names */ };

static double deviation_of(const TimedRun *run, const PlanRoute *route) {
    double measured = observed_times_of(&route->observed).deviation;
    return !isnan(run->deviation) ? run->deviation : measured > 0 ? measured : TIME_DEVIATION;
}

/* Takes the means that the house file holds: their standard error is the deviation of one run by sqrt(runs). */
static void take_means(FitJob *job, const Plan *plan) {
    for (size_t r = 0; r < plan->route_count; r++) {
        ObservedTimes observed = observed_times_of(&plan->routes[r].observed);
        double error =
            observed.deviation > 0 && observed.runs > 1 ? observed.deviation / sqrt(observed.runs) : TIME_DEVIATION;
        Timed *timed = &job->timed;
        if (!observed.runs)
            continue;
        timed->runs = memory_reserve(timed->runs, &timed->capacity, timed->count + 1, sizeof *timed->runs);
        timed->runs[timed->count++] =
            (TimedRun){.route = plan->routes[r].id, .time = observed.mean, .deviation = error};
    }
}

/* Opens an experiment of a route (NULL: of all people); NULL after an error. */
static Experiment *open_experiment(FitJob *job, const char *route, const char *kind, Fault *fault) {
    job->experiments = memory_reserve(job->experiments, &job->experiment_capacity, job->experiment_count + 1,
                                      sizeof *job->experiments);
    Experiment *experiment = &job->experiments[job->experiment_count];
    if (!house_experiment_open(experiment, job->options->files[0], &job->house_options, route, fault))
        return NULL;
    experiment->kind = kind;
    job->experiment_count++;
    return experiment;
}

/* Returns the number of the experiment of a route, opened once; SIZE_MAX after an error. */
static size_t open_route(FitJob *job, const char *id, Fault *fault) {
    for (size_t e = 0; e < job->experiment_count; e++)
        if (strcmp(job->experiments[e].kind, id) == 0)
            return e;
    return open_experiment(job, id, id, fault) ? job->experiment_count - 1 : SIZE_MAX;
}

static void add_times(FitJob *job, const Plan *plan, Fault *fault) {
    for (size_t i = 0; i < job->timed.count; i++) {
        TimedRun *run = &job->timed.runs[i];
        size_t route = plan_find_route(plan, run->route);
        if (route == SIZE_MAX) {
            fault_add(fault, "%s:%d:1: the house has no route \"%s\"", run->path, run->line, run->route);
            continue;
        }
        const char *id = arena_text(&job->arena, run->route);
        size_t experiment = open_route(job, id, fault);
        if (experiment != SIZE_MAX)
            fit_house_add_row(job, (FitRow){.observable = HOUSE_TIME,
                                            .way = HOUSE_WAY,
                                            .observed = run->time,
                                            .deviation = deviation_of(run, &plan->routes[route]),
                                            .group = experiment,
                                            .label = text_in_arena(&job->arena, "route %s", id)});
    }
}

/* Adds the places of a measured locus: how far beside it the chair drives, and how fast. */
static void add_locus(FitJob *job, const House *house, const ObservedLoci *of, const ObservedLocus *observed,
                      Fault *fault) {
    size_t person = report_loci_person(house, observed->person);
    const PlanRoute *route = house->people[person].route;
    const char *kind = text_in_arena(&job->arena, "locus %zu", job->experiment_count + 1);
    Experiment *experiment = open_experiment(job, route ? route->id : NULL, kind, fault);
    if (!experiment)
        return;
    const LocusRecord *record = house_experiment_follow(experiment, &observed->locus, person);
    if (!record->count)
        fault_add(fault, "%s:%d:1: the locus of %s is too short, must be at least %g m long", of->path, observed->line,
                  house->people[person].id, 2 * LOCUS_RECORD_STEP);
    for (size_t k = 0; k < 2 * record->count; k++) {
        size_t place = k % record->count;
        bool speed = k >= record->count;
        fit_house_add_row(job, (FitRow){.observable = record->first + k,
                                        .way = HOUSE_WAY,
                                        .observed = speed ? record->speed[place] : 0,
                                        .deviation = speed ? SPEED_DEVIATION : OFFSET_DEVIATION,
                                        .group = job->experiment_count - 1,
                                        .label = text_in_arena(&job->arena, "%s at %.2f m", house->people[person].id,
                                                               record->way[place])});
    }
}

static bool is_name(const char *text, size_t length, const char *name) {
    return strlen(name) == length && strncasecmp(text, name, length) == 0;
}

/* True of a table with the columns x and y: it holds loci. */
static bool holds_loci(const char *path) {
    char line[HEADING] = "", unit[TABLE_SHOWN];
    bool x = false, y = false;
    FILE *file = fopen(path, "r");
    if (file && !fgets(line, sizeof line, file))
        *line = 0;
    if (file)
        fclose(file);
    char *rest = line, *word;
    while ((word = strsep(&rest, ",;\t\r\n"))) {
        word += strspn(word, " \"\xef\xbb\xbf");
        size_t length = table_heading(word, unit);
        x |= is_name(word, length, "x");
        y |= is_name(word, length, "y");
    }
    return x && y;
}

/* Reads the files of --observed, FILE[,FILE ...]. */
static bool read_observed(FitJob *job, const House *house, Fault *fault) {
    char *list = text_copy(job->options->observed), *rest = list, *word;
    bool good = true;
    size_t capacity = 0;
    while ((word = strsep(&rest, ","))) {
        const char *path = arena_text(&job->arena, word);
        if (!holds_loci(path)) {
            good &= timed_read(&job->timed, path, fault);
            continue;
        }
        ObservedLoci loci = {.path = NULL};
        bool read = observed_read(&loci, path, fault) && report_loci_check(house, &loci, fault);
        job->loci = memory_reserve(job->loci, &capacity, job->loci_count + 1, sizeof *job->loci);
        job->loci[job->loci_count++] = loci;
        good &= read;
    }
    memory_free(list);
    return good;
}

bool fit_house_open(FitJob *job, Fault *fault) {
    const Options *options = job->options;
    House house = {0};
    if (options->measured && !text_read_interrupted()) {
        fault_add(fault, "clearance: --measured is for beams, %s is a house; its times come with --observed",
                  options->files[0]);
        return false;
    }
    if (!house_file_read(&house, options, 0, fault))
        return false;
    job->house_options = (HouseOptions){.profiles = shipped_places()->profiles,
                                        .settings = options->settings,
                                        .setting_count = options->setting_count,
                                        .seed = options->seed,
                                        .driving = options->driving};
    bool good = !options->observed || read_observed(job, &house, fault);
    if (good && !options->observed)
        take_means(job, &house.plan);
    if (good && !job->timed.count && !job->loci_count)
        fault_add(fault, "clearance: no route of %s has observed times, so that --observed FILE is needed",
                  options->files[0]);
    if (good)
        add_times(job, &house.plan, fault);
    for (size_t f = 0; f < job->loci_count && good; f++)
        for (size_t i = 0; i < job->loci[f].count; i++)
            add_locus(job, &house, &job->loci[f], &job->loci[f].loci[i], fault);
    for (size_t r = 0; r < job->fit.row_count; r++)
        job->fit.rows[r].experiment = &job->experiments[job->fit.rows[r].group];
    house_free(&house);
    return good && !fault->total;
}

void fit_house_close(FitJob *job) {
    for (size_t e = 0; e < job->experiment_count; e++)
        house_experiment_close(&job->experiments[e]);
    for (size_t f = 0; f < job->loci_count; f++)
        observed_free(&job->loci[f]);
    memory_free(job->loci);
    timed_free(&job->timed);
}

const char *fit_house_names(FitJob *job) {
    const House *house = house_experiment_house(&job->experiments[0]);
    for (size_t i = 0; i < house->person_count; i++) {
        const Profile *profile = house->people[i].profile;
        if (profile->driving != DRIVING_WALKER)
            return text_in_arena(&job->arena, "profile.%s.free_speed,profile.%s.steering_time", profile->name,
                                 profile->name);
    }
    return NULL;
}
