/* A beam's answer and given in words, for pictures. */
#pragma once

#include "beam/response.h"
#include "draw/scene.h"

/* "Chaotic: 485 to 989 N at 300 Hz", and a line more about it; they live as long as the scene. */
const char *beam_text_title(Scene *scene, const Beam *beam, const Rig *rig, const Response *response);
const char *beam_text_detail(Scene *scene, const Response *response);

/* A force to the newton, or where `most` is small to three digits of it; the second with its sign. */
const char *beam_text_newtons(Scene *scene, double force, double most);
const char *beam_text_signed_newtons(Scene *scene, double force, double most);

/* A number with its unit, in steps of a thousand: 0.047 kg is "47 g". */
const char *beam_text_quantity(Scene *scene, double value, const char *unit);

/* Where a value comes from, in a word: "identified, not published". `name` as in beam_table. */
const char *beam_text_provenance(Scene *scene, const Beam *beam, const char *name);
