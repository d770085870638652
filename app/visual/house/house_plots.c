#include "visual/house/house_plots.h"

#include <string.h>

#include "base/text.h"
#include "result/census.h"
#include "result/names.h"
#include "visual/house/crowd_plots.h"
#include "visual/house/people_scene.h"
#include "visual/house/trail.h"

/* Design points. */
#define LINE_WIDTH 3.0
#define THIN_WIDTH 1.6 /* of people whose colour and dashes repeat, of personal spaces, of the comparison */

#define WARNING_SHOWN 0.5 /* 1, of the warning level: a lower peak would be flattened by the warning */

enum { LOOKS = 4 /* that people_scene_nth_look distinguishes */, FEW = 2 /* people: personal spaces have lines too */ };

/* A displayed person, and the rows. */
typedef struct Subject {
    size_t person;         /* index into House.people */
    const char *name, *id; /* in the legend, and in the table */
    LocusLook look;
    const double *rows; /* (count x TRACE_COLUMNS) */
    size_t count;
} Subject;

typedef struct Subjects {
    const House *house;
    const Observation *observation;
    Subject list[PEOPLE_SCENE_INDIVIDUALS]; /* (count) */
    size_t count, people;                   /* shown, and taking part */
    bool alone;                             /* one person was requested */
    const char *name;                       /* of the comparison */
} Subjects;

typedef struct HousePlot {
    const char *name;
    size_t x, y; /* columns of the trace */
    const char *x_title, *y_title;
    void (*add_guides)(Plot *plot, const Subjects *subjects);
    void (*make)(Plot *plot, const Subjects *subjects, const Subjects *ghosts, Arena *arena); /* NULL: by columns */
} HousePlot;

static void add_guide(Plot *plot, PlotGuide guide) {
    plot->guides[plot->guide_count++] = guide;
}

/* The part that all plots share. */
static void add_nought(Plot *plot, const Subjects *subjects) {
    (void)subjects;
    add_guide(plot, (PlotGuide){.at = 0, .role = ROLE_ROOM, .style = LINE_SOLID});
}

/* True if there are at most as many as looks. */
static void add_speed_guides(Plot *plot, const Subjects *subjects) {
    for (size_t i = 0; i < subjects->count; i++) {
        double speed = subjects->house->people[subjects->list[i].person].speed;
        bool known = false;
        for (size_t g = 0; g < plot->guide_count; g++)
            known = known || plot->guides[g].at == speed;
        if (!known)
            add_guide(plot,
                      (PlotGuide){.at = speed, .name = "free speed", .role = ROLE_DIM_TEXT, .style = LINE_DASHED});
    }
    if (plot->guide_count > FEW)
        plot->guide_count = 0;
    add_nought(plot, subjects);
}

static void add_clearance_guides(Plot *plot, const Subjects *subjects) {
    double warning = subjects->house->plan.run.clearance_warning;
    add_nought(plot, subjects);
    add_guide(plot, (PlotGuide){.at = warning, .name = "danger below", .role = ROLE_ERROR, .style = LINE_DASHED});
}

static void add_force_guides(Plot *plot, const Subjects *subjects) {
    double warning = subjects->house->plan.run.force_warning, peak = 0;
    for (size_t i = 0; i < subjects->count; i++)
        peak = fmax(peak, subjects->observation->people[subjects->list[i].person].peak_force);
    if (peak >= WARNING_SHOWN * warning)
        add_guide(plot, (PlotGuide){.at = warning, .name = "danger above", .role = ROLE_ERROR, .style = LINE_DASHED});
    add_nought(plot, subjects);
}

static void add_path_guides(Plot *plot, const Subjects *subjects) {
    add_guide(plot, (PlotGuide){.upright = true, .at = 0, .role = ROLE_ROOM, .style = LINE_SOLID});
    add_nought(plot, subjects);
}

static void make_out(Plot *plot, const Subjects *subjects, const Subjects *ghosts, Arena *arena) {
    crowd_plots_out(plot, subjects->house, subjects->observation, ghosts->observation, ghosts->name, arena);
}

static void make_flow(Plot *plot, const Subjects *subjects, const Subjects *ghosts, Arena *arena) {
    (void)ghosts;
    crowd_plots_flow(plot, subjects->house, subjects->observation, arena);
}

