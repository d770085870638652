/* Where and how fast many drivers go, across the way of the nominal one: quantiles of their places and speeds. */
#pragma once

#include "draw/scene.h"
#include "experiment/drivers.h"

/* At a place of the nominal driver's way. */
typedef struct BandStation {
    Vec2 at, left;                       /* m, unit */
    double way;                          /* m, along the nominal driver's way */
    size_t drivers;                      /* who pass here; below BAND_LEAST quantiles are not computed */
    double low, quarters[2], high;       /* m to the left: 5, 25, 75 and 95 % of the drivers */
    double slow, speeds[2], fast, speed; /* m/s: the same of their speeds, and the nominal one */
} BandStation;

typedef struct DriversBand {
    BandStation *stations; /* (count) */
    size_t count;
} DriversBand;

enum { BAND_LEAST = 5 };

/* Makes the band of a person; `nominal` is the trace of the nominal driver. drivers_band_free releases it. */
DriversBand drivers_band_make(const Drivers *drivers, const Trace *nominal, size_t person);
void drivers_band_free(DriversBand *band);

/* Draws the bands of all people of the population, and a row that explains them. */
void drivers_band_add(Scene *scene, const Drivers *drivers, const Trace *nominal);
