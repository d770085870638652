#include "visual/house/film_moving.h"

#include "result/names.h"
#include "visual/house/crowd_scene.h"
#include "visual/house/density_scene.h"
#include "visual/house/film_layers.h"
#include "visual/house/plan_scene.h"
#include "visual/house/silhouette.h"

/* Design points. */
#define CONTACT_EDGE 1.5
#define CONTACT_TEXT 16.0
#define ID_TEXT 16.0
#define GHOST_EDGE 2.5

#define HEADS_ZOOM 3.0 /* 1, from which on the heads of many people are shown */

#define CONTACT_STAY 0.4 /* s, for which a touch stays visible */

/* The star of a contact: its radius, m, at CONTACT_FORCE, N; it grows with the root of the force up to CONTACT_MOST,
 * m. */
#define CONTACT_RADIUS 0.10
#define CONTACT_FORCE 100.0
#define CONTACT_MOST 0.25
#define CONTACT_HEIGHT 0.725 /* m, in the raised view */

#define SPACE_OPACITY 0.13
#define OTHER_RUN 0.4 /* opacity of a chair that lies over one of another run */

/* True while nothing of a person is recorded: in a window all stand at their starts until the first answer moves. */
static bool is_expected(const Film *film, size_t i) {
    return film->options.live && !film->trails[i].count && !(film->observation->time > 0) &&
           !film->house->people[i].under;
}

/* True if the person is visible. */
static bool is_there(const Film *film, size_t i) {
    const PersonObservation *observed = &film->observation->people[i];
    if (!observed->took_part || (!film->trails[i].count && !is_expected(film, i)))
        return false;
    return people_scene_is_drawn(film->observation, i, film->time, film->crowd);
}

/* Returns a person's group; if people run alone, one group per route. */
static size_t group_of(const Film *film, size_t i) {
    const Plan *plan = &film->house->plan;
    const PlanRoute *route = film->house->people[i].route;
    if (plan->run.routes != ROUTES_ALONE)
        return 0;
    return route ? (size_t)(route - plan->routes) : plan->route_count;
}

/* Returns where a person is now: at the start while an answer is being worked out. */
static Pose pose_of(const Film *film, size_t i) {
    const Inhabitant *person = &film->house->people[i];
    if (film->options.rests || is_expected(film, i))
        return (Pose){.at = person->at, .heading = person->heading};
    return trail_pose(&film->trails[i], film->time);
}

static size_t find_standing(Film *film) {
    size_t count = 0;
    for (size_t i = 0; i < film->house->person_count; i++)
        if (is_there(film, i))
            film->standing[count++] = (Standing){.profile = film->house->people[i].profile,
                                                 .pose = pose_of(film, i),
                                                 .person = i,
                                                 .group = group_of(film, i)};
    return count;
}

/* True if so many people are shown so small that their heads would be single pixels, which take as long to draw. */
static bool are_dots(const Film *film, size_t count) {
    const Camera *camera = &film->options.camera;
    return film->small && count > SILHOUETTE_HEADINGS && camera->kind == VIEW_PLAN && camera->zoom < HEADS_ZOOM;
}

static void add_walkers(Film *film, size_t count) {
    for (size_t k = 0; k < film->house->profile_count; k++) {
        const Profile *profile = &film->house->profiles[k];
        size_t of_this = 0;
        for (size_t i = 0; i < count && census_walks(profile); i++)
            if (film->standing[i].profile == profile)
                film->poses[of_this++] = film->standing[i].pose;
        if (of_this)
            silhouette_add_walkers(&film->moving, profile, film->poses, of_this, are_dots(film, of_this));
    }
}

/* Adds how crowded it is, below the people. */
static void add_density(Film *film, size_t count) {
    Vec2 *places = memory_zeroed(count + 1, sizeof *places);
    for (size_t i = 0; i < count; i++)
        places[i] = film->standing[i].pose.at;
    density_scene_add(&film->moving, film->still.box, places, count);
    memory_free(places);
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
    Role role = film->options.rests ? ROLE_WALKER : film_layers_look(film, standing->person).role;
    if (film->small)
        crowd_scene_chair(&film->moving, film->still.box, standing->profile, standing->pose, role);
    else
        silhouette_add_chair(&film->moving, standing->profile, standing->pose, role);
    if (film->options.shown & FILM_CIRCLES)
        space_scene_add_circles(&film->moving, standing->profile, standing->pose);
}

