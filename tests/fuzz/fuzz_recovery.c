/* The input is what a process that has ended left behind: up to its first 0 the file about the edits, then the house.
 */
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "fuzz.h"
#include "platform/recovery.h"

#define LEFT "clearance/recovery/4194999-1" /* its process number is larger than any */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    setenv("XDG_STATE_HOME", fuzz_folder(), 1);
    const uint8_t *end = size ? memchr(data, 0, size) : NULL;
    size_t about = end ? (size_t)(end - data) : size, rest = end ? size - about - 1 : 0;
    Recovery *recovery = recovery_create();
    fuzz_expect(recovery, "there is a folder");
    char path[FUZZ_PATH];
    fuzz_write(path, LEFT ".about", data, about);
    fuzz_write(path, LEFT ".json", rest ? end + 1 : (const uint8_t *)"{}", rest ? rest : 2);
    size_t count;
    RecoveryFound *found = recovery_find(recovery, &count);
    fuzz_expect(count == 1, "what was left is found");
    fuzz_expect(found->path && found->name, "it has a path and a name");
    fuzz_expect(found->when >= 0 && found->origin_when >= 0, "times are not negative");
    if (size % 2) {
        fuzz_expect(recovery_adopt(recovery, found), "it is taken over");
        recovery_remove(recovery);
    } else {
        recovery_forget(found);
    }
    recovery_free_found(found, count);
    found = recovery_find(recovery, &count);
    fuzz_expect(count == 0, "what was taken over or removed is not found again");
    recovery_free_found(found, count);
    recovery_destroy(recovery);
    return 0;
}
