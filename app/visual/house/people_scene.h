/* The observation of a house with a few people as a scene: where they go and how long that takes, the narrowest place,
 * what stops them, and the dangerous points. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "result/census.h"
#include "visual/house/trail.h"

enum {
    PEOPLE_SCENE_INDIVIDUALS = CENSUS_FEW, /* more people are a crowd, see crowd_scene.h */
    PEOPLE_SCENE_SEVERAL = 2, /* more people share the corridors: fewer bodies, no personal spaces or ticks */
};

#define PEOPLE_SCENE_STAY 1.0        /* s, for which people who are out stay visible */
#define PEOPLE_SCENE_TICK 1.0        /* s, from tick to tick of a locus */
#define PEOPLE_SCENE_APART 0.75      /* of a body's length: nearer bodies would merge into a blot */
#define PEOPLE_SCENE_COMPRESSED 0.02 /* m: a personal space pressed less than this counts as at rest */

/* The look of a person's locus: by route where there are routes, otherwise by person. */
typedef struct LocusLook {
    Role role;
    LineStyle style;
    double width; /* design points */
} LocusLook;

/* Sets the edge of a personal space, at rest or pressed. */
extern const LocusLook PEOPLE_SCENE_SPACE, PEOPLE_SCENE_PRESSED;
void people_scene_dress_ring(Primitive *ring, bool pressed);

LocusLook people_scene_look(const House *house, size_t person);
LocusLook people_scene_nth_look(size_t index);

Role people_scene_danger(const Hazard *hazard);

/* True if a moving picture has the person at a time, s: until PEOPLE_SCENE_STAY after leaving, and in a crowd until
 * then. The last person out of a few stays: a film ends with a person in the picture. */
bool people_scene_is_drawn(const Observation *observation, size_t person, double time, bool crowd);

/* Adds the body of a person at the start, with an arrow for a chair. */
void people_scene_start(Scene *scene, const Inhabitant *person, Role role);

/* Adds a past body: faint. */
void people_scene_body(Scene *scene, const Profile *profile, Pose pose, Role role);

/* Returns the interval between shown bodies, s: a multiple of 2 s that leaves the locus visible; `several` loci
 * overlap. */
double people_scene_interval(const Trail *trail, bool several);
double people_scene_least_interval(bool several);

/* Adds the loci of a comparison: dashed, with a name such as "before". */
void people_scene_ghost(Scene *scene, const Observation *before);

/* Names the loci of another run once, at the first place that is APART from all loci of this run (trail_count). */
void people_scene_ghost_label(Scene *scene, const Observation *before, const Trail *trails, size_t trail_count,
                              const char *name);

/* Adds the whole future loci (one trail per person), thin. */
void people_scene_ahead(Scene *scene, const House *house, const Trail *trails);

/* Adds the ticks of a locus after `from` s and up to `to` s. */
void people_scene_ticks(Scene *scene, const Trail *trail, Role role, double from, double to);

/* Adds the discs of the worst dangerous points. */
void people_scene_hazards(Scene *scene, const House *house, const Observation *observation);

/* In painting order; the labels of the second function must be added behind all other primitives. */
void people_scene_ways(Scene *scene, const House *house, const Observation *observation);
void people_scene_labels(Scene *scene, const House *house, const Observation *observation);