static const HousePlot known[HOUSE_PLOTS_KNOWN] = {
    {"speed", TRACE_TIME, TRACE_SPEED, "time", "speed", add_speed_guides, NULL},
    {"clearance", TRACE_TIME, TRACE_CLEARANCE, "time", "clearance", add_clearance_guides, NULL},
    {"force", TRACE_TIME, TRACE_BODY_FORCE, "time", "contact force", add_force_guides, NULL},
    {"ring", TRACE_TIME, TRACE_RING, "time", "compression of the personal space", add_nought, NULL},
    {"phase", TRACE_OFFSET, TRACE_OFFSET_RATE, "lateral offset", "lateral velocity", add_path_guides, NULL},
    {"out", TRACE_TIME, TRACE_TIME, "time", "people out", NULL, make_out},
    {"flow", TRACE_TIME, TRACE_TIME, "time", "people out a second", NULL, make_flow},
};

const char *house_plots_name(size_t index) {
    return known[index].name;
}

bool house_plots_choose(PlotChoice *choice, const char *text, char fault[PLOT_CHOICE_FAULT]) {
    const char *names[HOUSE_PLOTS_KNOWN];
    for (size_t i = 0; i < HOUSE_PLOTS_KNOWN; i++)
        names[i] = known[i].name;
    return plot_choice_read(choice, text, names, HOUSE_PLOTS_KNOWN, fault);
}

static void add_subject(Subjects *subjects, const Trail *trail, size_t person, Arena *arena) {
    double *rows = arena_allocate(arena, trail->count * TRACE_COLUMNS * sizeof *rows);
    for (size_t i = 0; i < trail->count; i++)
        memcpy(rows + i * TRACE_COLUMNS, trail->rows[i], TRACE_COLUMNS * sizeof *rows);
    subjects->list[subjects->count++] = (Subject){.person = person, .rows = rows, .count = trail->count};
}

/* Returns the look: by route where each person is on another one, as in the plan; otherwise by person. */
static void name_subjects(Subjects *subjects, Arena *arena) {
    const House *house = subjects->house;
    bool by_route = true;
    for (size_t i = 0; i < subjects->count; i++) {
        const PlanRoute *route = house->people[subjects->list[i].person].route;
        by_route = by_route && route;
        for (size_t j = 0; j < i; j++)
            by_route = by_route && route != house->people[subjects->list[j].person].route;
    }
    for (size_t i = 0; i < subjects->count; i++) {
        Subject *subject = &subjects->list[i];
        const Inhabitant *person = &house->people[subject->person];
        subject->id = by_route ? person->route->id : person->id;
        subject->name = by_route ? subject->id : names_person(house, subject->person, arena);
        subject->look = by_route ? people_scene_look(house, subject->person) : people_scene_nth_look(i);
        subject->look.width = i < LOOKS ? LINE_WIDTH : THIN_WIDTH;
    }
}

/* Returns the people of a run, chairs before walkers, or one of them, each with a copy of the rows. */
static Subjects make_subjects(const House *house, const Observation *observation, const Trail *trails, size_t person,
                              Arena *arena) {
    Subjects subjects = {.house = house, .observation = observation, .alone = person != SIZE_MAX};
    for (size_t i = 0; i < observation->person_count; i++)
        subjects.people += observation->people[i].took_part;
    for (int walks = 0; walks <= 1; walks++)
        for (size_t i = 0; i < observation->person_count; i++)
            if ((person == SIZE_MAX || person == i) && trails[i].count &&
                census_walks(house->people[i].profile) == walks && subjects.count < PEOPLE_SCENE_INDIVIDUALS)
                add_subject(&subjects, &trails[i], i, arena);
    name_subjects(&subjects, arena);
    return subjects;
}

static PlotSeries *add_series(Plot *plot, const HousePlot *definition, const Subject *subject) {
    PlotSeries *series = &plot->series[plot->series_count++];
    *series = (PlotSeries){.name = subject->name,
                           .heading = subject->id,
                           .x = subject->rows + definition->x,
                           .y = subject->rows + definition->y,
                           .count = subject->count,
                           .stride = TRACE_COLUMNS,
                           .role = subject->look.role,
                           .style = subject->look.style,
                           .width = subject->look.width};
    return series;
}

