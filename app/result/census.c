#include "result/census.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

#define TOGETHER 1.5 /* m: people stopped within this distance of each other count as stopped by the same cause */
#define ALIKE 0.005  /* m: widths that differ by less are printed alike */

enum { REASONS_SHOWN = 3 };

bool census_walks(const Profile *profile) {
    return profile->driving == DRIVING_WALKER;
}

const char *census_party_name(const House *house, const Party *party) {
    return party->crowd ? party->crowd->id : party->people == 1 ? house->people[party->first].id : "single people";
}

/* True if the name is "<crowd>-<number>" with the number of a member; only members have such names. */
static bool is_member(const Crowd *crowd, const char *id) {
    size_t length = strlen(crowd->id);
    if (strncmp(id, crowd->id, length) != 0 || id[length] != '-')
        return false;
    const char *digits = id + length + 1;
    if (*digits < '1' || *digits > '9' || digits[strspn(digits, "0123456789")] != 0 || strlen(digits) > 9)
        return false;
    return atoi(digits) <= crowd->count;
}

/* Finds a person's crowd. People are sorted by name, so the crowd of the person before is the best guess. */
static const Crowd *crowd_of(const Plan *plan, const char *id, const Crowd *guess) {
    if (guess && is_member(guess, id))
        return guess;
    for (size_t c = 0; c < plan->crowd_count; c++)
        if (is_member(&plan->crowds[c], id))
            return &plan->crowds[c];
    return NULL;
}

static size_t find_party(Census *census, const Crowd *crowd, size_t i, const Inhabitant *person) {
    for (size_t p = census->party_count; p-- > 0;) {
        const Party *party = &census->parties[p];
        if (party->crowd == crowd && party->profile == person->profile && party->route == person->route)
            return p;
    }
    census->parties =
        memory_reserve(census->parties, &census->party_capacity, census->party_count + 1, sizeof *census->parties);
    census->parties[census->party_count] =
        (Party){.crowd = crowd, .profile = person->profile, .route = person->route, .first = i};
    return census->party_count++;
}

static void count_person(Census *census, size_t party_index, const PersonObservation *person, bool out) {
    Party *party = &census->parties[party_index];
    party->people++;
    party->out += out;
    party->lost += person->lost_time;
    party->contacts += person->contacts;
    party->peak_force = fmax(party->peak_force, person->peak_force);
    census->people++;
    census->out += out;
    census->contacts += person->contacts;
    census->peak_force = fmax(census->peak_force, person->peak_force);
    census->impact = fmax(census->impact, person->impact);
    if (!out)
        return;
    party->mean += person->time;
    party->last = fmax(party->last, person->time);
    census->last = fmax(census->last, person->time);
}

static void finish_means(Party *party) {
    party->lost /= (double)party->people;
    party->mean = party->out ? party->mean / (double)party->out : NAN;
    party->last = party->out ? party->last : NAN;
}

static int severity(const char *what) {
    return strncmp(what, "door ", 5) == 0 ? 2 : strncmp(what, "person ", 7) != 0;
}

/* True if two holds are the same: narrow places are compared by widths, jams by place. */
static bool holds_agree(const Hold *a, const Hold *b) {
    if (a->reason != b->reason)
        return false;
    if (!observation_reason_has_place(a->reason))
        return true;
    if (observation_reason_is_planned(a->reason) &&
        (strcmp(a->blockage.what, b->blockage.what) != 0 || fabs(a->blockage.needs - b->blockage.needs) > ALIKE))
        return false;
    return a->box.low.x < b->box.high.x + TOGETHER && b->box.low.x < a->box.high.x + TOGETHER &&
           a->box.low.y < b->box.high.y + TOGETHER && b->box.low.y < a->box.high.y + TOGETHER;
}

static void join_holds(Hold *into, const Hold *other) {
    into->people += other->people;
    into->first = other->first < into->first ? other->first : into->first;
    into->box = box_include(box_include(into->box, other->box.low), other->box.high);
    if (severity(other->blockage.what) > severity(into->blockage.what))
        into->blockage = other->blockage;
}

