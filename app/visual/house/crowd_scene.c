#include "visual/house/crowd_scene.h"

#include "result/headline.h"
#include "result/names.h"
#include "visual/house/people_scene.h"
#include "visual/house/silhouette.h"
#include "visual/house/trail.h"

/* Design points. */
#define WALKER_WIDTH 1.5
#define CHAIR_WIDTH 2.5
#define CHAIR_EDGE 1.2
#define CHAIR_LEAST 12.0   /* shown length of a chair, at least */
#define CHAIR_LARGE 28.0   /* from this length on an arrow has room */
#define DIAMOND_LEAST 2.0  /* half, of many people who are not out, at least */
#define DIAMOND_SINGLE 6.0 /* half, of few */
#define DOT_LARGEST 8.0    /* radius */
#define TEXT_SIZE 16.0

#define START_OPACITY 0.28
#define LOCUS_OPACITY 0.4 /* of a walker's locus among FEW */
#define OPACITY_FALL 0.35 /* exponent: ten times as many loci are each 2.2 times fainter */
#define STUCK_OPACITY 0.85

#define KEEP_STUCK 0.2 /* weight against being covered by labels */
#define KEEP_CHAIR 2.0
#define KEEP_LOCUS 0.3

/* A walker's locus has a point every 0.3 m at most, all loci together at most this number: neither eye nor file needs
 * more. */
#define STEP_LEAST 0.3
#define POINTS_MOST 60000.0

#define CHAIR_LONG 1.1 /* m, about */
#define CHAIR_HIGH 0.9 /* m, in the raised view */

/* Approximate design points of a plan on the page: signs too small to see are drawn larger. */
#define PLAN_WIDTH 880.0
#define PLAN_HEIGHT 560.0

enum {
    FEW = 20,         /* too few loci to hide each other */
    DISC_POINTS = 24, /* of a start */
    DOT_POINTS = 6,   /* of one of many, drawn some pixels large */
    DOTS_FROM = 500,  /* people */
    STUCK_FEW = 100,  /* from this number on the signs of people who are not out are larger than their bodies */
};

/* Returns the length of a design point on the plan of a box, m. */
static double design_point(Box box) {
    Vec2 size = vec2_sub(box.high, box.low);
    return fmax(size.x / PLAN_WIDTH, size.y / PLAN_HEIGHT);
}

bool crowd_scene_is_large(Box box) {
    return CHAIR_LONG < CHAIR_LARGE * design_point(box);
}

LocusLook crowd_scene_look(const House *house, const Profile *profile) {
    if (census_walks(profile))
        return (LocusLook){ROLE_WALKER, LINE_SOLID, WALKER_WIDTH};
    size_t chairs = 0;
    for (const Profile *other = house->profiles; other < profile; other++)
        chairs += !census_walks(other);
    LocusLook look = people_scene_nth_look(chairs);
    look.width = CHAIR_WIDTH;
    return look;
}

/* Loci --------------------------------------------------------------------------------------------------------------*/

/* Lists points of a trail at least `step` apart, and its end; returns their number. */
static size_t thin_trail(const Trail *trail, double step, Vec2 *points) {
    size_t count = 0;
    for (size_t i = 0; i < trail->count; i++) {
        Vec2 at = vec2(trail->rows[i][TRACE_X], trail->rows[i][TRACE_Y]);
        if (count == 0 || i + 1 == trail->count || vec2_distance(at, points[count - 1]) >= step)
            points[count++] = at;
    }
    return count;
}

static void add_locus(Scene *scene, const Trail *trail, LocusLook look, double step, double opacity) {
    Vec2 *points = memory_zeroed(trail->count, sizeof *points);
    size_t count = thin_trail(trail, step, points);
    Primitive *locus = scene_add_line(scene, look.role, look.width, points, count);
    locus->style = look.style;
    locus->edge_opacity = opacity;
    memory_free(points);
}

static void add_walkers_loci(Scene *scene, const House *house, const Observation *observation, const Trail *trails) {
    double length = 0;
    size_t walkers = 0;
    for (size_t i = 0; i < house->person_count; i++)
        if (census_walks(house->people[i].profile) && trails[i].count > 1) {
            length += observation->people[i].path_length;
            walkers++;
        }
    double step = fmax(STEP_LEAST, length / POINTS_MOST);
    double opacity = LOCUS_OPACITY * fmin(1, pow(FEW / fmax(1, (double)walkers), OPACITY_FALL));
    for (size_t i = 0; i < house->person_count; i++)
        if (census_walks(house->people[i].profile) && trails[i].count > 1)
            add_locus(scene, &trails[i], crowd_scene_look(house, house->people[i].profile), step, opacity);
}

