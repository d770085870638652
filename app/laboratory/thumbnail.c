#include "laboratory/thumbnail.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "house/house.h"
#include "laboratory/shipped.h"
#include "visual/beam/beam_scene.h"
#include "visual/beam/beam_shape.h"
#include "visual/crank/crank_scene.h"
#include "visual/house/plan_picture.h"

/* Texts ----------------------------------------------------------------------------------------------------------- */

const char *thumbnail_name_of(const char *path, Arena *arena) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    return text_in_arena(arena, "%.*s", dot && dot > name ? (int)(dot - name) : (int)strlen(name), name);
}

/* Returns the bytes of a note's first sentence. A full stop in a number, or after a single letter, does not end it. */
static size_t sentence_of(const char *note) {
    for (const char *c = note; (c = strchr(c, '.')); c++)
        if ((c[1] == ' ' || !c[1]) && c > note + 1 && c[-2] != ' ')
            return (size_t)(c - note);
    return strlen(note);
}

/* Returns the bytes of the part of a text that fits: at most THUMBNAIL_LINE characters, up to the end of a clause, or
 * else of a word. */
static size_t shortened(const char *sentence, size_t length, bool *whole) {
    size_t characters = 0, word = 0, clause = 0;
    *whole = true;
    for (size_t i = 0; i < length; i++) {
        characters += ((unsigned char)sentence[i] & 0xc0) != 0x80;
        if (sentence[i] == ' ' && i > 0) {
            word = i;
            clause = strchr(",;:", sentence[i - 1]) ? i - 1 : clause;
        }
        if (characters > THUMBNAIL_LINE) {
            *whole = clause > 0;
            return clause ? clause : word ? word : i;
        }
    }
    return length;
}

/* Moves the phrase that begins every note of an unmeasured plan to the end, where it is not cut off. */
static const char *line_of(Thumbnail *thumbnail, const char *note) {
    static const char assumed[] = "assumed plan: ";
    bool is_assumed = strncmp(note, assumed, strlen(assumed)) == 0;
    const char *sentence = is_assumed ? note + strlen(assumed) : note;
    bool whole;
    size_t shown = shortened(sentence, sentence_of(sentence), &whole);
    if (!shown)
        return "";
    return text_in_arena(&thumbnail->arena, "%c%.*s%s%s", toupper((unsigned char)sentence[0]), (int)shown - 1,
                         sentence + 1, whole ? "" : " \u2026", is_assumed ? " (assumed plan)" : "");
}

static void set_texts(Thumbnail *thumbnail, const char *path, const char *name, const char *note) {
    thumbnail->name = name && *name ? arena_text(&thumbnail->arena, name) : thumbnail_name_of(path, &thumbnail->arena);
    thumbnail->line = line_of(thumbnail, note ? note : "");
}

/* Scenes ----------------------------------------------------------------------------------------------------------- */

#define REACH 1e-6      /* of the beam's length, least deflection that the picture has room for */
#define BEND 0.9        /* of the clearance: distance of the drawn tip from the middle */
#define BEAM_BEFORE 0.1 /* of the beam's length: visible margins before, behind, above and below */
#define BEAM_BEHIND 0.12
#define BEAM_HALF 0.21

bool thumbnail_read_house(Thumbnail *thumbnail, const char *path, Fault *fault) {
    *thumbnail = (Thumbnail){.scene = {.bare = true, .unscaled = true}};
    House house = {.seed = 0};
    bool good = plan_read(&house.plan, path, NULL, 0, fault) && outline_build(&house.outline, &house.plan, fault);
    if (good) {
        set_texts(thumbnail, path, house.plan.name, house.plan.note);
        plan_picture_bare(&thumbnail->scene, &house);
        thumbnail->people = house.plan.person_count;
        for (size_t i = 0; i < house.plan.crowd_count; i++)
            thumbnail->people += (size_t)house.plan.crowds[i].count;
    }
    if (!good)
        thumbnail_clear(thumbnail);
    house_free(&house);
    return good;
}

