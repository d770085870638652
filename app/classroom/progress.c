#include "classroom/progress.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/digest.h"
#include "base/file_write.h"
#include "base/json.h"
#include "base/text.h"

#define NUMBER_MOST 1e10 /* of PLAY_TYPED_MOST digits */

enum { LONGEST = 1 << 20 /* bytes of a lesson */, WHEN_MOST = 1 << 30, WHEN_TIMES = 1000 };

static char *path_in(const char *folder) {
    Text path = {0};
    text_format(&path, "%s/lessons.json", folder);
    return path.text;
}

/* Returns the lesson's absolute path; new. */
static char *place_of(const Lesson *lesson) {
    char *whole = realpath(lesson->path, NULL), *place = text_copy(whole ? whole : lesson->path);
    free(whole);
    return place;
}

/* Returns a text that differs with the lesson's file; new. */
static char *mark_of(const Lesson *lesson) {
    size_t size = 0;
    char *text = text_read_file(lesson->path, LONGEST, &size);
    Text mark = {0};
    text_format(&mark, "%016" PRIx64, digest_bytes(DIGEST_START, text ? text : "", text ? size : 0));
    memory_free(text);
    return mark.text;
}

static bool is_text(const json_t *object, const char *key, const char *expected) {
    const char *text = json_string_value(json_object_get(object, key));
    return text && strcmp(text, expected) == 0;
}

/* Reading ---------------------------------------------------------------------------------------------------------- */

/* Reads a whole number within limits; false: it is none. */
static bool read_whole(int *number, const json_t *value, int most) {
    json_int_t read = json_integer_value(value);
    if (!json_is_integer(value) || read < 0 || read > most)
        return false;
    *number = (int)read;
    return true;
}

static bool read_hands(PlayStep *shown, const LessonStep *step, const json_t *votes) {
    size_t vote, option;
    json_t *counts, *count;
    if (json_array_size(votes) > PLAY_VOTES)
        return false;
    json_array_foreach(votes, vote, counts) {
        if (json_array_size(counts) > step->options.count)
            return false;
        json_array_foreach(counts, option, count) {
            if (!read_whole(&shown->hands[vote][option], count, PLAY_HANDS_MOST))
                return false;
        }
    }
    return true;
}

/* Reads guesses that are numbers; absent: none. */
static bool read_numbers(PlayStep *shown, const LessonStep *step, const json_t *votes) {
    size_t vote, n;
    json_t *numbers, *number;
    if (json_array_size(votes) > (*step->unit ? PLAY_VOTES : 0))
        return false;
    json_array_foreach(votes, vote, numbers) {
        if (json_array_size(numbers) > PLAY_NUMBERS_MOST)
            return false;
        json_array_foreach(numbers, n, number) {
            if (!json_is_number(number) || fabs(json_number_value(number)) > NUMBER_MOST)
                return false;
            shown->numbers[vote][n] = json_number_value(number);
        }
        shown->number_count[vote] = (int)json_array_size(numbers);
    }
    return true;
}

static bool read_step(PlayStep *shown, const LessonStep *step, const json_t *value) {
    *shown = (PlayStep){.model = json_is_true(json_object_get(value, "model"))};
    return read_whole(&shown->vote, json_object_get(value, "vote"), PLAY_VOTES - 1) &&
           read_whole(&shown->chosen, json_object_get(value, "chosen"), (int)step->options.count) &&
           read_whole(&shown->hints, json_object_get(value, "hints"), (int)step->hints.count) &&
           read_hands(shown, step, json_object_get(value, "hands")) &&
           read_numbers(shown, step, json_object_get(value, "numbers"));
}

static bool read_one(Progress *progress, const Lesson *lesson, const json_t *value) {
    int step = 0;
    const json_t *steps = json_object_get(value, "steps"), *when = json_object_get(value, "when");
    *progress = (Progress){.when = json_integer_value(when)};
    if (!read_whole(&step, json_object_get(value, "step"), (int)lesson->step_count - 1) ||
        json_array_size(steps) != lesson->step_count || progress->when < 0 ||
        progress->when > (int64_t)WHEN_MOST * WHEN_TIMES)
        return false;
    progress->step = (size_t)step;
    for (size_t s = 0; s < lesson->step_count; s++)
        if (!read_step(&progress->steps[s], &lesson->steps[s], json_array_get(steps, s)))
            return false;
    return true;
}

