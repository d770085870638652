#include "teaching/lesson_sheet.h"

#include <string.h>

#include "base/text.h"
#include "house/run.h"
#include "laboratory/thumbnail.h"
#include "lesson/words.h"
#include "visual/house/house_scene.h"
#include "visual/house/plan_picture.h"

/* Design points. */
#define PICTURE_WIDTH 480.0
#define PICTURE_HEIGHT 300.0
#define BEAM_HEIGHT 130.0
#define RESULT_WIDTH 1020.0 /* the whole width of a page */
#define RESULT_HEIGHT 640.0

/* As wide as the page. */
#define LINE "________________________________________________________________________________________________"

enum { ROW_LONGEST = 120 /* bytes of options that stand in one line */ };

typedef struct Sheet {
    const Lesson *lesson;
    const SheetOptions *options;
    Document document;
    Fault *fault;
} Sheet;

static const char *filled(Sheet *sheet, const char *text) {
    return words_fill(sheet->lesson, text, &sheet->document.arena);
}

static void add_line(Sheet *sheet, const char *before, const char *text) {
    document_add_paragraph(&sheet->document, document_text(&sheet->document, "%s%s", before, filled(sheet, text)));
}

static void add_texts(Sheet *sheet, const char *heading, const LessonTexts *texts) {
    if (!texts->count)
        return;
    document_add_heading(&sheet->document, 2, heading);
    for (size_t i = 0; i < texts->count; i++)
        add_line(sheet, "\u2022 ", texts->at[i]);
}

