#include "laboratory/house/text.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/text.h"
#include "laboratory/house/passing.h"
#include "laboratory/house/marks.h"
#include "laboratory/house/rows.h"
#include "laboratory/house/runs.h"
#include "laboratory/house/shake_rows.h"
#include "plan/plan_geometry.h"
#include "result/grade.h"
#include "result/headline.h"
#include "result/house.h"
#include "result/jam.h"
#include "result/names.h"
#include "result/panel.h"
#include "result/tight.h"
#include "visual/house/blockage_scene.h"
#include "visual/house/people_scene.h"

#define MOMENT 0.1 /* s, of a steady clock, between two updates of the texts of the moment */
#define ALIKE 0.05 /* s: times closer than this count as equal */
#define AHEAD 2.0  /* s, time before a person reaches a dangerous point at which "go to" begins */

enum { EXITS_MOST = 16 /* that are counted one by one in a crowd */ };

static bool is_crowd(const HouseSession *session) {
    return session->runs[RUN_SHOWN]->house.person_count > PEOPLE_SCENE_INDIVIDUALS;
}

/* The selection ---------------------------------------------------------------------------------------------------- */

static void add_pair(HouseSession *session, const char *what, const char *value) {
    house_rows_add(session, ROW_PLAIN, what)->row.cells[1] = value;
}

static void add_moment(HouseSession *session, size_t person, double time) {
    Scene *scene = &session->texts.moment;
    const double *row = trail_row_at(&session->trails.trails[person], time);
    const PersonObservation *observed = &session->observation->people[person];
    if (!row || (observed->completed && time >= observed->time))
        return;
    double reach = session->runs[RUN_SHOWN]->house.people[person].profile->space_reach;
    bool free = row[TRACE_CLEARANCE] >= reach;
    double speed = round(100 * row[TRACE_SPEED]) / 100 + 0.0; /* no negative zero */
    add_pair(session, "speed now", scene_text(scene, "%.2f m/s", speed));
    const char *gap = tight_to_spare(free ? reach : row[TRACE_CLEARANCE], &scene->arena);
    add_pair(session, "room to spare now", free ? scene_text(scene, "over %s", gap) : gap);
    add_pair(session, "force now", scene_text(scene, "%.0f N", row[TRACE_BODY_FORCE]));
}

/* Adds a row for each fact of a record that has a value, from row `first` on. */
static void add_record(HouseSession *session, ResultTable *table, size_t first) {
    Arena *arena = &session->texts.moment.arena;
    const House *house = &session->runs[RUN_SHOWN]->house;
    bool brief = session->runs[RUN_SHOWN]->wish.brief;
    for (size_t r = first; r < table->row_count; r++) {
        SceneRow line;
        const ResultRow *row = result_at(table, 0, r);
        if (!result_panel_row(&line, row, arena) ||
            (brief && line.cells[0] && strcmp(line.cells[0], "width needed") == 0)) /* not final yet */
            continue;
        line.cells[0] = names_number(line.cells[0]);
        line.cells[1] = line.cells[1] ? names_text(house, names_profile(line.cells[1]), arena) : NULL;
        house_rows_add(session, line.kind, NULL)->row = line;
    }
    result_clear(table);
}

static void add_person(HouseSession *session, size_t i, double time) {
    if (!session->observation->people[i].took_part) {
        add_pair(session, "not in this run", NULL);
        return;
    }
    ResultTable table = {0};
    result_house_add_person(&table, &session->runs[RUN_SHOWN]->house, session->observation, i);
    add_record(session, &table, 1); /* the name is the heading */
    add_moment(session, i, time);
}

/* Adds how many people of a crowd pass a second; nothing among few people. */
static void add_flow(HouseSession *session, const char *what, double flow) {
    Scene *scene = &session->texts.moment;
    if (is_crowd(session))
        add_pair(session, what, scene_text(scene, "%.1f people/s", flow));
}

static double flow_of_door(const HouseSession *session, const Door *door, double time) {
    const House *house = &session->runs[RUN_SHOWN]->house;
    return passing_door(&house->plan, door, session->trails.trails, session->trails.count, time);
}