/* Adds many small figures of one look as one primitive. */
typedef struct Figures {
    Vec2 *points;
    size_t *starts;
    size_t count, point_capacity, start_capacity;
} Figures;

static void add_figure(Figures *figures, const Vec2 *points, size_t count) {
    size_t begin = figures->count ? figures->starts[figures->count] : 0;
    figures->points = memory_reserve(figures->points, &figures->point_capacity, begin + count, sizeof *points);
    figures->starts =
        memory_reserve(figures->starts, &figures->start_capacity, figures->count + 2, sizeof *figures->starts);
    for (size_t i = 0; i < count; i++)
        figures->points[begin + i] = points[i];
    figures->starts[++figures->count] = begin + count;
}

/* Adds a regular polygon round a point: many corners make a disc, four a diamond. */
static void add_polygon(Figures *figures, Vec2 at, double radius, size_t corners) {
    Vec2 points[DISC_POINTS];
    for (size_t i = 0; i < corners; i++)
        points[i] = vec2_along(at, radius, vec2_heading(2 * M_PI * (double)i / (double)corners));
    add_figure(figures, points, corners);
}

static void finish_figures(Scene *scene, Figures *figures, Role role, double opacity, double keep_clear) {
    if (figures->count) {
        Primitive *all = scene_add_rings(scene, role, figures->points, figures->starts, figures->count);
        all->united = true;
        all->fill_opacity = opacity;
        all->keep_clear = keep_clear;
    }
    memory_free(figures->points);
    memory_free(figures->starts);
}

static void add_walkers_starts(Scene *scene, const House *house, const Observation *observation) {
    Figures discs = {0};
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        double radius = person->profile->width / 2;
        bool dot = house->person_count >= DOTS_FROM && radius < DOT_LARGEST * design_point(scene->box);
        if (observation->people[i].took_part && census_walks(person->profile))
            add_polygon(&discs, person->at, radius, dot ? DOT_POINTS : DISC_POINTS);
    }
    finish_figures(scene, &discs, ROLE_WALKER, START_OPACITY, 0);
}

Primitive *crowd_scene_chair(Scene *scene, Box box, const Profile *profile, Pose pose, Role role) {
    double grown = fmax(1, CHAIR_LEAST * design_point(box) / profile->length);
    Profile shown = {.driving = profile->driving,
                     .length = grown * profile->length,
                     .width = grown * profile->width,
                     .axle = grown * profile->axle,
                     .corner_radius = grown * profile->corner_radius};
    Vec2 outline[SILHOUETTE_POINTS];
    silhouette_outline(&shown, pose.at, pose.heading, 0, outline);
    Primitive *chair = scene_add_polygon(scene, role, outline, SILHOUETTE_POINTS);
    chair->edge = ROLE_PAPER;
    chair->width = CHAIR_EDGE;
    chair->keep_clear = KEEP_CHAIR;
    chair->height = CHAIR_HIGH;
    return chair;
}

static void add_chairs(Scene *scene, const House *house, const Observation *observation, const Trail *trails) {
    for (size_t i = 0; i < house->person_count; i++) {
        const Profile *profile = house->people[i].profile;
        if (census_walks(profile) || trails[i].count < 2)
            continue;
        add_locus(scene, &trails[i], crowd_scene_look(house, profile), 0, 1);
        scene->primitives[scene->count - 1].keep_clear = KEEP_LOCUS;
    }
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        const Profile *profile = person->profile;
        if (!observation->people[i].took_part || census_walks(profile))
            continue;
        Role role = crowd_scene_look(house, profile).role;
        if (!crowd_scene_is_large(scene->box))
            people_scene_start(scene, person, role);
        else
            crowd_scene_chair(scene, scene->box, profile, (Pose){.at = person->at, .heading = person->heading}, role);
    }
}

