/* The recorded cycles of a beam as a moving picture, in the layers of film.h, with the phase plane and the force next
 * to it. Any time of the record can be shown, in any order. */
#pragma once

#include "plot/plot.h"
#include "visual/beam/beam_scene.h"

enum { BEAM_FILM_PLOTS = 2, BEAM_FILM_CYCLES = 8 /* shown by default */ };

#define BEAM_FILM_CYCLE_SECONDS 1.5 /* s, about, that a cycle lasts by default */

typedef struct BeamFilm BeamFilm;

/* Makes a film; beam, rig, response and record must outlive it; the plots are made of the record's samples. `slow` as
 * in beam_scene_labels. beam_film_destroy releases it. */
BeamFilm *beam_film_create(const Beam *beam, const Rig *rig, const Response *response, BeamRecord *record, double slow);
void beam_film_destroy(BeamFilm *film);

/* Returns the slow-motion factor, a round number, that makes a cycle last about as long as requested. */
double beam_film_slow(double frequency);

const Scene *beam_film_still(const BeamFilm *film);
const Scene *beam_film_added(const BeamFilm *film);
const Scene *beam_film_moving(const BeamFilm *film);

/* Moves to a time, s; returns the same as film_show. */
bool beam_film_show(BeamFilm *film, double time);

/* Returns the phase plane and the force (BEAM_FILM_PLOTS), and how many points of a series lie at or before a time, s.
 */
const Plot *beam_film_plots(const BeamFilm *film);
size_t beam_film_until(const BeamFilm *film, size_t plot, size_t series, double time);

/* Adds a disc at the displayed time to each plot: for still pictures. */
void beam_film_mark(BeamFilm *film);