/* Adds what no slider below says. */
static void add_door(HouseSession *session, const Plan *plan, const Door *door) {
    Scene *scene = &session->texts.moment;
    Vec2 from, to;
    plan_geometry_door_ends(plan, door, &from, &to);
    const char *wall = names_wall_at(plan, door->wall_index, vec2_scale(vec2_add(from, to), 0.5), &scene->arena);
    house_rows_add(session, ROW_PLAIN, scene_text(scene, "in %s", wall));
}

/* Adds the numbers of a tight place, as its row in the list has them. */
static void add_hazard(HouseSession *session, size_t place, double time) {
    Tight tight[TIGHT_MOST];
    Arena *arena = &session->texts.moment.arena;
    if (place >= tight_places(&session->runs[RUN_SHOWN]->house, session->observation, tight))
        return;
    const char *gap = tight_to_spare(tight[place].clearance, arena);
    Vec2 at = session->observation->hazards[tight[place].hazard].at;
    add_pair(session, is_crowd(session) ? "time lost by all" : "time lost",
             headline_duration(tight[place].lost_time, arena));
    if (gap && !is_crowd(session))
        add_pair(session, "room to spare", gap);
    if (tight[place].peak_force > 0)
        add_pair(session, "hardest touch", text_in_arena(arena, "%.0f N", tight[place].peak_force));
    add_pair(session, "worst at", text_in_arena(arena, "(%.2f, %.2f) m", at.x, at.y));
    if (is_crowd(session) && session->whole)
        add_pair(session, "worst after", headline_duration(session->texts.before[place], arena));
    const Plan *plan = &session->runs[RUN_SHOWN]->house.plan;
    JamPlace jam = jam_place(plan, &session->observation->hazards[tight[place].hazard]);
    if (jam.exit)
        add_flow(session, "through the exit now",
                 passing_exit(session->observation, (size_t)(jam.exit - plan->exits), time));
    else if (jam.door)
        add_flow(session, "through the door now", flow_of_door(session, jam.door, time));
}

static void add_selected(HouseSession *session, double time) {
    Scene *scene = &session->texts.moment;
    const Plan *plan = &session->runs[RUN_SHOWN]->house.plan;
    Item item = session->selected;
    char name[HOUSE_ITEM_NAME];
    house_item_name(&session->runs[RUN_SHOWN]->house, session->observation, item, name, sizeof name);
    if (!*name)
        return;
    *name = (char)toupper((unsigned char)*name);
    house_rows_add(session, ROW_HEADING, scene_text(scene, "%s", name));
    if (item.kind == HOUSE_PERSON) {
        add_person(session, item.index, time);
    } else if (item.kind == HOUSE_HAZARD) {
        add_hazard(session, item.index, time);
    } else if (item.kind == HOUSE_STOP) {
        const char *widths = blockage_scene_widths(scene, &session->observation->people[item.index].blockage);
        if (*widths)
            house_rows_add(session, ROW_PLAIN, widths);
    } else if (item.kind == HOUSE_DOOR) {
        add_door(session, plan, &plan->doors[item.index]);
        add_flow(session, "through now", flow_of_door(session, &plan->doors[item.index], time));
    } else if (item.kind == HOUSE_FURNITURE) {
        const Furniture *piece = &plan->furniture[item.index];
        add_pair(session, "size", scene_text(scene, "%.2f x %.2f m", piece->size.x, piece->size.y));
        add_pair(session, "height", scene_text(scene, "%.2f m", piece->height));
        add_pair(session, "fallen", piece->toppled ? "yes" : "no");
    } else if (item.kind == HOUSE_EXIT) {
        const Exit *exit = &plan->exits[item.index];
        add_pair(session, "width", scene_text(scene, "%.2f m", vec2_distance(exit->from, exit->to)));
        add_flow(session, "through now", passing_exit(session->observation, item.index, time));
    }
}

/* Before and now -------------------------------------------------------------------------------------------------- */

/* Adds how many tight places there are before and now, counted as they are listed. */
static void compare_places(HouseSession *session, const Before *ghost) {
    Arena *arena = &session->texts.moment.arena;
    bool known = ghost->observation->time > 0, moved = session->observation->time > 0;
    SceneRow *row = &house_rows_add(session, ROW_PLAIN, is_crowd(session) ? "jams" : "tight places")->row;
    row->cells[1] = known ? tight_number(ghost->house, ghost->observation, 0, arena) : "-";
    row->cells[2] = moved ? tight_number(&session->runs[RUN_SHOWN]->house, session->observation, 0, arena) : "-";
}

