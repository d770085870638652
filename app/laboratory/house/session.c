#include "laboratory/house/session.h"

#include <stdio.h>
#include <string.h>

#include "house/run.h"
#include "plan/draft_file.h"
#include "laboratory/house/control.h"
#include "laboratory/house/schedule.h"
#include "laboratory/house/picture.h"
#include "laboratory/house/text.h"
#include "laboratory/save_file.h"
#include "result/source_line.h"
#include "visual/house/people_scene.h"

#define STEP (1.0 / 30) /* s, duration of one displayed frame */
#define FASTEST 16.0

static size_t rows_recorded(const HouseSession *session) {
    return session->runs[RUN_SHOWN] ? session->observation->trace.rows : 0;
}

/* Returns the items that can be picked; a run must be displayed. */
static HouseScenery scenery_of(const HouseSession *session) {
    return (HouseScenery){&session->runs[RUN_SHOWN]->house, session->observation, session->trails.trails};
}

/* The editor ------------------------------------------------------------------------------------------------------- */

/* Passes the displayed house to the editor. */
static void update_editor_scene(HouseSession *session) {
    EditorScene scene = {.time = session->time};
    if (session->runs[RUN_SHOWN]) {
        scene.scenery = scenery_of(session);
        scene.revision = house_run_revision(session->runs[RUN_SHOWN]);
    }
    editor_set_scene(session->editor, &scene);
}

static Editor *editor(void *context) {
    return ((HouseSession *)context)->editor;
}

static unsigned update(void *context, double time) {
    HouseSession *session = house_control_sync(context);
    size_t rows = rows_recorded(session);
    session->time = time;
    house_schedule_update(session, time);
    house_fall_update(session);
    if (house_text_moved(session, time))
        session->changed |= LABORATORY_TEXTS;
    unsigned changed = session->changed;
    session->changed = 0;
    if (session->runs[RUN_SHOWN]) {
        house_picture_make_film(session, time);
        changed |= session->changed; /* another plan applies at that time */
        session->changed = 0;
        if (changed & LABORATORY_VIEW)
            film_look(session->film, session->camera);
        session->fresh = session->fresh || changed & LABORATORY_VIEW;
        if (changed & LABORATORY_PLOTS)
            house_picture_make_plots(session, true);
        if (changed & LABORATORY_TEXTS)
            house_text_make(session, time);
        if (changed & LABORATORY_PARAMETERS)
            house_value_follow(&session->values, draft_plan(session->draft), session->selected);
        if (changed & LABORATORY_PARAMETERS)
            house_value_sort(&session->values, &session->runs[RUN_SHOWN]->house, session->selected);
    }
    update_editor_scene(session);
    bool other = house_text_progress_changed(session) || rows_recorded(session) != rows;
    return changed | (other ? LABORATORY_TEXTS : 0);
}

static void tell(void *context, double time) {
    HouseSession *session = house_control_sync(context);
    session->time = time;
    if (house_text_moved(session, time))
        house_text_make(session, time);
}

/* Opening and closing --------------------------------------------------------------------------------------------- */

static void store_wish(HouseSession *session, const char *path, const LaboratoryOptions *options) {
    const char **settings = arena_allocate(&session->arena, (options->setting_count + 1) * sizeof *settings);
    for (size_t i = 0; i < options->setting_count; i++)
        settings[i] = arena_text(&session->arena, options->settings[i]);
    session->given = *options;
    session->given.settings = settings;
    session->given.origin = NULL;
    session->wish = (HouseWish){.path = arena_text(&session->arena, path),
                                .profiles = arena_text(&session->arena, options->profiles),
                                .route = options->route ? arena_text(&session->arena, options->route) : NULL,
                                .driving = options->driving,
                                .seed = options->seed,
                                .jobs = options->jobs,
                                .recall = recall_create()};
}

static bool check_route(const Plan *plan, const char *path, const char *route, Fault *fault) {
    if (!route || plan_find_route(plan, route) != SIZE_MAX)
        return true;
    Text known = {0};
    for (size_t r = 0; r < plan->route_count; r++)
        text_format(&known, r ? ", %s" : "%s", plan->routes[r].id);
    if (known.text)
        fault_add(fault, "%s has no route \"%s\", its routes are %s", path, route, known.text);
    else
        fault_add(fault, "%s has no routes, so --route %s cannot be used", path, route);
    memory_free(known.text);
    return false;
}