/* True if one of the sides of a convex outline separates it from another; outlines are counter-clockwise. */
static bool separates(const Vec2 a[SILHOUETTE_POINTS], const Vec2 b[SILHOUETTE_POINTS]) {
    for (size_t side = 0; side < SILHOUETTE_POINTS; side++) {
        Vec2 along = vec2_sub(a[(side + 1) % SILHOUETTE_POINTS], a[side]);
        size_t outside = 0;
        while (outside < SILHOUETTE_POINTS && vec2_cross(along, vec2_sub(b[outside], a[side])) < 0)
            outside++;
        if (outside == SILHOUETTE_POINTS)
            return true;
    }
    return false;
}

/* True if the chair would lie over one of another run, with which it has nothing to do. */
static bool lies_over_other_run(const Film *film, size_t count, size_t i) {
    Vec2 own[SILHOUETTE_POINTS], other[SILHOUETTE_POINTS];
    const Standing *standing = &film->standing[i];
    silhouette_outline(standing->profile, standing->pose.at, standing->pose.heading, 0, own);
    for (size_t k = 0; k < count; k++) {
        const Standing *beside = &film->standing[k];
        if (beside->group == standing->group || census_walks(beside->profile))
            continue;
        silhouette_outline(beside->profile, beside->pose.at, beside->pose.heading, 0, other);
        if (!separates(own, other) && !separates(other, own))
            return true;
    }
    return false;
}

/* Makes the primitives from one on faint. */
static void fade(Scene *scene, size_t first) {
    for (size_t p = first; p < scene->count; p++) {
        scene->primitives[p].fill_opacity *= OTHER_RUN;
        scene->primitives[p].edge_opacity *= OTHER_RUN;
    }
}

/* Chairs of separate runs that would overlap are faint: they never meet. */
static void add_chairs(Film *film, size_t count) {
    Scene *scene = &film->moving;
    bool alone = film->house->plan.run.routes == ROUTES_ALONE && film->several && !film->crowd;
    bool *faint = memory_zeroed(count + 1, sizeof *faint);
    for (size_t i = 0; i < count; i++)
        faint[i] = alone && !census_walks(film->standing[i].profile) && lies_over_other_run(film, count, i);
    for (size_t i = 0; i < count && !film->small && !(film->options.hidden & FILM_RINGS); i++) {
        size_t first = scene->count;
        if (!census_walks(film->standing[i].profile))
            add_space(film, count, i);
        fade(scene, faint[i] ? first : scene->count);
    }
    for (size_t i = 0; i < count; i++) {
        size_t first = scene->count;
        if (!census_walks(film->standing[i].profile))
            add_chair(film, &film->standing[i]);
        fade(scene, faint[i] ? first : scene->count);
    }
    memory_free(faint);
}

/* A star whose size shows the force. */
static void add_star(Scene *scene, Vec2 at, double force) {
    double radius = fmin(CONTACT_MOST, CONTACT_RADIUS * sqrt(force / CONTACT_FORCE));
    Primitive *star = scene_add_star(scene, ROLE_DANGER_MIDDLE, radius, at);
    star->edge = ROLE_WALL;
    star->width = CONTACT_EDGE;
    star->base = CONTACT_HEIGHT;
}

/* Adds the hardest touch of a person within CONTACT_STAY; its force stands outside the body. */
static void add_contact(Film *film, const Standing *standing) {
    const double *hardest = trail_hardest(&film->trails[standing->person], film->time - CONTACT_STAY, film->time);
    if (!hardest)
        return;
    Vec2 at = vec2(hardest[TRACE_CONTACT_X], hardest[TRACE_CONTACT_Y]);
    add_star(&film->moving, at, hardest[TRACE_BODY_FORCE]);
    if (film->crowd)
        return;
    const char *text = scene_text(&film->moving, "%.0f N", hardest[TRACE_BODY_FORCE]);
    Primitive *tag = scene_add_label(&film->moving, ROLE_TEXT, CONTACT_TEXT, at, text);
    Vec2 middle = silhouette_middle(standing->profile, standing->pose.at, standing->pose.heading);
    Vec2 beside = vec2_add(at, vec2_sub(at, middle));
    scene_bind_label(&film->moving, tag, &beside, 1);
    tag->fill = ROLE_DANGER_MIDDLE;
    tag->shape = LABEL_TAG;
    tag->fixed = tag->bold = tag->optional = true;
}

