#include <stdio.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "base/visible.h"
#include "command/answer.h"
#include "command/command.h"
#include "command/house_file.h"
#include "command/output.h"
#include "command/progress.h"
#include "house/journey.h"
#include "inquiry/suggest.h"
#include "inquiry/suggest_change.h"
#include "laboratory/shipped.h"
#include "plan/overlap.h"
#include "platform/terminal.h"
#include "result/check.h"
#include "result/json.h"
#include "result/shares.h"
#include "result/suggest.h"
#include "result/text.h"
#include "rules/rule_set.h"

/* Prints a line per person; with many people a line per crowd, and one per person without a crowd. */
static void print_answer(const House *house, const Journeys *journeys) {
    Observation observation = result_check_observation(house, journeys);
    Census census = census_make(house, &observation);
    Arena arena = {0};
    Text text = {0};
    bool many = census.people > CENSUS_ROWS;
    text_format(&text, "%s\n", result_check_sentence(house, &observation, &census, &arena));
    if (many)
        result_text_take(&text, "", result_check_parties(house, &observation, &census));
    result_text_take(&text, "", result_check_people(house, journeys, many ? &census : NULL));
    output_text(&text);
    memory_free(text.text);
    arena_clear(&arena);
    census_clear(&census);
    observation_free(&observation);
}

/* Adds a note, and clears its text. */
static void add_note(json_t *notes, Text *note) {
    char *line = visible_line(note->text);
    json_array_append_new(notes, json_string(line));
    memory_free(line);
    memory_free(note->text);
    *note = (Text){0};
}

/* Adds notes on a piece that stands in walls or in the open leaves of doors. */
static void add_overlaps(json_t *notes, const Plan *plan, size_t f) {
    char name[400];
    size_t wall = 0;
    Text note = {0};
    double depth = overlap_depth(plan, &plan->furniture[f], &wall);
    outline_name(plan, OWNER_FURNITURE, (int)f, name, sizeof name);
    if (depth >= OVERLAP_LEAST) {
        text_format(&note, "%s stands %.0f cm in wall %s", name, 100 * depth, plan->walls[wall].id);
        add_note(notes, &note);
    }
    for (size_t d = suggest_change_leaf(plan, f, 0); d < plan->door_count; d = suggest_change_leaf(plan, f, d + 1)) {
        text_format(&note, "%s stands in the way of the leaf of door %s, which cannot open as far as is assumed", name,
                    plan->doors[d].id);
        add_note(notes, &note);
    }
}

/* Returns notes about things that are allowed but strange, and about what is not checked. */
static json_t *notes_of(const Plan *plan) {
    json_t *notes = json_array();
    for (size_t f = 0; f < plan->furniture_count; f++)
        add_overlaps(notes, plan, f);
    for (size_t e = 0; e < plan->exit_count; e++) {
        Text note = {0};
        if (!(plan->exits[e].closes < HUGE_VAL))
            continue;
        text_format(&note, "exit %s closes at %g s: a run tells who is out in time", plan->exits[e].id,
                    plan->exits[e].closes);
        add_note(notes, &note);
    }
    return notes;
}

static void print_notes(const json_t *notes) {
    for (size_t i = 0; i < json_array_size(notes); i++)
        printf("note: %s\n", json_string_value(json_array_get(notes, i)));
}

static json_t *fault_lines(const Fault *fault) {
    json_t *lines = json_array();
    for (size_t i = 0; i < fault->count; i++)
        json_array_append_new(lines, json_string(fault->lines[i]));
    return lines;
}

/* The smallest changes of --suggest ---------------------------------------------------------------------------------
 */

/* Progress, once the work has taken more than a second. */
typedef struct Progress {
    double begin; /* s, by the clock */
    bool shown;
} Progress;

static void show_progress(void *context, size_t tries) {
    Progress *progress = context;
    if (stopwatch_now() - progress->begin < 1)
        return;
    terminal_progress("%zu changed houses tried ", tries);
    progress->shown = true;
}

