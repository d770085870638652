#include "window/script.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/choice.h"
#include "base/json.h"
#include "base/text.h"
#include "laboratory/laboratories.h"

enum {
    LARGEST_FILE = 1 << 20, /* bytes */
    LINE_WORDS = 6,         /* of a line: those of the longest command, and one more */
    PIXELS_MOST = 16384,
};

/* Grammar ---------------------------------------------------------------------------------------------------------- */

/* The kind of an argument of a command. */
typedef enum ArgumentKind {
    ARGUMENT_NONE,
    ARGUMENT_WORD,
    ARGUMENT_NUMBER,
    ARGUMENT_WHOLE,
    ARGUMENT_VALUE,      /* a word that may be a number */
    ARGUMENT_CHOICE,     /* one of `choices` */
    ARGUMENT_LABORATORY, /* the word of one of `laboratories` */
} ArgumentKind;

typedef struct Argument {
    ArgumentKind kind;
    double low, high;
    const char *choices; /* "right|double" */
} Argument;

typedef struct Row {
    const char *word;
    const char *usage;
    Argument arguments[SCRIPT_NUMBERS + 1];
    int least;       /* required arguments */
    double fallback; /* value of an omitted number */
} Row;

#define WORD                                                                                                           \
    { ARGUMENT_WORD, 0, 0, NULL }
#define VALUE                                                                                                          \
    { ARGUMENT_VALUE, 0, 0, NULL }
#define NUMBER(low_, high_)                                                                                            \
    { ARGUMENT_NUMBER, low_, high_, NULL }
#define WHOLE(low_, high_)                                                                                             \
    { ARGUMENT_WHOLE, low_, high_, NULL }
#define CHOICE(choices_)                                                                                               \
    { ARGUMENT_CHOICE, 0, 0, choices_ }
#define PLACE NUMBER(-PIXELS_MOST, PIXELS_MOST)

static const Row rows[SCRIPT_KINDS] = {
    [SCRIPT_KEY] = {"key", "NAME, such as Ctrl+M", {WORD}, 1, 0},
    [SCRIPT_TYPE] = {"type", "TEXT", {WORD}, 1, 0},
    [SCRIPT_MOUSE] = {"mouse", "X Y", {PLACE, PLACE}, 2, 0},
    [SCRIPT_CLICK] = {"click", "X Y [left|right|double]", {PLACE, PLACE, CHOICE("left|right|double")}, 2, 0},
    [SCRIPT_DRAG] = {"drag", "X1 Y1 X2 Y2", {PLACE, PLACE, PLACE, PLACE}, 4, 0},
    [SCRIPT_AT] = {"at", "X Y", {NUMBER(-1e6, 1e6), NUMBER(-1e6, 1e6)}, 2, 0},
    [SCRIPT_PRESS] = {"press", "[double]", {CHOICE("once|double")}, 0, 0},
    [SCRIPT_RELEASE] = {"release", "", {{0}}, 0, 0},
    [SCRIPT_HOLD] = {"hold", "nothing|Shift|Ctrl|Alt", {CHOICE("nothing|Shift|Ctrl|Alt")}, 1, 0},
    [SCRIPT_WHEEL] = {"wheel", "NOTCHES", {NUMBER(-1000, 1000)}, 1, 0},
    [SCRIPT_WAIT] = {"wait", "FRAMES", {WHOLE(0, 1e6)}, 1, 0},
    [SCRIPT_UNTIL] = {"until",
                      "complete|idle|answered|shaken [SECONDS]",
                      {CHOICE("complete|idle|answered|shaken"), NUMBER(0, 1e6)},
                      1,
                      SCRIPT_PATIENCE},
    [SCRIPT_OPEN] = {"open", "FILE", {WORD}, 1, 0},
    [SCRIPT_LABORATORY] = {"laboratory", "house, beam ...", {{ARGUMENT_LABORATORY, 0, 0, NULL}}, 1, 0},
    [SCRIPT_SELECT] = {"select", "NAME", {WORD}, 1, 0},
    [SCRIPT_SET] = {"set", "NAME VALUE", {WORD, VALUE}, 2, 0},
    [SCRIPT_PLAY] = {"play", "", {{0}}, 0, 0},
    [SCRIPT_PAUSE] = {"pause", "", {{0}}, 0, 0},
    [SCRIPT_SEEK] = {"seek", "SECONDS", {NUMBER(0, 1e9)}, 1, 0},
    [SCRIPT_SPEED] = {"speed", "TIMES", {NUMBER(1e-6, 1e6)}, 1, 0},
    [SCRIPT_RESIZE] = {"resize", "WIDTH HEIGHT", {WHOLE(1, PIXELS_MOST), WHOLE(1, PIXELS_MOST)}, 2, 0},
    [SCRIPT_PICTURE] = {"picture", "FILE", {WORD}, 1, 0},
    [SCRIPT_VIEW] = {"view", "FILE", {WORD}, 1, 0},
    [SCRIPT_STATE] = {"state", "FILE", {WORD}, 1, 0},
    [SCRIPT_TEXTS] = {"texts", "FILE", {WORD}, 1, 0},
    [SCRIPT_EXPECT] = {"expect", "NAME VALUE [TOLERANCE]", {WORD, VALUE, NUMBER(0, 1e300)}, 2, 0},
    [SCRIPT_QUIT] = {"quit", "", {{0}}, 0, 0},
};

