#include "laboratory/shipped.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_MOST = 4096, OWN_MOST = 8 };

static char assets[PATH_MOST], looked[4 * PATH_MOST], missing[5 * PATH_MOST];
static char profiles[(OWN_MOST + 1) * (PATH_MOST + 32)], populations[PATH_MOST + 32], furniture[PATH_MOST + 32],
    beams[PATH_MOST + 32], cranks[PATH_MOST + 32], houses[PATH_MOST + 32], help[PATH_MOST + 32], rules[PATH_MOST + 32],
    lessons[PATH_MOST + 32];
static char own[OWN_MOST][PATH_MOST + 32];
static size_t own_count;
static Shipped shipped = {profiles, populations, furniture, beams, cranks, houses, help, rules, lessons, NULL};

/* Adds a folder to the list of searched folders, once. */
static void add_looked(const char *folder) {
    size_t length = strlen(looked);
    const char *at = strstr(looked, folder), *end = at ? at + strlen(folder) : NULL;
    if (!at || (at != looked && at[-1] != ' ') || (*end && *end != ','))
        snprintf(looked + length, sizeof looked - length, "%s%s", length ? ", " : "", folder);
}

/* Uses the folder for the assets; false if it contains none. */
static bool consider(const char *folder) {
    add_looked(folder);
    char *whole = realpath(folder, NULL);
    snprintf(assets, sizeof assets, "%s", whole ? whole : folder);
    free(whole);
    snprintf(profiles, sizeof profiles, "%s/profiles", assets);
    snprintf(populations, sizeof populations, "%s/populations", assets);
    return access(profiles, R_OK | X_OK) == 0;
}

/* Finds the parent of the program's folder; false if the system does not know the program's path. */
static bool find_root(char root[PATH_MOST]) {
    ssize_t length = readlink("/proc/self/exe", root, PATH_MOST - 1);
    if (length <= 0)
        return false;
    root[length] = '\0';
    for (int level = 0; level < 2; level++) {
        char *slash = strrchr(root, '/');
        if (!slash)
            return false;
        *slash = '\0';
    }
    return true;
}

static bool consider_installed(const char *root) {
    char folder[PATH_MOST + 32];
    snprintf(folder, sizeof folder, "%s/share/clearance", root);
    return consider(folder);
}

/* Uses the assets next to a build folder. A build folder contains the build's own file. That file, itself and not a
 * link, and the assets must belong to the program's owner: other users must not be able to choose the assets. */
static bool consider_source(const char *root) {
    char path[PATH_MOST + 32];
    struct stat build, found, program;
    snprintf(path, sizeof path, "%s/build.ninja", root);
    if (stat("/proc/self/exe", &program) != 0 || lstat(path, &build) != 0 || !S_ISREG(build.st_mode) ||
        build.st_uid != program.st_uid)
        return false;
    snprintf(path, sizeof path, "%s/../assets", root);
    return (stat(path, &found) != 0 || found.st_uid == program.st_uid) && consider(path);
}

/* Calls `use` with the clearance folder of each folder of a list that is separated by colons, as in the XDG base
 * directory specification, until it returns true; relative folders are ignored. */
static bool each_data_folder(const char *list, bool (*use)(const char *folder)) {
    while (*list) {
        size_t length = strcspn(list, ":");
        char folder[PATH_MOST + 32];
        if (*list == '/' && length < PATH_MOST) {
            snprintf(folder, sizeof folder, "%.*s/clearance", (int)length, list);
            if (use(folder))
                return true;
        }
        list += length + (list[length] == ':');
    }
    return false;
}

static const char *variable(const char *name) {
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}

static bool each_data(bool (*use)(const char *folder)) {
    char personal[PATH_MOST] = "";
    const char *data = variable("XDG_DATA_HOME"), *home = variable("HOME"), *site = variable("XDG_DATA_DIRS");
    if (data)
        snprintf(personal, sizeof personal, "%s", data);
    else if (home)
        snprintf(personal, sizeof personal, "%s/.local/share", home);
    return each_data_folder(personal, use) || each_data_folder(site ? site : "/usr/local/share:/usr/share", use);
}

/* Adds a folder that exists, once; false, to go on. */
static bool add_own(const char *folder) {
    char *whole = realpath(folder, NULL);
    bool known = !whole || strlen(whole) >= PATH_MOST || strcmp(whole, assets) == 0;
    for (size_t i = 0; i < own_count && !known; i++)
        known = strcmp(own[i], whole) == 0;
    if (!known && own_count < OWN_MOST) {
        snprintf(own[own_count++], sizeof own[0], "%s", whole);
        size_t length = strlen(profiles);
        snprintf(profiles + length, sizeof profiles - length, "\n%s/profiles", whole);
    }
    free(whole);
    return false;
}

static bool find_assets(void) {
    char root[PATH_MOST];
    const char *given = variable("CLEARANCE_ASSETS");
    if (given)
        return consider(given);
    bool rooted = find_root(root);
    return (rooted && consider_installed(root)) || (rooted && consider_source(root)) || each_data(consider) ||
           consider(CLEARANCE_INSTALLED_ASSETS);
}

static void find(void) {
    if (!find_assets()) {
        snprintf(
            missing, sizeof missing,
            "the files that come with clearance were not found: none of these folders contains \"profiles\": %s; set "
            "CLEARANCE_ASSETS to the folder that does",
            looked);
        shipped.missing = missing;
    }
    if (!variable("CLEARANCE_ASSETS"))
        each_data(add_own);
    snprintf(furniture, sizeof furniture, "%s/furniture", assets);
    snprintf(beams, sizeof beams, "%s/beams", assets);
    snprintf(cranks, sizeof cranks, "%s/cranks", assets);
    snprintf(houses, sizeof houses, "%s/houses", assets);
    snprintf(help, sizeof help, "%s/help", assets);
    snprintf(lessons, sizeof lessons, "%s/lessons", assets);
    snprintf(rules, sizeof rules, "%s/rules", assets);
    if (access(houses, R_OK) != 0)
        snprintf(houses, sizeof houses, "%s/../houses", assets);
    char *whole = realpath(houses, NULL);
    if (whole)
        snprintf(houses, sizeof houses, "%s", whole);
    free(whole);
}

const char *shipped_own(size_t i) {
    shipped_places();
    return i < own_count ? own[i] : NULL;
}

const Shipped *shipped_places(void) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, find);
    return &shipped;
}

const char *shipped_title(const char *name) {
    static const char *const titles[][2] = {
        {"ibs", "Impact beam (set B)"}, {"ibs-r", "Impact beam (set R)"}, {"ssc", "Slider crank (desk rig)"}};
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        if (strcmp(titles[i][0], name) == 0)
            return titles[i][1];
    return name;
}
