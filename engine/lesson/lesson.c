#include "lesson/lesson.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/parameters_schema.h"
#include "base/text.h"
#include "lesson/language.h"
#include "lesson/look.h"
#include "lesson/names.h"
#include "lesson/person.h"
#include "lesson/words.h"

#define LABORATORY_WORDS "house|beam|crank"
#define KIND_WORDS "read|predict|observe|task|explain|compare|transfer"

static const struct {
    const char *word, *title;
} kinds[LESSON_KINDS] = {
    [LESSON_READ] = {"read", "Read"},
    [LESSON_PREDICT] = {"predict", "Your guess first"},
    [LESSON_OBSERVE] = {"observe", "Watch"},
    [LESSON_TASK] = {"task", "Your turn"},
    [LESSON_EXPLAIN] = {"explain", "Explain"},
    [LESSON_COMPARE] = {"compare", "Guesses and result"},
    [LESSON_TRANSFER] = {"transfer", "And elsewhere?"},
};

const char *lesson_kind_word(LessonKind kind) {
    return kinds[kind].word;
}

const char *lesson_kind_title(LessonKind kind) {
    return kinds[kind].title;
}

/* Tables ----------------------------------------------------------------------------------------------------------- */

#define TEXT CONDITION_TEXT
#define CHOICE(struct_, field_, name_, choices_, meaning_)                                                             \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_CHOICE, .offset = offsetof(struct_, field_), .unit = "", .needed = true,      \
        .choices = choices_, .meaning = meaning_                                                                       \
    }
#define WHOLE(struct_, field_, name_, low_, high_, fallback_, meaning_)                                                \
    {                                                                                                                  \
        .name = name_, .kind = PARAMETER_WHOLE, .offset = offsetof(struct_, field_), .unit = "1", .low = low_,         \
        .high = high_, .fallback = fallback_, .meaning = meaning_                                                      \
    }
#define TABLE(name_, rows_)                                                                                            \
    { name_, rows_, sizeof rows_ / sizeof *rows_ }

