#include "visual/study/study_axes.h"

#include <math.h>
#include <string.h>

#include "base/text.h"

/* A length below this is shown in mm, a time in ms. */
#define SHORT 0.01     /* m, of houses */
#define OF_MACHINE 1.0 /* m, of what is not a house */
#define BRIEF 0.1      /* s */

#define MILLI 1000.0

/* Returns "joint clearance" for "joint.clearance". */
static const char *spoken(Arena *arena, const char *name) {
    char *text = (char *)arena_text(arena, name);
    for (char *at = text; *at; at++)
        if (*at == '.' || *at == '_')
            *at = ' ';
    return text;
}

StudyScale study_axes_parameter(const Study *study, size_t axis, Arena *arena) {
    const StudyAxis *varied = &study->axes[axis];
    const Parameter *row = study->experiment->parameter(study->experiment->given, varied->name);
    const char *unit = row && row->unit ? row->unit : "1";
    double largest = fmax(fabs(varied->from), fabs(varied->to));
    if (experiment_turns(study->experiment, varied->name))
        return (StudyScale){{.title = "speed", .unit = "rpm"}, EXPERIMENT_RPM};
    StudyScale scale = {{.title = spoken(arena, varied->name), .unit = unit}, 1};
    double below = strcmp(study->experiment->kind, "house") == 0 ? SHORT : OF_MACHINE;
    bool length = strcmp(unit, "m") == 0 && largest < below, time = strcmp(unit, "s") == 0 && largest < BRIEF;
    if (length || time) {
        scale.axis.unit = length ? "mm" : "ms";
        scale.factor = MILLI;
    }
    return scale;
}

StudyScale study_axes_observable(const Observable *observable) {
    return (StudyScale){{.title = observable->meaning, .unit = observable->unit}, 1};
}

double study_axes_value(const Trial *trial, size_t observable) {
    return trial->done && !trial->fault ? trial->observed[observable] : NAN;
}

static double value_at(const void *of, size_t run) {
    const StudyRuns *runs = of;
    return study_axes_value(study_trial(runs->study, runs->pass, run, 0, runs->point), runs->observable);
}

Numbers study_axes_runs(const StudyRuns *runs) {
    return (Numbers){value_at, runs, runs->study->runs};
}

size_t study_axes_find(const Study *study, const char *name) {
    size_t o = 0;
    while (o < study->experiment->observable_count && strcmp(study->experiment->observables[o].name, name) != 0)
        o++;
    return o;
}

bool study_axes_is_mark(const Study *study, size_t observable) {
    return strcmp(study->experiment->kind, "house") == 0 && observable == study->experiment->outcome;
}