static Draft *open_draft(const char *path, const LaboratoryOptions *options, Fault *fault) {
    if (!path)
        return draft_create("new house");
    Draft *draft = draft_file_read(path, options->settings, options->setting_count, fault);
    if (draft && check_route(draft_plan(draft), path, options->route, fault))
        return draft;
    draft_destroy(draft);
    return NULL;
}

/* Opens a session of a draft, which it takes over; NULL: no draft, or an error. */
static void *open_session(Draft *draft, const char *path, const LaboratoryOptions *options, Fault *fault) {
    HouseWorker *worker = draft ? house_worker_create(false) : NULL;
    HouseWorker *crew_worker = worker ? house_worker_create(true) : NULL;
    if (worker && !crew_worker) {
        house_worker_destroy(worker);
        worker = NULL;
    }
    if (draft && !worker)
        fault_add(fault, "the house cannot be run: the system has no more threads; close other programs");
    if (!worker) {
        draft_destroy(draft);
        return NULL;
    }
    HouseSession *session = memory_zeroed(1, sizeof *session);
    session->draft = draft;
    session->nothing = (Scene){.box = {{0, 0}, {1, 1}}, .bare = true, .unscaled = true};
    session->layers = house_laboratory.layers_at_first;
    store_wish(session, path, options);
    session->editor = editor_create(draft, &(EditorOptions){.path = session->wish.path,
                                                            .profiles = session->wish.profiles,
                                                            .seed = session->wish.seed,
                                                            .driving = session->wish.driving,
                                                            .jobs = session->wish.jobs});
    session->worker = worker;
    session->crew_worker = crew_worker;
    session->edited = NAN;
    house_history_begin(&session->history, draft_text(draft), draft_revision(draft));
    house_schedule_request(session);
    return session;
}

static void *open_house(const char *path, const LaboratoryOptions *options, Fault *fault) {
    const char *origin = options->origin ? options->origin : path ? path : "";
    return open_session(open_draft(path, options, fault), origin, options, fault);
}

static void *open_proposal(void *context, size_t proposal, Fault *fault) {
    HouseSession *session = house_control_sync(context);
    size_t count;
    const char *doing;
    const Proposal *proposals = editor_proposals(session->editor, &count, &doing);
    if (proposal >= count)
        return NULL;
    const HouseWish *wish = &session->wish;
    LaboratoryOptions options = {.profiles = wish->profiles,
                                 .route = wish->route,
                                 .driving = wish->driving,
                                 .seed = wish->seed,
                                 .jobs = wish->jobs};
    Draft *draft = draft_file_of_text(wish->path, draft_text(session->draft), proposals[proposal].settings,
                                      proposals[proposal].setting_count, fault);
    return open_session(draft, wish->path, &options, fault);
}

static void close_house(void *context) {
    HouseSession *session = context;
    editor_destroy(session->editor);
    if (session->film)
        film_destroy(session->film);
    plan_walls_clear(&session->walls);
    house_schedule_end(session);
    recall_destroy(session->wish.recall);
    house_fall_clear(session);
    house_picture_clear_plots(session);
    scene_clear(&session->plain);
    house_text_clear(session);
    house_value_clear(&session->values);
    house_value_clear(&session->opened);
    draft_destroy(session->draft);
    house_history_clear(&session->history);
    memory_free(session->error.text);
    memory_free(session->command);
    arena_clear(&session->command_arena);
    arena_clear(&session->arena);
    memory_free(session);
}

/* Display --------------------------------------------------------------------------------------------------------- */

/* A crowd is followed by how many are out; where nobody sets off there is nothing to plot. */
static const char *plots_for(const void *context) {
    const HouseSession *session = context;
    const Plan *plan = draft_plan(session->draft);
    size_t people = plan->person_count;
    for (size_t i = 0; i < plan->crowd_count; i++)
        people += (size_t)plan->crowds[i].count;
    bool stands = session->whole && session->observation && session->observation->time <= 0;
    return stands ? "" : people > PEOPLE_SCENE_INDIVIDUALS ? "out,flow" : NULL;
}

