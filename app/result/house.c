#include "result/house.h"

#include "base/text.h"
#include "experiment/danger.h"
#include "house/touch.h"
#include "plan/observed_times.h"
#include "result/census.h"
#include "result/tight.h"

static const char *exit_id(const House *house, size_t exit) {
    return exit < house->plan.exit_count ? house->plan.exits[exit].id : NULL;
}

/* People --------------------------------------------------------------------------------------------------------------
 */

/* JSON gives places and widths to the micrometre, whatever the numbers of the table. */
static double in_micrometres(double length) {
    return round(length * 1e6) / 1e6;
}

void result_house_add_blockage(ResultTable *table, const Blockage *blockage) {
    static const Blockage nowhere = {.what = ""};
    bool omitted = !blockage;
    blockage = blockage ? blockage : &nowhere;
    bool known = !omitted && (blockage->has > 0 || blockage->needs > 0), weak = blockage->lacks != LACK_WIDTH;
    const char *unit = route_lack_unit(blockage->lacks);
    result_add(table, (ResultRow){.key = "blocked_at.x",
                                  .kind = RESULT_NUMBER,
                                  .number = in_micrometres(blockage->at.x),
                                  .omitted = omitted});
    result_add(table, (ResultRow){.key = "blocked_at.y",
                                  .kind = RESULT_NUMBER,
                                  .number = in_micrometres(blockage->at.y),
                                  .omitted = omitted});
    result_add(table, (ResultRow){
                          .key = "blocked_at.what", .label = "stopped at", .text = blockage->what, .omitted = omitted});
    result_add(
        table,
        (ResultRow){.key = "blocked_at.beside", .text = blockage->beside, .omitted = omitted || !*blockage->beside});
    result_add(table, (ResultRow){.key = "blocked_at.has",
                                  .label = "width there",
                                  .head = "has",
                                  .kind = RESULT_NUMBER,
                                  .number = in_micrometres(blockage->has),
                                  .unit = "m",
                                  .decimals = 3,
                                  .unknown = weak,
                                  .omitted = !known});
    result_add(table, (ResultRow){.key = "blocked_at.needs",
                                  .label = "width needed",
                                  .head = "needs",
                                  .kind = RESULT_NUMBER,
                                  .number = in_micrometres(blockage->needs),
                                  .unit = "m",
                                  .decimals = 3,
                                  .unknown = weak,
                                  .omitted = !known});
    result_add(table, (ResultRow){.key = "blocked_at.unit", .text = unit, .omitted = !weak});
    result_add(table, (ResultRow){.label = "strength there",
                                  .head = "strength",
                                  .text = text_in_arena(&table->arena, "%.2g %s", blockage->has, unit),
                                  .omitted = !weak});
    result_add(table, (ResultRow){.label = "strength needed",
                                  .head = "needed",
                                  .text = text_in_arena(&table->arena, "%.2g %s", blockage->needs, unit),
                                  .omitted = !weak});
    result_add(table, (ResultRow){.key = "blocked_at.skid",
                                  .label = "skids with which the chair could pass",
                                  .head = "skids",
                                  .kind = RESULT_NUMBER,
                                  .number = in_micrometres(blockage->skid),
                                  .unit = "m",
                                  .decimals = 3,
                                  .omitted = omitted || !(blockage->skid > 0)});
    result_add(table, (ResultRow){.key = "blocked_at.estimated",
                                  .kind = RESULT_FLAG,
                                  .number = blockage->estimated,
                                  .omitted = !known || weak});
}

/* "door d1" or "person p2"; NULL: nothing came into the personal space. */
static const char *nearest_name(Arena *arena, const House *house, size_t i, const PersonObservation *person) {
    char name[96];
    if (!(person->narrowest < house->people[i].profile->space_reach) || !(person->time > 0))
        return NULL;
    if (person->narrowest_other >= 0)
        return text_in_arena(arena, "person %s", house->people[person->narrowest_other].id);
    outline_place_name(&house->outline, &house->plan, person->narrowest_to, name, sizeof name);
    return arena_text(arena, name);
}

static void add_identity(ResultTable *table, const House *house, size_t i, const PersonObservation *person) {
    const Inhabitant *inhabitant = &house->people[i];
    result_add(table, (ResultRow){.key = "id", .label = "person", .text = inhabitant->id});
    result_add(table, (ResultRow){.key = "profile", .label = "profile", .text = inhabitant->profile->name});
    result_add(table,
               (ResultRow){.key = "route", .label = "route", .text = inhabitant->route ? inhabitant->route->id : NULL});
    result_add(table, (ResultRow){.key = "exit", .label = "exit", .text = exit_id(house, person->exit)});
}

