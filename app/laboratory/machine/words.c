#include "laboratory/machine/words.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"

#define MINUS "\u2212"

enum { WRITTEN_MOST = 10 /* numbers up to this one are written as words */ };

static const double CLEAR = 1.1; /* 1: a drift below this factor is told with three digits, */
static const double LARGE = 100; /* 1: and one from this on in whole numbers */
static const double ALIKE = 0.5; /* N: hits that differ by less have one number */

/* Returns "two", or "12" for numbers above ten. */
static const char *count_words(size_t count, Arena *arena) {
    static const char *const words[] = {"no",  "one",   "two",   "three", "four", "five",
                                        "six", "seven", "eight", "nine",  "ten"};
    return count <= WRITTEN_MOST ? words[count] : text_in_arena(arena, "%zu", count);
}

/* Returns the text with a capital first letter. */
static const char *as_title(const char *text, Arena *arena) {
    return text_in_arena(arena, "%c%s", toupper((unsigned char)*text), text + 1);
}

const char *machine_words_periodic(const MachineKind *kind, size_t period, bool touches, Arena *arena) {
    if (!touches)
        return "Never touches";
    if (period == 1)
        return text_in_arena(arena, "Every %s alike", kind->cycle);
    return as_title(text_in_arena(arena, "%s %s in turn", count_words(period, arena), kind->hits), arena);
}

/* True if the recorded cycles still hold the way to a periodic motion. */
static bool is_settling(const MachineFacts *facts) {
    const ResultRow *row = facts->motion.row_count ? result_find(&facts->motion, 0, "settled") : NULL;
    return facts->verdict == RESPONSE_PERIODIC && row && row->number == 0;
}

const char *machine_words_title(const MachineKind *kind, const MachineFacts *facts, Arena *arena) {
    static const char *const titles[] = {[RESPONSE_PERIODIC] = "",
                                         [RESPONSE_QUASI_PERIODIC] = "two rhythms at once",
                                         [RESPONSE_CHAOTIC] = "chaotic",
                                         [RESPONSE_TRANSIENT] = "settles late",
                                         [RESPONSE_UNDETERMINED] = "undecided",
                                         [RESPONSE_CHATTERS] = "chatter",
                                         [RESPONSE_DIVERGED] = "runs away",
                                         [RESPONSE_STIFF] = "too stiff",
                                         [RESPONSE_INTERRUPTED] = "interrupted"};
    if (is_settling(facts))
        return "Still settling";
    if (facts->verdict == RESPONSE_PERIODIC)
        return machine_words_periodic(kind, facts->period, facts->peaks.count > 0, arena);
    if (facts->quick && response_is_told(facts->verdict))
        return text_in_arena(arena, "Probably %s", titles[facts->verdict]);
    return as_title(titles[facts->verdict], arena);
}

const char *machine_words_hits(const MachineKind *kind, const SectionPeaks *peaks, Arena *arena) {
    if (!peaks->count)
        return "";
    if (peaks->max - peaks->min < ALIKE)
        return text_in_arena(arena, "hardest %s %.0f N", kind->hit, peaks->max);
    return text_in_arena(arena, "hardest %s %.0f to %.0f N", kind->hits, peaks->min, peaks->max);
}

const char *machine_words_repeat(const MachineKind *kind, size_t period, Arena *arena) {
    if (period == 1)
        return text_in_arena(arena, "the same every %s (period 1)", kind->cycle);
    return text_in_arena(arena, "the same every %s %ss (period %zu)", count_words(period, arena), kind->cycle, period);
}

const char *machine_words_rhythm(const MachineKind *kind, const MachineFacts *facts, Arena *arena) {
    switch (facts->verdict) {
    case RESPONSE_PERIODIC:
        return text_in_arena(arena, "%s%s", is_settling(facts) ? "later " : "",
                             machine_words_repeat(kind, facts->period, arena));
    case RESPONSE_QUASI_PERIODIC:
        return "never quite the same (quasi-periodic)";
    case RESPONSE_CHAOTIC:
        return "never the same twice";
    case RESPONSE_TRANSIENT:
        return "the first motion does not last (transient)";
    case RESPONSE_UNDETERMINED:
        return "neither a rhythm nor chaos was found (undetermined)";
    case RESPONSE_CHATTERS:
        return text_in_arena(arena, "too many %s in a %s to follow", kind->hits, kind->cycle);
    case RESPONSE_DIVERGED:
        return "its numbers grow without bound (diverged)";
    case RESPONSE_STIFF:
        return "it changes too fast to follow";
    case RESPONSE_INTERRUPTED:
        break;
    }
    return "";
}

const char *machine_words_drift(const MachineKind *kind, double exponent, Arena *arena) {
    double factor = exp(exponent);
    const char *times = factor < LARGE ? text_in_arena(arena, "%.*g", factor < CLEAR ? 3 : 2, factor)
                                       : text_in_arena(arena, "%.0f", factor);
    return text_in_arena(arena, "two almost equal starts drift %s times apart each %s (Lyapunov %s%.2f)", times,
                         kind->cycle, exponent < 0 ? MINUS : "+", fabs(exponent));
}

const char *machine_words_type(TypesKind type) {
    return type == TYPES_I     ? "safe (type I)"
           : type == TYPES_II  ? "steep: close tolerances (type II)"
           : type == TYPES_III ? "do not run it here (type III)"
                               : "undecided whether it is safe (type unresolved)";
}

const char *machine_words_type_heading(TypesKind type) {
    return type == TYPES_I     ? "Safe (type I)"
           : type == TYPES_II  ? "Steep (type II)"
           : type == TYPES_III ? "Do not run it (type III)"
                               : "Safe or not: undecided";
}

const char *machine_words_label(const MachineKind *kind, const ResultRow *row, Arena *arena) {
    const struct {
        const char *key, *before, *middle, *after;
    } labels[] = {{"frequency", kind->drive, "", ""},
                  {"clearance", "gap in the joint", "", " (clearance)"},
                  {"verdict", "how it moves", "", ""},
                  {"quick", "first look only", "", " (quick)"},
                  {"period", kind->cycle, "", "s until it repeats (period)"},
                  {"settled", "has settled", "", ""},
                  {"lyapunov", "drift per ", kind->cycle, " (Lyapunov exponent)"},
                  {"zero_one", "0 order, 1 chaos", "", " (0-1 test)"},
                  {"rotation", "second rhythm", "", " (rotation number)"},
                  {"multiplier", "how soon it dies away", "", " (multiplier)"},
                  {"peaks.min", "least of the hardest ", kind->hits, ""},
                  {"peaks.max", "hardest ", kind->hit, " (peak force)"},
                  {"peaks.mean", "mean of the hardest ", kind->hits, ""},
                  {"peaks.count", kind->hits, "", " measured"}};
    for (size_t i = 0; row->label && row->key && i < sizeof labels / sizeof *labels; i++)
        if (strcmp(labels[i].key, row->key) == 0)
            return text_in_arena(arena, "%s%s%s", labels[i].before, labels[i].middle, labels[i].after);
    return row->label;
}

const char *machine_words_value(const char *value, Arena *arena) {
    bool negative = value && value[0] == '-' && (isdigit((unsigned char)value[1]) || value[1] == '.');
    return negative ? text_in_arena(arena, MINUS "%s", value + 1) : value;
}