/* Adds the facts of the whole run before and now. */
static void compare(HouseSession *session) {
    Before ghost = house_runs_compared(session);
    Scene *scene = &session->texts.moment;
    if (!ghost.observation || !session->whole)
        return;
    ResultTable before = result_house_totals(ghost.house, ghost.observation),
                now = result_house_totals(&session->runs[RUN_SHOWN]->house, session->observation);
    house_rows_add(session, ROW_HEADING, scene_text(scene, "Compare: %s, now", house_scene_before_name(ghost)));
    for (size_t r = 0; r < now.row_count; r++) {
        SceneRow line;
        const ResultRow *row = result_at(&now, 0, r);
        if (strcmp(row->label, "tight places") != 0 && /* below, as jams or "at least 9" */
            result_panel_pair(&line, result_at(&before, 0, r), row, &scene->arena)) {
            line.cells[0] = names_number(line.cells[0]);
            house_rows_add(session, line.kind, NULL)->row = line;
        }
    }
    result_clear(&before);
    result_clear(&now);
    compare_places(session, &ghost);
}

/* Many drivers --------------------------------------------------------------------------------------------------- */

/* Returns the person whose drivers the answer tells: the selected one, or the last one out; person_count: none. */
static size_t crew_person(const HouseSession *session) {
    const Crew *crew = session->crew;
    const Item selected = session->selected;
    if (selected.kind == HOUSE_PERSON && selected.index < crew->person_count && crew->said[selected.index])
        return selected.index;
    size_t last = crew->person_count;
    for (size_t i = 0; i < crew->person_count; i++)
        if (crew->said[i] && (last == crew->person_count ||
                              session->observation->people[i].time > session->observation->people[last].time))
            last = i;
    return last;
}

/* Returns ", the first 10 drivers" while more are running, or "". */
static const char *first_drivers(HouseSession *session) {
    bool more = session->runs[RUN_CREW] && !house_runs_is_over(session, RUN_CREW);
    return more ? scene_text(&session->texts.moment, ", the first %zu drivers", session->crew->count) : "";
}

/* Adds a row for each person, and those of the picture's signs. */
static void add_crew(HouseSession *session) {
    const Crew *crew = session->crew;
    Scene *scene = &session->texts.moment;
    const House *house = &session->runs[RUN_SHOWN]->house;
    if (!crew)
        return;
    house_rows_add(session, ROW_HEADING,
                   *first_drivers(session) ? scene_text(scene, "the first %zu drivers", crew->count)
                                           : scene_text(scene, "%zu drivers", crew->count));
    for (size_t i = 0; i < crew->person_count; i++)
        if (crew->said[i])
            house_rows_add(session, ROW_PLAIN,
                           scene_text(scene, "%s: %s", names_person(house, i, &scene->arena), crew->said[i]))
                ->item = (Item){HOUSE_PERSON, i};
    if (crew_person(session) == crew->person_count)
        house_rows_add(session, ROW_PLAIN, "nobody here has the wheelchair of the population");
    for (size_t r = 0; r < crew->scene.row_count; r++)
        house_rows_add(session, ROW_PLAIN, NULL)->row = crew->scene.rows[r];
}

/* A crowd now ------------------------------------------------------------------------------------------------------ */

/* Adds how many are out, of all and at each exit; once it is known, also of how many who will leave there. */
static void add_now(HouseSession *session, double time) {
    const Observation *observation = session->observation;
    const Plan *plan = &session->runs[RUN_SHOWN]->house.plan;
    Scene *scene = &session->texts.moment;
    size_t out = 0, now[EXITS_MOST] = {0}, all[EXITS_MOST] = {0};
    if (!is_crowd(session))
        return;
    for (size_t i = 0; i < observation->person_count; i++) {
        const PersonObservation *person = &observation->people[i];
        bool gone = person->completed && person->time <= time;
        out += gone;
        if (person->completed && person->exit < EXITS_MOST) {
            now[person->exit] += gone;
            all[person->exit]++;
        }
    }
    house_rows_add(session, ROW_HEADING, "Now");
    size_t people = observation->person_count;
    add_pair(session, "out", scene_text(scene, "%s of %zu", headline_count(out, people, &scene->arena), people));
    for (size_t e = 0; e < plan->exit_count && e < EXITS_MOST; e++)
        add_pair(session, scene_text(scene, "exit %s", plan->exits[e].id),
                 session->whole ? scene_text(scene, "%s of %zu", headline_count(now[e], all[e], &scene->arena), all[e])
                                : headline_count(now[e], people, &scene->arena));
    if (plan->exit_count > EXITS_MOST)
        house_rows_add(session, ROW_PLAIN, scene_text(scene, "and %zu more exits", plan->exit_count - EXITS_MOST));
}