/* Returns why a person is not out, in a word or two; "" for one who still may get out. */
static const char *outcome(const Inhabitant *inhabitant, const PersonObservation *person) {
    if (person->reason == REASON_CANNOT_PASS && inhabitant->under)
        return "caught";
    if (person->reason == REASON_CANNOT_PASS && census_start(&person->blockage))
        return "no room at start";
    return observation_reason(person->reason);
}

static void add_outcome(ResultTable *table, const Inhabitant *inhabitant, const PersonObservation *person) {
    bool stopped = !person->completed && observation_reason_has_place(person->reason);
    const char *reason = outcome(inhabitant, person);
    result_add(table, (ResultRow){.key = "completed",
                                  .label = "result",
                                  .kind = RESULT_FLAG,
                                  .number = person->completed,
                                  .text = person->completed ? "out"
                                          : *reason         ? reason
                                                            : "on the way",
                                  .role = person->completed || !*reason ? ROLE_TEXT : ROLE_ERROR});
    result_add(table, (ResultRow){.key = "time",
                                  .label = "time",
                                  .kind = RESULT_NUMBER,
                                  .number = person->time,
                                  .unit = "s",
                                  .decimals = 2,
                                  .unknown = !(person->time > 0),
                                  .difference = DIFFERENCE_IF_BOTH});
    result_add(table,
               (ResultRow){.key = "reason", .text = observation_reason(person->reason), .omitted = person->completed});
    result_house_add_blockage(table, stopped ? &person->blockage : NULL);
}

/* How near the body came to anything: at most as far as the personal space reaches. */
static void add_narrowest(ResultTable *table, const House *house, size_t i, const PersonObservation *person) {
    Arena *arena = &table->arena;
    double reach = house->people[i].profile->space_reach;
    bool moved = person->time > 0, free = isfinite(person->narrowest) && person->narrowest >= reach;
    bool named = house->person_count <= CENSUS_ROWS;
    result_add(table, (ResultRow){.key = "narrowest.x", .kind = RESULT_NUMBER, .number = person->narrowest_at.x});
    result_add(table, (ResultRow){.key = "narrowest.y", .kind = RESULT_NUMBER, .number = person->narrowest_at.y});
    result_add(table, (ResultRow){.key = "narrowest.clearance",
                                  .label = "narrowest clearance",
                                  .head = "narrowest",
                                  .kind = RESULT_NUMBER,
                                  .number = person->narrowest,
                                  .text = free ? text_in_arena(arena, "over %.2f", reach) : NULL,
                                  .read = reach,
                                  .unit = "m",
                                  .decimals = 3,
                                  .gap = true,
                                  .unknown = !moved,
                                  .difference = DIFFERENCE_IF_BOTH});
    result_add(table,
               (ResultRow){.label = "narrowest at", .text = named ? nearest_name(arena, house, i, person) : NULL});
}

/* How hard a chair ran into something: speed and energy do not depend on the contact law. */
static void add_impact(ResultTable *table, const PersonObservation *person) {
    bool hit = person->impact > 0;
    result_add(table, (ResultRow){.key = "impact.speed",
                                  .label = "fastest impact",
                                  .head = "impact",
                                  .kind = RESULT_NUMBER,
                                  .number = person->impact,
                                  .unit = "m/s",
                                  .decimals = 2,
                                  .unknown = !hit,
                                  .omitted = !hit});
    result_add(table, (ResultRow){.key = "impact.word",
                                  .label = "which is a",
                                  .text = hit ? danger_word(person->impact) : NULL,
                                  .omitted = !hit});
    result_add(table, (ResultRow){.key = "impact.part", .text = touch_part(person->impact_part), .omitted = !hit});
    result_add(table, (ResultRow){.key = "impact.energy",
                                  .label = "energy of that impact",
                                  .head = "energy",
                                  .kind = RESULT_NUMBER,
                                  .number = person->impact_energy,
                                  .unit = "J",
                                  .decimals = 1,
                                  .unknown = !hit,
                                  .omitted = !hit});
    result_add(table, (ResultRow){.key = "impact.energy_of_all",
                                  .kind = RESULT_NUMBER,
                                  .number = person->energy,
                                  .unit = "J",
                                  .omitted = !hit});
    result_add(table, (ResultRow){.key = "squeeze",
                                  .label = "squeezed for half a second by",
                                  .head = "squeeze",
                                  .kind = RESULT_NUMBER,
                                  .number = person->squeeze,
                                  .unit = "N",
                                  .unknown = !(person->squeeze > 0),
                                  .omitted = !hit});
}

