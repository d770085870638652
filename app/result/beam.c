#include "result/beam.h"

#include "base/text.h"
#include "result/verdict.h"

/* A length on either side of the middle, which people read in millimetres. */
static const char *either_side(Arena *arena, double length) {
    return text_in_arena(arena, "\u00b1%.4g", 1000 * length);
}

ResultTable result_beam_motion(const Beam *beam, const Response *response) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    result_add(&table, (ResultRow){.key = "frequency",
                                   .label = "drive frequency",
                                   .kind = RESULT_NUMBER,
                                   .number = beam->frequency,
                                   .unit = "Hz",
                                   .significant = 4});
    result_add(&table, (ResultRow){.key = "clearance",
                                   .label = "clearance",
                                   .kind = RESULT_NUMBER,
                                   .number = beam->clearance,
                                   .text = either_side(&table.arena, beam->clearance),
                                   .unit = "mm"});
    result_verdict_add(&table, response, "cycle");
    result_add(&table, (ResultRow){.key = "mirror_image",
                                   .label = "mirror image",
                                   .text = response->image == ORBIT_IMAGE_OWN     ? "its own"
                                           : response->image == ORBIT_IMAGE_OTHER ? "another orbit"
                                                                                  : NULL});
    result_end(&table);
    return table;
}

static const double *natural_frequencies(Arena *arena, const Rig *rig) {
    double *list = arena_allocate(arena, rig->modes.count * sizeof *list);
    for (size_t i = 0; i < rig->modes.count; i++)
        list[i] = rig->modes.frequency[i] / (2 * M_PI);
    return list;
}

ResultTable result_beam_forces(const Rig *rig, const Response *response) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    bool touches = response->peaks.count > 0;
    double free_amplitude = rig_free_amplitude(rig), lacking = fmax(0, rig->modes.residual * rig->stiffness);
    result_verdict_add_peaks(&table, response);
    result_add(&table, (ResultRow){.key = "switches",
                                   .label = "switches per cycle",
                                   .kind = RESULT_NUMBER,
                                   .number = response->switches,
                                   .decimals = 2,
                                   .unknown = !touches});
    result_add(&table, (ResultRow){.key = "contact_share",
                                   .label = "time in contact",
                                   .kind = RESULT_NUMBER,
                                   .number = response->contact_share,
                                   .unit = "%",
                                   .factor = 100,
                                   .unknown = !touches});
    result_add(&table, (ResultRow){.key = "grazes",
                                   .label = "grazing contacts",
                                   .kind = RESULT_COUNT,
                                   .number = response->section.count ? (double)response->grazes : (double)NAN});
    result_add(&table, (ResultRow){.key = "free_amplitude",
                                   .label = "tip without the joint",
                                   .kind = RESULT_NUMBER,
                                   .number = free_amplitude,
                                   .text = either_side(&table.arena, free_amplitude),
                                   .unit = "mm"});
    result_add(&table, (ResultRow){.key = "natural_frequencies",
                                   .label = "natural frequencies",
                                   .kind = RESULT_LIST,
                                   .list = natural_frequencies(&table.arena, rig),
                                   .count = rig->modes.count,
                                   .unit = "Hz",
                                   .decimals = 1});
    result_add(&table, (ResultRow){.key = "residual_compliance",
                                   .label = "compliance left out",
                                   .kind = RESULT_NUMBER,
                                   .number = rig->modes.residual,
                                   .text = text_in_arena(&table.arena, "%.2g", 100 * lacking),
                                   .unit = "% of the contact's"});
    result_end(&table);
    return table;
}
