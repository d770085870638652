#include "visual/beam/beam_text.h"

#include <math.h>
#include <string.h>

const char *beam_text_quantity(Scene *scene, double value, const char *unit) {
    static const struct {
        double size;
        const char *name;
    } prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "\u00b5"}, {1e-9, "n"}};
    enum { LAST = sizeof prefixes / sizeof *prefixes - 1 };
    if (strcmp(unit, "kg") == 0)
        return value >= 1 || value == 0 ? scene_text(scene, "%.3g kg", value)
                                        : beam_text_quantity(scene, 1000 * value, "g");
    int p = 0;
    while (p < LAST && fabs(value) < prefixes[p].size)
        p++;
    if (value == 0)
        return scene_text(scene, "0 %s", unit);
    return scene_text(scene, "%.3g %s%s", value / prefixes[p].size, prefixes[p].name, unit);
}

/* Returns the digits behind the point that give at least three significant digits. */
static int digits_of(double most) {
    return (int)real_clamp(most > 0 ? 2 - floor(log10(most)) : 0, 0, 9);
}

const char *beam_text_newtons(Scene *scene, double force, double most) {
    return scene_text(scene, "%.*f N", digits_of(most), force);
}

const char *beam_text_signed_newtons(Scene *scene, double force, double most) {
    return scene_text(scene, "%s%.*f N", force < 0 ? "\u2212" : "+", digits_of(most), fabs(force));
}

/* Prints "485 to 989 N", or a single value if both are printed alike. */
static const char *peaks_of(Scene *scene, const SectionPeaks *peaks) {
    const char *least = scene_text(scene, "%.*f", digits_of(peaks->max), peaks->min);
    const char *most = scene_text(scene, "%.*f", digits_of(peaks->max), peaks->max);
    return strcmp(least, most) == 0 ? scene_text(scene, "%s N", most) : scene_text(scene, "%s to %s N", least, most);
}

const char *beam_text_title(Scene *scene, const Beam *beam, const Rig *rig, const Response *response) {
    static const char *const verdicts[] = {
        [RESPONSE_PERIODIC] = "Periodic",         [RESPONSE_QUASI_PERIODIC] = "Quasi-periodic",
        [RESPONSE_CHAOTIC] = "Chaotic",           [RESPONSE_TRANSIENT] = "Transient",
        [RESPONSE_UNDETERMINED] = "Undetermined", [RESPONSE_CHATTERS] = "Chatter",
        [RESPONSE_DIVERGED] = "Diverged",         [RESPONSE_STIFF] = "Too stiff",
        [RESPONSE_INTERRUPTED] = "Interrupted"};
    const char *verdict = verdicts[response->verdict];
    if (response->verdict == RESPONSE_PERIODIC && response->orbit.period > 1)
        verdict = scene_text(scene, "Period %zu", response->orbit.period);
    if (!response->section.count)
        return scene_text(scene, "%s at %g Hz", verdict, beam->frequency);
    if (!response->peaks.count)
        return scene_text(scene, "No contact: tip \u00b1%s at %g Hz",
                          beam_text_quantity(scene, rig_free_amplitude(rig), "m"), beam->frequency);
    return scene_text(scene, "%s: %s at %g Hz", verdict, peaks_of(scene, &response->peaks), beam->frequency);
}

const char *beam_text_detail(Scene *scene, const Response *response) {
    if (response->verdict == RESPONSE_PERIODIC)
        return scene_text(scene,
                          response->orbit.period == 1 ? "all cycles are equal, multiplier %.3f"
                                                      : "the motion repeats, multiplier %.3f",
                          response->orbit.largest);
    if (isfinite(response->exponent.value))
        return scene_text(scene, "exponent %+.2g \u00b1 %.1g per cycle", response->exponent.value,
                          response->exponent.error);
    return scene_text(scene, "after %zu cycles", response->cycles);
}

const char *beam_text_provenance(Scene *scene, const Beam *beam, const char *name) {
    const ParameterTable *table = beam_table();
    const Parameter *row = parameters_find(table, name);
    const char *whole = row ? beam->provenance[row - table->rows] : NULL;
    if (!whole)
        return "";
    const char *label = scene_text(scene, "%.*s", (int)strcspn(whole, ":"), whole);
    return strstr(whole, "not published") ? scene_text(scene, "%s, not published", label) : label;
}