static void add_backing(ResultTable *table, const PersonObservation *person) {
    bool backs = person->back_times > 0;
    result_add(table, (ResultRow){.key = "backwards.distance",
                                  .label = "driven backwards",
                                  .head = "backwards",
                                  .kind = RESULT_NUMBER,
                                  .number = person->back_length,
                                  .unit = "m",
                                  .decimals = 2,
                                  .unknown = !backs,
                                  .omitted = !backs});
    result_add(
        table,
        (ResultRow){.key = "backwards.times", .kind = RESULT_COUNT, .number = person->back_times, .omitted = !backs});
    result_add(table, (ResultRow){.key = "backwards.out",
                                  .label = "exit crossed backwards",
                                  .kind = RESULT_FLAG,
                                  .number = person->back_out,
                                  .text = person->back_out ? "backwards" : "forwards",
                                  .omitted = !person->back_out});
}

void result_house_add_person(ResultTable *table, const House *house, const Observation *observation, size_t i) {
    const PersonObservation *person = &observation->people[i];
    const Profile *profile = house->people[i].profile;
    bool moved = person->time > 0, touched = person->contacts > 0;
    add_identity(table, house, i, person);
    add_outcome(table, &house->people[i], person);
    result_add(table, (ResultRow){.key = "driving", .text = profile_driving_name(profile->driving)});
    result_add(table, (ResultRow){.key = "trace_person", .kind = RESULT_COUNT, .number = (double)i});
    result_add(table, (ResultRow){.key = "reversals",
                                  .label = "changes of direction",
                                  .head = "reversals",
                                  .kind = RESULT_COUNT,
                                  .number = person->reversals,
                                  .unknown = census_walks(profile)});
    result_add(table, (ResultRow){.key = "path_length",
                                  .label = "path length",
                                  .head = "path",
                                  .kind = RESULT_NUMBER,
                                  .number = person->path_length,
                                  .unit = "m",
                                  .decimals = 2,
                                  .unknown = !moved});
    add_narrowest(table, house, i, person);
    result_add(table, (ResultRow){.key = "contacts",
                                  .label = "contacts",
                                  .kind = RESULT_COUNT,
                                  .number = person->contacts,
                                  .unknown = !moved,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "peak_force",
                                  .label = "hardest contact",
                                  .head = "hardest",
                                  .kind = RESULT_NUMBER,
                                  .number = person->peak_force,
                                  .unit = "N",
                                  .unknown = !moved,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "impulse",
                                  .label = "impulse of contacts",
                                  .head = "impulse",
                                  .kind = RESULT_NUMBER,
                                  .number = person->impulse,
                                  .unit = "N s",
                                  .decimals = 1,
                                  .unknown = !touched});
    add_impact(table, person);
    add_backing(table, person);
    result_add(table, (ResultRow){.key = "ring_time",
                                  .label = "personal space entered",
                                  .head = "space entered",
                                  .kind = RESULT_NUMBER,
                                  .number = person->ring_time,
                                  .unit = "s",
                                  .decimals = 1,
                                  .unknown = !moved});
    result_add(table, (ResultRow){.key = "lost_time",
                                  .label = "lost time",
                                  .head = "lost",
                                  .kind = RESULT_NUMBER,
                                  .number = person->lost_time,
                                  .unit = "s",
                                  .decimals = 1,
                                  .unknown = !moved,
                                  .difference = DIFFERENCE_IF_BOTH});
    result_end(table);
}

ResultTable result_house_people(const House *house, const Observation *observation) {
    ResultTable table = {0};
    for (size_t i = 0; i < house->person_count; i++)
        if (observation->people[i].took_part)
            result_house_add_person(&table, house, observation, i);
    return table;
}

/* Parties -----------------------------------------------------------------------------------------------------------
 */

