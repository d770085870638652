#include "result/crank.h"

#include <math.h>

#include "base/text.h"
#include "result/verdict.h"

/* A multiple of the speed within this part of a natural frequency is told. */
static const double NEAR_MULTIPLE = 0.01;

static void add_number(ResultTable *table, const char *key, const char *label, double number, const char *unit,
                       int significant, bool unknown) {
    result_add(table, (ResultRow){.key = key,
                                  .label = label,
                                  .kind = RESULT_NUMBER,
                                  .number = number,
                                  .unit = unit,
                                  .significant = significant,
                                  .unknown = unknown});
}

ResultTable result_crank_motion(const Crank *crank, const Response *response) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    result_add(&table, (ResultRow){.key = "frequency",
                                   .label = "speed of the crank",
                                   .kind = RESULT_NUMBER,
                                   .number = crank->frequency,
                                   .text = text_in_arena(&table.arena, "%.5g rpm = %.4g", 60 * crank->frequency,
                                                         crank->frequency),
                                   .unit = "Hz"});
    result_add(&table, (ResultRow){.key = "clearance",
                                   .label = "clearance, radial",
                                   .kind = RESULT_NUMBER,
                                   .number = crank->clearance,
                                   .factor = 1000,
                                   .unit = "mm",
                                   .significant = 4});
    result_verdict_add(&table, response, "revolution");
    result_end(&table);
    return table;
}

ResultTable result_crank_forces(const Tree *tree, const Response *response, double ideal) {
    ResultTable table = {.numbers = RESULT_SHORTEST};
    bool touches = response->peaks.count > 0;
    result_verdict_add_peaks(&table, response);
    add_number(&table, "ideal_force", "largest force without clearance", ideal, "N", 4, !isfinite(ideal));
    result_add(&table, (ResultRow){.key = "switches",
                                   .label = "switches per revolution",
                                   .kind = RESULT_NUMBER,
                                   .number = response->switches,
                                   .decimals = 2,
                                   .unknown = !touches});
    result_add(&table, (ResultRow){.key = "touches",
                                   .label = "contacts that begin, per revolution",
                                   .kind = RESULT_NUMBER,
                                   .number = response->touches,
                                   .decimals = 2,
                                   .unknown = !touches});
    result_add(&table, (ResultRow){.key = "contact_share",
                                   .label = "time in contact",
                                   .kind = RESULT_NUMBER,
                                   .number = response->contact_share,
                                   .unit = "%",
                                   .factor = 100,
                                   .decimals = 1,
                                   .unknown = !touches});
    double bending = tree->bending ? tree_bending_frequency(tree, 0) : NAN;
    add_number(&table, "bending_frequency", "first bending of the coupler", bending, "Hz", 4, !tree->bending);
    double *supports = arena_allocate(&table.arena, 3 * sizeof *supports);
    for (size_t i = 0; i < 3; i++)
        supports[i] = tree_support_frequency(tree, i);
    result_add(&table, (ResultRow){.key = "support_frequencies",
                                   .label = "supports, x, y and z",
                                   .kind = RESULT_LIST,
                                   .list = supports,
                                   .count = 3,
                                   .unit = "Hz",
                                   .decimals = 1});
    result_end(&table);
    return table;
}

/* Words ------------------------------------------------------------------------------------------------------------ */

void result_crank_name(Text *text, const Crank *crank, const Response *response, double ideal) {
    const SectionPeaks *peaks = &response->peaks;
    result_verdict_name(text, response, "revolution");
    text_format(text, ": at %.5g rpm ", 60 * crank->frequency);
    if (!response->section.count)
        text_format(text, "with a clearance of %.4g mm", 1000 * crank->clearance);
    else if (!peaks->count)
        text_add(text, "the ball does not touch its socket");
    else if (peaks->max - peaks->min < 0.005)
        text_format(text, "the largest force in the joint is %.2f N", peaks->max);
    else
        text_format(text, "the largest force in the joint is %.0f to %.0f N a revolution, %.0f N in the mean of %zu",
                    peaks->min, peaks->max, peaks->mean, response->section.count);
    if (peaks->count && ideal > 0 && crank->clearance > 0)
        text_format(text, ", %.2g times the %.4g N of a joint without clearance", peaks->max / ideal, ideal);
    text_add(text, "\n");
}

static void say_contact(Text *text, const Crank *crank, const Response *response) {
    if (crank->clearance <= 0 || !response->section.count)
        return;
    if (response->touches > 0)
        text_format(text, "The pin leaves its socket %.3g times a revolution, %.2g %% of the time\n", response->touches,
                    100 * (1 - response->contact_share));
    else if (response->switches > 0)
        text_add(text, "The pin presses on its socket with interruptions, but does not leave it\n");
    else
        text_add(text, "The pin never leaves its socket\n");
    if (crank->contact.friction <= 0)
        text_add(text, "This joint has no friction (joint.friction 0); friction calms such a mechanism\n");
}

/* Returns "1st", "2nd", "13th". */
static const char *ending_of(int number) {
    static const char *const endings[] = {"th", "st", "nd", "rd"};
    return number % 10 > 3 || number / 10 % 10 == 1 ? endings[0] : endings[number % 10];
}

/* Tells which multiple of the speed meets a natural frequency: a likely cause of forces that change steeply. */
static void say_meeting(Text *text, const Crank *crank, double frequency, const char *what) {
    double speed = crank->frequency, multiple = round(frequency / speed);
    if (multiple >= 1 && fabs(multiple * speed - frequency) < NEAR_MULTIPLE * frequency)
        text_format(text,
                    "The %.0f%s multiple of the speed, %.4g Hz, meets %s, %.4g Hz: a likely cause of forces that "
                    "change steeply with the speed (not shown to be it)\n",
                    multiple, ending_of((int)multiple), multiple * speed, what, frequency);
}

void result_crank_say(Text *text, const Crank *crank, const Tree *tree, const Response *response) {
    if (response->verdict == RESPONSE_PERIODIC && !response->settled)
        text_add(text, "The recorded revolutions still hold the transient: use more run.transient_cycles to leave it "
                       "out\n");
    if (response->verdict == RESPONSE_DIVERGED)
        text_add(text,
                 "The coupler bends further than its equations describe, or numbers grow without bound or change too "
                 "fast to be followed: a lower speed, a smaller clearance or a thicker coupler may help\n");
    if (response->verdict == RESPONSE_DIVERGED && tree->turns)
        text_add(text, "The motor may have stalled\n");
    if (response->verdict == RESPONSE_STIFF)
        text_add(text,
                 "Its revolutions would take too many steps: the joint or the coupler is too stiff or too damped for "
                 "this speed, friction sets in too sharply, or the numbers are too large; a softer or less "
                 "damped joint, a larger joint.slip_speed, a higher speed or fewer run.transient_cycles may "
                 "help\n");
    say_contact(text, crank, response);
    if (tree->bending)
        say_meeting(text, crank, tree_bending_frequency(tree, 0), "the coupler's first bending");
    say_meeting(text, crank, tree_support_frequency(tree, 0), "the support's frequency along the guide");
    say_meeting(text, crank, tree_support_frequency(tree, 1), "the support's frequency across the guide");
    if (fabs(tree_support_frequency(tree, 2) - tree_support_frequency(tree, 1)) > 0)
        say_meeting(text, crank, tree_support_frequency(tree, 2), "the support's upright frequency");
}
