#include "visual/house/film.h"

#include <string.h>

#include "result/grade.h"
#include "visual/house/blockage_scene.h"
#include "visual/house/crowd_scene.h"
#include "visual/house/density_scene.h"
#include "visual/house/film_layers.h"
#include "visual/house/film_moving.h"
#include "visual/house/plan_scene.h"
#include "visual/house/route_scene.h"

/* Design points. */
#define WAY_WIDTH 44.0 /* about a chair's width, where a house fills a screen */
#define KEEP_WAY 2.0   /* weight against being covered by labels */

#define STEP_MANY 0.3 /* m, from point to point of a locus among many */
#define ROUNDING 1e-6 /* samples: times of the record are sums of steps */
#define WALKER_OPACITY 0.10
#define PALE_OPACITY 0.3 /* of a chair's locus below the colours of density, which must stay the darkest */

int film_shown(const char *text, const char **unknown) {
    static const char *const names[] = {"circles", "routes", "widths"};
    const size_t count = sizeof names / sizeof *names;
    int shown = 0;
    while (*text) {
        size_t length = strcspn(text, ","), i = 0;
        while (i < count && (strlen(names[i]) != length || memcmp(names[i], text, length) != 0))
            i++;
        *unknown = text;
        if (i == count)
            return -1;
        shown |= 1 << i;
        text += length + (text[length] == ',');
    }
    return shown;
}

static Vec2 row_place(const double *row) {
    return vec2(row[TRACE_X], row[TRACE_Y]);
}

/* Fixed parts ------------------------------------------------------------------------------------------------------ */

/* True if people of more than one route take part. */
static bool has_several_routes(const Film *film) {
    const PlanRoute *first = NULL;
    bool several = false;
    for (size_t i = 0; i < film->house->person_count; i++)
        if (film->observation->people[i].took_part) {
            several |= first && film->house->people[i].route != first;
            first = film->house->people[i].route;
        }
    return several;
}

/* Marks the future routes of the people, including their feet, against being covered by labels, before they are
 * recorded the starts; draws nothing. */
static void mark_routes(Film *film) {
    for (size_t i = 0; i < film->house->person_count; i++) {
        const Trail *trail = &film->trails[i];
        const Inhabitant *person = &film->house->people[i];
        if (!film->observation->people[i].took_part)
            continue;
        Vec2 *points = memory_zeroed(trail->count + 2, sizeof *points);
        size_t count = 0;
        for (size_t r = 0; r < trail->count; r++)
            points[count++] = row_place(trail->rows[r]);
        Pose end = {.at = person->at, .heading = person->heading};
        if (count)
            end = trail_pose(trail, trail_end(trail));
        else
            points[count++] = end.at;
        double ahead = person->profile->length + person->profile->space_reach;
        points[count++] = vec2_along(end.at, ahead, vec2_heading(end.heading));
        Primitive *way = scene_add_line(&film->still, ROLE_PAPER, WAY_WIDTH, points, count);
        way->edge_opacity = 0;
        way->keep_clear = KEEP_WAY;
        memory_free(points);
    }
}

static bool is_falling(const Film *film, const char *id) {
    for (size_t i = 0; i < film->options.falling_count; i++)
        if (strcmp(film->options.falling[i].piece.id, id) == 0)
            return true;
    return false;
}

/* Returns the house without the furniture that the moving layer draws; labels avoid the places of that furniture. */
static House without_falling(Film *film) {
    House rest = *film->house;
    if (!film->options.falling_count)
        return rest;
    const Plan *plan = &film->house->plan;
    Furniture *kept = arena_allocate(&film->still.arena, (plan->furniture_count + 1) * sizeof *kept);
    rest.plan.furniture = kept;
    rest.plan.furniture_count = 0;
    for (size_t i = 0; i < plan->furniture_count; i++) {
        if (is_falling(film, plan->furniture[i].id))
            plan_scene_place(&film->still, &plan->furniture[i]);
        else
            kept[rest.plan.furniture_count++] = plan->furniture[i];
    }
    return rest;
}

/* Adds the bodies that do not pass, and the missing widths unless danger is hidden. */
static void add_blockages(Film *film) {
    const Observation *observation = film->observation;
    for (size_t i = 0; i < film->house->person_count && !film->crowd; i++)
        if (blockage_scene_has(&observation->people[i]))
            blockage_scene_add(&film->still, film->house, observation, i, &film->trails[i]);
    if (!film->crowd && !(film->options.hidden & FILM_DANGER))
        blockage_scene_labels(&film->still, film->house, observation);
}