static void add_party(ResultTable *table, const House *house, const Party *party) {
    result_add(table, (ResultRow){.key = "id", .label = "people", .text = census_party_name(house, party)});
    result_add(table, (ResultRow){.key = "profile", .label = "profile", .text = party->profile->name});
    result_add(table, (ResultRow){.key = "route", .label = "route", .text = party->route ? party->route->id : NULL});
    result_add(table, (ResultRow){.key = "people",
                                  .label = "number",
                                  .kind = RESULT_COUNT,
                                  .number = (double)party->people,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "out",
                                  .label = "out",
                                  .kind = RESULT_COUNT,
                                  .number = (double)party->out,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "mean_time",
                                  .label = "mean time",
                                  .head = "mean",
                                  .kind = RESULT_NUMBER,
                                  .number = party->mean,
                                  .unit = "s",
                                  .decimals = 2,
                                  .difference = DIFFERENCE_IF_BOTH});
    result_add(table, (ResultRow){.key = "last_time",
                                  .label = "last time",
                                  .head = "last",
                                  .kind = RESULT_NUMBER,
                                  .number = party->last,
                                  .unit = "s",
                                  .decimals = 2,
                                  .difference = DIFFERENCE_IF_BOTH});
    result_add(table, (ResultRow){.key = "mean_lost_time",
                                  .label = "mean lost time",
                                  .head = "lost",
                                  .kind = RESULT_NUMBER,
                                  .number = party->lost,
                                  .unit = "s",
                                  .decimals = 1,
                                  .difference = DIFFERENCE_IF_BOTH});
    result_add(table, (ResultRow){.key = "contacts",
                                  .label = "contacts",
                                  .kind = RESULT_COUNT,
                                  .number = party->contacts,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "peak_force",
                                  .label = "hardest contact",
                                  .head = "hardest",
                                  .kind = RESULT_NUMBER,
                                  .number = party->peak_force,
                                  .unit = "N",
                                  .difference = DIFFERENCE_ALWAYS});
    result_end(table);
}

ResultTable result_house_parties(const House *house, const Census *census, bool only_crowds) {
    ResultTable table = {0};
    for (size_t p = 0; p < census->party_count; p++)
        if (census->parties[p].crowd || !only_crowds)
            add_party(&table, house, &census->parties[p]);
    return table;
}

/* Routes ------------------------------------------------------------------------------------------------------------
 */

static void add_route(ResultTable *table, const House *house, const Observation *observation, const PlanRoute *route) {
    ObservedTimes observed = observed_times_of(&route->observed);
    double time = census_route_time(house, observation, route);
    bool measured = observed.runs > 0, simulated = time >= 0;
    result_add(table, (ResultRow){.key = "id", .label = "route", .text = route->id});
    result_add(table, (ResultRow){.key = "mean",
                                  .label = "measured mean (a)",
                                  .head = "mean (a)",
                                  .kind = RESULT_NUMBER,
                                  .number = measured ? observed.mean : NAN,
                                  .unit = "s",
                                  .decimals = 2});
    result_add(table, (ResultRow){.key = "deviation",
                                  .label = "deviation (b)",
                                  .kind = RESULT_NUMBER,
                                  .number = observed.runs > 1 ? observed.deviation : NAN,
                                  .unit = "s",
                                  .decimals = 2});
    result_add(table, (ResultRow){.key = "simulation",
                                  .label = "simulation (c)",
                                  .kind = RESULT_NUMBER,
                                  .number = simulated ? time : NAN,
                                  .unit = "s",
                                  .decimals = 2,
                                  .difference = DIFFERENCE_ALWAYS});
    result_add(table, (ResultRow){.key = "error",
                                  .label = "error ((c) - (a)) / (a)",
                                  .head = "((c)-(a))/(a)",
                                  .kind = RESULT_NUMBER,
                                  .number = measured && simulated ? (time - observed.mean) / observed.mean : NAN,
                                  .unit = "%",
                                  .factor = 100,
                                  .decimals = 1,
                                  .sign = true});
    result_add(table, (ResultRow){.key = "runs",
                                  .label = "measured runs",
                                  .kind = RESULT_COUNT,
                                  .number = measured ? observed.runs : NAN});
    result_end(table);
}

ResultTable result_house_routes(const House *house, const Observation *observation) {
    ResultTable table = {0};
    for (size_t r = 0; r < house->plan.route_count; r++)
        add_route(&table, house, observation, &house->plan.routes[r]);
    return table;
}

/* Tight places --------------------------------------------------------------------------------------------------------
 */

static void add_costs(ResultTable *table, double clearance, double peak_force, double lost_time) {
    result_add(table, (ResultRow){.key = "clearance",
                                  .label = "clearance",
                                  .kind = RESULT_NUMBER,
                                  .number = clearance,
                                  .unit = "m",
                                  .decimals = 3,
                                  .gap = true});
    result_add(table, (ResultRow){.key = "peak_force",
                                  .label = "hardest contact",
                                  .head = "hardest",
                                  .kind = RESULT_NUMBER,
                                  .number = peak_force,
                                  .unit = "N",
                                  .unknown = !(peak_force > 0)});
    result_add(table, (ResultRow){.key = "lost_time",
                                  .label = "lost time",
                                  .head = "lost",
                                  .kind = RESULT_NUMBER,
                                  .number = lost_time,
                                  .unit = "s",
                                  .decimals = 1});
}

