#include "laboratory/film.h"

#include <string.h>

#include "laboratory/blockage_scene.h"
#include "laboratory/burst.h"
#include "laboratory/crowd_scene.h"
#include "laboratory/figure.h"
#include "laboratory/people_scene.h"
#include "laboratory/plan_scene.h"
#include "laboratory/route_scene.h"
#include "laboratory/silhouette.h"
#include "laboratory/space_scene.h"
#include "laboratory/trail.h"

/* Design points. */
#define CONTACT_EDGE 1.5
#define CONTACT_LETTERS 17.0
#define ID_LETTERS 15.0
#define WAY_WIDTH 44.0 /* about a chair's, where a house fills a screen */
#define KEEP_WAY 2.0   /* how much labels avoid it */

#define ID_BESIDE 0.62   /* m, up the plan, of the name from a body's middle */
#define ID_HEIGHT 1.45   /* m, in the raised view */
#define STAY 1.0         /* s: who is out is seen so much longer */
#define CONTACT_STAY 0.4 /* s, that a touch is seen */

/* The star of a contact: its radius, m, at this force, N; it grows with the root of the force, up to this, m. */
#define CONTACT_RADIUS 0.10
#define CONTACT_FORCE 100.0
#define CONTACT_MOST 0.25
#define CONTACT_HEIGHT 0.725 /* m, in the raised view */

#define STEP_MANY 0.3 /* m, from point to point of a locus among many */
#define ROUNDING 1e-6 /* samples: times of the record are sums of steps */
#define WALKER_OPACITY 0.10
#define SPACE_OPACITY 0.13

/* How far a person's way has been added. */
typedef struct Progress {
    size_t row;     /* of the trail, the last one added */
    double length;  /* m, of the locus */
    double body;    /* s, when the next body is left behind */
    Pose last_body; /* the last one left */
} Progress;

struct Film {
    const House *house;
    const Observation *observation;
    FilmOptions options;
    Trail *trails;      /* (person_count) */
    Progress *progress; /* (person_count) */
    Standing *standing; /* (person_count) room for who is there */
    Pose *poses;        /* (person_count) room for walkers of one profile */
    bool *door_open;    /* (doors of the plan) at the time that is shown */
    bool crowd;
    bool several;   /* people of more than one route take part */
    bool small;     /* a house so large that chairs are signs rather than likenesses */
    double time;    /* s, shown last; -1: none */
    size_t samples; /* of the record, that have been added */
    Scene still, added, moving;
};

int film_shown(const char *words, const char **unknown) {
    static const char *const names[] = {"circles", "routes", "widths"};
    const size_t count = sizeof names / sizeof *names;
    int shown = 0;
    while (*words) {
        size_t length = strcspn(words, ","), i = 0;
        while (i < count && (strlen(names[i]) != length || memcmp(names[i], words, length) != 0))
            i++;
        *unknown = words;
        if (i == count)
            return -1;
        shown |= 1 << i;
        words += length + (words[length] == ',');
    }
    return shown;
}

static bool walks(const Film *film, size_t i) {
    return census_walks(film->house->people[i].profile);
}

static Vec2 row_place(const double *row) {
    return vec2(row[TRACE_X], row[TRACE_Y]);
}

/* What stays --------------------------------------------------------------------------------------------------------*/

/* Do people of more than one route take part? */
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

/* Where people will go, with their feet before them, labels would hide them: marked, not seen. */
static void keep_ways_clear(Film *film) {
    for (size_t i = 0; i < film->house->person_count; i++) {
        const Trail *trail = &film->trails[i];
        const Profile *profile = film->house->people[i].profile;
        if (!trail->count)
            continue;
        Vec2 *points = memory_allocate(trail->count + 1, sizeof *points);
        for (size_t r = 0; r < trail->count; r++)
            points[r] = row_place(trail->rows[r]);
        Pose end = trail_pose(trail, trail_end(trail));
        points[trail->count] = vec2_along(end.at, profile->length + profile->space_reach, vec2_heading(end.heading));
        Primitive *way = scene_add_line(&film->still, ROLE_PAPER, WAY_WIDTH, points, trail->count + 1);
        way->edge_opacity = 0;
        way->keep_clear = KEEP_WAY;
        memory_free(points);
    }
}

