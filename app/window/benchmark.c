#include "window/benchmark.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/order.h"
#include "window/plan_input.h"

#define WARM 3.0     /* s, before the piece is grabbed */
#define PATIENCE 1.0 /* s, to wait for a result */
#define RADIUS 0.15  /* m */
#define ROUND 40     /* steps */
#define MILLI 1000.0
#define NEARER 2.0     /* 1, times the size of the view, while it is moved */
#define PAN_ROUND 4.0  /* s, for a circle */
#define PAN_RADIUS 0.1 /* 1, of the view's width */

/* Dragging --------------------------------------------------------------------------------------------------------- */

/* Selects an item and returns its name if it is furniture; NULL: it is something else. */
static const char *piece_name(Tab *tab, Item item) {
    static const char begin[] = "furniture.", end[] = ".name";
    size_t count;
    tab_select(tab, item);
    const EditText *texts = editor_texts(tab_editor(tab), &count);
    for (size_t i = 0; i < count; i++) {
        size_t length = strlen(texts[i].name);
        if (strncmp(texts[i].name, begin, sizeof begin - 1) == 0 && length >= sizeof end &&
            strcmp(texts[i].name + length - sizeof end + 1, end) == 0)
            return texts[i].value;
    }
    return NULL;
}

/* Returns the first wardrobe, or else the first piece of furniture. */
static Item find_piece(Tab *tab) {
    Item first = tab->laboratory->next(tab->session, (Item){0}, 1), item = first, found = {0};
    do {
        const char *name = item.kind ? piece_name(tab, item) : NULL;
        if (name && strstr(name, "wardrobe"))
            return item;
        if (name && !found.kind)
            found = item;
        item = tab->laboratory->next(tab->session, item, 1);
    } while (item.kind && !item_same(item, first));
    return found;
}

/* Selects the piece to drag and finds its middle, m; false: there is none. */
static bool find_middle(Tab *tab, Vec2 *middle) {
    Vec2 points[LABORATORY_OUTLINE_MOST];
    Item item = find_piece(tab);
    size_t count = item.kind ? tab->laboratory->outline(tab->session, item, tab->player.time, points) : 0;
    tab_select(tab, item);
    *middle = vec2(0, 0);
    for (size_t i = 0; i < count; i++)
        *middle = vec2_along(*middle, 1 / (double)count, points[i]);
    return count > 0;
}

static void push(Window *window, Vec2 floor, SdlWindowKind kind, bool down) {
    const Tab *tab = window_tab(window);
    Vec2 at = vec2_add(window->frame.view.low, view_layers_point(&tab->view_layers, floor));
    SdlWindowEvent event = {
        .kind = kind, .at = vec2_scale(at, window->unit), .button = SDL_WINDOW_EVENT_LEFT, .down = down};
    sdl_window_push(window->sdl_window, &event);
}

/* Grabs the piece; false: there is nothing to drag. */
static bool begin_edits(Window *window) {
    EditBenchmark *benchmark = &window->edit_benchmark;
    Tab *tab = window_tab(window);
    if (!tab_editor(tab) || !find_middle(tab, &benchmark->middle))
        return false;
    push(window, benchmark->middle, SDL_WINDOW_EVENT_MOUSE, false);
    push(window, benchmark->middle, SDL_WINDOW_EVENT_BUTTON, true);
    benchmark->begun = stopwatch_now();
    frame_timer_count(&window->frame_timer);
    return true;
}

static void step(Window *window) {
    EditBenchmark *benchmark = &window->edit_benchmark;
    double angle = 2 * M_PI * (double)benchmark->steps++ / ROUND;
    Vec2 away = vec2_sub(vec2_scale(vec2_heading(angle), RADIUS), vec2(RADIUS, 0));
    benchmark->revision = editor_revision(tab_editor(window_tab(window)));
    push(window, vec2_add(benchmark->middle, away), SDL_WINDOW_EVENT_MOUSE, false);
    benchmark->waits = true;
    benchmark->frames = 0;
}

/* Results ---------------------------------------------------------------------------------------------------------- */

static double part_of(const double *sorted, size_t count, double part) {
    return count ? sorted[(size_t)(part * (double)(count - 1))] : NAN;
}

