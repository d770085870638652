/* The input is a lesson file: read, and its texts filled in. */
#include "fuzz.h"
#include "lesson/words.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size);
    Lesson lesson = {.path = NULL};
    Fault fault = {0};
    bool good = lesson_read(&lesson, path, &fault);
    fuzz_expect(good == !fault.total, "a lesson that is not read has a fault");
    for (size_t s = 0; good && s < lesson.step_count; s++) {
        Arena arena = {0};
        fuzz_expect(words_fill(&lesson, lesson.steps[s].text, &arena) != NULL, "a text is filled in");
        arena_clear(&arena);
    }
    fault_clear(&fault);
    lesson_free(&lesson);
    return 0;
}