/* The bodies that do not pass, and how much is missing. */
static void add_blockages(Film *film) {
    const Observation *observation = film->observation;
    for (size_t i = 0; i < film->house->person_count && !film->crowd; i++)
        if (blockage_scene_has(&observation->people[i])) {
            blockage_scene_add(&film->still, film->house, observation, i, &film->trails[i]);
            blockage_scene_label(&film->still, &observation->people[i].blockage);
        }
}

static void make_still(Film *film) {
    const House *house = film->house;
    Scene *scene = &film->still;
    Census census = census_take(house, film->observation);
    film->crowd = house_scene_begin(scene, house, film->observation, &census);
    census_clear(&census);
    house_scene_say_before(scene, film->options.before);
    film->several = has_several_routes(film);
    film->small = film->crowd && crowd_scene_is_large(scene->box);
    scene->clock = NULL;
    scene->camera = film->options.camera;
    scene->panels = film->options.panels;
    scene->bare = film->options.bare;
    if (scene->camera.kind == VIEW_RAISED)
        scene->name = scene_text(scene, "%s, walls cut at %.1f m", scene->name, PLAN_SCENE_CUT);
    plan_scene_still(scene, house);
    if (film->options.before.observation)
        people_scene_ghost(scene, film->options.before.observation);
    route_scene_add(scene, house, film->observation, film->options.shown & FILM_ROUTES,
                    film->options.shown & FILM_WIDTHS);
    if (!film->crowd)
        keep_ways_clear(film);
    if (!film->crowd)
        plan_scene_signs(scene, house);
    add_blockages(film);
    people_scene_hazards(scene, film->observation);
    plan_scene_names(scene, house, !film->crowd && scene->camera.kind == VIEW_PLAN);
}

Film *film_create(const House *house, const Observation *observation, const FilmOptions *options) {
    Film *film = memory_allocate(1, sizeof *film);
    *film = (Film){.house = house, .observation = observation, .options = *options, .time = -1};
    film->trails = trail_list(observation);
    film->progress = memory_allocate(house->person_count, sizeof *film->progress);
    film->standing = memory_allocate(house->person_count, sizeof *film->standing);
    film->poses = memory_allocate(house->person_count, sizeof *film->poses);
    film->door_open = memory_allocate(house->plan.door_count, sizeof *film->door_open);
    make_still(film);
    return film;
}