/* Adds the band and the touches of many drivers, and the rows that explain them. */
static void add_drivers(Scene *scene, const Scene *drivers) {
    scene_add_all(scene, drivers);
    for (size_t r = 0; r < drivers->row_count; r++)
        *scene_add_row(scene, ROW_PLAIN, "") = drivers->rows[r];
}

static void make_still(Film *film) {
    const House *house = film->house;
    Scene *scene = &film->still;
    int hidden = film->options.hidden;
    Census census = census_make(house, film->observation);
    film->crowd = house_scene_begin(scene, house, film->observation, &census);
    census_clear(&census);
    if (film->options.letters)
        result_grade_add(&scene->title, &scene->detail, house, film->options.letters, &scene->arena);
    house_scene_add_before(scene, film->options.before);
    if (box_width(film->options.box) > 0)
        scene->box = film->options.box;
    if (house->person_count >= DENSITY_SCENE_PEOPLE)
        density_scene_key(scene);
    film->several = has_several_routes(film);
    film->small = film->crowd && crowd_scene_is_large(scene->box);
    scene->clock = NULL;
    scene->camera = film->options.camera;
    scene->panels = film->options.panels;
    scene->bare = film->options.bare;
    scene->grid = hidden & FILM_GRID ? 0 : scene->grid;
    if (film->options.changed)
        scene->name = scene_text(scene, "%s, changed for this run", scene->name);
    if (scene->camera.kind == VIEW_RAISED)
        scene->name = scene_text(scene, "%s, walls cut at %.1f m", scene->name, PLAN_SCENE_CUT);
    House rest = without_falling(film);
    plan_scene_still(scene, &rest, film->options.walls);
    if (film->options.before.observation && !(hidden & FILM_GHOST))
        people_scene_ghost(scene, film->options.before.observation);
    if (film->options.ahead && !film->crowd && !(hidden & FILM_LOCI))
        people_scene_ahead(scene, house, film->trails);
    route_scene_add(scene, house, film->observation, film->options.shown & FILM_ROUTES,
                    film->options.shown & FILM_WIDTHS, NULL);
    if (film->options.drivers)
        add_drivers(scene, film->options.drivers);
    if (film->options.routes)
        scene_add_all(scene, film->options.routes);
    if (!film->crowd)
        mark_routes(film);
    if (!film->crowd)
        plan_scene_tags(scene, &rest, NULL);
    bool tells = (hidden & (FILM_DANGER | FILM_LOCI)) != (FILM_DANGER | FILM_LOCI); /* something of the result */
    if (!film->options.rests && tells)
        add_blockages(film);
    if (!(hidden & FILM_DANGER))
        people_scene_hazards(scene, film->options.observed ? film->options.observed : house, film->observation);
    if (film->options.before.observation && !(hidden & FILM_GHOST))
        people_scene_ghost_label(scene, film->options.before.observation, film->trails, house->person_count,
                                 house_scene_before_name(film->options.before));
    if (!(hidden & FILM_NAMES) && scene->camera.kind == VIEW_PLAN && !film->crowd)
        (film->options.shown & FILM_ALL_NAMES ? plan_scene_all_names : plan_scene_names)(scene, house);
}

Film *film_create(const House *house, const Observation *observation, const FilmOptions *options) {
    Film *film = memory_zeroed(1, sizeof *film);
    *film = (Film){.house = house, .observation = observation, .options = *options, .time = -1};
    film->listed = options->trails ? NULL : trail_list(observation);
    film->trails = options->trails ? options->trails : film->listed;
    film->progress = memory_zeroed(house->person_count, sizeof *film->progress);
    film->standing = memory_zeroed(house->person_count, sizeof *film->standing);
    film->poses = memory_zeroed(house->person_count, sizeof *film->poses);
    film->door_open = memory_zeroed(house->plan.door_count, sizeof *film->door_open);
    film->door_opened = memory_zeroed(house->plan.door_count, sizeof *film->door_opened);
    film->door_observed = memory_zeroed(house->plan.door_count, sizeof *film->door_observed);
    for (size_t d = 0; d < house->plan.door_count; d++)
        film->door_observed[d] =
            options->observed ? plan_find_door(&options->observed->plan, house->plan.doors[d].id) : d;
    if (options->live && options->before.observation && !(options->hidden & FILM_GHOST))
        film->ghosts = trail_list(options->before.observation);
    make_still(film);
    return film;
}

/* Starts the progress of a person. */
static void begin_progress(Film *film, size_t i) {
    const Trail *trail = &film->trails[i];
    film->progress[i] = (Progress){.begun = trail->count};
    if (!trail->count)
        return;
    film->progress[i].last_body = trail_pose(trail, trail_begin(trail));
    film->progress[i].body = trail_begin(trail);
}