/* Returns the list of the file, empty if there is none; new. */
static json_t *read_list(const char *path, Fault *notes) {
    JsonFile file = {0};
    Fault fault = {0};
    json_t *list = NULL;
    if (access(path, F_OK) != 0)
        return json_array();
    if (json_read(&file, path, &fault))
        list = json_incref(json_object_get(json_root(&file).value, "lessons"));
    if (!json_is_array(list)) {
        Text bad = {0};
        text_format(&bad, "%s.bad", path);
        bool kept = rename(path, bad.text) == 0;
        if (notes)
            fault_add(notes, "%s; %s%s", fault.count ? fault.lines[0] : "the list of lessons is invalid",
                      kept ? "lessons restart, and the file is kept as " : "lessons restart", kept ? bad.text : "");
        memory_free(bad.text);
        json_decref(list);
        list = json_array();
    }
    json_free(&file);
    fault_clear(&fault);
    return list;
}

/* Returns the place of the lesson in the list; its size: it is not there. */
static size_t find(const json_t *list, const char *place) {
    size_t at = 0;
    while (at < json_array_size(list) && !is_text(json_array_get(list, at), "path", place))
        at++;
    return at;
}

bool progress_read(Progress *progress, const Lesson *lesson, const char *folder, Fault *notes) {
    char *path = path_in(folder), *place = place_of(lesson), *mark = mark_of(lesson);
    json_t *list = read_list(path, notes);
    const json_t *value = json_array_get(list, find(list, place));
    bool good = is_text(value, "digest", mark) && read_one(progress, lesson, value);
    json_decref(list);
    memory_free(path);
    memory_free(place);
    memory_free(mark);
    return good;
}

/* Writing ---------------------------------------------------------------------------------------------------------- */

static json_t *numbers_of(const PlayStep *shown, const LessonStep *step) {
    json_t *votes = json_array();
    for (int vote = 0; vote <= shown->vote && *step->unit; vote++) {
        json_t *numbers = json_array();
        for (int n = 0; n < shown->number_count[vote]; n++)
            json_array_append_new(numbers, json_real(shown->numbers[vote][n]));
        json_array_append_new(votes, numbers);
    }
    return votes;
}

static json_t *step_values(const PlayStep *shown, const LessonStep *step) {
    json_t *votes = json_array();
    for (int vote = 0; vote <= shown->vote && step->kind == LESSON_PREDICT; vote++) {
        json_t *counts = json_array();
        for (size_t o = 0; o < step->options.count; o++)
            json_array_append_new(counts, json_integer(shown->hands[vote][o]));
        json_array_append_new(votes, counts);
    }
    return json_pack("{s:o, s:o, s:i, s:i, s:i, s:b}", "hands", votes, "numbers", numbers_of(shown, step), "vote",
                     shown->vote, "chosen", shown->chosen, "hints", shown->hints, "model", shown->model);
}

static json_t *play_values(const Play *play, const char *place, const char *mark, int64_t when) {
    json_t *steps = json_array();
    for (size_t s = 0; s < play->lesson.step_count; s++)
        json_array_append_new(steps, step_values(&play->steps[s], &play->lesson.steps[s]));
    return json_pack("{s:s, s:s, s:I, s:I, s:o}", "path", place, "digest", mark, "when", (json_int_t)when, "step",
                     (json_int_t)play->step, "steps", steps);
}

static int write_list(const char *folder, const char *path, json_t *list) {
    int error = text_make_folder(folder);
    json_t *all = json_pack("{s:O}", "lessons", list);
    char *words = json_dumps(all, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    json_decref(all);
    if (!error)
        error = file_write_quickly(path, words, strlen(words));
    free(words);
    return error;
}

/* Puts the play, or nothing, in the place of what was kept of the lesson: the newest stands first. */
static int put(const Lesson *lesson, const char *folder, const Play *play, int64_t when) {
    char *path = path_in(folder), *place = place_of(lesson), *mark = mark_of(lesson);
    json_t *list = read_list(path, NULL);
    size_t at = find(list, place);
    bool changes = play || at < json_array_size(list);
    json_array_remove(list, at);
    json_t *value = play ? play_values(play, place, mark, when) : NULL;
    if (value) /* NULL: the path is not UTF-8, the only encoding of JSON */
        json_array_insert_new(list, 0, value);
    while (json_array_size(list) > PROGRESS_LESSONS)
        json_array_remove(list, PROGRESS_LESSONS);
    int error = play && !value ? EILSEQ : changes ? write_list(folder, path, list) : 0;
    json_decref(list);
    memory_free(path);
    memory_free(place);
    memory_free(mark);
    return error;
}

int progress_write(const Play *play, const char *folder, int64_t when) {
    return put(&play->lesson, folder, play, when);
}

int progress_forget(const Lesson *lesson, const char *folder) {
    return put(lesson, folder, NULL, 0);
}

int progress_hands(const Progress *progress) {
    int all = 0;
    for (size_t s = 0; s < LESSON_STEPS_MOST; s++)
        all += play_hands(&progress->steps[s], progress->steps[s].vote);
    return all;
}