/* Rows of the scene's list: dangerous points and people ----------------------------------------------------------- */

/* Finds the time when a person is nearest to each tight place, minus AHEAD; s. */
static void find_nearest(const Observation *observation, const Tight *tight, size_t count, double *before) {
    double least[TIGHT_MOST];
    for (size_t h = 0; h < count; h++)
        least[h] = HUGE_VAL;
    for (size_t r = 0; r < observation->trace.rows && count; r++) {
        const double *row = trace_row(&observation->trace, r);
        for (size_t h = 0; h < count; h++) {
            double distance = vec2_distance(vec2(row[TRACE_X], row[TRACE_Y]), observation->hazards[tight[h].hazard].at);
            if (distance >= least[h])
                continue;
            least[h] = distance;
            before[h] = fmax(0, row[TRACE_TIME] - AHEAD);
        }
    }
}

/* Finds the time for each tight place, s; in a crowd, once the run is over, the time when its jam is worst. */
static void find_times(HouseSession *session) {
    const House *house = &session->runs[RUN_SHOWN]->house;
    const Observation *observation = session->observation;
    Tight tight[TIGHT_MOST];
    size_t count = tight_places(house, observation, tight);
    if (!is_crowd(session))
        find_nearest(observation, tight, count, session->texts.before);
    for (size_t h = 0; h < count && is_crowd(session); h++)
        session->texts.before[h] =
            session->whole ? jam_worst(house, observation, &observation->hazards[tight[h].hazard]) : NAN;
}

/* Returns the first person who is stopped; person_count: none. */
static size_t first_stopped(const Observation *observation) {
    size_t i = 0;
    while (i < observation->person_count && !blockage_scene_has(&observation->people[i]))
        i++;
    return i;
}

/* Adds a row below the list of tight places, if there are more than are listed. */
static void add_more(HouseSession *session, size_t listed) {
    const House *house = &session->runs[RUN_SHOWN]->house;
    if (tight_count(house, session->observation) == listed)
        return;
    const char *number = tight_number(house, session->observation, listed, &session->texts.moment.arena);
    add_pair(session, is_crowd(session) ? "more jams" : "more tight places", number);
}

/* Adds the rows of the scene's list with their items: the n-th row below a heading is the n-th item of its kind. */
static void add_listed(HouseSession *session) {
    const Scene *scene = &session->texts.run;
    const House *house = &session->runs[RUN_SHOWN]->house;
    size_t hazard = 0, person = 0, stopped = first_stopped(session->observation);
    bool stops = session->whole && stopped < session->observation->person_count;
    for (size_t i = 0; i < scene->row_count; i++) {
        PanelRow *row = house_rows_add(session, ROW_PLAIN, NULL);
        row->row = scene->rows[i];
        if (stops)
            row->place = (Item){HOUSE_STOP, stopped};
        if (row->row.kind == ROW_DISC) {
            row->item = (Item){HOUSE_HAZARD, hazard};
            row->place = stops ? row->place : row->item;
            row->time = session->texts.before[hazard++];
            if (i + 1 == scene->row_count || scene->rows[i + 1].kind != ROW_DISC)
                add_more(session, hazard);
        } else if (row->row.kind == ROW_LINE && house->person_count <= PEOPLE_SCENE_INDIVIDUALS) {
            while (person < house->person_count && !session->observation->people[person].took_part)
                person++;
            if (person < house->person_count)
                row->item = (Item){HOUSE_PERSON, person++};
        }
    }
}

/* The answer ------------------------------------------------------------------------------------------------------ */