/* Looks for the smallest changes that let all people out, with progress on standard error when that is wanted. False:
 * faults say why not. */
static bool find_suggestions(SuggestList *list, const Options *options, Fault *fault) {
    Progress progress = {.begin = stopwatch_now()};
    HouseOptions house_options = {.profiles = shipped_places()->profiles,
                                  .settings = options->settings,
                                  .setting_count = options->setting_count,
                                  .seed = options->seed,
                                  .driving = options->driving};
    SuggestTask task = {.path = options->files[0],
                        .options = &house_options,
                        .jobs = options->jobs,
                        .stop = &progress_stop,
                        .progress = progress_is_shown(options) ? show_progress : NULL,
                        .context = &progress};
    bool good = suggest_find(list, &task, fault);
    if (progress.shown)
        terminal_clear_progress();
    return good;
}

/* Adds "suggestions", and "suggestion_notes" about what was tried, to the answer. */
static void add_suggestions(json_t *answer, const SuggestList *list, const RuleSets *payers) {
    json_t *suggestions = result_json_take_list(result_suggest_changes(list, payers)), *notes = json_array();
    for (size_t i = 0; i < list->note_count; i++)
        json_array_append_new(notes, json_string(list->notes[i]));
    json_object_set_new(answer, "suggestions", suggestions);
    json_object_set_new(answer, "suggestion_notes", notes);
    json_object_set_new(answer, "suggestions_complete", json_boolean(!list->stopped && !list->exhausted));
}

static void print_suggestions(const SuggestList *list, const RuleSets *payers) {
    Arena arena = {0};
    Text text = {0};
    text_format(&text, "\n%s\n", result_suggest_sentence(list, &arena));
    result_text_take(&text, "", result_suggest_changes(list, payers));
    if (!list->out_already)
        text_format(&text, "\n%s\n", result_suggest_tried(list, &arena));
    for (size_t i = 0; i < list->note_count; i++)
        text_format(&text, "note: %s\n", list->notes[i]);
    for (size_t s = 0; s < payers->count && list->count; s++)
        text_format(&text, "%s: %s\n", payers->sets[s].id, payers->sets[s].note);
    output_text(&text);
    memory_free(text.text);
    arena_clear(&arena);
}

/* Reads the sets of rules that say what is paid for. Returns false after an error. */
static bool read_payers(RuleSets *payers, const Options *options, Fault *fault) {
    if (!options->rules)
        return true;
    if (!options->suggest)
        fault_add(fault, "--rules: says who pays for the changes of --suggest, which must be given, too");
    else if (rule_set_read_all(payers, shipped_places()->rules, options->rules, fault))
        for (size_t s = 0; s < payers->count; s++)
            if (!payers->sets[s].pay_count)
                fault_add(fault,
                          "--rules: %s does not say what is paid for, must be a set with \"pays\", such as "
                          "jp-care-insurance",
                          payers->sets[s].id);
    return !fault->total;
}

/* Adds the smallest changes to the answer, or prints them. */
static bool suggest(const Options *options, const RuleSets *payers, json_t *answer, bool *interrupted, Fault *fault) {
    SuggestList list = {0};
    fflush(stdout);
    if (!find_suggestions(&list, options, fault))
        return false;
    add_suggestions(answer, &list, payers);
    if (!options->json)
        print_suggestions(&list, payers);
    *interrupted |= list.stopped;
    suggest_clear(&list);
    return true;
}

/* Adds the grades of all chairs to the answer, or prints them. */
static void grade(const Options *options, const House *house, json_t *answer, bool *interrupted) {
    Grade *grades = memory_zeroed(house->person_count, sizeof *grades);
    Text text = {0};
    fflush(stdout);
    *interrupted |= !grade_all(grades, house, options->jobs, &progress_stop);
    json_object_set_new(answer, "grades", result_json_take_list(result_check_grades(house, grades)));
    json_object_set_new(answer, "grade_places", result_json_take_list(result_check_grade_places(house, grades)));
    if (!options->json) {
        bool any = *interrupted;
        for (size_t i = 0; i < house->person_count; i++)
            any |= house->people[i].profile->driving == DRIVING_DRIVER;
        if (!any)
            text_add(&text, "\nno chair in this house is moved by the model \"driver\", so that nothing has a grade\n");
        result_text_take(&text, "", result_check_grades(house, grades));
        result_text_take(&text, "", result_check_grade_places(house, grades));
        output_text(&text);
    }
    memory_free(text.text);
    memory_free(grades);
}

