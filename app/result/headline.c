#include "result/headline.h"

#include <math.h>
#include <stdlib.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "result/danger.h"

static const double CLOSE = 0.1; /* m: smaller clearances are printed to the millimetre */

const char *headline_duration(double seconds, Arena *arena) {
    long whole = lround(seconds);
    return seconds < HEADLINE_LONG ? text_in_arena(arena, "%.1f s", seconds)
                                   : text_in_arena(arena, "%ld:%02ld", whole / 60, whole % 60);
}

/* Returns a time with the digits that are shown. */
static double shown(double seconds) {
    char digits[64];
    snprintf(digits, sizeof digits, "%.1f", seconds);
    return seconds < HEADLINE_LONG ? strtod(digits, NULL) : (double)lround(seconds);
}

const char *headline_count(size_t count, size_t most, Arena *arena) {
    static const char blanks[] = "\u2007\u2007\u2007\u2007\u2007\u2007\u2007\u2007\u2007\u2007";
    size_t missing = 0, blank = strlen("\u2007");
    for (size_t rest = count / 10, least = most / 10; least > 0; least /= 10, rest /= 10)
        missing += rest == 0;
    missing = missing * blank < strlen(blanks) ? missing : strlen(blanks) / blank;
    return text_in_arena(arena, "%.*s%zu", (int)(missing * blank), blanks, count);
}

double headline_difference(double before, double now) {
    return shown(now) - shown(before);
}

const char *headline_clearance(double clearance, Arena *arena) {
    if (clearance <= 0)
        return "touches";
    if (isinf(clearance))
        return "-"; /* no person came near to anything */
    return text_in_arena(arena, clearance < CLOSE ? "%.3f m" : "%.2f m", clearance);
}

/* All out --------------------------------------------------------------------------------------------------------- */

/* Returns "no contact", "1 contact, a knock at 0.21 m/s" or, of people on foot alone, "12 contacts, up to 340 N".
 */
static const char *contacts(const Census *census, Arena *arena) {
    if (!census->contacts)
        return "no contact";
    if (census->impact > 0)
        return text_in_arena(arena, census->contacts == 1 ? "%d contact, %s" : "%d contacts, at most %s",
                             census->contacts, result_danger_words(census->impact, arena));
    return text_in_arena(arena, census->contacts == 1 ? "%d contact, up to %.0f N" : "%d contacts, up to %.0f N",
                         census->contacts, census->peak_force);
}

/* m, assumed: so long a way backwards is told, and a shorter one where it crosses the exit. */
static const double BACKED = 1;

const char *headline_backwards(const House *house, const Observation *observation, Arena *arena) {
    const PersonObservation *farthest = NULL;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        bool backs = person->took_part && (person->back_length >= BACKED || person->back_out);
        if (backs && (!farthest || person->back_length > farthest->back_length))
            farthest = person;
    }
    if (!farthest)
        return "";
    const char *who = house->people[farthest - observation->people].id;
    return text_in_arena(arena, ", %s%sbacks %.1f m%s", observation->person_count > 1 ? who : "",
                         observation->person_count > 1 ? " " : "", farthest->back_length,
                         farthest->back_out ? ", over the exit" : "");
}

/* Returns "narrowest 0.06 m at door d2, 3 contacts, at most a knock at 0.21 m/s". */
static const char *findings(const House *house, const Observation *observation, const Census *census, Arena *arena) {
    size_t narrowest = census_narrowest(house, observation);
    const char *touched =
        text_in_arena(arena, "%s%s", contacts(census, arena), headline_backwards(house, observation, arena));
    if (narrowest == SIZE_MAX)
        return text_in_arena(arena, "nothing entered a personal space, %s", touched);
    const PersonObservation *person = &observation->people[narrowest];
    const char *clearance = headline_clearance(person->narrowest, arena);
    char place[96];
    if (person->narrowest_other >= 0)
        snprintf(place, sizeof place, "person %s", house->people[person->narrowest_other].id);
    else
        outline_place_name(&house->outline, &house->plan, person->narrowest_to, place, sizeof place);
    return text_in_arena(arena, person->narrowest <= 0 ? "%s %s, %s" : "narrowest %s at %s, %s", clearance, place,
                         touched);
}

