/* Says what a house lacks before it can be answered, and the tool that adds it: walls, an exit, a person, a door. */
#pragma once

#include "draw/scene.h"
#include "house/observation.h"

typedef struct Missing {
    const char *title, *detail; /* in the scene's memory; never NULL */
    const char *cure;           /* words of a button: "Add an exit" */
    int tool;                   /* EditTool that adds what is missing */
    Vec2 at;                    /* m, where; NAN: anywhere */
    Role role;
} Missing;

/* False: nothing is missing. */
bool missing_find(const House *house, const Observation *observation, Scene *scene, Missing *missing);
