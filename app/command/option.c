#include "command/option.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exchange/import.h"
#include "plan/profile.h"
#include "visual/beam/beam_plots.h"
#include "visual/house/film.h"
#include "platform/settings.h"

static bool take_setting(Options *options, const char *value) {
    options->settings[options->setting_count++] = value;
    return true;
}

static bool take_whole(const char *value, long long low, long long high, long long *number) {
    char *end;
    errno = 0;
    *number = strtoll(value, &end, 10);
    return *value && !*end && !errno && *number >= low && *number <= high;
}

static bool take_seed(Options *options, const char *value) {
    long long number;
    if (!take_whole(value, 0, INT64_MAX, &number))
        return false;
    options->seed = (uint64_t)number;
    return options->seed_said = true;
}

static bool take_jobs(Options *options, const char *value) {
    long long number;
    if (!take_whole(value, 1, 1024, &number))
        return false;
    options->jobs = (int)number;
    return true;
}

static bool take_out(Options *options, const char *value) {
    options->out = value;
    return *value;
}

static bool take_json(Options *options, const char *value) {
    (void)value;
    return options->json = true;
}

static bool take_quiet(Options *options, const char *value) {
    (void)value;
    return options->quiet = true;
}

static bool take_report(Options *options, const char *value) {
    (void)value;
    return options->report = true;
}

static bool take_observed(Options *options, const char *value) {
    options->observed = value;
    return *value;
}

static bool take_route(Options *options, const char *value) {
    options->route = value;
    return *value;
}

static bool take_driving(Options *options, const char *value) {
    options->driving = strcmp(value, "driver") == 0 ? DRIVING_DRIVER : strcmp(value, "miura") == 0 ? DRIVING_MIURA : -1;
    return options->driving >= 0;
}

/* --until is a parameter like any other. */
static bool take_until(Options *options, const char *value) {
    char *end;
    double seconds = strtod(value, &end);
    if (!*value || *end || !(seconds >= 0))
        return false;
    size_t size = strlen("run.until=") + strlen(value) + 1;
    char *setting = arena_allocate(&options->arena, size);
    snprintf(setting, size, "run.until=%s", value);
    return take_setting(options, setting);
}

static bool take_size(Options *options, const char *value) {
    int used = 0;
    bool good = sscanf(value, "%dx%d%n", &options->width, &options->height, &used) == 2 && !value[used];
    return good && options->width >= 320 && options->height >= 200 && options->width <= 16384 &&
           options->height <= 16384 && (options->size_said = true);
}

/* A number of a range, alone. */
static bool take_number(const char *value, double low, double high, double *number) {
    char *end;
    *number = strtod(value, &end);
    return *value && !*end && *number >= low && *number <= high;
}

static bool take_frames(Options *options, const char *value) {
    return take_number(value, 0.001, 1000, &options->frames);
}

static bool take_slow(Options *options, const char *value) {
    return take_number(value, 0.001, 1e9, &options->slow);
}

static bool take_from(Options *options, const char *value) {
    return take_number(value, 0, 1e9, &options->from);
}

static bool take_to(Options *options, const char *value) {
    return take_number(value, 0, 1e9, &options->to);
}

static bool take_movie(Options *options, const char *value) {
    options->movie = value;
    return *value;
}

static bool take_view(Options *options, const char *value) {
    options->camera.kind = strcmp(value, "raised") == 0 ? VIEW_RAISED : VIEW_PLAN;
    return strcmp(value, "raised") == 0 || strcmp(value, "plan") == 0;
}

static bool take_camera(Options *options, const char *value) {
    Camera *camera = &options->camera;
    int used = 0,
        numbers = sscanf(value, "%lf,%lf%n,%lf%n", &camera->azimuth, &camera->elevation, &used, &camera->zoom, &used);
    bool good = numbers >= 2 && !value[used] && fabs(camera->azimuth) <= 360;
    camera->kind = VIEW_RAISED;
    return good && camera->elevation >= 5 && camera->elevation <= 90 && camera->zoom >= 0.1 && camera->zoom <= 100;
}

static bool take_show(Options *options, const char *value) {
    const char *unknown;
    options->show = film_shown(value, &unknown);
    return options->show >= 0;
}

static bool take_plots(Options *options, const char *value) {
    char fault[PLOT_CHOICE_FAULT];
    PlotChoice beam;
    options->plot_words = value;
    options->plots.count = 0;
    return house_plots_choose(&options->plots, value, fault) || beam_plots_choose(&beam, value, fault);
}

static bool take_measured(Options *options, const char *value) {
    options->measured = value;
    return *value;
}

static bool take_theme(Options *options, const char *value) {
    options->theme = strcmp(value, "board") == 0 ? THEME_BOARD : THEME_PAPER;
    options->theme_said = true;
    return strcmp(value, "board") == 0 || strcmp(value, "paper") == 0;
}

static bool take_vary(Options *options, const char *value) {
    return study_request_vary(&options->study, value, &options->arena);
}

