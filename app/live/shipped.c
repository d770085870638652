#include "live/shipped.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { PATH_MOST = 4096 };

static char profiles[PATH_MOST], furniture[PATH_MOST], beams[PATH_MOST], houses[PATH_MOST],
    default_house[PATH_MOST + 32];
static const Shipped shipped = {profiles, furniture, beams, houses, default_house};

static void find(void) {
    const char *assets = getenv("CLEARANCE_ASSETS");
    if (!assets)
        assets = access(CLEARANCE_SOURCE_ASSETS, R_OK) == 0 ? CLEARANCE_SOURCE_ASSETS : CLEARANCE_INSTALLED_ASSETS;
    snprintf(profiles, PATH_MOST, "%s/profiles", assets);
    snprintf(furniture, PATH_MOST, "%s/furniture", assets);
    snprintf(beams, PATH_MOST, "%s/beams", assets);
    snprintf(houses, PATH_MOST, "%s/houses", assets);
    if (access(houses, R_OK) != 0)
        snprintf(houses, PATH_MOST, "%s/../houses", assets);
    char *whole = realpath(houses, NULL);
    if (whole)
        snprintf(houses, PATH_MOST, "%s", whole);
    free(whole);
    snprintf(default_house, sizeof default_house, "%s/ube-techno-house.json", houses);
}

const Shipped *shipped_places(void) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    pthread_once(&once, find);
    return &shipped;
}