static void print_edits(Window *window) {
    EditBenchmark *benchmark = &window->edit_benchmark;
    FrameTimer *frames = &window->frame_timer;
    qsort(benchmark->answers, benchmark->count, sizeof *benchmark->answers, order_rising);
    qsort(frames->times, frames->count, sizeof *frames->times, order_rising);
    double median = MILLI * part_of(benchmark->answers, benchmark->count, 0.5);
    double late = MILLI * part_of(benchmark->answers, benchmark->count, 0.99);
    double frame = MILLI * part_of(frames->times, frames->count, 0.5);
    double slow = MILLI * part_of(frames->times, frames->count, 0.99);
    double longest = MILLI * part_of(frames->times, frames->count, 1);
    FrameMachine machine = frame_timer_machine(frames);
    printf("%s, %d x %d, dragged for %.1f s: %zu edits, %zu unanswered (%zu steps moved nothing, since pieces snap); "
           "from an edit to its answer on the screen %.1f ms (median), %.1f ms (99 of 100); a frame takes %.1f ms "
           "(median), %.1f ms (99 of 100), %.1f ms (longest); "
           "used %.2f of %ld processors, load %.1f\n",
           window_tab(window)->laboratory->title(window_tab(window)->session), window->width, window->height,
           stopwatch_now() - benchmark->begun, benchmark->count + benchmark->missed, benchmark->missed,
           benchmark->unmoved, median, late, frame, slow, longest, machine.used, machine.processors, machine.load);
    if (benchmark->count && frames->count)
        printf("{\"edits\":%zu,\"unanswered\":%zu,\"answer_ms\":{\"median\":%.3f,\"p99\":%.3f},\"frame_ms\":"
               "{\"median\":%.3f,\"p99\":%.3f,\"longest\":%.3f},\"used\":%.3f,\"processors\":%ld,\"load\":%.2f}\n",
               benchmark->count + benchmark->missed, benchmark->missed, median, late, frame, slow, longest,
               machine.used, machine.processors, machine.load);
}

/* Records the delay of the last step's result, or that it did not come in time. The first frame after a step still
 * shows the old result: it is the frame in which the pointer moved. */
static void look(Window *window) {
    EditBenchmark *benchmark = &window->edit_benchmark;
    Tab *tab = window_tab(window);
    double now = stopwatch_now();
    if (benchmark->frames++ == 0) {
        benchmark->edited = window->frame_timer.last; /* the beginning of that frame */
        benchmark->waits = editor_revision(tab_editor(tab)) != benchmark->revision;
        benchmark->unmoved += !benchmark->waits;
        return;
    }
    if (!tab->laboratory->answer(tab->session).due) {
        benchmark->answers =
            memory_reserve(benchmark->answers, &benchmark->capacity, benchmark->count + 1, sizeof *benchmark->answers);
        benchmark->answers[benchmark->count++] = now - benchmark->edited;
        benchmark->waits = false;
    } else if (now - benchmark->edited > PATIENCE) {
        benchmark->missed++;
        benchmark->waits = false;
    }
}

static bool advance_edits(Window *window, double begun) {
    EditBenchmark *benchmark = &window->edit_benchmark;
    double now = stopwatch_now();
    if (benchmark->begun <= 0)
        return now - begun > WARM && !begin_edits(window);
    if (benchmark->waits)
        look(window);
    if (!benchmark->waits && now - benchmark->begun <= window->options->benchmark_edit)
        step(window);
    if (now - benchmark->begun <= window->options->benchmark_edit)
        return false;
    print_edits(window);
    return true;
}

/* The window ------------------------------------------------------------------------------------------------------- */

static Vec2 view_size(const Window *window) {
    return vec2_sub(window->frame.view.high, window->frame.view.low);
}

/* Moves the view on along its circle. */
static void pan(Window *window) {
    Tab *tab = window_tab(window);
    Vec2 side = vec2(view_size(window).x, 0);
    double width =
        vec2_distance(view_layers_floor(&tab->view_layers, vec2(0, 0)), view_layers_floor(&tab->view_layers, side));
    double now = stopwatch_now() - window->frame_timer.begun, before = window->panned;
    Vec2 from = vec2_heading(2 * M_PI * before / PAN_ROUND), to = vec2_heading(2 * M_PI * now / PAN_ROUND);
    tab_pan(tab, vec2_scale(vec2_sub(to, from), PAN_RADIUS * width));
    window->panned = now;
}

static bool advance_window(Window *window, double begun) {
    FrameTimer *timer = &window->frame_timer;
    Tab *tab = window_tab(window);
    bool done = frame_timer_advance(timer, stopwatch_now() - begun, window->options->benchmark);
    if (!done && window->pans)
        pan(window);
    if (done && window->pans)
        frame_timer_print_pans(timer);
    if (!done || window->pans)
        return done;
    frame_timer_print(timer, tab->laboratory->title(tab->session), window->width, window->height);
    tab_zoom(tab, NEARER, vec2_scale(view_size(window), 0.5));
    window->pans = true;
    frame_timer_count(timer);
    return false;
}

bool benchmark_hurries(const Window *window) {
    return window->frame_timer.counting && window->options->benchmark > 0;
}

bool benchmark_moves(const Window *window) {
    return window->pans || window->options->benchmark_edit > 0;
}

bool benchmark_advance(Window *window, double begun) {
    return (window->options->benchmark_edit > 0 && advance_edits(window, begun)) ||
           (window->options->benchmark > 0 && advance_window(window, begun));
}

void benchmark_clear(Window *window) {
    memory_free(window->edit_benchmark.answers);
}