static bool take_spread(Options *options, const char *value) {
    return study_request_spread(&options->study, value, &options->arena);
}

static bool take_sweep(Options *options, const char *value) {
    return study_request_sweep(&options->study, value);
}

static bool take_types(Options *options, const char *value) {
    options->types = value;
    return *value;
}

static bool take_thorough(Options *options, const char *value) {
    (void)value;
    return options->thorough = true;
}

static bool take_paper(Options *options, const char *value) {
    (void)value;
    return options->paper = true;
}

static bool take_runs(Options *options, const char *value) {
    long long number;
    bool good = take_whole(value, 1, STUDY_RUNS_MOST, &number);
    options->study.runs = good ? (size_t)number : 0;
    return good;
}

static bool take_shakes(Options *options, const char *value) {
    long long number;
    bool good = take_whole(value, 1, STUDY_RUNS_MOST, &number);
    options->study.shakes = good ? (size_t)number : 0;
    return good;
}

static bool take_suggest(Options *options, const char *value) {
    (void)value;
    options->suggest = true;
    return true;
}

static bool take_text(Options *options, const char *value) {
    long long number;
    bool good = take_whole(value, 1, SETTINGS_TEXT_MOST, &number);
    options->text = good ? (int)number : 0;
    return good;
}

static bool take_script(Options *options, const char *value) {
    options->script = value;
    return *value;
}

static bool take_benchmark_edit(Options *options, const char *value) {
    return take_number(value, 0.1, 1e6, &options->benchmark_edit);
}

static bool take_benchmark(Options *options, const char *value) {
    return take_number(value, 0.1, 1e6, &options->benchmark);
}

static bool take_reduced_motion(Options *options, const char *value) {
    (void)value;
    return options->reduced_motion = true;
}

static bool take_unit(Options *options, const char *value) {
    options->unit = import_unit(value);
    return options->unit > 0;
}

static bool take_layers(Options *options, const char *value) {
    options->layers = value;
    return *value;
}

static bool take_level(Options *options, const char *value) {
    options->level = value;
    return *value;
}

static bool take_format(Options *options, const char *value) {
    options->format = value;
    return strcmp(value, "wkt") == 0 || strcmp(value, "svg") == 0;
}

