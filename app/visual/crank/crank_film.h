/* The recorded revolutions of a crank as a moving picture, in layers, with the phase plane and the force next to it.
 * Any time of the record can be shown, in any order. */
#pragma once

#include "plot/plot.h"
#include "visual/crank/crank_scene.h"

enum { CRANK_FILM_PLOTS = 2, CRANK_FILM_TURNS = 3 /* shown by default */ };

#define CRANK_FILM_SLOW 60.0 /* 1, slow motion by default */

typedef struct CrankFilm CrankFilm;

/* Makes a film of the times from `first` to `last` (s since the end of the transient) of a trace that has a whole
 * revolution; crank, tree and response must outlive it. crank_film_destroy releases it. */
CrankFilm *crank_film_create(const Crank *crank, const Tree *tree, const Response *response, double first, double last);
void crank_film_destroy(CrankFilm *film);

const Scene *crank_film_still(const CrankFilm *film);
const Scene *crank_film_added(const CrankFilm *film);
const Scene *crank_film_moving(const CrankFilm *film);

/* Moves to a time, s. Always true: nothing is added to the static layer. */
bool crank_film_show(CrankFilm *film, double time);

/* Returns the phase plane and the force (CRANK_FILM_PLOTS), and how many points of a series lie at or before a time,
 * s. */
const Plot *crank_film_plots(const CrankFilm *film);
size_t crank_film_until(const CrankFilm *film, size_t plot, size_t series, double time);
