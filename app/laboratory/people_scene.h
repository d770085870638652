/* The observed of a house with a few people as a scene: where they go and what that takes, the narrowest place, what
 * stops them, and the dangerous points. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"

enum {
    PEOPLE_SCENE_INDIVIDUALS = 6, /* more people are a crowd, see crowd_scene.h */
    PEOPLE_SCENE_SEVERAL = 2,     /* more people share the corridors: fewer bodies, no personal spaces or seconds */
    PEOPLE_SCENE_HAZARDS = 5,     /* shown, of those that were found */
};

/* How a person's locus looks: by route where there are routes, otherwise by person. */
typedef struct LocusLook {
    Role role;
    LineStyle style;
    double width; /* design points */
} LocusLook;

/* The edge of a personal space, at rest and pressed. */
extern const LocusLook PEOPLE_SCENE_SPACE, PEOPLE_SCENE_PRESSED;

LocusLook people_scene_look(const House *house, size_t person);
LocusLook people_scene_nth_look(size_t index);

/* "0.06 m", "0.004 m" below a centimetre, or "touches" from nought down. */
const char *people_scene_clearance(Scene *scene, double clearance);

Role people_scene_danger(const Hazard *hazard);

/* Who came nearest to something; SIZE_MAX when nothing came into anybody's personal space. */
size_t people_scene_narrowest(const House *house, const Observation *observation);

/* The body of somebody at the start, with an arrow where it is a chair. */
void people_scene_start(Scene *scene, const Inhabitant *person, Role role);

/* The discs of the worst dangerous points. */
void people_scene_hazards(Scene *scene, const Observation *observation);

/* In painting order; the labels of the second belong behind all other primitives. */
void people_scene_ways(Scene *scene, const House *house, const Observation *observation);
void people_scene_labels(Scene *scene, const House *house, const Observation *observation);