static const Parameter lesson_rows[] = {
    TEXT(Lesson, title, "title", PARAMETER_TEXT, true, "title"),
    CHOICE(Lesson, laboratory, "laboratory", LABORATORY_WORDS, "kind of the file"),
    WHOLE(Lesson, minutes, "minutes", 1, 240, 20, "time that a class needs"),
    TEXT(Lesson, level, "level", PARAMETER_TEXT, true, "whom it is for"),
    TEXT(Lesson, file, "file", PARAMETER_TEXT, true, "house, beam or crank, from the lesson's folder"),
    TEXT(Lesson, set, "set", PARAMETER_TEXT, false, "settings NAME=VALUE NAME=VALUE ..."),
    TEXT(Lesson, script, "script", PARAMETER_TEXT, true, "script that tries the lesson, from the lesson's folder"),
    {.name = "names",
     .kind = PARAMETER_FLAG,
     .offset = offsetof(Lesson, names),
     .unit = "1",
     .meaning = "each piece of a house has its name in the view, with a line to it if need be"},
};
static const Parameter step_rows[] = {
    CHOICE(LessonStep, kind, "kind", KIND_WORDS, "kind of the step"),
    TEXT(LessonStep, text, "text", PARAMETER_TEXT, false, "text"),
    TEXT(LessonStep, ask, "ask", PARAMETER_TEXT, false, "question"),
    TEXT(LessonStep, model, "model", PARAMETER_TEXT, false, "model answer"),
    TEXT(LessonStep, done, "done", PARAMETER_TEXT, false, "said when the goal is reached"),
    TEXT(LessonStep, set, "set", PARAMETER_TEXT, false, "settings with which the step begins"),
    WHOLE(LessonStep, truth, "truth", 0, LESSON_OPTIONS_MOST, 0, "right option, from 1; 0: there is none"),
    TEXT(LessonStep, unit, "unit", PARAMETER_TEXT, false, "unit of a guess that is a number, 1 of one without"),
    CONDITION_NUMBER(LessonStep, answer, "answer", "", 0, 1e9, HUGE_VAL, "right number, in this unit"),
    CONDITION_NUMBER(LessonStep, speed, "speed", "1", 0.0625, 64, HUGE_VAL,
                     "speed of playback, else that of the view, 1"),
    CONDITION_NUMBER(LessonStep, from, "from", "s", 0, 3600, 0, "time from which it is watched"),
    WHOLE(LessonStep, minutes, "minutes", 0, 240, 0, "time that a class needs for the step; 0: not said"),
    TEXT(LessonStep, show, "show", PARAMETER_TEXT, false, "thing of a house that the view shows near"),
};
static const Parameter goal_rows[] = {
    CONDITION_ROWS(LessonGoal, condition),
    TEXT(LessonGoal, than, "than", PARAMETER_TEXT, false, "settings; the value is the ratio to that with them"),
};
static const Parameter number_rows[] = {
    TEXT(LessonNumber, name, "name", PARAMETER_ID, true, "name in texts, {name}"),
    TEXT(LessonNumber, set, "set", PARAMETER_TEXT, false, "settings NAME=VALUE NAME=VALUE ..."),
    TEXT(LessonNumber, than, "than", PARAMETER_TEXT, false, "settings; the number is the ratio to that with them"),
    TEXT(LessonNumber, condition.measure_name, "measure", PARAMETER_TEXT, true, "name of the measure"),
    TEXT(LessonNumber, condition.question.of, "of", PARAMETER_IDS, false, "people and crowds; absent: all people"),
    TEXT(LessonNumber, condition.unit, "unit", PARAMETER_TEXT, true, "unit, 1 of a number or a ratio"),
    WHOLE(LessonNumber, digits, "digits", 0, 6, 0, "digits behind the point"),
    CONDITION_NUMBER(LessonNumber, condition.low, "low", "", -1e9, 1e9, -HUGE_VAL, "the lesson holds from here on"),
    CONDITION_NUMBER(LessonNumber, condition.high, "high", "", -1e9, 1e9, HUGE_VAL, "the lesson holds up to here"),
};
static const Parameter picture_rows[] = {
    TEXT(LessonPicture, caption, "caption", PARAMETER_TEXT, true, "what it shows"),
    TEXT(LessonPicture, set, "set", PARAMETER_TEXT, false, "settings NAME=VALUE NAME=VALUE ..."),
};
static const ParameterTable lesson_table = TABLE("lesson", lesson_rows), step_table = TABLE("step", step_rows),
                            goal_table = TABLE("goal", goal_rows), number_table = TABLE("number", number_rows),
                            picture_table = TABLE("picture", picture_rows);

/* Reading ---------------------------------------------------------------------------------------------------------- */

typedef struct Reader {
    Lesson *lesson;
    Fault *fault;
    Names checker;
    bool checks; /* the names can be checked: the lesson's file was read */
} Reader;

static JsonNode list_of(const Reader *reader, const JsonNode *object, const char *key) {
    JsonNode list = json_member(object, key);
    if (list.value && !json_is_array(list.value)) {
        json_fault(&list, reader->fault, "%s must be a list [ ... ]", key);
        list.value = NULL;
    }
    return list;
}

/* Reads the elements of a list as texts. */
static LessonTexts texts_in(Reader *reader, const JsonNode *list) {
    LessonTexts texts = {.count = json_array_size(list->value)};
    texts.at = arena_allocate(&reader->lesson->arena, (texts.count + 1) * sizeof *texts.at);
    for (size_t i = 0; i < texts.count; i++) {
        JsonNode element = json_element(list, i);
        const char *text = json_string_value(element.value);
        if (!text)
            json_fault(&element, reader->fault, "must be a text");
        texts.at[i] = arena_text(&reader->lesson->arena, text ? text : "");
    }
    return texts;
}

static LessonTexts read_texts(Reader *reader, const JsonNode *object, const char *key) {
    JsonNode list = list_of(reader, object, key);
    return texts_in(reader, &list);
}

/* Reads the rows of a table from an object with further members (more, NULL-ended). */
static void read_rows(Reader *reader, const ParameterTable *table, void *object, const JsonNode *node,
                      const char *const *more) {
    const char *keys[40];
    size_t count = 0;
    parameters_reset(table, object);
    if (!json_is_object(node->value)) {
        json_fault(node, reader->fault, "%s must be an object { ... }", table->what);
        return;
    }
    for (; more[count]; count++)
        keys[count] = more[count];
    for (size_t r = 0; r < table->count; r++)
        keys[count++] = table->rows[r].name;
    keys[count] = NULL;
    json_check_keys(node, keys, reader->fault);
    for (size_t r = 0; r < table->count; r++) {
        JsonNode member = json_member(node, table->rows[r].name);
        if (member.value)
            parameters_read_value(&table->rows[r], object, &member, &reader->lesson->arena, reader->fault);
        else if (table->rows[r].needed)
            json_fault(node, reader->fault, "%s has no \"%s\" (%s)", table->what, table->rows[r].name,
                       table->rows[r].meaning);
    }
}

