#include "visual/study/plot_choice.h"

#include <stdio.h>
#include <string.h>

enum { SHOWN = 40 /* characters of a wrong word */ };

static bool choose(PlotChoice *choice, const char *word, size_t length, const char *const *known, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strlen(known[i]) == length && strncmp(known[i], word, length) == 0) {
            for (size_t c = 0; c < choice->count; c++)
                if (choice->indices[c] == i)
                    return true;
            choice->indices[choice->count++] = i;
            return true;
        }
    return false;
}

bool plot_choice_read(PlotChoice *choice, const char *words, const char *const *known, size_t count,
                      char fault[PLOT_CHOICE_FAULT]) {
    PlotChoice chosen = {.count = 0};
    for (const char *word = words;; word++) {
        size_t length = strcspn(word, ",");
        if (!choose(&chosen, word, length, known, count)) {
            snprintf(fault, PLOT_CHOICE_FAULT, "no plot \"%.*s\": plots are", (int)(length < SHOWN ? length : SHOWN),
                     word);
            for (size_t i = 0; i < count; i++)
                strcat(strcat(fault, i ? ", " : " "), known[i]);
            return false;
        }
        word += length;
        if (!*word)
            break;
    }
    *choice = chosen;
    return true;
}
