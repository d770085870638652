#include "laboratory/house/picture.h"

#include <string.h>

#include "laboratory/house/runs.h"
#include "visual/house/plan_picture.h"

enum { GHOSTS_MOST = 60 /* people: larger crowds have no ghosts, since no person could be recognised */ };

#define OUTSIDE 1.0        /* m, margin around exits, in which people are seen to leave */
#define FIRST_SECONDS 10.0 /* s, least length of the time axis while a run is in progress */
#define THICK_TAIL 2.0     /* s, end of the line that is drawn thick in a plot whose x axis is not time */

static const char *const titles[HOUSE_PLOTS_KNOWN] = {
    "Speed",      "Clearance",        "Contact force", "Personal space pressed", "Sideways phase plane",
    "People out", "Through each exit"};

/* The film --------------------------------------------------------------------------------------------------------- */

/* Returns the box of the plan and the space outside its exits: it stays the same wherever people drive and after
 * they leave. */
static Box box_of(const House *house) {
    Box box = house->outline.box;
    for (size_t e = 0; e < house->plan.exit_count; e++) {
        const Exit *exit = &house->plan.exits[e];
        Vec2 across = vec2_scale(vec2_left(vec2_unit(vec2_sub(exit->to, exit->from))), OUTSIDE);
        box = box_include(box_include(box, vec2_add(exit->from, across)), vec2_sub(exit->from, across));
        box = box_include(box_include(box, vec2_add(exit->to, across)), vec2_sub(exit->to, across));
    }
    return box_expand(box, HOUSE_SCENE_MARGIN);
}

static int hidden_of(unsigned layers) {
    static const int bits[][2] = {{LAYER_RINGS, FILM_RINGS},   {LAYER_LOCI, FILM_LOCI}, {LAYER_GHOST, FILM_GHOST},
                                  {LAYER_DANGER, FILM_DANGER}, {LAYER_GRID, FILM_GRID}, {LAYER_NAMES, FILM_NAMES},
                                  {LAYER_FORCES, FILM_FORCES}};
    int hidden = 0;
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++)
        hidden |= layers & 1u << bits[i][0] ? 0 : bits[i][1];
    return hidden;
}

void house_picture_make_film(HouseSession *session, double time) {
    size_t epoch = session->runs[RUN_SHOWN] ? house_run_epoch(session->runs[RUN_SHOWN], time) : 0;
    size_t falling = house_fall_count(session, time);
    if (epoch != session->epoch || falling != session->fall.drawn)
        house_picture_void_film(session);
    if (house_picture_has_film(session) || !session->runs[RUN_SHOWN])
        return;
    if (session->film)
        film_destroy(session->film);
    bool last = epoch + 1 == session->runs[RUN_SHOWN]->wish.epoch_count;
    const House *house = last && session->runs[RUN_EARLY] ? &session->runs[RUN_EARLY]->house
                                                          : house_run_house(session->runs[RUN_SHOWN], epoch);
    Before ghost = house_runs_compared(session);
    bool rests = session->settles;
    bool is_crowd = ghost.house && ghost.house->person_count > GHOSTS_MOST;
    bool has_routes = house_runs_is_over(session, RUN_ROUTES) && session->layers & 1u << LAYER_WIDTHS;
    FilmOptions options = {
        .camera = session->camera,
        .bare = true,
        .shown = (session->layers & 1u << LAYER_CIRCLES ? FILM_CIRCLES : 0) |
                 (session->layers & LABORATORY_ALL_NAMES ? FILM_ALL_NAMES : 0),
        .hidden = hidden_of(session->layers) | (rests ? FILM_RINGS | FILM_LOCI | FILM_DANGER | FILM_FORCES : 0),
        .before = is_crowd ? (Before){.house = NULL} : ghost,
        .live = true,
        .rests = rests,
        .ahead = !rests && session->whole && session->ghost == GHOST_BEFORE && ghost.house, /* both are complete */
        .observed = house == &session->runs[RUN_SHOWN]->house ? NULL : &session->runs[RUN_SHOWN]->house,
        .trails = session->trails.trails,
        .drivers = session->crew && !rests ? &session->crew->scene : NULL,
        .routes = has_routes ? &session->runs[RUN_ROUTES]->routes : NULL,
        .falling = session->fall.pieces,
        .falling_count = falling,
        .walls = &session->walls,
        .box = box_of(&session->runs[RUN_SHOWN]->house)};
    session->epoch = epoch;
    session->film_of = house_runs_identity(session->runs[RUN_SHOWN]);
    session->fall.drawn = falling;
    session->film = film_create(house, session->observation, &options);
    session->film_is_stale = false;
    session->fresh = true;
}