const char *script_word(ScriptKind kind) {
    return rows[kind].word;
}

/* Words of a line -------------------------------------------------------------------------------------------------- */

/* The file that is read, and the present line. */
typedef struct Reader {
    Script *script;
    Fault *fault;
    int line;
    const char *begin; /* of the line */
} Reader;

typedef struct Word {
    const char *text;
    int column; /* from 1, in characters */
} Word;

static int column_of(const Reader *reader, const char *at) {
    int column = 1;
    for (const char *c = reader->begin; c < at; c++)
        column += ((unsigned char)*c & 0xc0) != 0x80;
    return column;
}

static void fault_at(const Reader *reader, int column, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void fault_at(const Reader *reader, int column, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *text = text_printed(format, arguments);
    va_end(arguments);
    fault_add(reader->fault, "%s:%d:%d: %s", reader->script->path, reader->line, column, text);
    memory_free(text);
}

/* Returns the character for a backslash and `letter`, or 0. */
static char escaped(char letter) {
    return letter == 'n' ? '\n' : letter == 't' ? '\t' : letter == '"' || letter == '\\' ? letter : 0;
}

/* Reads a quoted word from after its first quote. NULL: a fault says why not. */
static const char *read_quoted(const Reader *reader, const char **at, const char *end) {
    const char *begin = *at - 1;
    char *word = arena_allocate(&reader->script->arena, (size_t)(end - *at) + 1), *to = word;
    for (const char *c = *at; c < end; c++) {
        if (*c == '"') {
            *at = c + 1;
            return word;
        }
        if (*c == '\\') {
            if (c + 1 == end || !escaped(c[1])) {
                fault_at(reader, column_of(reader, c), "a \\ must be followed by \", \\, n or t");
                return NULL;
            }
            *to++ = escaped(*++c);
        } else {
            *to++ = *c;
        }
    }
    fault_at(reader, column_of(reader, begin), "a quote that is not closed on its line");
    return NULL;
}

static const char *read_bare(const Reader *reader, const char **at, const char *end) {
    const char *begin = *at;
    while (*at < end && !strchr(" \t#\"", **at))
        ++*at;
    size_t length = (size_t)(*at - begin);
    return memcpy(arena_allocate(&reader->script->arena, length + 1), begin, length);
}

/* Reads at most LINE_WORDS words and returns their number; -1: a fault says what is wrong with one. */
static int read_words(const Reader *reader, const char *end, Word words[LINE_WORDS]) {
    int count = 0;
    for (const char *at = reader->begin;; count++) {
        const char *before = at;
        while (at < end && (*at == ' ' || *at == '\t'))
            at++;
        if (at == end || *at == '#' || count == LINE_WORDS)
            return count;
        if (count && at == before) {
            fault_at(reader, column_of(reader, at), "a blank must part two words");
            return -1;
        }
        words[count].column = column_of(reader, at);
        words[count].text = *at == '"' ? (at++, read_quoted(reader, &at, end)) : read_bare(reader, &at, end);
        if (!words[count].text)
            return -1;
    }
}

/* Commands --------------------------------------------------------------------------------------------------------- */

static bool read_double(const char *word, double *value) {
    char *end;
    *value = strtod(word, &end);
    bool plain = !word[strspn(word, "+-.0123456789eE")];
    return *word && !*end && plain && isfinite(*value);
}

/* The number of words and numbers that a command has so far. */
typedef struct Filled {
    int words, numbers;
} Filled;

static bool read_number(const Reader *reader, const Argument *argument, const Word *word, double *number) {
    if (!read_double(word->text, number))
        fault_at(reader, word->column, "\"%.60s\" must be a number", word->text);
    else if (*number < argument->low || *number > argument->high)
        fault_at(reader, word->column, "%g must be from %g to %g", *number, argument->low, argument->high);
    else if (argument->kind == ARGUMENT_WHOLE && *number != floor(*number))
        fault_at(reader, word->column, "%g must be a whole number", *number);
    else
        return true;
    return false;
}

static bool read_laboratory(const Reader *reader, const Word *word, ScriptCommand *command) {
    size_t index = laboratory_find(word->text);
    command->choice = (int)index;
    if (index < laboratories_count)
        return true;
    Text words = {0};
    for (size_t i = 0; i < laboratories_count; i++)
        text_format(&words, "%s%s", i ? "|" : "", laboratories[i].laboratory->word);
    fault_at(reader, word->column, "\"%.60s\" must be one of %s", word->text, words.text);
    memory_free(words.text);
    return false;
}

static bool read_argument(const Reader *reader, const Argument *argument, const Word *word, ScriptCommand *command,
                          Filled *filled) {
    double number;
    switch (argument->kind) {
    case ARGUMENT_VALUE:
        command->numbers[filled->numbers++] = read_double(word->text, &number) ? number : NAN;
        command->words[filled->words++] = word->text;
        return true;
    case ARGUMENT_WORD:
        command->words[filled->words++] = word->text;
        if (!*word->text)
            fault_at(reader, word->column, "a word must not be empty");
        return *word->text;
    case ARGUMENT_CHOICE:
        command->words[filled->words++] = word->text;
        command->choice = choice_place(argument->choices, word->text);
        if (command->choice < 0)
            fault_at(reader, word->column, "\"%.60s\" must be one of %s", word->text, argument->choices);
        return command->choice >= 0;
    case ARGUMENT_LABORATORY:
        command->words[filled->words++] = word->text;
        return read_laboratory(reader, word, command);
    case ARGUMENT_NUMBER:
    case ARGUMENT_WHOLE:
        return read_number(reader, argument, word, &command->numbers[filled->numbers++]);
    case ARGUMENT_NONE:
        break;
    }
    return false;
}

/* Returns the kind of a command; SCRIPT_KINDS: it is unknown, and a fault names the nearest one. */
static ScriptKind kind_of(const Reader *reader, const Word *word) {
    const char *names[SCRIPT_KINDS];
    for (ScriptKind kind = 0; kind < SCRIPT_KINDS; kind++) {
        names[kind] = rows[kind].word;
        if (strcmp(rows[kind].word, word->text) == 0)
            return kind;
    }
    const char *nearest = text_nearest(word->text, names, SCRIPT_KINDS);
    fault_at(reader, word->column, "there is no command \"%.60s\"%s%s%s", word->text, nearest ? ", did you mean " : "",
             nearest ? nearest : "", nearest ? "?" : "");
    return SCRIPT_KINDS;
}

static void add_command(Script *script, const ScriptCommand *command) {
    script->commands = memory_reserve(script->commands, &script->capacity, script->count + 1, sizeof *script->commands);
    script->commands[script->count++] = *command;
}

static void read_command(const Reader *reader, const Word *words, int count) {
    ScriptCommand command = {.kind = kind_of(reader, &words[0]), .line = reader->line};
    if (command.kind == SCRIPT_KINDS)
        return;
    const Row *row = &rows[command.kind];
    int most = 0;
    while (row->arguments[most].kind)
        most++;
    if (count - 1 < row->least || count - 1 > most) {
        fault_at(reader, words[0].column, "too %s words, must be: %s%s%s", count - 1 < row->least ? "few" : "many",
                 row->word, *row->usage ? " " : "", row->usage);
        return;
    }
    Filled filled = {0, 0};
    bool good = true;
    for (int i = 0; i < count - 1; i++)
        good &= read_argument(reader, &row->arguments[i], &words[i + 1], &command, &filled);
    if (filled.numbers < SCRIPT_NUMBERS && count - 1 < most)
        command.numbers[filled.numbers] = row->fallback;
    if (good)
        add_command(reader->script, &command);
}

/* Checks the characters of a line: control characters, which editors do not show, and invalid UTF-8 are faults. */
static bool check_characters(const Reader *reader, const char *end) {
    for (const char *c = reader->begin; c < end; c++)
        if (((unsigned char)*c < ' ' && *c != '\t') || *c == 127) {
            fault_at(reader, column_of(reader, c), "a control character, number %d", (unsigned char)*c);
            return false;
        }
    json_t *text = json_stringn(reader->begin, (size_t)(end - reader->begin));
    if (!text)
        fault_at(reader, 1, "not UTF-8");
    json_decref(text);
    return text;
}

static void read_line(const Reader *reader, const char *end) {
    Word words[LINE_WORDS];
    if (end > reader->begin && end[-1] == '\r')
        end--;
    int count = check_characters(reader, end) ? read_words(reader, end, words) : 0;
    if (count > 0)
        read_command(reader, words, count);
}

bool script_read(Script *script, const char *path, Fault *fault) {
    size_t size, before = fault->total;
    char *text = text_read_file(path, LARGEST_FILE, &size);
    if (!text) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, text_read_reason(errno));
        return false;
    }
    Script read = {.count = 0};
    read.path = arena_text(&read.arena, path);
    Reader reader = {&read, fault, 1, text};
    for (const char *end; reader.begin < text + size; reader.begin = end + 1, reader.line++) {
        end = memchr(reader.begin, '\n', (size_t)(text + size - reader.begin));
        end = end ? end : text + size;
        read_line(&reader, end);
    }
    memory_free(text);
    bool good = fault->total == before;
    script_free(good ? script : &read);
    if (good)
        *script = read;
    return good;
}