static const char *beside(Lesson *lesson, const char *file) {
    const char *slash = strrchr(lesson->path, '/');
    int length = slash && *file != '/' ? (int)(slash - lesson->path) + 1 : 0;
    return text_in_arena(&lesson->arena, "%.*s%s", length, lesson->path, file);
}

size_t lesson_add_settings(const char *set, const char **settings, size_t count, Arena *arena) {
    for (const char *at = set + strspn(set, " "); *at && count < LESSON_SETTINGS_MOST; at += strspn(at, " ")) {
        size_t length = strcspn(at, " ");
        settings[count++] = text_in_arena(arena, "%.*s", (int)length, at);
        at += length;
    }
    return count;
}

/* Adds faults for settings that the lesson's file does not take. */
static void check_set(Reader *reader, const JsonNode *node, const char *key, const char *set) {
    const char *settings[LESSON_SETTINGS_MOST];
    Names tried;
    Fault faults = {0};
    Lesson *lesson = reader->lesson;
    if (!reader->checks || !*set)
        return;
    size_t count = lesson_add_settings(lesson->set, settings, 0, &lesson->arena);
    count = lesson_add_settings(set, settings, count, &lesson->arena);
    JsonNode member = json_member(node, key);
    if (names_open(&tried, lesson, settings, count, &faults))
        names_close(&tried, lesson);
    for (size_t l = 0; l < faults.count; l++)
        json_fault(&member, reader->fault, "%s", faults.lines[l]);
    fault_clear(&faults);
}

