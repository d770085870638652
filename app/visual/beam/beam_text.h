/* A beam's answer and inputs as text, for pictures. */
#pragma once

#include "beam/beam_cycle.h"
#include "draw/scene.h"

/* Return "Chaotic: 485 to 989 N at 300 Hz", and one more line about it; they live as long as the scene. */
const char *beam_text_title(Scene *scene, const Beam *beam, const Rig *rig, const Response *response);
const char *beam_text_detail(Scene *scene, const Response *response);

/* Prints a force to the newton, or to three digits of `most` if that is small; the second function with the sign. */
const char *beam_text_newtons(Scene *scene, double force, double most);
const char *beam_text_signed_newtons(Scene *scene, double force, double most);

/* Prints a number with its unit and an SI prefix: 0.047 kg is "47 g". */
const char *beam_text_quantity(Scene *scene, double value, const char *unit);

/* Returns the provenance of a value in a word: "identified, not published". `name` as in beam_table. */
const char *beam_text_provenance(Scene *scene, const Beam *beam, const char *name);
