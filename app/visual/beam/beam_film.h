/* A beam's recorded cycles as a moving picture, in the layers of film.h, with the phase plane and the force beside it.
 * Any time of the record can be shown, in any order. */
#pragma once

#include "plot/plot.h"
#include "visual/beam/beam_scene.h"

enum { BEAM_FILM_PLOTS = 2, BEAM_FILM_CYCLES = 8 /* that are shown where nothing else is asked for */ };

#define BEAM_FILM_CYCLE_SECONDS 1.5 /* s, about, that a cycle takes where nothing else is asked for */

typedef struct BeamFilm BeamFilm;

/* Beam, rig, response and record must outlive it; the plots are of the record's samples. `slow` as in
 * beam_scene_labels. beam_film_destroy releases it. */
BeamFilm *beam_film_create(const Beam *beam, const Rig *rig, const Response *response, BeamRecord *record, double slow);
void beam_film_destroy(BeamFilm *film);

/* So many times slower, a round number, that a cycle lasts about as long as it should. */
double beam_film_slow(double frequency);

const Scene *beam_film_still(const BeamFilm *film);
const Scene *beam_film_added(const BeamFilm *film);
const Scene *beam_film_moving(const BeamFilm *film);

/* Moves to a time, s; returns as film_show. */
bool beam_film_show(BeamFilm *film, double time);

/* The phase plane and the force (BEAM_FILM_PLOTS), and how many points of a series lie at or before a time, s. */
const Plot *beam_film_plots(const BeamFilm *film);
size_t beam_film_until(const BeamFilm *film, size_t plot, size_t series, double time);

/* Adds to each plot a disc at the time that is shown: for still pictures. */
void beam_film_mark(BeamFilm *film);