static void check_condition(Reader *reader, Condition *condition, const char *than, const JsonNode *node) {
    if (!reader->checks || !*condition->measure_name)
        return;
    const char *unit = names_unit(&reader->checker, reader->lesson, condition, node, reader->fault);
    if (!unit)
        return;
    condition_check_unit(condition, *than ? "1" : unit, node, reader->fault);
    if (condition->measure)
        condition_check_needs(condition, node, reader->fault);
    if (reader->lesson->laboratory != LESSON_HOUSE)
        return;
    condition_check_people(&condition->question.of, "of", &reader->checker.plan, node, reader->fault);
    condition_check_people(&condition->question.past, "past", &reader->checker.plan, node, reader->fault);
    condition_check_exit(condition, &reader->checker.plan, node, reader->fault);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static void read_goals(Reader *reader, LessonStep *step, const JsonNode *node) {
    static const char *const more[] = {"is", NULL};
    JsonNode list = list_of(reader, node, "goal");
    size_t count = json_array_size(list.value);
    if (count > LESSON_OPTIONS_MOST) {
        json_fault(&list, reader->fault, "goal has %zu conditions, must have at most %d", count, LESSON_OPTIONS_MOST);
        count = 0;
    }
    step->goal_count = count;
    step->goals = arena_allocate(&reader->lesson->arena, (count + 1) * sizeof *step->goals);
    for (size_t g = 0; g < count; g++) {
        JsonNode element = json_element(&list, g);
        LessonGoal *goal = &step->goals[g];
        size_t before = reader->fault->total;
        read_rows(reader, &goal_table, goal, &element, more);
        if (reader->fault->total != before)
            continue;
        person_read(goal, reader->lesson, step, reader->checks ? &reader->checker : NULL, &element, reader->fault);
        if (!person_has(goal->condition.measure_name))
            check_condition(reader, &goal->condition, goal->than, &element);
        condition_check_limits(&goal->condition, "a condition", &element, reader->fault);
        check_set(reader, &element, "than", goal->than);
    }
}

static void read_table(Reader *reader, LessonStep *step, const JsonNode *node) {
    static const char *const keys[] = {"head", "rows", NULL};
    JsonNode table = json_member(node, "table");
    if (!table.value)
        return;
    if (!json_is_object(table.value)) {
        json_fault(&table, reader->fault, "table must be an object { ... }");
        return;
    }
    json_check_keys(&table, keys, reader->fault);
    step->table.head = read_texts(reader, &table, "head");
    JsonNode rows = list_of(reader, &table, "rows");
    step->table.row_count = json_array_size(rows.value);
    step->table.rows = arena_allocate(&reader->lesson->arena, (step->table.row_count + 1) * sizeof *step->table.rows);
    for (size_t r = 0; r < step->table.row_count; r++) {
        JsonNode row = json_element(&rows, r);
        step->table.rows[r] = texts_in(reader, &row);
        if (step->table.rows[r].count != step->table.head.count)
            json_fault(&row, reader->fault, "the row has %zu cells, must have %zu as the head",
                       step->table.rows[r].count, step->table.head.count);
    }
}

static void need(Reader *reader, const LessonStep *step, const JsonNode *node, const char *text, const char *key) {
    if (!*text)
        json_fault(node, reader->fault, "a step \"%s\" needs \"%s\"", lesson_kind_word((LessonKind)step->kind), key);
}

static void check_options(Reader *reader, const LessonStep *step, const JsonNode *node) {
    JsonNode options = json_member(node, "options"), truth = json_member(node, "truth");
    bool asks = (step->kind == LESSON_PREDICT && !*step->unit) || (step->kind == LESSON_OBSERVE && *step->ask);
    if (asks && (step->options.count < 2 || step->options.count > LESSON_OPTIONS_MOST))
        json_fault(options.value ? &options : node, reader->fault, "a question has %zu options, must have 2 to %d",
                   step->options.count, LESSON_OPTIONS_MOST);
    else if (asks && (step->truth < 1 || (size_t)step->truth > step->options.count))
        json_fault(truth.value ? &truth : node, reader->fault, "truth is %d, must be an option, 1 to %zu", step->truth,
                   step->options.count);
    if (!asks && step->options.count)
        json_fault(&options, reader->fault, "a step \"%s\"%s has no options", lesson_kind_word((LessonKind)step->kind),
                   *step->unit ? " with a unit" : "");
    JsonNode wrong = json_member(node, "wrong");
    if (step->wrong.count && step->wrong.count != step->options.count)
        json_fault(&wrong, reader->fault, "wrong has %zu texts, must have one for each of the %zu options",
                   step->wrong.count, step->options.count);
}

/* Adds faults for a guess that is a number. */
static void check_number_guess(Reader *reader, const LessonStep *step, const JsonNode *node) {
    JsonNode unit = json_member(node, "unit"), answer = json_member(node, "answer");
    bool answered = step->answer < HUGE_VAL;
    if (*step->unit && step->kind != LESSON_PREDICT)
        json_fault(&unit, reader->fault, "only a step \"predict\" has a unit, of a guess that is a number");
    else if (*step->unit && !answered)
        json_fault(node, reader->fault, "a guess in %s needs \"answer\", the right number", step->unit);
    else if (!*step->unit && answered)
        json_fault(&answer, reader->fault, "an answer needs \"unit\", 1 if it is a number without one");
}

static void check_step(Reader *reader, const LessonStep *step, const JsonNode *node) {
    check_number_guess(reader, step, node);
    check_options(reader, step, node);
    JsonNode hints = json_member(node, "hints");
    if (step->hints.count != 0 && step->hints.count != LESSON_HINTS)
        json_fault(&hints, reader->fault, "there are %zu hints, must be %d: a question, a place, the action",
                   step->hints.count, LESSON_HINTS);
    if (step->kind == LESSON_TASK) {
        need(reader, step, node, step->text, "text");
        need(reader, step, node, step->goal_count ? "x" : "", "goal");
        need(reader, step, node, step->hints.count ? "x" : "", "hints");
        need(reader, step, node, step->done, "done");
    } else if (step->goal_count) {
        JsonNode goal = json_member(node, "goal");
        json_fault(&goal, reader->fault, "only a step \"task\" has a goal");
    }
    if (step->kind == LESSON_PREDICT || step->kind == LESSON_EXPLAIN)
        need(reader, step, node, step->ask, "ask");
    if (step->kind == LESSON_EXPLAIN)
        need(reader, step, node, step->model, "model");
    if (step->kind == LESSON_READ || step->kind == LESSON_COMPARE || step->kind == LESSON_TRANSFER)
        need(reader, step, node, step->text, "text");
}

/* Adds faults for names of things that the view does not have. */
static void check_things(Reader *reader, const LessonStep *step, const JsonNode *node) {
    JsonNode marks = json_member(node, "mark"), show = json_member(node, "show");
    if (!reader->checks)
        return;
    for (size_t m = 0; m < step->mark.count; m++) {
        JsonNode mark = json_element(&marks, m);
        names_check_thing(&reader->checker, reader->lesson, step->mark.at[m], true, &mark, reader->fault);
    }
    if (*step->show)
        names_check_thing(&reader->checker, reader->lesson, step->show, false, &show, reader->fault);
}

static void read_step(Reader *reader, LessonStep *step, const JsonNode *node) {
    static const char *const more[] = {"options", "wrong", "hints", "goal", "table", "mark", "view", NULL};
    size_t before = reader->fault->total;
    read_rows(reader, &step_table, step, node, more);
    if (!json_is_object(node->value))
        return;
    step->options = read_texts(reader, node, "options");
    step->wrong = read_texts(reader, node, "wrong");
    step->hints = read_texts(reader, node, "hints");
    step->mark = read_texts(reader, node, "mark");
    check_things(reader, step, node);
    look_read(&step->view, reader->lesson, node, reader->fault);
    double speed = look_of_step(reader->lesson, step).speed;
    if (!(step->speed < HUGE_VAL))
        step->speed = speed > 0 ? speed : 1;
    read_goals(reader, step, node);
    read_table(reader, step, node);
    if (reader->fault->total == before)
        check_step(reader, step, node);
    check_set(reader, node, "set", step->set);
}

/* Numbers and pictures --------------------------------------------------------------------------------------------- */

static void read_numbers(Reader *reader, const JsonNode *root) {
    JsonNode list = list_of(reader, root, "numbers");
    Lesson *lesson = reader->lesson;
    lesson->number_count = json_array_size(list.value);
    lesson->numbers = arena_allocate(&lesson->arena, (lesson->number_count + 1) * sizeof *lesson->numbers);
    for (size_t n = 0; n < lesson->number_count; n++) {
        JsonNode element = json_element(&list, n), name = json_member(&element, "name");
        LessonNumber *number = &lesson->numbers[n];
        size_t before = reader->fault->total;
        parameters_read(&number_table, number, &element, &lesson->arena, reader->fault);
        number->condition.question.last = 1;
        number->condition.title = number->condition.why = number->condition.question.exit = "";
        if (reader->fault->total != before)
            continue;
        for (size_t k = 0; k < n; k++)
            if (lesson->numbers[k].name && strcmp(lesson->numbers[k].name, number->name) == 0)
                json_fault(&name, reader->fault, "the name \"%.40s\" is already used; names must be unique",
                           number->name);
        check_condition(reader, &number->condition, number->than, &element);
        if (number->condition.low > -HUGE_VAL || number->condition.high < HUGE_VAL)
            condition_check_limits(&number->condition, "a number", &element, reader->fault);
        check_set(reader, &element, "set", number->set);
        check_set(reader, &element, "than", number->than);
    }
}

static void read_pictures(Reader *reader, const JsonNode *root) {
    JsonNode list = list_of(reader, root, "pictures");
    Lesson *lesson = reader->lesson;
    lesson->picture_count = json_array_size(list.value);
    lesson->pictures = arena_allocate(&lesson->arena, (lesson->picture_count + 1) * sizeof *lesson->pictures);
    for (size_t p = 0; p < lesson->picture_count; p++) {
        JsonNode element = json_element(&list, p);
        if (parameters_read(&picture_table, &lesson->pictures[p], &element, &lesson->arena, reader->fault))
            check_set(reader, &element, "set", lesson->pictures[p].set);
    }
}

static void read_teacher(Reader *reader, const JsonNode *root) {
    static const char *const keys[] = {"before", "questions", "mistakes", NULL};
    JsonNode teacher = json_member(root, "teacher");
    if (!json_is_object(teacher.value)) {
        json_fault(teacher.value ? &teacher : root, reader->fault, "a lesson needs \"teacher\", an object { ... }");
        return;
    }
    json_check_keys(&teacher, keys, reader->fault);
    reader->lesson->before = read_texts(reader, &teacher, "before");
    reader->lesson->questions = read_texts(reader, &teacher, "questions");
    reader->lesson->mistakes = read_texts(reader, &teacher, "mistakes");
}

static void report_unknown(Reader *reader, const JsonNode *node, const char *unknown) {
    const Lesson *lesson = reader->lesson;
    const char **names = arena_allocate(&reader->lesson->arena, (lesson->number_count + 1) * sizeof *names);
    for (size_t n = 0; n < lesson->number_count; n++)
        names[n] = lesson->numbers[n].name;
    const char *nearest = text_nearest(unknown, names, lesson->number_count);
    if (nearest)
        json_fault(node, reader->fault, "the lesson has no number \"%.40s\", did you mean \"%s\"?", unknown, nearest);
    else
        json_fault(node, reader->fault, "the lesson has no number \"%.40s\"; give it in \"numbers\"", unknown);
}

/* Adds a fault for every number in a text, at any depth, that the lesson does not have. */
static void check_numbers(Reader *reader, const JsonNode *node) {
    const char *text = json_string_value(node->value);
    const char *unknown = text ? words_unknown(reader->lesson, text, &reader->lesson->arena) : NULL;
    if (unknown)
        report_unknown(reader, node, unknown);
    for (size_t i = 0; i < json_array_size(node->value); i++) {
        JsonNode element = json_element(node, i);
        check_numbers(reader, &element);
    }
    const char *key;
    json_t *value;
    json_object_foreach(node->value, key, value) {
        JsonNode member = json_member(node, key);
        check_numbers(reader, &member);
    }
}

static void read_steps(Reader *reader, const JsonNode *root) {
    JsonNode list = list_of(reader, root, "steps");
    Lesson *lesson = reader->lesson;
    lesson->step_count = json_array_size(list.value);
    if (!lesson->step_count || lesson->step_count > LESSON_STEPS_MOST) {
        json_fault(list.value ? &list : root, reader->fault, "a lesson has %zu steps, must have 1 to %d",
                   lesson->step_count, LESSON_STEPS_MOST);
        lesson->step_count = 0;
    }
    lesson->steps = arena_allocate(&lesson->arena, (lesson->step_count + 1) * sizeof *lesson->steps);
    memset(lesson->steps, 0, (lesson->step_count + 1) * sizeof *lesson->steps);
    int minutes = 0;
    for (size_t s = 0; s < lesson->step_count; s++) {
        JsonNode element = json_element(&list, s);
        read_step(reader, &lesson->steps[s], &element);
        minutes += lesson->steps[s].minutes;
    }
    JsonNode whole = json_member(root, "minutes");
    if (minutes && minutes != lesson->minutes)
        json_fault(whole.value ? &whole : root, reader->fault,
                   "minutes is %d, must be the sum of those of the steps, %d", lesson->minutes, minutes);
}

/* Adds a fault if the house or machine cannot be read, at the place that names it. */
static void check_file(Reader *reader, const JsonNode *root) {
    JsonNode name = json_member(root, "file");
    if (json_is_string(name.value) && access(reader->lesson->file, R_OK) != 0)
        json_fault(&name, reader->fault, "%s cannot be read: %s; the path begins at the lesson's folder",
                   reader->lesson->file, text_read_reason(errno));
}

static void read_lock(Reader *reader, const JsonNode *root) {
    JsonNode list = json_member(root, "lock");
    reader->lesson->lock = read_texts(reader, root, "lock");
    for (size_t l = 0; reader->checks && l < reader->lesson->lock.count; l++) {
        JsonNode element = json_element(&list, l);
        names_check_lock(&reader->checker, reader->lesson, reader->lesson->lock.at[l], &element, reader->fault);
    }
}

/* `all`: the lesson in all its languages. */
static void read_lesson(Reader *reader, const JsonNode *root, const JsonNode *all) {
    static const char *const more[] = {"format", "version",  "learn",   "lock", "numbers",
                                       "steps",  "pictures", "teacher", "view", NULL};
    Lesson *lesson = reader->lesson;
    const char *settings[LESSON_SETTINGS_MOST];
    size_t before = reader->fault->total;
    read_rows(reader, &lesson_table, lesson, root, more);
    lesson->file = beside(lesson, lesson->file);
    lesson->script = beside(lesson, lesson->script);
    lesson->learn = read_texts(reader, root, "learn");
    check_file(reader, root);
    if (reader->fault->total == before) {
        size_t count = lesson_add_settings(lesson->set, settings, 0, &lesson->arena);
        reader->checks = names_open(&reader->checker, lesson, settings, count, reader->fault);
    }
    read_lock(reader, root);
    look_read(&lesson->view, lesson, root, reader->fault);
    read_numbers(reader, root);
    read_steps(reader, root);
    read_pictures(reader, root);
    read_teacher(reader, root);
    if (reader->fault->total == before)
        check_numbers(reader, all);
    if (reader->checks)
        names_close(&reader->checker, lesson);
}

bool lesson_read(Lesson *lesson, const char *path, Fault *fault) {
    size_t before = fault->total;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    Lesson read = {.title = ""};
    read.path = arena_text(&read.arena, path);
    Reader reader = {.lesson = &read, .fault = fault};
    JsonNode all = json_root(&file), root = all;
    if (json_check_header(&all, "lesson", "clearance-lesson", fault)) {
        root.value = language_choose(&all, language_wanted(), fault);
        read_lesson(&reader, &root, &all);
        json_decref(root.value);
    }
    json_free(&file);
    if (fault->total != before) {
        lesson_free(&read);
        return false;
    }
    lesson_free(lesson);
    *lesson = read;
    return true;
}

void lesson_free(Lesson *lesson) {
    arena_clear(&lesson->arena);
    *lesson = (Lesson){.path = NULL};
}

/* Schema ----------------------------------------------------------------------------------------------------------- */

static json_t *texts_schema(void) {
    return json_pack("{s:s, s:{s:s}}", "type", "array", "items", "type", "string");
}

static json_t *list_schema(json_t *items) {
    return json_pack("{s:s, s:o}", "type", "array", "items", items);
}

/* Returns the schema of a table with more members, which it takes over. */
static json_t *object_schema(const ParameterTable *table, json_t *more) {
    json_t *schema = parameters_schema_table(table);
    json_object_update(json_object_get(schema, "properties"), more);
    json_decref(more);
    return schema;
}

json_t *lesson_schema(void) {
    json_t *filled = json_pack("{s:s, s:{s:o, s:o}, s:b}", "type", "object", "properties", "head", texts_schema(),
                               "rows", list_schema(texts_schema()), "additionalProperties", 0);
    json_t *goal =
        object_schema(&goal_table, json_pack("{s:{s:[s,s], s:s}}", "is", "type", "number", "string", "description",
                                             "the exact number, or the name of the selected thing"));
    json_t *step =
        object_schema(&step_table, json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "options", texts_schema(), "wrong",
                                             texts_schema(), "hints", texts_schema(), "mark", texts_schema(), "goal",
                                             list_schema(goal), "table", filled, "view", look_schema()));
    json_t *teacher =
        json_pack("{s:s, s:{s:o, s:o, s:o}, s:b}", "type", "object", "properties", "before", texts_schema(),
                  "questions", texts_schema(), "mistakes", texts_schema(), "additionalProperties", 0);
    json_t *steps = list_schema(step);
    json_object_set_new(steps, "minItems", json_integer(1));
    json_object_set_new(steps, "maxItems", json_integer(LESSON_STEPS_MOST));
    json_t *schema = object_schema(
        &lesson_table,
        json_pack("{s:{s:s}, s:{s:i}, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "format", "const", "clearance-lesson",
                  "version", "const", 1, "learn", texts_schema(), "lock", texts_schema(), "numbers",
                  list_schema(parameters_schema_table(&number_table)), "steps", steps, "pictures",
                  list_schema(parameters_schema_table(&picture_table)), "teacher", teacher, "view", look_schema()));
    json_t *required = json_object_get(schema, "required");
    json_array_append_new(required, json_string("format"));
    json_array_append_new(required, json_string("version"));
    json_array_append_new(required, json_string("steps"));
    json_array_append_new(required, json_string("teacher"));
    json_object_set_new(schema, "$schema", json_string("https://json-schema.org/draft/2020-12/schema"));
    json_object_set_new(schema, "title", json_string("lesson"));
    language_extend_schema(schema);
    return schema;
}
