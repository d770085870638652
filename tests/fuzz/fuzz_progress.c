/* The input is what was kept of lessons: after an odd byte the whole file, after an even one what it says of a shipped
 * lesson next to its path and digest. */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "classroom/progress.h"
#include "fuzz.h"

static Play play;
static char *about; /* path and digest of the lesson, as members of an object */

/* Returns from the file that is written at first the member of a key, with its quotes; new. */
static char *member_of(const char *text, const char *key) {
    const char *from = strstr(text, key), *end = from ? strchr(from, '\n') : NULL;
    fuzz_expect(end, "the file has a path and a digest, each in a line");
    Text member = {0};
    text_format(&member, "%.*s", (int)(end - from), from);
    return member.text;
}

static void begin(void) {
    char file[FUZZ_PATH];
    Fault fault = {0};
    if (about)
        return;
    fuzz_expect(lesson_read(&play.lesson, fuzz_source("assets/lessons/two-doors-locked.json"), &fault),
                "the shipped lesson is read");
    fuzz_expect(progress_write(&play, fuzz_folder(), 0) == 0, "there is a folder");
    snprintf(file, sizeof file, "%s/lessons.json", fuzz_folder());
    size_t size;
    char *text = text_read_file(file, 1 << 20, &size);
    char *path = member_of(text, "\"path\""), *digest = member_of(text, "\"digest\"");
    Text both = {0};
    text_format(&both, "%s %s", path, digest);
    about = both.text;
    memory_free(path);
    memory_free(digest);
    memory_free(text);
}

static void write_input(const uint8_t *data, size_t size) {
    char path[FUZZ_PATH];
    bool whole = fuzz_take(&data, &size) & 1;
    Text text = {0};
    if (!whole)
        text_format(&text, "{\"lessons\": [{%s ", about);
    for (size_t i = 0; i < size; i++) /* a 0 ends the text */
        if (data[i])
            text_format(&text, "%c", data[i]);
    if (!whole)
        text_add(&text, "}]}");
    size_t length = text.text ? strlen(text.text) : 0;
    fuzz_write(path, "lessons.json", (const uint8_t *)text.text, length);
    memory_free(text.text);
}

static void check_ranges(const Progress *progress) {
    const Lesson *lesson = &play.lesson;
    fuzz_expect(progress->step < lesson->step_count && progress->when >= 0, "the step and the time are in range");
    for (size_t s = 0; s < lesson->step_count; s++) {
        const PlayStep *step = &progress->steps[s];
        fuzz_expect(step->vote >= 0 && step->vote < PLAY_VOTES && step->hints >= 0 && step->chosen >= 0 &&
                        (size_t)step->chosen <= lesson->steps[s].options.count,
                    "votes, hints and answers are in range");
        for (size_t v = 0; v < PLAY_VOTES; v++)
            for (size_t o = 0; o < LESSON_OPTIONS_MOST; o++)
                fuzz_expect(step->hands[v][o] >= 0 && step->hands[v][o] <= PLAY_HANDS_MOST, "hands are in range");
    }
}

/* Writes what was read, and reads it. */
static Progress carry_over(const Progress *progress) {
    Progress again;
    Fault notes = {0};
    play.step = progress->step;
    memcpy(play.steps, progress->steps, sizeof play.steps);
    fuzz_expect(progress_write(&play, fuzz_folder(), progress->when) == 0, "what was read is written");
    fuzz_expect(progress_read(&again, &play.lesson, fuzz_folder(), &notes), "what was written is read");
    fuzz_expect_faults(notes.total == 0, &notes, "");
    check_ranges(&again);
    return again;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    begin();
    write_input(data, size);
    Progress first;
    Fault notes = {0};
    bool good = progress_read(&first, &play.lesson, fuzz_folder(), &notes);
    fuzz_expect_faults(notes.total == 0, &notes, "");
    if (!good)
        return 0;
    check_ranges(&first);
    Progress second = carry_over(&first), third = carry_over(&second);
    fuzz_expect(second.step == first.step && second.when == first.when, "the place survives writing");
    fuzz_expect(memcmp(&second, &third, sizeof second) == 0, "guesses survive writing");
    return 0;
}