static RecordSpan span(const void *context) {
    const HouseSession *session = context;
    return (RecordSpan){.end = house_runs_reach(session),
                        .complete = !house_runs_is_working(session) &&
                                    (session->whole || (!session->runs[RUN_SHOWN] && !session->runs[RUN_LATEST])),
                        .pace = 1,
                        .step = STEP,
                        .fastest = FASTEST};
}

static double reach(void *context, double time) {
    (void)time;
    return house_runs_reach(context);
}

static bool show(void *context, double time) {
    HouseSession *session = house_control_sync(context);
    session->time = time;
    house_picture_make_film(session, time);
    update_editor_scene(session);
    if (!house_picture_has_film(session))
        return false;
    if (session->fresh)
        film_restart(session->film);
    bool onwards = film_show(session->film, time) && !session->fresh;
    session->fresh = false;
    return onwards;
}

static bool is_unchanged(const void *context, double time) {
    const HouseSession *session = context;
    return house_picture_has_film(session) && !session->fresh && !session->fall.count &&
           house_run_epoch(session->runs[RUN_SHOWN], time) == session->epoch && film_is_unchanged(session->film, time);
}

static const Scene *still(void *context) {
    HouseSession *session = house_control_sync(context);
    house_picture_make_film(session, session->time); /* a call since the last update may have made the film stale */
    if (house_picture_has_film(session))
        return film_still(session->film);
    return session->plain.count && !session->runs[RUN_SHOWN] ? &session->plain : &session->nothing;
}

static const Scene *added(const void *context) {
    const HouseSession *session = context;
    return house_picture_has_film(session) ? film_added(session->film) : &session->nothing;
}

static const Scene *moving(const void *context) {
    const HouseSession *session = context;
    return house_picture_has_film(session) ? film_moving(session->film) : &session->nothing;
}

static void set_camera(void *context, Camera camera) {
    HouseSession *session = house_control_sync(context);
    if (camera.kind != session->camera.kind)
        house_picture_void_film(session);
    session->camera = camera;
    session->changed |= LABORATORY_VIEW;
}

static void set_layers(void *context, unsigned layers) {
    HouseSession *session = context;
    if (layers != session->layers)
        house_picture_void_film(session);
    session->layers = layers;
}

static size_t plot_count(const void *context) {
    const HouseSession *session = context;
    return session->plots.made ? HOUSE_PLOTS_KNOWN : 0;
}

static LaboratoryPlot plot(const void *context, size_t index) {
    return house_picture_plot(context, index);
}

static size_t points_until(const void *context, size_t plot, size_t series, double time) {
    const HouseSession *session = context;
    return house_plots_until(&session->plots.plots, plot, series, time);
}

/* Texts ----------------------------------------------------------------------------------------------------------- */

static Result answer(void *context) {
    return house_text_answer(house_control_sync(context));
}

static const char *format_clock(void *context, double time) {
    HouseSession *session = context;
    HouseTexts *texts = &session->texts;
    snprintf(texts->clock, sizeof texts->clock, "%.1f s", time);
    return texts->clock;
}

static void add_note(HouseSession *session, const char *more) {
    char *texts = session->texts.note;
    size_t used = strlen(texts);
    snprintf(texts + used, sizeof session->texts.note - used, "%s%s", used ? "; " : "", more);
}

static const char *note(void *context) {
    HouseSession *session = house_control_sync(context);
    const HouseWish *wish = session->runs[RUN_SHOWN] ? &session->runs[RUN_SHOWN]->wish : NULL;
    const char *picture = editor_image_error(session->editor);
    *session->texts.note = 0;
    if (wish && wish->epoch_count > 1) {
        char mixed[96];
        snprintf(mixed, sizeof mixed, "the plan changed at %.1f s; R runs it from the start",
                 wish->epochs[wish->epoch_count - 1].time);
        add_note(session, mixed);
    }
    if (source_line_is_assumed(draft_plan(session->draft)))
        add_note(session, "assumed plan: not measured");
    if (picture)
        add_note(session, picture);
    return session->texts.note;
}

static const char *title(const void *context) {
    const HouseSession *session = context;
    const char *name = draft_plan(session->draft)->name;
    return *name ? name : "house";
}

static const PanelRow *rows(const void *context, size_t *count) {
    const HouseSession *session = context;
    *count = session->texts.row_count;
    return session->texts.rows;
}

static const TimelineMark *marks(void *context, size_t *count) {
    const HouseSession *session = context;
    *count = session->settles ? 0 : session->texts.mark_count;
    return session->texts.marks;
}