static void add_hindrance(ResultTable *table, const Observation *observation, size_t rank, const Tight *tight) {
    const Hazard *hazard = &observation->hazards[tight->hazard];
    const char *at = text_in_arena(&table->arena, "(%.2f, %.2f)", hazard->at.x, hazard->at.y);
    result_add(table, (ResultRow){.label = "rank", .text = text_in_arena(&table->arena, "%zu", rank)});
    result_add(table, (ResultRow){.key = "x", .kind = RESULT_NUMBER, .number = hazard->at.x});
    result_add(table, (ResultRow){.key = "y", .kind = RESULT_NUMBER, .number = hazard->at.y});
    result_add(table, (ResultRow){.key = "what", .label = "tight place", .text = hazard->what});
    result_add(table, (ResultRow){.label = "at", .text = at, .unit = "m"});
    add_costs(table, tight->clearance, tight->peak_force, tight->lost_time);
    result_end(table);
}

ResultTable result_house_hindrances(const House *house, const Observation *observation) {
    ResultTable table = {0};
    Tight places[HAZARDS_MOST];
    size_t count = tight_all(house, observation, places);
    for (size_t i = 0; i < count; i++)
        add_hindrance(&table, observation, i + 1, &places[i]);
    return table;
}

static void add_hazard(ResultTable *table, const Hazard *hazard) {
    result_add(table, (ResultRow){.key = "x", .kind = RESULT_NUMBER, .number = hazard->at.x});
    result_add(table, (ResultRow){.key = "y", .kind = RESULT_NUMBER, .number = hazard->at.y});
    result_add(table, (ResultRow){.key = "what", .text = hazard->what});
    result_add(table, (ResultRow){.key = "score", .kind = RESULT_NUMBER, .number = hazard->score, .decimals = 1});
    add_costs(table, hazard->clearance, hazard->peak_force, hazard->lost_time);
    result_end(table);
}

ResultTable result_house_hazards(const Observation *observation) {
    ResultTable table = {0};
    for (size_t h = 0; h < observation->hazard_count; h++)
        add_hazard(&table, &observation->hazards[h]);
    return table;
}

/* The whole run -----------------------------------------------------------------------------------------------------
 */

/* Nothing is known of people who never set off. */
ResultTable result_house_totals(const House *house, const Observation *observation) {
    ResultTable table = {0};
    Census census = census_make(house, observation);
    bool moved = observation->time > 0;
    double narrowest = HUGE_VAL, ring = 0;
    for (size_t i = 0; i < house->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        if (!person->took_part || !(person->time > 0))
            continue;
        narrowest = fmin(narrowest, person->narrowest);
        ring += person->ring_time;
    }
    result_add(&table, (ResultRow){.label = "people",
                                   .kind = RESULT_COUNT,
                                   .number = (double)census.people,
                                   .difference = DIFFERENCE_ALWAYS});
    result_add(&table, (ResultRow){.label = "people out",
                                   .kind = RESULT_COUNT,
                                   .number = (double)census.out,
                                   .difference = DIFFERENCE_ALWAYS});
    result_add(&table, (ResultRow){.label = "last out",
                                   .kind = RESULT_NUMBER,
                                   .number = census.out ? census.last : NAN,
                                   .unit = "s",
                                   .decimals = 2,
                                   .difference = DIFFERENCE_IF_BOTH});
    result_add(&table, (ResultRow){.label = "narrowest clearance",
                                   .kind = RESULT_NUMBER,
                                   .number = narrowest,
                                   .unit = "m",
                                   .decimals = 3,
                                   .gap = true,
                                   .difference = DIFFERENCE_IF_BOTH});
    result_add(&table, (ResultRow){.label = "contacts",
                                   .kind = RESULT_COUNT,
                                   .number = census.contacts,
                                   .unknown = !moved,
                                   .difference = DIFFERENCE_ALWAYS});
    result_add(&table, (ResultRow){.label = "hardest contact",
                                   .kind = RESULT_NUMBER,
                                   .number = census.peak_force,
                                   .unit = "N",
                                   .unknown = !moved,
                                   .difference = DIFFERENCE_ALWAYS});
    result_add(&table, (ResultRow){.label = "personal space entered",
                                   .kind = RESULT_NUMBER,
                                   .number = ring,
                                   .unit = "s",
                                   .decimals = 1,
                                   .unknown = !moved,
                                   .difference = DIFFERENCE_IF_BOTH});
    result_add(&table, (ResultRow){.label = "tight places",
                                   .kind = RESULT_COUNT,
                                   .number = (double)tight_count(house, observation),
                                   .unknown = !moved,
                                   .difference = DIFFERENCE_ALWAYS});
    result_end(&table);
    census_clear(&census);
    return table;
}