void script_free(Script *script) {
    memory_free(script->commands);
    arena_clear(&script->arena);
    *script = (Script){.count = 0};
}

const ScriptCommand *script_next(Script *script) {
    return script->at < script->count ? &script->commands[script->at++] : NULL;
}

/* Actions ---------------------------------------------------------------------------------------------------------- */

void script_fault(const Script *script, const ScriptCommand *command, Fault *fault, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    char *text = text_printed(format, arguments);
    va_end(arguments);
    fault_add(fault, "%s:%d:1: %s: %s", script->path, command->line, rows[command->kind].word, text);
    memory_free(text);
}

/* Returns the value at a path "people.0.time", or NULL; the rest of a path may be a single name, "door.d1.width". */
static const json_t *find_value(const json_t *state, const char *way) {
    const char *at = way;
    while (state && *at) {
        const json_t *whole = json_object_get(state, at);
        if (whole)
            return whole;
        size_t length = strcspn(at, ".");
        if (json_is_array(state))
            state = json_array_get(state, strspn(at, "0123456789") == length ? strtoul(at, NULL, 10) : SIZE_MAX);
        else
            state = json_object_getn(state, at, length);
        at += length + (at[length] == '.');
    }
    return state;
}

static bool is_expected(const json_t *value, const ScriptCommand *command) {
    const char *word = command->words[1];
    if (json_is_string(value))
        return strcmp(json_string_value(value), word) == 0;
    if (json_is_number(value))
        return fabs(json_number_value(value) - command->numbers[0]) <= command->numbers[1];
    return strcmp(word, json_is_true(value)    ? "true"
                        : json_is_false(value) ? "false"
                        : json_is_null(value)  ? "null"
                                               : "") == 0;
}

bool script_expect(const Script *script, const ScriptCommand *command, const json_t *state, Fault *fault) {
    const json_t *value = find_value(state, command->words[0]);
    if (!value) {
        script_fault(script, command, fault, "the state has no \"%s\"", command->words[0]);
        return false;
    }
    if (is_expected(value, command))
        return true;
    char *line = json_line(value), tolerance[40] = "";
    if (command->numbers[1] > 0)
        snprintf(tolerance, sizeof tolerance, " within %g", command->numbers[1]);
    script_fault(script, command, fault, "%s is %s, expected %s%s", command->words[0], line, command->words[1],
                 tolerance);
    memory_free(line);
    return false;
}