static const char *error(const void *context, double *time) {
    const HouseSession *session = context;
    *time = session->error_time;
    return session->error.text;
}

/* Picking --------------------------------------------------------------------------------------------------------- */

static Item pick(const void *context, Vec2 at, double time, Item below) {
    const HouseSession *session = context;
    HouseScenery scenery = session->runs[RUN_SHOWN] ? scenery_of(session) : (HouseScenery){NULL, NULL, NULL};
    return session->runs[RUN_SHOWN] ? house_item_at(&scenery, at, time, below) : (Item){0, 0};
}

static Item next(const void *context, Item item, int step) {
    const HouseSession *session = context;
    HouseScenery scenery = session->runs[RUN_SHOWN] ? scenery_of(session) : (HouseScenery){NULL, NULL, NULL};
    return session->runs[RUN_SHOWN] ? house_item_next(&scenery, item, step) : (Item){0, 0};
}

static void select_item(void *context, Item item) {
    HouseSession *session = house_control_sync(context);
    bool known = session->runs[RUN_SHOWN] &&
                 item.index < house_item_count(&session->runs[RUN_SHOWN]->house, session->observation, item.kind);
    Item chosen = known ? item : (Item){0, 0};
    house_control_select(session, chosen);
    editor_set_selected(session->editor, chosen);
}

static Item selected(void *context) {
    return house_control_sync(context)->selected;
}

static const char *item_name(void *context, Item item) {
    HouseSession *session = context;
    HouseTexts *texts = &session->texts;
    *texts->name = 0;
    if (session->runs[RUN_SHOWN])
        house_item_name(&session->runs[RUN_SHOWN]->house, session->observation, item, texts->name, sizeof texts->name);
    return texts->name;
}

static const char *name_at(void *context, Item item, Vec2 at) {
    HouseSession *session = context;
    HouseTexts *texts = &session->texts;
    *texts->name = 0;
    if (session->runs[RUN_SHOWN])
        house_item_name_at(&session->runs[RUN_SHOWN]->house, session->observation, item, at, texts->name,
                           sizeof texts->name);
    return texts->name;
}

static const char *item_key(void *context, Item item) {
    HouseSession *session = context;
    HouseTexts *texts = &session->texts;
    *texts->name = 0;
    if (session->runs[RUN_SHOWN])
        house_item_key(&session->runs[RUN_SHOWN]->house, session->observation, item, texts->name, sizeof texts->name);
    return texts->name;
}

/* Returns the outline of an item of the plan as it is edited, of which no run is displayed yet; 0: not of the plan. */
static size_t outline_in_draft(const HouseSession *session, Item item, Vec2 *points) {
    const Plan *plan = draft_plan(session->draft);
    const char *id = house_item_id(&session->runs[RUN_SHOWN]->house, item);
    Item edited = house_item_in(plan, item.kind, id);
    return edited.kind ? house_item_outline_in(plan, edited, points) : 0;
}

static size_t outline(void *context, Item item, double time, Vec2 *points) {
    HouseSession *session = context;
    if (!session->runs[RUN_SHOWN])
        return 0;
    HouseScenery scenery = scenery_of(session);
    size_t count = house_item_outline(&scenery, item, time, points);
    size_t edited = count && house_run_revision(session->runs[RUN_SHOWN]) != draft_revision(session->draft)
                        ? outline_in_draft(session, item, points)
                        : 0;
    count = edited ? edited : count;
    const FurnitureFall *fall = NULL;
    if (count && item.kind == HOUSE_FURNITURE)
        fall = house_fall_find(session, house_item_id(&session->runs[RUN_SHOWN]->house, item));
    if (fall)
        furniture_fall_corners(&fall->piece, furniture_fall_share(fall), points);
    return count;
}

static void animate(void *context, double seconds) {
    house_fall_advance(house_control_sync(context), seconds);
}

static const char *animation(void *context) {
    return house_fall_text(house_control_sync(context));
}

static bool save(void *context, const char *path, Fault *fault) {
    return save_file_house(draft_text(((const HouseSession *)context)->draft), path, fault);
}

static bool sound(void *context, double from, double to, float *samples, size_t count) {
    (void)context;
    (void)from;
    (void)to;
    (void)samples;
    (void)count;
    return false;
}