void film_destroy(Film *film) {
    scene_clear(&film->still);
    scene_clear(&film->added);
    scene_clear(&film->moving);
    trail_free_list(film->trails);
    memory_free(film->progress);
    memory_free(film->standing);
    memory_free(film->poses);
    memory_free(film->door_open);
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

static LocusLook look_of(const Film *film, size_t i) {
    return film->crowd ? crowd_scene_look(film->house, film->house->people[i].profile)
                       : people_scene_look(film->house, i);
}

/* What comes and stays ----------------------------------------------------------------------------------------------*/

/* The locus from the last row that has been added to the last one up to `time`; of many people only when that is some
 * way on. */
static void add_locus(Film *film, size_t i, LocusLook look, double time) {
    const Trail *trail = &film->trails[i];
    Progress *progress = &film->progress[i];
    size_t last = progress->row;
    while (last + 1 < trail->count && trail->rows[last + 1][TRACE_TIME] <= time)
        last++;
    bool many = film->crowd && walks(film, i);
    Vec2 from = row_place(trail->rows[progress->row]), to = row_place(trail->rows[last]);
    double length = vec2_distance(from, to);
    if (length <= (many ? STEP_MANY : 0))
        return;
    Primitive *locus = scene_add_line(&film->added, look.role, look.width, (Vec2[]){from, to}, 2);
    locus->style = look.style;
    locus->begun = progress->length;
    locus->edge_opacity = many ? WALKER_OPACITY : 1;
    progress->length += length;
    progress->row = last;
}

/* Bodies at regular times where there is room between them. */
static void add_bodies(Film *film, size_t i, Role role, double time) {
    const Trail *trail = &film->trails[i];
    const Profile *profile = film->house->people[i].profile;
    Progress *progress = &film->progress[i];
    double interval = people_scene_interval(trail, film->house->person_count > PEOPLE_SCENE_SEVERAL);
    for (; progress->body <= fmin(time, trail_end(trail)); progress->body += interval) {
        Pose pose = trail_pose(trail, progress->body);
        if (vec2_distance(pose.at, progress->last_body.at) < PEOPLE_SCENE_APART * profile->length)
            continue;
        people_scene_body(&film->added, profile, pose, role);
        progress->last_body = pose;
    }
}

/* What has come of a person after `before` s, up to `time`. */
static void add_way(Film *film, size_t i, double before, double time) {
    LocusLook look = look_of(film, i);
    if (!film->crowd && !walks(film, i))
        add_bodies(film, i, look.role, time);
    add_locus(film, i, look, time);
    if (!film->crowd)
        people_scene_ticks(&film->added, &film->trails[i], look.role, before, time);
}

/* All that has come since the last time, sample by sample, so that in the end it does not matter at which times the
 * film was looked at. */
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

/* From nothing. */
static void begin_again(Film *film) {
    film->samples = 0;
    for (size_t i = 0; i < film->house->person_count; i++) {
        const Trail *trail = &film->trails[i];
        film->progress[i] = (Progress){.row = 0};
        if (!trail->count)
            continue;
        film->progress[i].last_body = trail_pose(trail, trail_begin(trail));
        film->progress[i].body = trail_begin(trail);
    }
}

/* What moves --------------------------------------------------------------------------------------------------------*/

/* Is the person still, or again, to be seen? The last one out stays: a film ends with somebody in the picture. */
static bool is_there(const Film *film, size_t i) {
    const PersonObservation *observed = &film->observation->people[i];
    if (!observed->took_part || !film->trails[i].count)
        return false;
    bool last = !film->crowd && observed->time >= film->observation->time;
    return !observed->completed || last || film->time <= observed->time + (film->crowd ? 0 : STAY);
}

/* Whoever runs alone: by route. */
static size_t group_of(const Film *film, size_t i) {
    const Plan *plan = &film->house->plan;
    const PlanRoute *route = film->house->people[i].route;
    if (plan->run.routes != ROUTES_ALONE)
        return 0;
    return route ? (size_t)(route - plan->routes) : plan->route_count;
}

static size_t find_standing(Film *film) {
    size_t count = 0;
    for (size_t i = 0; i < film->house->person_count; i++)
        if (is_there(film, i))
            film->standing[count++] = (Standing){.profile = film->house->people[i].profile,
                                                 .pose = trail_pose(&film->trails[i], film->time),
                                                 .person = i,
                                                 .group = group_of(film, i)};
    return count;
}

static void add_walkers(Film *film, size_t count) {
    for (size_t k = 0; k < film->house->profile_count; k++) {
        const Profile *profile = &film->house->profiles[k];
        size_t of_this = 0;
        for (size_t i = 0; i < count && census_walks(profile); i++)
            if (film->standing[i].profile == profile)
                film->poses[of_this++] = film->standing[i].pose;
        if (of_this)
            figure_add_walkers(&film->moving, profile, film->poses, of_this);
    }
}

static void add_space(Film *film, size_t count, size_t i) {
    const Standing *standing = &film->standing[i];
    double compression = trail_compression(&film->trails[standing->person], film->time, film->time);
    if (standing->profile->space_reach <= 0)
        return;
    Primitive *ring = space_scene_add(&film->moving, film->house, film->door_open, film->standing, count, i);
    people_scene_dress_ring(ring, compression > PEOPLE_SCENE_COMPRESSED);
    ring->fill_opacity = SPACE_OPACITY;
}

static void add_chair(Film *film, const Standing *standing) {
    Role role = look_of(film, standing->person).role;
    if (film->small)
        crowd_scene_chair(&film->moving, film->still.box, standing->profile, standing->pose, role);
    else
        figure_add_chair(&film->moving, standing->profile, standing->pose, role);
    if (film->options.shown & FILM_CIRCLES)
        space_scene_add_circles(&film->moving, standing->profile, standing->pose);
}

static void add_chairs(Film *film, size_t count) {
    for (size_t i = 0; i < count && !film->small; i++)
        if (!census_walks(film->standing[i].profile))
            add_space(film, count, i);
    for (size_t i = 0; i < count; i++)
        if (!census_walks(film->standing[i].profile))
            add_chair(film, &film->standing[i]);
}

/* A star whose size tells the force, and the force in words. */
static void add_burst(Scene *scene, Vec2 at, double force) {
    double radius = fmin(CONTACT_MOST, CONTACT_RADIUS * sqrt(force / CONTACT_FORCE));
    Primitive *burst = burst_add(scene, at, radius);
    burst->width = CONTACT_EDGE;
    burst->base = CONTACT_HEIGHT;
}

/* The hardest touch of a person within the last moments; its force stands outside the body. */
static void add_contact(Film *film, const Standing *standing) {
    const double *hardest = trail_hardest(&film->trails[standing->person], film->time - CONTACT_STAY, film->time);
    if (!hardest)
        return;
    Vec2 at = vec2(hardest[TRACE_CONTACT_X], hardest[TRACE_CONTACT_Y]);
    add_burst(&film->moving, at, hardest[TRACE_BODY_FORCE]);
    if (film->crowd)
        return;
    const char *text = scene_text(&film->moving, "%.0f N", hardest[TRACE_BODY_FORCE]);
    Primitive *tag = scene_add_label(&film->moving, ROLE_TEXT, CONTACT_LETTERS, at, text);
    Vec2 middle = silhouette_middle(standing->profile, standing->pose.at, standing->pose.heading);
    Vec2 beside = vec2_add(at, vec2_sub(at, middle));
    scene_bind_label(&film->moving, tag, &beside, 1);
    tag->fill = ROLE_DANGER_MIDDLE;
    tag->shape = LABEL_TAG;
    tag->fixed = tag->bold = true;
}

static void add_name(Film *film, const Standing *standing) {
    const Inhabitant *person = &film->house->people[standing->person];
    Vec2 middle = silhouette_middle(person->profile, standing->pose.at, standing->pose.heading);
    bool raised = film->options.camera.kind == VIEW_RAISED;
    Vec2 at = raised ? middle : vec2_add(middle, vec2(0, ID_BESIDE));
    Primitive *tag =
        scene_add_label(&film->moving, ROLE_TEXT, ID_LETTERS, at, person->route ? person->route->id : person->id);
    tag->fill = look_of(film, standing->person).role;
    tag->base = ID_HEIGHT;
    tag->shape = LABEL_TAG;
    tag->fixed = tag->bold = true;
}

/* Of a crowd: how many have left by each exit so far. */
static void add_exits(Film *film) {
    const Plan *plan = &film->house->plan;
    size_t *left = memory_allocate(plan->exit_count, sizeof *left);
    for (size_t i = 0; i < film->house->person_count; i++) {
        const PersonObservation *person = &film->observation->people[i];
        if (person->took_part && person->completed && person->time <= film->time)
            left[person->exit]++;
    }
    for (size_t e = 0; e < plan->exit_count; e++) {
        const char *text = scene_text(&film->moving, "EXIT %s: %zu", plan->exits[e].id, left[e]);
        plan_scene_sign(&film->moving, film->house, &plan->exits[e], text);
    }
    memory_free(left);
}

static void make_moving(Film *film) {
    Scene *scene = &film->moving;
    size_t count = find_standing(film);
    for (size_t d = 0; d < film->house->plan.door_count; d++)
        film->door_open[d] = film->observation->door_opened[d] <= film->time;
    plan_scene_moving(scene, film->house, film->observation->door_opened, film->time);
    add_walkers(film, count);
    add_chairs(film, count);
    for (size_t i = 0; i < count; i++)
        add_contact(film, &film->standing[i]);
    for (size_t i = 0; i < count && !film->crowd; i++)
        add_name(film, &film->standing[i]);
    if (film->crowd)
        add_exits(film);
    bool alone = film->house->plan.run.routes == ROUTES_ALONE && film->several;
    scene->clock = scene_text(scene, alone ? "%.1f s of separate runs, one over the other" : "%.1f s", film->time);
}

bool film_show(Film *film, double time) {
    bool onwards = time >= film->time;
    if (!onwards || film->time < 0)
        begin_again(film);
    film->time = time;
    scene_reset(&film->added);
    scene_reset(&film->moving);
    add_ways(film);
    make_moving(film);
    return onwards;
}