static void add_name(Film *film, const Standing *standing) {
    const Inhabitant *person = &film->house->people[standing->person];
    Vec2 middle = silhouette_middle(person->profile, standing->pose.at, standing->pose.heading);
    bool raised = film->options.camera.kind == VIEW_RAISED;
    Vec2 at = middle;
    Primitive *tag = scene_add_label(&film->moving, ROLE_TEXT, ID_TEXT, at,
                                     names_person(film->house, standing->person, &film->moving.arena));
    tag->fill = film->options.rests ? ROLE_WALKER : film_layers_look(film, standing->person).role;
    tag->base = SILHOUETTE_NAME_HEIGHT;
    tag->shape = raised ? LABEL_TAG : LABEL_DISC;
    tag->fixed = tag->bold = true;
}

/* Adds how many people of a crowd have left by each exit so far. */
static void add_exits(Film *film) {
    const Plan *plan = &film->house->plan;
    size_t *left = memory_zeroed(plan->exit_count, sizeof *left);
    for (size_t i = 0; i < film->house->person_count; i++) {
        const PersonObservation *person = &film->observation->people[i];
        bool out = person->took_part && person->completed && person->time <= film->time;
        if (out && person->exit < plan->exit_count) /* otherwise by an exit that no longer exists */
            left[person->exit]++;
    }
    plan_scene_signs(&film->moving, film->house, left);
    memory_free(left);
}

/* Adds the people of the comparison at the same time. */
static void add_ghosts(Film *film) {
    const Before *before = &film->options.before;
    for (size_t i = 0; film->ghosts && !film->options.rests && i < before->observation->person_count; i++) {
        const PersonObservation *observed = &before->observation->people[i];
        const Profile *profile = before->house->people[i].profile;
        bool gone = observed->completed && film->time > observed->time + PEOPLE_SCENE_STAY;
        if (!film->ghosts[i].count || gone || census_walks(profile))
            continue;
        Pose pose = trail_pose(&film->ghosts[i], film->time);
        Vec2 outline[SILHOUETTE_POINTS];
        silhouette_outline(profile, pose.at, pose.heading, 0, outline);
        Primitive *body = scene_add_polygon(&film->moving, ROLE_GHOST, outline, SILHOUETTE_POINTS);
        body->fill_opacity = 0;
        body->width = GHOST_EDGE;
        body->style = LINE_DASHED;
    }
}

void film_moving_make(Film *film) {
    Scene *scene = &film->moving;
    size_t count = find_standing(film);
    for (size_t d = 0; d < film->house->plan.door_count; d++) {
        size_t observed = film->door_observed[d];
        film->door_opened[d] = observed == SIZE_MAX ? HUGE_VAL : film->observation->door_opened[observed];
        film->door_open[d] = film->door_opened[d] <= film->time;
    }
    for (size_t i = 0; i < film->options.falling_count; i++)
        plan_scene_falling(scene, &film->options.falling[i], film->options.camera.kind == VIEW_RAISED);
    plan_scene_moving(scene, film->house, film->door_opened, film->time);
    if (film_layers_density(film))
        add_density(film, count);
    add_walkers(film, count);
    add_chairs(film, count);
    add_ghosts(film);
    for (size_t i = 0; i < count && !(film->options.hidden & FILM_FORCES); i++)
        add_contact(film, &film->standing[i]);
    for (size_t i = 0; i < count && !film->crowd; i++)
        add_name(film, &film->standing[i]);
    if (film->crowd)
        add_exits(film);
    bool alone = film->house->plan.run.routes == ROUTES_ALONE && film->several;
    if (film->options.live)
        return; /* a window has its own clock */
    scene->clock = scene_text(scene, alone ? "%.1f s, separate runs overlaid" : "%.1f s", film->time);
}