/* Compares the time with that of the saved run: "before 24.1 s, -5.7 s (-24 %)". */
static const char *against(HouseSession *session, const Observation *now) {
    Before ghost = house_runs_compared(session);
    Scene *scene = &session->texts.moment;
    if (!ghost.observation)
        return "";
    const char *word = house_scene_before_name(ghost);
    double before = ghost.observation->time, more = headline_difference(before, now->time);
    if (!ghost.observation->completed)
        return scene_text(scene, "%s: not everybody gets out", word);
    if (!now->completed || before <= 0)
        return scene_text(scene, "%s %s", word, headline_duration(before, &scene->arena));
    if (fabs(more) < ALIKE)
        return scene_text(scene, "%s %s, the same", word, headline_duration(before, &scene->arena));
    const char *sign = more < 0 ? "\u2212" : "+";
    return scene_text(scene, "%s %s, %s%s (%s%.0f %%)", word, headline_duration(before, &scene->arena), sign,
                      headline_duration(fabs(more), &scene->arena), sign, 100 * fabs(more) / before);
}

static void make_answer(HouseSession *session) {
    HouseTexts *texts = &session->texts;
    const Scene *run = &texts->run;
    const HouseRun *shown = session->runs[RUN_SHOWN];
    texts->missing = (Missing){.title = NULL};
    if (!session->whole) {
        texts->title = session->observation->trace.rows ? "On the way" : "Finding ways";
        texts->role = ROLE_TEXT;
        texts->detail = "";
        return;
    }
    if (missing_find(&shown->house, session->observation, &texts->moment, &texts->missing)) {
        texts->title = texts->missing.title;
        texts->role = texts->missing.role;
        texts->detail = texts->missing.detail;
        return;
    }
    const char *than = against(session, session->observation);
    const HouseWish *wish = &shown->wish;
    if (wish->epoch_count > 1)
        than = scene_text(&texts->moment, "after the change at %.1f s", wish->epochs[wish->epoch_count - 1].time);
    texts->title = run->title;
    texts->role = run->title_role;
    texts->detail = run->detail;
    if (house_runs_has_grade(session))
        result_grade_add(&texts->title, &texts->detail, &shown->house,
                         house_runs_is_over(session, RUN_GRADES) ? session->runs[RUN_GRADES]->grades : NULL,
                         &texts->moment.arena);
    if (*than)
        texts->detail = *texts->detail ? scene_text(&texts->moment, "%s; %s", than, texts->detail) : than;
    size_t person = session->crew ? crew_person(session) : 0;
    if (session->crew && person < session->crew->person_count)
        texts->detail =
            scene_text(&texts->moment, "%s%s: %s", names_person(&shown->house, person, &texts->moment.arena),
                       first_drivers(session), session->crew->said[person]);
}

/* Makes the answer and the lists. Those of a run in progress are of the displayed time: more may be computed. */
static void make_lists(HouseSession *session, double time) {
    const House *house = &session->runs[RUN_SHOWN]->house;
    Census census = census_until(house, session->observation, session->whole ? HUGE_VAL : time);
    scene_clear(&session->texts.run);
    house_scene_add_answer(&session->texts.run, house, session->observation, &census);
    census_clear(&census);
}

/* Makes the texts about the run as a whole. */
static void make_run_texts(HouseSession *session, double time) {
    make_lists(session, time);
    find_times(session);
    session->texts.last = census_last(session->observation);
    house_marks_make(session);
    session->texts_are_stale = false;
}

void house_text_make(HouseSession *session, double time) {
    HouseTexts *texts = &session->texts;
    texts->row_count = 0;
    texts->said = stopwatch_now();
    texts->time = time;
    session->texts_of = house_runs_identity(session->runs[RUN_SHOWN]);
    if (session->texts_are_stale)
        make_run_texts(session, time);
    else if (is_crowd(session) && !session->whole)
        make_lists(session, time);
    scene_clear(&texts->moment);
    make_answer(session);
    add_selected(session, time);
    house_shake_rows_add(session);
    compare(session);
    add_now(session, time);
    add_crew(session);
    add_listed(session);
}

void house_text_clear(HouseSession *session) {
    scene_clear(&session->texts.run);
    scene_clear(&session->texts.moment);
    memory_free(session->texts.rows);
    memory_free(session->texts.marks);
    session->texts = (HouseTexts){.title = NULL};
}