/* How the lesson is opened, and its keys: a sheet has to be enough. */
static void add_keys(Sheet *sheet) {
    static const char *const keys[] = {
        "PgDn goes on, as a presenter's remote does, and PgUp goes back.",
        "1 to 9 count a raised hand for that guess, Backspace takes it back, 0 begins a second vote.",
        "A guess that is a number is typed, with Return after each.",
        "? gives a hint. Ctrl+Z takes a change back, Ctrl+R starts the step again.",
        "C folds the card. F1 tells all keys, F5 enlarges the letters.",
    };
    document_add_heading(&sheet->document, 2, "Keys");
    add_line(sheet, "\u2022 ",
             document_text(&sheet->document, "Start the program, press Ctrl+L, and choose \u201c%s\u201d.",
                           sheet->lesson->title));
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        add_line(sheet, "\u2022 ", keys[i]);
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static bool read_house(House *house, Sheet *sheet, const char *set, Arena *arena) {
    const char *settings[LESSON_SETTINGS_MOST];
    size_t count = lesson_add_settings(sheet->lesson->set, settings, 0, arena);
    count = lesson_add_settings(set, settings, count, arena);
    HouseOptions options = {
        .profiles = sheet->options->profiles, .settings = settings, .setting_count = count, .seed = 1, .driving = -1};
    return house_read(house, sheet->lesson->file, &options, sheet->fault);
}

/* Fills the scene of the start and returns its height; 0: there is no picture. */
static double make_start(Sheet *sheet, Scene *scene) {
    Arena arena = {0};
    double height = 0;
    if (sheet->lesson->laboratory == LESSON_HOUSE) {
        House house = {0};
        if (read_house(&house, sheet, "", &arena)) {
            plan_picture_make(scene, &house, sheet->lesson->names);
            scene->title = scene->note = ""; /* the sheet has its own */
            scene->bare = true;
            height = PICTURE_HEIGHT;
        }
        house_free(&house);
    } else {
        Thumbnail thumbnail = {.name = NULL};
        bool beam = sheet->lesson->laboratory == LESSON_BEAM;
        if ((beam ? thumbnail_read_beam : thumbnail_read_crank)(&thumbnail, sheet->lesson->file, sheet->fault)) {
            *scene = thumbnail.scene;
            thumbnail.scene = (Scene){0};
            height = beam ? BEAM_HEIGHT : PICTURE_HEIGHT;
        }
        thumbnail_clear(&thumbnail);
    }
    arena_clear(&arena);
    return height;
}

static void add_start(Sheet *sheet) {
    Scene scene = {0};
    double height = make_start(sheet, &scene);
    if (height > 0) {
        document_add_figures(&sheet->document);
        document_add_scene(&sheet->document, &scene, vec2(PICTURE_WIDTH, height), "The start",
                           document_text(&sheet->document, "Start of the lesson: %s", sheet->lesson->title));
    }
}

static void add_result(Sheet *sheet, const LessonPicture *picture) {
    House house = {0};
    Arena arena = {0};
    if (read_house(&house, sheet, picture->set, &arena)) {
        Scene scene = {0};
        Observation observation;
        RunOptions run = {.route = SIZE_MAX, .jobs = sheet->options->jobs};
        run_house(&observation, &house, &run);
        house_scene_make(&scene, &house, &observation);
        observation_free(&observation);
        const char *caption = filled(sheet, picture->caption);
        document_add_figures(&sheet->document);
        document_add_scene(&sheet->document, &scene, vec2(RESULT_WIDTH, RESULT_HEIGHT), caption, caption);
    }
    house_free(&house);
    arena_clear(&arena);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* Adds short options in one line, to be ticked; false: they are too long. */
static bool add_row(Sheet *sheet, const LessonStep *step) {
    const char *row = "";
    for (size_t o = 0; o < step->options.count; o++)
        row = document_text(&sheet->document, "%s%s[ %s ] %zu:\u00a0%s", row, o ? "\u2003\u2003" : "",
                            sheet->options->answers && step->truth == (int)o + 1 ? "x" : "  ", o + 1,
                            filled(sheet, step->options.at[o]));
    if (!*row || strlen(row) > ROW_LONGEST)
        return false;
    document_add_paragraph(&sheet->document, row);
    return true;
}

static void add_options(Sheet *sheet, const LessonStep *step) {
    if (!(sheet->options->answers && step->wrong.count) && add_row(sheet, step))
        return;
    for (size_t o = 0; o < step->options.count; o++) {
        bool right = sheet->options->answers && step->truth == (int)o + 1;
        document_add_paragraph(&sheet->document, document_text(&sheet->document, "[ %s ]  %zu  %s", right ? "x" : "   ",
                                                               o + 1, filled(sheet, step->options.at[o])));
        if (sheet->options->answers && step->wrong.count && *step->wrong.at[o])
            add_line(sheet, "Who says so may be told: ", step->wrong.at[o]);
    }
}

static void add_lines(Sheet *sheet, int count) {
    for (int i = 0; i < count; i++)
        document_add_paragraph(&sheet->document, LINE);
}

static void add_table(Sheet *sheet, const LessonTable *table) {
    if (!table->head.count)
        return;
    Column *columns = arena_allocate(&sheet->document.arena, table->head.count * sizeof *columns);
    for (size_t c = 0; c < table->head.count; c++)
        columns[c] = (Column){filled(sheet, table->head.at[c]), c ? ALIGN_RIGHT : ALIGN_LEFT};
    document_add_table(&sheet->document, NULL, columns, table->head.count);
    for (size_t r = 0; r < table->row_count; r++) {
        const char **cells = arena_allocate(&sheet->document.arena, table->head.count * sizeof *cells);
        for (size_t c = 0; c < table->head.count; c++) {
            const char *text = table->rows[r].at[c];
            bool blank = !sheet->options->answers && words_has_number(text);
            cells[c] = blank ? "______" : filled(sheet, text);
        }
        document_add_row(&sheet->document, cells);
    }
}

static void add_answers(Sheet *sheet, const LessonStep *step) {
    Document *document = &sheet->document;
    for (size_t h = 0; h < step->hints.count; h++)
        add_line(sheet, document_text(document, "Hint %zu: ", h + 1), step->hints.at[h]);
    for (size_t g = 0; g < step->goal_count; g++)
        document_add_paragraph(document, document_text(document, "The program checks %s: %s",
                                                       words_goal(&step->goals[g], &document->arena),
                                                       words_limits(&step->goals[g], &document->arena)));
    if (*step->done)
        add_line(sheet, "When it is reached: ", step->done);
    if (*step->model)
        add_line(sheet, "Model answer: ", step->model);
}

static void add_step(Sheet *sheet, const LessonStep *step, size_t number) {
    const char *title = lesson_kind_title((LessonKind)step->kind);
    bool timed = sheet->options->answers && step->minutes;
    document_add_heading(&sheet->document, 2,
                         timed ? document_text(&sheet->document, "%zu  %s (%d min)", number, title, step->minutes)
                               : document_text(&sheet->document, "%zu  %s", number, title));
    bool tells = step->kind == LESSON_COMPARE && !sheet->options->answers; /* what the class guesses first */
    if (tells)
        document_add_paragraph(&sheet->document, "We guessed: ____________________     It was: ____________________");
    else if (*step->text)
        add_line(sheet, "", step->text);
    if (*step->ask)
        add_line(sheet, "", step->ask);
    if (*step->unit)
        document_add_paragraph(&sheet->document,
                               sheet->options->answers
                                   ? document_text(&sheet->document, "The answer: %s",
                                                   words_value(step->answer, -1, step->unit, &sheet->document.arena))
                                   : document_text(&sheet->document, "We guess: ____________ %s",
                                                   strcmp(step->unit, "1") ? step->unit : ""));
    add_options(sheet, step);
    add_table(sheet, &step->table);
    if (sheet->options->answers)
        add_answers(sheet, step);
    else if (step->kind == LESSON_EXPLAIN || step->kind == LESSON_TRANSFER)
        add_lines(sheet, 2);
    else if (step->kind == LESSON_TASK && !step->table.head.count)
        add_lines(sheet, 1);
}

Document lesson_sheet_make(const Lesson *lesson, const SheetOptions *options, Fault *fault) {
    Sheet sheet = {.lesson = lesson, .options = options, .document = document_begin(options->program), .fault = fault};
    Document *document = &sheet.document;
    document_add_title(document,
                       document_text(document, "%s, %s, %d minutes", options->answers ? "For the teacher" : "Lesson",
                                     lesson->level, lesson->minutes),
                       lesson->title);
    if (!options->answers)
        document_add_paragraph(document, "Name: ______________________________     Date: _______________");
    if (options->answers) {
        add_texts(&sheet, "What they learn", &lesson->learn);
        add_texts(&sheet, "Before", &lesson->before);
        add_keys(&sheet);
    }
    add_start(&sheet);
    for (size_t s = 0; s < lesson->step_count; s++)
        add_step(&sheet, &lesson->steps[s], s + 1);
    if (options->answers) {
        add_texts(&sheet, "Mistakes to expect", &lesson->mistakes);
        add_texts(&sheet, "More questions", &lesson->questions);
        if (lesson->picture_count && lesson->laboratory == LESSON_HOUSE)
            document_add_heading(document, 2, "If the projector fails");
        for (size_t p = 0; p < lesson->picture_count && lesson->laboratory == LESSON_HOUSE; p++)
            add_result(&sheet, &lesson->pictures[p]);
    }
    return sheet.document;
}