/* Returns "mean 96.1 s on foot, 162.0 s in chairs, 12 contacts, at most a knock at 0.21 m/s". */
static const char *mean_times(const Census *census, Arena *arena) {
    double sums[2] = {0};
    size_t counts[2] = {0};
    for (size_t p = 0; p < census->party_count; p++) {
        const Party *party = &census->parties[p];
        bool walks = census_walks(party->profile);
        sums[walks] += party->out ? party->mean * (double)party->out : 0;
        counts[walks] += party->out;
    }
    double chairs = sums[0] / (double)counts[0], walkers = sums[1] / (double)counts[1];
    const char *touched = contacts(census, arena);
    if (counts[0] && counts[1])
        return text_in_arena(arena, "mean %.1f s on foot, %.1f s in chairs, %s", walkers, chairs, touched);
    return text_in_arena(arena, "mean %.1f s, %s", counts[0] ? chairs : walkers, touched);
}

/* Routes that are driven alone have no time in common. */
static Headline all_out(const House *house, const Observation *observation, const Census *census, Arena *arena) {
    bool alone = house->plan.run.routes == ROUTES_ALONE && house->plan.route_count > 1;
    size_t people = census->people;
    double time = observation->time;
    const char *detail = people > CENSUS_FEW ? mean_times(census, arena) : findings(house, observation, census, arena);
    Headline headline = {.role = ROLE_TEXT, .detail = detail};
    if (people == 1) {
        headline.title = text_in_arena(arena, "Out in %s", headline_duration(time, arena));
        headline.sentence = text_in_arena(arena, "Out in %.1f s", time);
    } else {
        headline.title = text_in_arena(arena, "All %zu out in %s", people, headline_duration(time, arena));
        headline.sentence = text_in_arena(arena, "All %zu out in %.1f s", people, time);
    }
    if (people > 1 && alone) {
        headline.sentence = text_in_arena(arena, "All %zu out, each route alone, in at most %.1f s", people, time);
        headline.detail = text_in_arena(arena, "each route alone, %s", detail);
    }
    if (census->impact >= DANGER_KNOCK)
        headline.sentence =
            text_in_arena(arena, "%s, with %s", headline.sentence, result_danger_words(census->impact, arena));
    if (people <= CENSUS_FEW)
        headline.sentence =
            text_in_arena(arena, "%s%s", headline.sentence, headline_backwards(house, observation, arena));
    return headline;
}

/* Not all out ----------------------------------------------------------------------------------------------------- */

/* Returns the exit that a person was bound for, if it has closed, or else the last one to close up to the time; NULL:
 * none did. */
static const Exit *closed_exit(const Plan *plan, size_t bound_for, double time) {
    const Exit *last = NULL;
    if (bound_for < plan->exit_count && plan->exits[bound_for].closes <= time)
        return &plan->exits[bound_for];
    for (size_t e = 0; e < plan->exit_count; e++)
        if (plan->exits[e].closes <= time && (!last || plan->exits[e].closes > last->closes))
            last = &plan->exits[e];
    return last;
}

static const char *why_no_exit(const House *house, const PersonObservation *person, const char *id, Arena *arena) {
    const Exit *closed = closed_exit(&house->plan, person->exit, person->time);
    if (!closed)
        return text_in_arena(arena, "%s has no exit to go to", id);
    const char *exit = house->plan.exit_count > 1 ? text_in_arena(arena, "exit %s", closed->id) : "the exit";
    return text_in_arena(arena, "%s is not out: %s closed at %.1f s", id, exit, closed->closes);
}

/* Returns "p1 is blocked at door d2 after 18.4 s". */
static const char *why(const House *house, const PersonObservation *person, size_t i, Arena *arena) {
    const char *id = house->people[i].id, *what = person->blockage.what;
    if (house->people[i].under)
        return text_in_arena(arena, "%s is caught %s", id, what);
    switch (person->reason) {
    case REASON_CANNOT_PASS:
        if (census_start(&person->blockage))
            return text_in_arena(arena, "%s starts %s", id, census_start(&person->blockage));
        return text_in_arena(arena, "%s cannot pass %s", id, *what ? what : "here");
    case REASON_TOO_WEAK:
        return text_in_arena(arena, "%s is too weak: %s", id, what);
    case REASON_BLOCKED:
        return *what ? text_in_arena(arena, "%s is blocked at %s after %.1f s", id, what, person->time)
                     : text_in_arena(arena, "%s is blocked after %.1f s", id, person->time);
    case REASON_NO_EXIT:
        return why_no_exit(house, person, id, arena);
    case REASON_TIME_LIMIT:
    case REASON_NONE:
        break;
    case REASON_INTERRUPTED:
        return text_in_arena(arena, "%s is not out: the run was interrupted at %.1f s", id, person->time);
    case REASON_OTHER_DIVERGED:
        return text_in_arena(arena, "%s is not out: the run ended at %.2f s because another person diverged", id,
                             person->time);
    case REASON_DIVERGED:
        return text_in_arena(arena, "%s is not out: the simulation diverged at %.2f s", id, person->time);
    }
    return text_in_arena(arena, "%s is not out after %.1f s", id, person->time);
}