void house_picture_make_plain(HouseSession *session) {
    House house = {.seed = 0};
    Fault fault = {0};
    scene_reset(&session->plain);
    session->plain.bare = true;
    const char *path = session->wish.path;
    if (plan_read_text(&house.plan, path, draft_text(session->draft), NULL, 0, &fault) &&
        outline_build(&house.outline, &house.plan, &fault))
        plan_picture_make(&session->plain, &house, false);
    fault_clear(&fault);
    house_free(&house);
    session->changed |= LABORATORY_VIEW;
}

/* The plots -------------------------------------------------------------------------------------------------------- */

/* Rounds away from zero to 1, 2 or 5 times a power of ten. */
static double round_out(double value) {
    if (!(fabs(value) > 0))
        return 0;
    double power = pow(10, floor(log10(fabs(value)))), part = fabs(value) / power;
    double out = part <= 1 ? 1 : part <= 2 ? 2 : part <= 5 ? 5 : 10;
    return copysign(out * power, value);
}

static Box extent_of(const Plot *plot) {
    Box box = {{0, 0}, {0, 0}};
    for (size_t s = 0; s < plot->series_count; s++)
        for (size_t i = 0; i < plot->series[s].count; i++) {
            Vec2 value = plot_value(&plot->series[s], i);
            if (isfinite(value.x) && isfinite(value.y))
                box = box_include(box, value);
        }
    for (size_t g = 0; g < plot->guide_count; g++)
        box = box_include(box, plot->guides[g].upright ? vec2(plot->guides[g].at, 0) : vec2(0, plot->guides[g].at));
    return box;
}

/* Extends the axes until they contain the plot's data; true: the axes have changed. */
static bool grow_axes(Plot *plot, Box *grown, bool timed) {
    Box box = extent_of(plot), before = *grown;
    if (timed)
        box.high.x = fmax(box.high.x, FIRST_SECONDS);
    grown->low = vec2(fmin(before.low.x, round_out(box.low.x)), fmin(before.low.y, round_out(box.low.y)));
    grown->high = vec2(fmax(before.high.x, round_out(box.high.x)), fmax(before.high.y, round_out(box.high.y)));
    plot->x.low = grown->low.x;
    plot->x.high = grown->high.x;
    plot->y.low = grown->low.y;
    plot->y.high = grown->high.y;
    return memcmp(&before, grown, sizeof before) != 0;
}

void house_picture_make_plots(HouseSession *session, bool restart) {
    static const PlotChoice all = {.indices = {0, 1, 2, 3, 4, 5, 6}, .count = HOUSE_PLOTS_KNOWN};
    ShownPlots *plots = &session->plots;
    size_t person = session->selected.kind == HOUSE_PERSON ? session->selected.index : SIZE_MAX;
    if (plots->made)
        house_plots_free(&plots->plots);
    plots->made = true;
    session->plots_of = house_runs_identity(session->runs[RUN_SHOWN]);
    plots->plots = house_plots_make_of(&session->runs[RUN_SHOWN]->house, session->observation, session->trails.trails,
                                       house_runs_compared(session), person, &all);
    for (size_t i = 0; i < HOUSE_PLOTS_KNOWN; i++) {
        Plot *plot = &plots->plots.plots[i];
        if (restart)
            plots->grown[i] = (Box){{0, 0}, {0, 0}};
        bool timed = strcmp(house_plots_name(i), "phase") != 0;
        bool other = !session->whole && grow_axes(plot, &plots->grown[i], timed);
        plots->revision[i] += restart || other;
    }
}

void house_picture_clear_plots(HouseSession *session) {
    if (session->plots.made)
        house_plots_free(&session->plots.plots);
    session->plots.made = false;
}

LaboratoryPlot house_picture_plot(const HouseSession *session, size_t index) {
    const char *name = house_plots_name(index);
    return (LaboratoryPlot){.name = name,
                            .title = titles[index],
                            .plot = &session->plots.plots.plots[index],
                            .revision = session->plots.revision[index],
                            .cursor = NAN,
                            .now = ROLE_PAPER,
                            .tail = strcmp(name, "phase") == 0 ? THICK_TAIL : 0,
                            .ahead = strcmp(name, "out") == 0 && session->whole && !session->settles};
}