bool house_text_moved(const HouseSession *session, double time) {
    if (!session->runs[RUN_SHOWN] || time == session->texts.time)
        return false;
    if (is_crowd(session))
        return true; /* its counts stand in the picture, too, and must be of the same time */
    if (session->selected.kind != HOUSE_PERSON)
        return false;
    const Trail *trail = &session->trails.trails[session->selected.index];
    return stopwatch_now() - session->texts.said >= MOMENT &&
           trail_row_at(trail, time) != trail_row_at(trail, session->texts.time);
}

/* Returns a text about the work in progress; NULL: there is none. */
static const char *describe_progress(HouseSession *session) {
    HouseTexts *texts = &session->texts;
    const char *model = NULL;
    if (house_runs_seeks_reasons(session))
        return "working out how wide it must be";
    if (house_runs_is_working(session)) {
        if (!session->settles)
            return NULL;
        snprintf(texts->doing, sizeof texts->doing, "working it out for the plan as it is now, %.1f s",
                 stopwatch_now() - session->edited);
        return texts->doing;
    }
    HouseRun *run = NULL;
    if (session->runs[RUN_SHOWN] && !session->whole)
        run = session->runs[RUN_SHOWN];
    if (!run && session->runs[RUN_RIVAL] && !house_runs_is_over(session, RUN_RIVAL)) {
        run = session->runs[RUN_RIVAL];
        model = profile_driving_name(run->wish.driving);
    }
    if (!run && session->runs[RUN_ROUTES] && !house_runs_is_over(session, RUN_ROUTES))
        run = session->runs[RUN_ROUTES];
    if (!run && session->runs[RUN_CREW] && !house_runs_is_over(session, RUN_CREW)) {
        const Crew *crew = house_run_crew(session->runs[RUN_CREW]);
        size_t size = crew_size(crew ? CREW_STEPS - 1 : 0, draft_plan(session->draft));
        snprintf(texts->doing, sizeof texts->doing, "running %zu drivers", size);
        return texts->doing;
    }
    return run && house_run_describe(run, model, texts->doing, sizeof texts->doing) ? texts->doing : NULL;
}

/* Returns the answer before a house is displayed. */
static Result answer_nothing(HouseSession *session) {
    if (session->runs[RUN_LATEST])
        return (Result){.title = "Reading ...",
                        .role = ROLE_TEXT,
                        .detail = "",
                        .due = true,
                        .doing = describe_progress(session),
                        .part = NAN};
    return (Result){.title = "This house cannot be run",
                    .role = ROLE_ERROR,
                    .detail = session->error.text ? session->error.text : "",
                    .part = NAN,
                    .broken = true};
}

/* Tells who of a crowd is the last one out, if the run is over and all have left. */
static void add_last(const HouseSession *session, Result *answer) {
    size_t last = session->texts.last;
    if (!is_crowd(session) || !session->whole || !session->observation->completed || last == SIZE_MAX)
        return;
    answer->last = (Item){HOUSE_PERSON, last};
    answer->last_time = fmax(0, session->observation->people[last].time - AHEAD);
}

Result house_text_answer(HouseSession *session) {
    const HouseTexts *texts = &session->texts;
    if (!session->runs[RUN_SHOWN])
        return answer_nothing(session);
    Result answer = {.title = texts->title ? texts->title : "Finding ways",
                     .role = texts->role,
                     .detail = texts->detail ? texts->detail : "",
                     .stale = session->settles,
                     .due = house_runs_is_working(session),
                     .doing = describe_progress(session),
                     .grading = house_runs_wants(session, RUN_GRADES) && !house_runs_is_over(session, RUN_GRADES),
                     .shaking = house_runs_wants(session, RUN_SHAKES) && !house_runs_is_over(session, RUN_SHAKES),
                     .part = NAN,
                     .cure = texts->missing.cure,
                     .tool = texts->missing.tool,
                     .cure_at = texts->missing.at};
    add_last(session, &answer);
    return answer;
}

bool house_text_progress_changed(HouseSession *session) {
    HouseTexts *texts = &session->texts;
    const char *doing = describe_progress(session);
    bool other = strcmp(doing ? doing : "", texts->done) != 0;
    snprintf(texts->done, sizeof texts->done, "%s", doing ? doing : "");
    return other;
}