void film_extend(Film *film) {
    film->extended = true;
    for (size_t i = 0; i < film->house->person_count; i++)
        if (!film->progress[i].begun)
            begin_progress(film, i);
}

void film_restart(Film *film) {
    film->time = -1;
}

void film_look(Film *film, Camera camera) {
    film->options.camera = film->still.camera = camera;
}

void film_destroy(Film *film) {
    scene_clear(&film->still);
    scene_clear(&film->added);
    scene_clear(&film->moving);
    if (film->listed)
        trail_free_list(film->listed);
    if (film->ghosts)
        trail_free_list(film->ghosts);
    memory_free(film->progress);
    memory_free(film->standing);
    memory_free(film->poses);
    memory_free(film->door_open);
    memory_free(film->door_opened);
    memory_free(film->door_observed);
    memory_free(film);
}

const Scene *film_still(const Film *film) {
    return &film->still;
}

const Scene *film_added(const Film *film) {
    return &film->added;
}

const Scene *film_moving(const Film *film) {
    return &film->moving;
}

/* Parts that appear ------------------------------------------------------------------------------------------------ */

/* Extends the locus from the last added row to the last row up to `time`; among many people only once that is
 * STEP_MANY long. */
static void add_locus(Film *film, size_t i, LocusLook look, double time) {
    const Trail *trail = &film->trails[i];
    Progress *progress = &film->progress[i];
    size_t last = progress->row;
    while (last + 1 < trail->count && trail->rows[last + 1][TRACE_TIME] <= time)
        last++;
    bool many = film->crowd && film_layers_walks(film, i);
    Vec2 from = row_place(trail->rows[progress->row]), to = row_place(trail->rows[last]);
    double length = vec2_distance(from, to);
    if (length <= (many ? STEP_MANY : 0))
        return;
    Primitive *locus = scene_add_line(&film->added, look.role, look.width, (Vec2[]){from, to}, 2);
    locus->style = look.style;
    locus->begun = progress->length;
    locus->edge_opacity = many ? WALKER_OPACITY : film_layers_density(film) ? PALE_OPACITY : 1;
    progress->length += length;
    progress->row = last;
}

/* Adds bodies at regular times where they have room. */
static void add_bodies(Film *film, size_t i, Role role, double time) {
    const Trail *trail = &film->trails[i];
    const Profile *profile = film->house->people[i].profile;
    Progress *progress = &film->progress[i];
    bool several = film->house->person_count > PEOPLE_SCENE_SEVERAL;
    double interval = film->options.live ? people_scene_least_interval(several) : people_scene_interval(trail, several);
    for (; progress->body <= fmin(time, trail_end(trail)); progress->body += interval) {
        Pose pose = trail_pose(trail, progress->body);
        if (vec2_distance(pose.at, progress->last_body.at) < PEOPLE_SCENE_APART * profile->length)
            continue;
        people_scene_body(&film->added, profile, pose, role);
        progress->last_body = pose;
    }
}

/* Adds a person's locus, bodies and ticks after `before` s, up to `time`. The loci of walkers would be darker together
 * than the colours of density. */
static void add_way(Film *film, size_t i, double before, double time) {
    if (film_layers_density(film) && film_layers_walks(film, i))
        return;
    LocusLook look = film_layers_look(film, i);
    if (!film->crowd && !film_layers_walks(film, i))
        add_bodies(film, i, look.role, time);
    add_locus(film, i, look, time);
    if (!film->crowd)
        people_scene_ticks(&film->added, &film->trails[i], look.role, before, time);
}

/* Adds everything since the last time, sample by sample, so that the result does not depend on the times at which the
 * film was shown. */
static void add_ways(Film *film) {
    double sample = film->observation->sample;
    double until = film->time < film->observation->time ? film->time : film->observation->time + sample;
    for (; ((double)film->samples + ROUNDING) * sample <= until; film->samples++) {
        double time = ((double)film->samples + ROUNDING) * sample;
        for (size_t i = 0; i < film->house->person_count; i++)
            if (film->observation->people[i].took_part && film->trails[i].count)
                add_way(film, i, time - sample, time);
    }
}

/* Restarts the progress of all people. */
static void begin_again(Film *film) {
    film->samples = 0;
    for (size_t i = 0; i < film->house->person_count; i++)
        begin_progress(film, i);
}

bool film_show(Film *film, double time) {
    bool onwards = time >= film->time;
    if (!onwards || film->time < 0)
        begin_again(film);
    film->time = time;
    film->extended = false;
    scene_reset(&film->added);
    scene_reset(&film->moving);
    if (!(film->options.hidden & FILM_LOCI))
        add_ways(film);
    film_moving_make(film);
    return onwards;
}

bool film_is_unchanged(const Film *film, double time) {
    return film->time == time && !film->extended;
}
