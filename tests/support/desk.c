#include "base/file_write.h"
#include "desk.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "check.h"

static char home[CHECK_PATH];

static int remove_one(const char *path, const struct stat *status, int flag, struct FTW *walk) {
    (void)status;
    (void)flag;
    (void)walk;
    return remove(path);
}

void desk_remove(void) {
    if (*home && chdir("/") == 0)
        nftw(home, remove_one, 16, FTW_DEPTH | FTW_PHYS);
    *home = 0;
}

const char *desk_make(void) {
    static const char *const variables[][2] = {
        {"HOME", ""}, {"XDG_CONFIG_HOME", "/config"}, {"XDG_STATE_HOME", "/state"}, {"XDG_CACHE_HOME", "/cache"}};
    desk_remove();
    check_temporary(home, "desk-XXXXXX");
    CHECK(mkdtemp(home));
    for (size_t i = 0; i < sizeof variables / sizeof *variables; i++) {
        char path[CHECK_PATH + 36];
        snprintf(path, sizeof path, "%s%s", home, variables[i][1]);
        setenv(variables[i][0], path, 1);
    }
    CHECK(chdir(home) == 0);
    return home;
}

const char *desk_path(const char *name) {
    static char paths[2][300];
    static int next;
    char *path = paths[next ^= 1];
    snprintf(path, sizeof paths[0], "%s/%s", home, name);
    return path;
}

void desk_write(const char *name, const char *text) {
    const char *path = desk_path(name), *slash = strrchr(path, '/');
    char folder[300];
    snprintf(folder, sizeof folder, "%.*s", (int)(slash - path), path);
    CHECK(text_make_folder(folder) == 0);
    CHECK(file_write_quickly(path, text, strlen(text)) == 0);
}