static size_t find_hold(const Census *census, const Hold *hold) {
    size_t h = 0;
    while (h < census->hold_count && !holds_agree(hold, &census->holds[h]))
        h++;
    return h;
}

/* Joins holds: one that has grown may agree with others in turn. */
static void add_hold(Census *census, Hold hold) {
    for (size_t h; (h = find_hold(census, &hold)) < census->hold_count;) {
        Hold joined = census->holds[h];
        join_holds(&joined, &hold);
        hold = joined;
        census->holds[h] = census->holds[--census->hold_count];
    }
    census->holds = memory_reserve(census->holds, &census->hold_capacity, census->hold_count + 1, sizeof hold);
    census->holds[census->hold_count++] = hold;
}

static void hold_person(Census *census, size_t i, const PersonObservation *person) {
    Hold hold = {.reason = person->reason, .first = i, .people = 1};
    if (observation_reason_has_place(person->reason)) {
        hold.box = (Box){person->blockage.at, person->blockage.at};
        hold.blockage = person->blockage;
    }
    add_hold(census, hold);
}

static int compare_holds(const void *a, const void *b) {
    const Hold *p = a, *q = b;
    return p->people != q->people ? (p->people < q->people) - (p->people > q->people)
                                  : (p->first > q->first) - (p->first < q->first);
}

Census census_make(const House *house, const Observation *observation) {
    return census_until(house, observation, HUGE_VAL);
}

Census census_until(const House *house, const Observation *observation, double time) {
    Census census = {.interrupted = observation->interrupted || isfinite(time),
                     .stuck = SIZE_MAX,
                     .left = memory_zeroed(house->plan.exit_count, sizeof *census.left),
                     .party_of = memory_zeroed(house->person_count, sizeof *census.party_of)};
    const Crowd *crowd = NULL;
    for (size_t i = 0; i < house->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part)
            continue;
        crowd = crowd_of(&house->plan, house->people[i].id, crowd);
        census.party_of[i] = find_party(&census, crowd, i, &house->people[i]);
        bool out = person->completed && person->time <= time;
        count_person(&census, census.party_of[i], person, out);
        if (out && person->exit < house->plan.exit_count)
            census.left[person->exit]++;
        if (out)
            continue;
        hold_person(&census, i, person);
        census.stuck = census.stuck == SIZE_MAX ? i : census.stuck;
    }
    for (size_t p = 0; p < census.party_count; p++)
        finish_means(&census.parties[p]);
    if (census.hold_count)
        qsort(census.holds, census.hold_count, sizeof *census.holds, compare_holds);
    return census;
}

void census_clear(Census *census) {
    memory_free(census->parties);
    memory_free(census->holds);
    memory_free(census->left);
    memory_free(census->party_of);
    *census = (Census){0};
}

const char *census_start(const Blockage *blockage) {
    static const char start[] = "start, ";
    return strncmp(blockage->what, start, sizeof start - 1) == 0 ? blockage->what + sizeof start - 1 : NULL;
}

/* Returns the format of a reason without a place, of one person or of several. */
static const char *other_reason(Reason reason) {
    return reason == REASON_NO_EXIT          ? "%s without an exit"
           : reason == REASON_DIVERGED       ? "%s diverged"
           : reason == REASON_INTERRUPTED    ? "%s interrupted"
           : reason == REASON_OTHER_DIVERGED ? "%s stopped because another person diverged"
                                             : "%s stopped by the time limit";
}

