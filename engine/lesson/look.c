#include "lesson/look.h"

#include <string.h>

#include "base/text.h"

#define SLOWEST 0.0625
#define FASTEST 64.0

enum { PLOTS_MOST = 9, LAYERS_MOST = 9 /* keys 1 to 9 */ };

/* The layers and plots of each laboratory; the tests of the window compare these with its own. */
static const struct {
    size_t layers;
    const char *plots[PLOTS_MOST]; /* NULL-ended */
} laboratories[] = {
    [LESSON_HOUSE] = {9, {"speed", "clearance", "force", "ring", "phase", "out", "flow"}},
    [LESSON_BEAM] = {4, {"phase", "poincare", "force", "spectrum", "orbit"}},
    [LESSON_CRANK] = {4, {"phase", "poincare", "section", "force", "slider", "spectrum", "orbit", "map"}},
};

size_t look_layers(LessonLaboratory laboratory) {
    return laboratories[laboratory].layers;
}

const char *const *look_plots(LessonLaboratory laboratory, size_t *count) {
    const char *const *plots = laboratories[laboratory].plots;
    for (*count = 0; *count < PLOTS_MOST && plots[*count];)
        (*count)++;
    return plots;
}

static void read_layers(LessonLook *look, const Lesson *lesson, const JsonNode *view, Fault *fault) {
    JsonNode list = json_member(view, "layers");
    size_t most = look_layers((LessonLaboratory)lesson->laboratory);
    if (!list.value)
        return;
    if (!json_is_array(list.value)) {
        json_fault(&list, fault, "layers must be a list [ ... ]");
        return;
    }
    look->layered = true;
    for (size_t i = 0; i < json_array_size(list.value); i++) {
        JsonNode element = json_element(&list, i);
        json_int_t key = json_integer_value(element.value);
        if (key < 1 || key > (json_int_t)most)
            json_fault(&element, fault, "a layer must be the number of its key, 1 to %zu", most);
        else
            look->layers |= 1u << (key - 1);
    }
}

/* Adds a fault if the laboratory has no plot of this name. */
static void check_plot(const char *name, LessonLaboratory laboratory, const JsonNode *node, Fault *fault) {
    size_t count;
    const char *const *plots = look_plots(laboratory, &count);
    for (size_t p = 0; p < count; p++)
        if (strcmp(plots[p], name) == 0)
            return;
    const char *nearest = text_nearest(name, plots, count);
    if (nearest)
        json_fault(node, fault, "unknown plot \"%.40s\", did you mean \"%s\"?", name, nearest);
    else
        json_fault(node, fault, "unknown plot \"%.40s\"", name);
}

static void read_plots(LessonLook *look, Lesson *lesson, const JsonNode *view, Fault *fault) {
    JsonNode node = json_member(view, "plots");
    look->plots = json_read_text(view, "plots", &lesson->arena, fault);
    if (strcmp(look->plots, "none") == 0)
        return;
    for (const char *at = look->plots; *at; at += strcspn(at, ","), at += *at == ',')
        check_plot(text_in_arena(&lesson->arena, "%.*s", (int)strcspn(at, ","), at),
                   (LessonLaboratory)lesson->laboratory, &node, fault);
}

void look_read(LessonLook *look, Lesson *lesson, const JsonNode *object, Fault *fault) {
    static const char *const keys[] = {"layers", "plots", "speed", NULL};
    JsonNode view = json_member(object, "view"), speed = json_member(&view, "speed");
    *look = (LessonLook){.plots = ""};
    if (!view.value)
        return;
    if (!json_is_object(view.value)) {
        json_fault(&view, fault, "view must be an object { ... }");
        return;
    }
    json_check_keys(&view, keys, fault);
    read_layers(look, lesson, &view, fault);
    read_plots(look, lesson, &view, fault);
    look->speed = json_number_value(speed.value);
    if (speed.value && !(look->speed >= SLOWEST && look->speed <= FASTEST))
        json_fault(&speed, fault, "speed must be a number, %g to %g", SLOWEST, FASTEST);
}

LessonLook look_of_step(const Lesson *lesson, const LessonStep *step) {
    LessonLook look = step->view;
    if (!look.layered) {
        look.layered = lesson->view.layered;
        look.layers = lesson->view.layers;
    }
    if (!*look.plots)
        look.plots = lesson->view.plots;
    if (!(look.speed > 0))
        look.speed = lesson->view.speed;
    return look;
}

json_t *look_schema(void) {
    json_t *layers = json_pack("{s:s, s:{s:s, s:i, s:i}, s:s}", "type", "array", "items", "type", "integer", "minimum",
                               1, "maximum", LAYERS_MOST, "description", "numbers of the keys of the layers shown");
    json_t *plots =
        json_pack("{s:s, s:s}", "type", "string", "description", "plots shown, separated by commas, or none");
    json_t *speed = json_pack("{s:s, s:f, s:f, s:s}", "type", "number", "minimum", SLOWEST, "maximum", FASTEST,
                              "description", "speed of playback");
    return json_pack("{s:s, s:{s:o, s:o, s:o}, s:b, s:s}", "type", "object", "properties", "layers", layers, "plots",
                     plots, "speed", speed, "additionalProperties", 0, "description",
                     "what the window shows; a step without one of these has that of the lesson");
}
