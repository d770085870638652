#include "visual/house/film_layers.h"

#include "visual/house/crowd_scene.h"
#include "visual/house/density_scene.h"

bool film_layers_walks(const Film *film, size_t i) {
    return census_walks(film->house->people[i].profile);
}

LocusLook film_layers_look(const Film *film, size_t i) {
    return film->crowd ? crowd_scene_look(film->house, film->house->people[i].profile)
                       : people_scene_look(film->house, i);
}

bool film_layers_density(const Film *film) {
    return film->house->person_count >= DENSITY_SCENE_PEOPLE && !(film->options.hidden & FILM_RINGS);
}