/* Adds a diamond at the end of each person who is not out, on foot or in a chair; a chair keeps its shape round it. */
static void add_stuck(Scene *scene, const House *house, const Observation *observation, const Census *census,
                      const Trail *trails, bool on_foot) {
    size_t stuck = census->people - census->out;
    double least = design_point(scene->box) * (stuck > STUCK_FEW ? DIAMOND_LEAST : DIAMOND_SINGLE);
    Figures diamonds = {0};
    for (size_t i = 0; i < house->person_count; i++) {
        const Inhabitant *person = &house->people[i];
        const Profile *profile = person->profile;
        bool out = !observation->people[i].took_part || observation->people[i].completed;
        if (out || census_walks(profile) != on_foot)
            continue;
        Pose pose = {.at = person->at, .heading = person->heading};
        if (trails[i].count)
            pose = trail_pose(&trails[i], trail_end(&trails[i]));
        if (!on_foot) {
            Primitive *chair = crowd_scene_chair(scene, scene->box, profile, pose, ROLE_PAPER);
            chair->edge = ROLE_ERROR;
            chair->width = 2 * CHAIR_EDGE;
        }
        add_polygon(&diamonds, silhouette_middle(profile, pose.at, pose.heading), fmax(least, profile->width / 2), 4);
    }
    finish_figures(scene, &diamonds, ROLE_ERROR, STUCK_OPACITY, KEEP_STUCK);
}

void crowd_scene_ways(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    Trail *trails = trail_list(observation);
    add_walkers_starts(scene, house, observation);
    add_walkers_loci(scene, house, observation, trails);
    add_chairs(scene, house, observation, trails);
    add_stuck(scene, house, observation, census, trails, true);
    add_stuck(scene, house, observation, census, trails, false);
    trail_free_list(trails);
}

/* Labels ------------------------------------------------------------------------------------------------------------*/

static void add_hold_label(Scene *scene, const Hold *hold) {
    const char *format = hold->reason == REASON_BLOCKED    ? "%zu blocked here"
                         : hold->reason == REASON_TOO_WEAK ? "%zu too weak here"
                                                           : "%zu cannot pass here";
    const char *text = scene_text(scene, format, hold->people);
    Vec2 middle = vec2_scale(vec2_add(hold->box.low, hold->box.high), 0.5);
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TEXT_SIZE, middle, text);
    tag->fill = ROLE_ERROR;
    tag->shape = LABEL_TAG;
    tag->bold = tag->leader = true;
}

void crowd_scene_labels(Scene *scene, const House *house, const Observation *observation, const Census *census) {
    size_t shown = 0;
    for (size_t h = 0; h < census->hold_count && shown < CROWD_SCENE_HOLDS; h++) {
        const Hold *hold = &census->holds[h];
        if (!observation_reason_has_place(hold->reason))
            continue;
        add_hold_label(scene, hold);
        shown++;
    }
    people_scene_hazards(scene, house, observation);
}

/* The primitives of one profile. */
static Party sum_profile(const Census *census, const Profile *profile) {
    Party sum = {.profile = profile};
    for (size_t p = 0; p < census->party_count; p++) {
        const Party *party = &census->parties[p];
        if (party->profile != profile)
            continue;
        sum.people += party->people;
        sum.out += party->out;
        sum.last = party->out ? fmax(sum.last, party->last) : sum.last;
    }
    return sum;
}

static void list_profile(Scene *scene, const House *house, const Party *sum) {
    LocusLook look = crowd_scene_look(house, sum->profile);
    const char *out = scene_text(scene, "%zu/%zu", sum->out, sum->people);
    const char *last = sum->out ? headline_duration(sum->last, &scene->arena) : "-";
    SceneRow *row = scene_add_row(scene, ROW_LINE, names_profile(sum->profile->name));
    row->role = look.role;
    row->style = look.style;
    row->width = look.width;
    row->symbol = census_walks(sum->profile) ? SYMBOL_DISC : SYMBOL_BOX;
    row->cells[1] = out;
    row->cells[2] = last;
}

void crowd_scene_list(Scene *scene, const House *house, const Census *census) {
    scene_add_row(scene, ROW_HEADING, "People: out/all, last");
    size_t listed = 0, profiles = 0;
    for (size_t k = 0; k < house->profile_count; k++) {
        Party sum = sum_profile(census, &house->profiles[k]);
        if (!sum.people)
            continue;
        profiles++;
        if (listed == CROWD_SCENE_PROFILES)
            continue;
        list_profile(scene, house, &sum);
        listed++;
    }
    if (listed < profiles)
        scene_add_row(scene, ROW_PLAIN, scene_text(scene, "more profiles: %zu", profiles - listed));
    size_t stuck = census->people - census->out;
    if (!stuck)
        return;
    const char *count = scene_text(scene, "%zu", stuck);
    SceneRow *row = scene_add_row(scene, ROW_LINE, census->interrupted ? "still inside" : "not out");
    row->role = ROLE_ERROR;
    row->symbol = SYMBOL_DIAMOND;
    row->cells[1] = count;
}