/* Prints "29 blocked at door d2", "p1 cannot pass door d2 (needs at least 0.80 m, has 0.75 m)". */
static void format_hold(const House *house, const Hold *hold, bool with_widths, char *text, size_t size) {
    const char *what = hold->blockage.what;
    char widths[ROUTE_WIDTHS] = "", who[64];
    if (with_widths)
        route_widths(&hold->blockage, widths, sizeof widths);
    snprintf(who, sizeof who, "%zu", hold->people);
    if (hold->people == 1)
        snprintf(who, sizeof who, "%s", house->people[hold->first].id);
    if (house->people[hold->first].under)
        snprintf(text, size, "%s caught %s", who, what);
    else if (hold->reason == REASON_CANNOT_PASS && census_start(&hold->blockage))
        snprintf(text, size, hold->people > 1 ? "%s start %s" : "%s starts %s", who, census_start(&hold->blockage));
    else if (hold->reason == REASON_CANNOT_PASS)
        snprintf(text, size, *widths ? "%s cannot pass %s (%s)" : "%s cannot pass %s", who, *what ? what : "here",
                 widths);
    else if (hold->reason == REASON_TOO_WEAK)
        snprintf(text, size, *widths ? "%s too weak, %s (%s)" : "%s too weak, %s", who, what, widths);
    else if (hold->reason == REASON_BLOCKED && severity(what))
        snprintf(text, size, "%s blocked at %s", who, what);
    else if (hold->reason == REASON_BLOCKED)
        snprintf(text, size, "%s blocked by %s", who, hold->people > 1 ? "other people" : what);
    else
        snprintf(text, size, other_reason(hold->reason), who);
}

/* True if two holds read alike once their widths are left out. */
static bool read_alike(const House *house, const Hold *a, const Hold *b) {
    return a->reason == REASON_CANNOT_PASS && b->reason == REASON_CANNOT_PASS && !house->people[a->first].under &&
           !house->people[b->first].under && strcmp(a->blockage.what, b->blockage.what) == 0;
}

/* Returns whether an earlier hold already tells of this one, and adds to it the people of the later ones that it tells
 * of, too. */
static bool is_told(const House *house, const Census *census, size_t h, Hold *hold) {
    *hold = census->holds[h];
    for (size_t other = 0; other < census->hold_count; other++) {
        if (other == h || !read_alike(house, hold, &census->holds[other]))
            continue;
        if (other < h)
            return true;
        hold->people += census->holds[other].people;
    }
    return false;
}

void census_reasons(const House *house, const Census *census, bool with_widths, char *text, size_t size) {
    size_t used = 0, listed = 0, lines = 0;
    *text = 0;
    for (size_t h = 0; h < census->hold_count && lines < REASONS_SHOWN && used < size; h++) {
        char line[256];
        Hold hold = census->holds[h];
        if (!with_widths && is_told(house, census, h, &hold))
            continue;
        format_hold(house, &hold, with_widths, line, sizeof line);
        used += (size_t)snprintf(text + used, size - used, "%s%s", lines ? ", " : "", line);
        lines++;
        listed += hold.people;
    }
    size_t rest = census->people - census->out - listed;
    if (rest && used < size)
        snprintf(text + used, size - used, ", %zu elsewhere", rest);
}

const Party *census_find_party(const House *house, const Census *census, const char *name, const char *profile) {
    for (size_t p = 0; p < census->party_count; p++)
        if (strcmp(census_party_name(house, &census->parties[p]), name) == 0 &&
            strcmp(census->parties[p].profile->name, profile) == 0)
            return &census->parties[p];
    return NULL;
}

size_t census_narrowest(const House *house, const Observation *observation) {
    size_t narrowest = SIZE_MAX;
    double least = HUGE_VAL;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        bool known = person->took_part && person->time > 0;
        if (known && person->narrowest < fmin(least, house->people[i].profile->space_reach)) {
            least = person->narrowest;
            narrowest = i;
        }
    }
    return narrowest;
}

size_t census_last(const Observation *observation) {
    size_t last = SIZE_MAX;
    for (size_t i = 0; i < observation->person_count; i++)
        if (observation->people[i].completed &&
            (last == SIZE_MAX || observation->people[i].time > observation->people[last].time))
            last = i;
    return last;
}

double census_route_time(const House *house, const Observation *observation, const PlanRoute *route) {
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < house->person_count; i++) {
        if (house->people[i].route != route)
            continue;
        if (!observation->people[i].completed)
            return -1;
        sum += observation->people[i].time;
        count++;
    }
    return count ? sum / (double)count : -1;
}