uint64_t house_session_digest(void *context) {
    const HouseSession *session = house_control_sync(context);
    return session->whole && !session->runs[RUN_LATEST] && !session->runs[RUN_MIXED] ? session->observation->digest : 0;
}

static LaboratoryRuns runs(void *context) {
    HouseSession *session = house_control_sync(context);
    return (LaboratoryRuns){.answer = session->texts_of,
                            .picture = session->film ? session->film_of : 0,
                            .rows = session->texts_of,
                            .plots = session->plots_of,
                            .working = house_runs_is_working(session)};
}

static void stop(void *context) {
    house_schedule_stop(house_control_sync(context));
}

static const char *const layer_names[LAYERS] = {
    [LAYER_RINGS] = "rings",     [LAYER_LOCI] = "paths",      [LAYER_GHOST] = "before", [LAYER_DANGER] = "danger",
    [LAYER_WIDTHS] = "widths",   [LAYER_GRID] = "grid",       [LAYER_NAMES] = "names",  [LAYER_FORCES] = "forces",
    [LAYER_CIRCLES] = "circles", [LAYER_DRIVERS] = "drivers",
};

static const char *const layer_meanings[LAYERS] = {
    [LAYER_RINGS] =
        "Personal spaces, indented where a person or an obstacle is near; of 200 people or more, people on a "
        "square metre as colour.",
    [LAYER_LOCI] = "The paths so far, with a tick for each second and earlier outlines of the bodies.",
    [LAYER_GHOST] = "The saved run, or the other driving model.",
    [LAYER_DANGER] =
        "Tight places, as discs with their rank, and the names of impassable places; without these and the "
        "paths, nothing of the result is drawn.",
    [LAYER_WIDTHS] = "The planned routes, and the widths W1 and W2 before and after each corner.",
    [LAYER_GRID] = "Lines a metre apart.",
    [LAYER_NAMES] = "Names of rooms and furniture, where they have room.",
    [LAYER_FORCES] = "Stars of contacts, with their forces.",
    [LAYER_CIRCLES] = "Discs that cover the chairs, as simpler methods have them.",
    [LAYER_DRIVERS] =
        "100 drivers of different bodies, strengths and skills: the band of their paths (half of them, and 9 "
        "of 10), and discs where they touch something: by area the share of them, by shade the speed, by "
        "letter the part of the chair.",
};

const Laboratory house_laboratory = {
    .name = "House",
    .word = "house",
    .plots_at_first = "speed,clearance",
    .plots_in_order = "speed,clearance,force,ring",
    .layers = layer_names,
    .meanings = layer_meanings,
    .layer_count = LAYERS,
    .layers_at_first = (1u << LAYERS) - 1 - (1u << LAYER_WIDTHS) - (1u << LAYER_CIRCLES) - (1u << LAYER_DRIVERS),
    .raised = true,
    .open = open_house,
    .close = close_house,
    .update = update,
    .tell = tell,
    .span = span,
    .reach = reach,
    .show = show,
    .is_unchanged = is_unchanged,
    .still = still,
    .added = added,
    .moving = moving,
    .set_camera = set_camera,
    .set_layers = set_layers,
    .plots_for = plots_for,
    .plot_count = plot_count,
    .plot = plot,
    .points_until = points_until,
    .answer = answer,
    .clock = format_clock,
    .note = note,
    .title = title,
    .rows = rows,
    .marks = marks,
    .error = error,
    .parameters = house_control_parameters,
    .set = house_control_set,
    .reset = house_control_reset,
    .presets = house_control_presets,
    .apply_preset = house_control_apply_preset,
    .choices = house_control_choices,
    .choose = house_control_choose,
    .runs = runs,
    .stop = stop,
    .restart = house_control_restart,
    .save_run = house_control_save_run,
    .clear_runs = house_control_clear,
    .pick = pick,
    .next = next,
    .select = select_item,
    .selected = selected,
    .item_name = item_name,
    .item_key = item_key,
    .name_at = name_at,
    .outline = outline,
    .command = house_control_command,
    .digest = house_session_digest,
    .save = save,
    .sound = sound,
    .editor = editor,
    .open_proposal = open_proposal,
    .begin_number = house_control_begin_number,
    .end_number = house_control_end_number,
    .animate = animate,
    .animation = animation,
};