/* Bends the beam approximately as its first mode does, with the tip at the lower stop. */
static void bend(BeamShape *shape, const Beam *beam) {
    for (size_t i = 0; i < shape->count; i++) {
        double part = (shape->place[i] - beam->pivot_position) / (beam->length - beam->pivot_position);
        shape->deflection[i] = -BEND * beam->clearance * (part > 0 ? part * part : 0);
    }
}

/* True if a primitive lies left of the loupe. */
static bool is_seen(const Primitive *primitive, double right) {
    for (size_t i = 0; i < primitive->count; i++)
        if (primitive->points[i].x > right)
            return false;
    return primitive->kind != PRIMITIVE_LABEL && primitive->kind != PRIMITIVE_DIMENSION;
}

/* Removes texts and the parts of the loupe that would be cut off. */
static void keep_seen(Scene *scene, double right) {
    size_t kept = 0;
    for (size_t i = 0; i < scene->count; i++)
        if (is_seen(&scene->primitives[i], right))
            scene->primitives[kept++] = scene->primitives[i];
    scene->count = kept;
    scene->clock = NULL;
}

static void draw_beam(Scene *scene, const Beam *beam, const Rig *rig) {
    double length = beam->length, right = (1 + BEAM_BEHIND) * length, reach = fmax(beam->clearance, REACH * length);
    BeamScale scale = beam_scene_scale(beam, reach, reach);
    BeamShape shape = beam_shape_create(rig);
    bend(&shape, beam);
    beam_scene_still(scene, beam, &scale);
    beam_scene_moving(scene, beam, &scale, &shape, &(BeamMoment){.largest = 1});
    keep_seen(scene, right);
    scene->box = (Box){{-BEAM_BEFORE * length, -BEAM_HALF * length}, {right, BEAM_HALF * length}};
    beam_shape_destroy(&shape);
}

bool thumbnail_read_beam(Thumbnail *thumbnail, const char *path, Fault *fault) {
    *thumbnail = (Thumbnail){.scene = {.bare = true, .unscaled = true}};
    Beam beam = {.name = NULL};
    Rig rig;
    bool good = beam_read(&beam, path, NULL, 0, fault);
    if (good && (good = rig_build(&rig, &beam, path, fault))) {
        set_texts(thumbnail, path, beam.name ? shipped_title(beam.name) : NULL, beam.note);
        draw_beam(&thumbnail->scene, &beam, &rig);
        rig_clear(&rig);
    }
    if (!good)
        thumbnail_clear(thumbnail);
    beam_free(&beam);
    return good;
}

/* Draws the ideal mechanism with its pin at this angle. */
#define CRANK_ANGLE_SHOWN 1.0 /* rad */

bool thumbnail_read_crank(Thumbnail *thumbnail, const char *path, Fault *fault) {
    *thumbnail = (Thumbnail){.scene = {.bare = true, .unscaled = true}};
    Crank crank = {.name = NULL};
    if (!crank_read(&crank, path, NULL, 0, fault))
        return false;
    set_texts(thumbnail, path, crank.name ? shipped_title(crank.name) : NULL, crank.note);
    Tree tree = tree_of(&crank);
    CrankScale scale = crank_scene_scale(&crank, &tree, 0, 1);
    double state[TREE_STATES_MOST] = {0};
    scale.parts = 0;
    tree_ideal(&tree, CRANK_ANGLE_SHOWN, tree.omega, state);
    crank_scene_still(&thumbnail->scene, &crank, &tree, &scale);
    crank_scene_moving(&thumbnail->scene, &tree, &scale,
                       &(CrankMoment){.time = CRANK_ANGLE_SHOWN / tree.omega, .state = state});
    thumbnail->scene.box = scale.box;
    thumbnail->scene.box.high.x = scale.socket.x - scale.loupe; /* without the loupe's place */
    crank_free(&crank);
    return true;
}

void thumbnail_clear(Thumbnail *thumbnail) {
    scene_clear(&thumbnail->scene);
    arena_clear(&thumbnail->arena);
    *thumbnail = (Thumbnail){.name = NULL};
}