const Option option_rows[] = {
    {"--unit", IMPORT_UNITS, FOR_IMPORT, "what the file's numbers are in (default: what the file says, or is usual)",
     take_unit},
    {"--layers", "ROLE=NAME[,NAME ...]", FOR_IMPORT,
     "which layers of a drawing are walls, doors, furniture and exits, for instance walls=A-WALL,A-GLAZ,doors=A-DOOR "
     "(default: by their names)",
     take_layers},
    {"--level", "NAME", FOR_IMPORT, "which storey of a home (default: the lowest)", take_level},
    {"--to", "wkt|svg", FOR_EXPORT, "the walkable area as WKT (default), or the plan as a picture", take_format},
    {"--out", "FILE|DIR", FOR_EXPORT, "write it there (default: WKT to standard output, a picture beside the house)",
     take_out},
    {"--set", "NAME=VALUE", FOR_HOUSES | FOR_OPEN | FOR_EXPORT,
     "change a parameter, for instance door.d1.width=0.8 (repeatable)", take_setting},
    {"--out", "DIR", FOR_RUN,
     "write summary.json, trace.csv, of a house trajectory.sqlite, and plan.png or beam.png, .svg and .pdf there",
     take_out},
    {"--out", "DIR", FOR_COMPARE,
     "write plan.png, .svg and .pdf, B with the ways in A as \"before\", and what other options ask for", take_out},
    {"--out", "DIR", FOR_CASES, "write cases.html, cases.md and cases.json there", take_out},
    {"--out", "DIR", FOR_STUDY,
     "write summary.json, study.csv and plots there, and study.sqlite, from which a study that was stopped goes on",
     take_out},
    {"--vary", "NAME=FROM:TO:STEPS", FOR_STUDY,
     "from FROM to TO in STEPS values, both ends among them, for instance door.d1.width=0.7:1:31 (at most twice)",
     take_vary},
    {"--runs", "N", FOR_STUDY, "runs of each point, with seeds of their own, 1 to 100000 (default 1)", take_runs},
    {"--shake", "N", FOR_STUDY,
     "of a house: so many earthquakes, with seeds from --seed on; in each, furniture topples by its probability, then "
     "ways are planned anew: who gets out how often and how fast, what stops them",
     take_shakes},
    {"--spread", "NAME=SHARE", FOR_STUDY,
     "in each run the number is off by a normal deviate of this share of it, such as 0.02 (repeatable)", take_spread},
    {"--sweep", "reset,up,down", FOR_STUDY,
     "each run from its start, or from where its neighbour below or above ended; a list (default reset)", take_sweep},
    {"--types", "NAME[,NAME ...]", FOR_STUDY,
     "tell type I, II or III in a window of 1 % in each of these numbers, from 16 starts, and what is beyond; with "
     "--vary, of each point",
     take_types},
    {"--thorough", NULL, FOR_STUDY, "of a beam: tell each run as `run` does, with exponents and the 0-1 test; slower",
     take_thorough},
    {"--paper", NULL, FOR_STUDY,
     "of a beam: each claim and figure of Gu and Dubowsky's paper beside ours; --out has them as a page", take_paper},
    {"--suggest", NULL, FOR_CHECK,
     "when somebody does not get out: the smallest changes that let everybody out, doors widened, furniture moved, "
     "turned or stood up, each tried by simulation",
     take_suggest},
    {"--report", NULL, FOR_RUN | FOR_COMPARE | FOR_STUDY,
     "write report.html and report.pdf to --out, to be handed on; of a study, with --shake", take_report},
    {"--observed", "FILE", FOR_RUN, "measured loci for the report: CSV with columns time, x, y and person",
     take_observed},
    {"--json", NULL, FOR_HOUSES | FOR_CASES | FOR_IMPORT, "the answer as one JSON object and nothing else", take_json},
    {"--route", "ID", FOR_RUN | FOR_STUDY | FOR_OPEN, "only this route's people", take_route},
    {"--driving", "miura|driver", (FOR_HOUSES & ~FOR_LOCI) | FOR_OPEN, "drive everybody this way", take_driving},
    {"--until", "SECONDS", FOR_RUN | FOR_COMPARE | FOR_STUDY, "give up at this simulated time", take_until},
    {"--seed", "N", FOR_HOUSES | FOR_CASES | FOR_OPEN, "seed of all chance, from 0 (default 1)", take_seed},
    {"--jobs", "N", FOR_HOUSES | FOR_CASES | FOR_OPEN,
     "threads, from 1 (default: one a processor); the answer is the same", take_jobs},
    {"--frames", "FPS", FOR_FILMS,
     "write so many pictures of each second (of a beam: of film) to DIR/frames/frame-00001.png and so on", take_frames},
    {"--movie", "FILE", FOR_FILMS, "make a film of them (30 a second where --frames does not say), by ffmpeg",
     take_movie},
    {"--slow", "TIMES", FOR_RUN, "of a beam: so many times slower (default: so that a cycle takes some 1.5 s)",
     take_slow},
    {"--from", "SECONDS", FOR_FILMS, "begin them at this time (default 0)", take_from},
    {"--to", "SECONDS", FOR_FILMS, "end them at this time (default: when the last is out, or 8 cycles of a beam)",
     take_to},
    {"--view", VIEW_WORDS, FOR_FILMS, "seen from above, or raised: then also DIR/raised.png, at the end", take_view},
    {"--camera", "AZ,EL[,ZOOM]", FOR_FILMS,
     "raised from this azimuth (0: up the plan) and elevation, 5 to 90 degrees, so many times larger (default 10,60,1)",
     take_camera},
    {"--show", FILM_WORDS, FOR_FILMS, "show also discs that cover the chairs, planned ways, widths at corners; a list",
     take_show},
    {"--plots", HOUSE_PLOTS_WORDS, FOR_FILMS,
     "curves beside the house, in place of the list, and as DIR/plot-NAME.png, .svg, .pdf and .csv; a list; of a "
     "beam: " BEAM_PLOTS_WORDS " (default " BEAM_PLOTS_USUAL ")",
     take_plots},
    {"--measured", "FILE", FOR_RUN | FOR_STUDY,
     "measured points laid over the plots of a beam or a study: CSV with columns like time [s] and force [N], or "
     "drive.frequency [Hz] and peak_max [N]",
     take_measured},
    {"--size", "WxH", FOR_FILMS | FOR_STUDY | FOR_EXPORT,
     "size of the pictures in pixels, 320x200 to 16384x16384 (default 1280x720)", take_size},
    {"--size", "WxH", FOR_OPEN, "size of the window in pixels, 320x200 to 16384x16384 (default: as last time)",
     take_size},
    {"--theme", THEME_WORDS, FOR_FILMS | FOR_STUDY | FOR_EXPORT, "light or dark pictures", take_theme},
    {"--theme", THEME_WORDS, FOR_OPEN, "light or dark (default: as last time)", take_theme},
    {"--text", "1|2|3", FOR_OPEN, "size of the text (default: as last time)", take_text},
    {"--reduced-motion", NULL, FOR_OPEN, "nothing moves but what is simulated", take_reduced_motion},
    {"--script", "FILE", FOR_OPEN, "do what this file says, as a person would; for tests and lessons", take_script},
    {"--benchmark-window", "SECONDS", FOR_OPEN, "play for so long, say how many pictures a second there were, and end",
     take_benchmark},
    {"--benchmark-edit", "SECONDS", FOR_OPEN,
     "drag a wardrobe for so long, say how long the answer takes after each move, and end", take_benchmark_edit},
    {"--quiet", NULL, FOR_HOUSES | FOR_CASES, "no progress", take_quiet},
};
const size_t option_count = sizeof option_rows / sizeof *option_rows;
_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTIONS_MOST, "room for their names");