/* Adds the same people of the comparison below the others, under one name. */
static void add_ghosts(Plot *plot, const HousePlot *definition, const Subjects *subjects, const Subjects *ghosts,
                       Arena *arena) {
    for (size_t g = 0; g < ghosts->count; g++)
        for (size_t i = 0; i < subjects->count; i++)
            if (strcmp(ghosts->house->people[ghosts->list[g].person].id,
                       subjects->house->people[subjects->list[i].person].id) == 0) {
                PlotSeries *ghost = add_series(plot, definition, &ghosts->list[g]);
                ghost->heading = text_in_arena(arena, "%s %s", ghosts->list[g].name, ghosts->name);
                ghost->name = plot->series_count == 1 ? ghosts->name : NULL;
                ghost->role = ROLE_GHOST;
                ghost->style = LINE_DASHED;
                ghost->width = THIN_WIDTH;
            }
}

static const char *note_of(const HousePlot *definition, const Subjects *subjects, Arena *arena) {
    bool moving = false, touching = definition->y != TRACE_BODY_FORCE;
    for (size_t i = 0; i < subjects->count; i++) {
        moving = moving || subjects->list[i].count > 1;
        touching = touching || subjects->observation->people[subjects->list[i].person].peak_force > 0;
    }
    if (!moving || !touching)
        return moving ? "no contact" : "nobody starts";
    if (subjects->count == subjects->people || subjects->alone)
        return NULL;
    return text_in_arena(arena, "%zu of %zu people", subjects->count, subjects->people);
}

static Plot make_plot(const HousePlot *definition, const Subjects *subjects, const Subjects *ghosts, Arena *arena) {
    const TraceColumn *columns = subjects->observation->trace.columns;
    Plot made = {.title = NULL};
    if (definition->make) {
        definition->make(&made, subjects, ghosts, arena);
        return made;
    }
    Plot plot = {.x = {.title = definition->x_title, .unit = columns[definition->x].unit},
                 .y = {.title = definition->y_title, .unit = columns[definition->y].unit}};
    plot.series = arena_allocate(arena, 3 * PEOPLE_SCENE_INDIVIDUALS * sizeof *plot.series);
    plot.guides = arena_allocate(arena, (PEOPLE_SCENE_INDIVIDUALS + 1) * sizeof *plot.guides);
    add_ghosts(&plot, definition, subjects, ghosts, arena);
    for (size_t i = 0; i < subjects->count; i++)
        add_series(&plot, definition, &subjects->list[i]);
    definition->add_guides(&plot, subjects);
    plot.note = note_of(definition, subjects, arena);
    return plot;
}

/* Returns the person of the same name in the comparison; SIZE_MAX: none, or all people are requested. */
static size_t like_before(const House *house, Before before, size_t person) {
    for (size_t i = 0; person != SIZE_MAX && i < before.house->person_count; i++)
        if (strcmp(before.house->people[i].id, house->people[person].id) == 0)
            return i;
    return SIZE_MAX;
}

HousePlots house_plots_make_of(const House *house, const Observation *observation, const Trail *trails, Before before,
                               size_t person, const PlotChoice *choice) {
    HousePlots plots = {.choice = *choice};
    Subjects subjects = make_subjects(house, observation, trails, person, &plots.arena), ghosts = {.count = 0};
    if (before.observation) {
        Trail *others = trail_list(before.observation);
        ghosts =
            make_subjects(before.house, before.observation, others, like_before(house, before, person), &plots.arena);
        trail_free_list(others);
    }
    ghosts.name = text_in_arena(&plots.arena, "%s", house_scene_before_name(before));
    for (size_t i = 0; i < choice->count; i++)
        plots.plots[i] = make_plot(&known[choice->indices[i]], &subjects, &ghosts, &plots.arena);
    return plots;
}

HousePlots house_plots_make(const House *house, const Observation *observation, const House *ghost_house,
                            const Observation *ghost, const PlotChoice *choice) {
    Trail *trails = trail_list(observation);
    HousePlots plots = house_plots_make_of(house, observation, trails,
                                           (Before){.house = ghost_house, .observation = ghost}, SIZE_MAX, choice);
    trail_free_list(trails);
    return plots;
}

void house_plots_free(HousePlots *plots) {
    arena_clear(&plots->arena);
    *plots = (HousePlots){.choice = {.count = 0}};
}

size_t house_plots_until(const HousePlots *plots, size_t plot, size_t series, double time) {
    const PlotSeries *drawn = &plots->plots[plot].series[series];
    const double *times = drawn->x - known[plots->choice.indices[plot]].x + TRACE_TIME;
    size_t low = 0, high = drawn->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (times[middle * drawn->stride] <= time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