/* Adds how many drivers of the population get through, or prints it. */
static void share(const Options *options, const House *house, const Population *population, json_t *answer,
                  bool *interrupted) {
    Shares *shares = memory_zeroed(house->person_count, sizeof *shares);
    Text text = {0};
    fflush(stdout);
    shares_find(shares, house, population, (size_t)options->drivers, SIZE_MAX, options->jobs, &progress_stop);
    bool any = false;
    for (size_t i = 0; i < house->person_count; i++) {
        *interrupted |= shares[i].interrupted;
        any |= shares[i].drivers > 0;
    }
    json_object_set_new(answer, "shares",
                        json_pack("{s:s, s:i, s:o}", "population", population->id, "count", options->drivers, "people",
                                  result_json_take_list(result_shares_table(house, shares))));
    if (!options->json) {
        text_format(&text, "\ndrivers of the population %s: %s\n", population->id, population->title);
        if (!any)
            text_format(&text, "nobody in this house has its profile, %s\n", population->profile);
        result_text_take(&text, "", result_shares_table(house, shares));
        output_text(&text);
    }
    memory_free(text.text);
    memory_free(shares);
}

/* Reads the house and, for --drivers, the population, and for --rules, who pays. Returns false after an error. */
static bool read_files(House *house, Population *population, RuleSets *payers, const Options *options, Fault *fault) {
    bool read = read_payers(payers, options, fault) && house_file_read(house, options, 0, fault);
    if (!read || !options->drivers || house_file_population(population, options, &house->plan, fault))
        return read;
    house_free(house);
    return false;
}

int command_check(const Options *options) {
    House house = {0};
    Population population = {0};
    RuleSets payers = {0};
    Fault fault = {0};
    if (!read_files(&house, &population, &payers, options, &fault)) {
        rule_set_free_all(&payers);
        population_free(&population);
        if (options->json && !text_read_interrupted()) /* the verb's caller answers for an interruption */
            answer_print(json_pack("{s:s, s:o, s:[]}", "kind", "check", "faults", fault_lines(&fault), "people"));
        return house_file_report(&fault);
    }
    Journeys journeys = journey_plan_all(&house, NULL, options->jobs, &progress_stop);
    json_t *people = result_json_take_list(result_check_people(&house, &journeys, NULL));
    bool all = true, interrupted = false;
    for (size_t i = 0; i < house.person_count; i++) {
        all &= journeys.of[i].route.answer == ROUTE_FOUND;
        interrupted |= journeys.of[i].route.answer == ROUTE_INTERRUPTED;
    }
    json_t *notes = notes_of(&house.plan);
    json_t *answer = json_pack("{s:s, s:[], s:o, s:o}", "kind", "check", "faults", "notes", notes, "people", people);
    if (!options->json) {
        print_answer(&house, &journeys);
        print_notes(notes);
    }
    if (options->grades)
        grade(options, &house, answer, &interrupted);
    if (options->drivers && !interrupted)
        share(options, &house, &population, answer, &interrupted);
    bool good = !options->suggest || suggest(options, &payers, answer, &interrupted, &fault);
    answer_mark_interrupted(answer, interrupted);
    if (interrupted && good)
        fprintf(stderr, "clearance: interrupted; what is not known yet is neither a yes nor a no\n");
    if (options->json && good)
        answer_print(json_incref(answer));
    json_decref(answer);
    journey_free_all(&journeys);
    population_free(&population);
    rule_set_free_all(&payers);
    house_free(&house);
    return !good ? house_file_report(&fault) : all && !interrupted ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}
