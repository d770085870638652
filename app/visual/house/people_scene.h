/* The observed of a house with a few people as a scene: where they go and what that takes, the narrowest place, what
 * stops them, and the dangerous points. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"
#include "visual/house/trail.h"

enum {
    PEOPLE_SCENE_INDIVIDUALS = 6, /* more people are a crowd, see crowd_scene.h */
    PEOPLE_SCENE_SEVERAL = 2,     /* more people share the corridors: fewer bodies, no personal spaces or seconds */
    PEOPLE_SCENE_HAZARDS = 5,     /* shown, of those that were found */
};

#define PEOPLE_SCENE_TICK 1.0        /* s, from tick to tick of a locus */
#define PEOPLE_SCENE_APART 0.75      /* of a body's length: bodies nearer to one another are a blot */
#define PEOPLE_SCENE_COMPRESSED 0.02 /* m: a personal space pressed less than this is at rest */

/* How a person's locus looks: by route where there are routes, otherwise by person. */
typedef struct LocusLook {
    Role role;
    LineStyle style;
    double width; /* design points */
} LocusLook;

/* The edge of a personal space, at rest and pressed. */
extern const LocusLook PEOPLE_SCENE_SPACE, PEOPLE_SCENE_PRESSED;
void people_scene_dress_ring(Primitive *ring, bool pressed);

LocusLook people_scene_look(const House *house, size_t person);
LocusLook people_scene_nth_look(size_t index);

/* "0.26 m", "0.064 m" below a decimetre, or "touches" from nought down. */
const char *people_scene_clearance(Scene *scene, double clearance);

Role people_scene_danger(const Hazard *hazard);

/* Who came nearest to something; SIZE_MAX when nothing came into anybody's personal space. */
size_t people_scene_narrowest(const House *house, const Observation *observation);

/* The body of somebody at the start, with an arrow where it is a chair. */
void people_scene_start(Scene *scene, const Inhabitant *person, Role role);

/* A body that has been somewhere: faint. */
void people_scene_body(Scene *scene, const Profile *profile, Pose pose, Role role);

/* From one body shown to the next, s: a multiple of 2 s that leaves the way to be seen; `several` ways overlap. */
double people_scene_interval(const Trail *trail, bool several);
double people_scene_least_interval(bool several);

/* The loci of an observation that is not the one shown: dashed, with a word such as "before". */
void people_scene_ghost(Scene *scene, const Observation *before, const char *name);

/* The whole loci (trails, a person each), thin: where everybody will have been. */
void people_scene_ahead(Scene *scene, const House *house, const Trail *trails);

/* The ticks of a locus after `from` s and up to `to` s. */
void people_scene_ticks(Scene *scene, const Trail *trail, Role role, double from, double to);

/* The discs of the worst dangerous points. */
void people_scene_hazards(Scene *scene, const Observation *observation);

/* In painting order; the labels of the second belong behind all other primitives. */
void people_scene_ways(Scene *scene, const House *house, const Observation *observation);
void people_scene_labels(Scene *scene, const House *house, const Observation *observation);
