/* The input damages the file of a study's results: four bytes each say where a byte is changed and into what, and the
 * first two how much is cut off the end. */
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "fuzz.h"
#include "study/store.h"
#include "toy.h"

enum { FILE_LARGEST = 1 << 20, STEPS = 12, DIGEST = 7 };

typedef struct Bytes {
    char *at;
    size_t size;
} Bytes;

static Study begin_study(const Experiment *experiment) {
    Study study = {.experiment = experiment,
                   .axes = {{"x", 0, 8, STEPS}},
                   .axis_count = 1,
                   .passes = {STUDY_RESET},
                   .pass_count = 1,
                   .runs = 1};
    Fault fault = {0};
    fuzz_expect(study_check(&study, &fault), "the study is valid");
    study_begin(&study);
    return study;
}

/* Runs the study with its store. Returns true if all of it was kept. */
static bool run_study(const char *path, int most) {
    Toy toy = {.interrupted_after = most};
    Experiment experiment = toy_experiment(&toy);
    Study study = begin_study(&experiment);
    StoreFound found = {0};
    Fault fault = {0};
    Store *store = store_open(path, STORE_ALONE, &study, DIGEST, &found, &fault);
    bool good = store;
    fuzz_expect_faults(good, &fault, "");
    if (store) {
        fuzz_expect(found.done == study_done(&study) && found.done <= STEPS, "the stored trials are done");
        study_run(&study, &(StudyOptions){.jobs = 1, .stop = &toy.stop, .keep = store_write, .keeper = store});
        fuzz_expect(most || study_done(&study) == STEPS, "all trials are done");
        good = store_close(store, &fault);
        fuzz_expect_faults(good, &fault, "");
    }
    study_clear(&study);
    return good;
}

/* Merges the file into a new one. */
static void merge_study(const char *path, const char *into) {
    Toy toy = {0};
    Experiment experiment = toy_experiment(&toy);
    Study study = begin_study(&experiment);
    StoreFound found = {0};
    Fault fault = {0};
    Store *store = store_open(into, STORE_ALONE, &study, DIGEST, &found, &fault);
    fuzz_expect(store, "a new file is made");
    StoreMerge end = store_merge(store, &study, path, &fault);
    fuzz_expect(end != STORE_REFUSED || study_done(&study) == 0, "nothing is taken from a file that is refused");
    fuzz_expect_faults(end == STORE_MERGED, &fault, "");
    store_abandon(store);
    study_clear(&study);
}

static Bytes read_bytes(const char *path) {
    Bytes bytes = {.size = 0};
    bytes.at = text_read_file(path, FILE_LARGEST, &bytes.size);
    fuzz_expect(bytes.at, "the file is read");
    return bytes;
}

/* Makes the file of a study of which a half is done. */
static Bytes make_sound(void) {
    char path[FUZZ_PATH];
    fuzz_write(path, "study", NULL, 0);
    fuzz_expect(run_study(path, STEPS / 2), "a new study is kept");
    return read_bytes(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static Bytes sound;
    char path[FUZZ_PATH], beside[FUZZ_PATH];
    if (!sound.at)
        sound = make_sound();
    fuzz_write(beside, "study-journal", NULL, 0);
    uint8_t *damaged = memory_zeroed(sound.size, 1);
    memcpy(damaged, sound.at, sound.size);
    size_t cut = fuzz_take(&data, &size) % 4 ? 0 : 64 * (size_t)fuzz_take(&data, &size);
    size_t left = cut < sound.size ? sound.size - cut : 1;
    while (size >= 4) {
        size_t place = fuzz_take(&data, &size);
        place = (place << 8 | fuzz_take(&data, &size)) << 8;
        place |= fuzz_take(&data, &size);
        damaged[place % sound.size] = fuzz_take(&data, &size);
    }
    fuzz_write(path, "study", damaged, left);
    char merged[FUZZ_PATH];
    fuzz_write(merged, "merged", NULL, 0);
    merge_study(path, merged);
    fuzz_write(path, "study", damaged, left);
    if (!run_study(path, 0)) {
        Bytes after = read_bytes(path);
        fuzz_expect(after.size > 0, "a file that cannot be used is still there");
        memory_free(after.at);
    } else {
        run_study(path, 0);
    }
    memory_free(damaged);
    return 0;
}
