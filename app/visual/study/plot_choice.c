#include "visual/study/plot_choice.h"

#include <stdio.h>
#include <string.h>

enum { SHOWN = 40 /* characters of a wrong name */ };

static bool choose(PlotChoice *choice, const char *name, size_t length, const char *const *known, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strlen(known[i]) == length && strncmp(known[i], name, length) == 0) {
            for (size_t c = 0; c < choice->count; c++)
                if (choice->indices[c] == i)
                    return true;
            choice->indices[choice->count++] = i;
            return true;
        }
    return false;
}

bool plot_choice_read(PlotChoice *choice, const char *text, const char *const *known, size_t count,
                      char fault[PLOT_CHOICE_FAULT]) {
    PlotChoice chosen = {.count = 0};
    for (const char *name = text;; name++) {
        size_t length = strcspn(name, ",");
        if (!choose(&chosen, name, length, known, count)) {
            snprintf(fault, PLOT_CHOICE_FAULT, "no plot \"%.*s\": plots are", (int)(length < SHOWN ? length : SHOWN),
                     name);
            for (size_t i = 0; i < count; i++)
                strcat(strcat(fault, i ? ", " : " "), known[i]);
            return false;
        }
        name += length;
        if (!*name)
            break;
    }
    *choice = chosen;
    return true;
}