/* True if walls or furniture, not other people, block a person on a path that was found: `check` finds it too. */
static bool blocked_on_a_path(Reason reason, const Blockage *blockage) {
    return reason == REASON_BLOCKED && strncmp(blockage->what, "person ", 7) != 0;
}

static Headline one_stuck(const House *house, const Observation *observation, const Census *census, Arena *arena) {
    const PersonObservation *person = &observation->people[census->stuck];
    char widths[ROUTE_WIDTHS], skids[64];
    route_widths(&person->blockage, widths, sizeof widths);
    route_skids(&person->blockage, skids, sizeof skids);
    const char *title = why(house, person, census->stuck, arena);
    size_t closed = observation_walled_exit(house, observation);
    if (closed != SIZE_MAX) {
        title = text_in_arena(arena, "No opening at exit %s: add a door", house->plan.exits[closed].id);
        return (Headline){.role = ROLE_ERROR, .title = title, .detail = "", .sentence = title};
    }
    const char *detail = text_in_arena(arena, *widths && *skids ? "%s; %s" : "%s%s", widths, skids);
    if (!*detail && blocked_on_a_path(person->reason, &person->blockage))
        detail = "check finds a path from the start, but the simulated motion does not reach the exit";
    return (Headline){.role = ROLE_ERROR,
                      .title = title,
                      .detail = detail,
                      .sentence = *detail ? text_in_arena(arena, "%s: %s", title, detail) : title};
}

/* Returns the reasons, with or without the widths, and when the other people are out. */
static const char *reasons(const House *house, const Census *census, bool with_widths, Arena *arena) {
    char text[512];
    census_reasons(house, census, with_widths, text, sizeof text);
    return !census->out ? arena_text(arena, text)
                        : text_in_arena(arena,
                                        census->out > 1 ? "%s; the others are out in %.1f s"
                                                        : "%s; the other person is out in %.1f s",
                                        text, census->last);
}

/* True if all people find their way barred: nobody leaves however long it takes. */
static bool nobody_can_leave(const Census *census) {
    for (size_t h = 0; h < census->hold_count; h++)
        if (!observation_reason_has_place(census->holds[h].reason))
            return false;
    return !census->out;
}

/* The line next to a title has no room for the widths of several places. */
static Headline several_stuck(const House *house, const Census *census, Arena *arena) {
    size_t stuck = census->people - census->out;
    Headline headline = {.role = ROLE_ERROR};
    headline.title = nobody_can_leave(census)
                         ? "Nobody gets out"
                         : text_in_arena(arena, stuck == 1 ? "%zu of %zu is not out" : "%zu of %zu are not out", stuck,
                                         census->people);
    headline.detail = reasons(house, census, census->hold_count == 1, arena);
    headline.sentence = text_in_arena(arena, "%s: %s", headline.title, reasons(house, census, true, arena));
    for (size_t h = 0; h < census->hold_count; h++)
        if (blocked_on_a_path(census->holds[h].reason, &census->holds[h].blockage)) {
            headline.sentence =
                text_in_arena(arena, "%s; check finds a path for each blocked person", headline.sentence);
            break;
        }
    return headline;
}

/* Returns the headline of an interrupted run: who would have left is unknown. */
static Headline interrupted(const Observation *observation, const Census *census, Arena *arena) {
    Headline headline = {.role = ROLE_ERROR, .detail = ""};
    headline.title = headline.sentence =
        text_in_arena(arena, "Interrupted at %.1f s: of %zu people, %zu are out so far", observation->time,
                      census->people, census->out);
    return headline;
}

Headline headline_make(const House *house, const Observation *observation, const Census *census, Arena *arena) {
    const char *empty = house->person_count ? "No person takes part" : "The house has no people";
    if (!census->people)
        return (Headline){.title = empty, .detail = "", .sentence = empty, .role = ROLE_TEXT};
    return census->stuck == SIZE_MAX  ? all_out(house, observation, census, arena)
           : census->people == 1      ? one_stuck(house, observation, census, arena)
           : observation->interrupted ? interrupted(observation, census, arena)
                                      : several_stuck(house, census, arena);
}

const char *headline_sentence(const House *house, const Observation *observation, Arena *arena) {
    Census census = census_make(house, observation);
    Headline headline = headline_make(house, observation, &census, arena);
    census_clear(&census);
    return headline.sentence;
}
