/* A cache of what several searches share: the frames of a plan, and fields, since bodies of one kind with one goal need
 * the same times. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "base/stop.h"
#include "route/field.h"
#include "route/frame.h"

/* The inputs of a field. Plan, space and profile are identified by address: they must neither move nor change as long
 * as the fields live. */
typedef struct FieldKey {
    const Plan *plan;
    const FreeSpace *space;
    const Profile *profile;
    double radius; /* m, of the disc */
    bool exact;    /* True if the ground has no allowance for the grid's rounding */
    Goal goal;
    const Stop *stop; /* stop flag of the ground */
    FieldBars bars;
} FieldKey;

/* Opaque; safe for several threads. The results do not depend on earlier requests. */
typedef struct Fields Fields;

Fields *fields_create(void);
/* Destroys the cache with its frames; every field must have been released. */
void fields_destroy(Fields *fields);

/* Returns the field of a key, with its ground, and builds it if it is not cached. The caller must release the field
 * with fields_release; unused fields are dropped when all fields take more than FIELDS_MOST_BYTES. */
const Field *fields_acquire(Fields *fields, const FieldKey *key);
void fields_release(Fields *fields, const Field *field);

/* Returns the frame of a plan in a sense (frame_sense), built once, which lives as long as the cache; NULL if there is
 * none, as frame_build says. The plan is identified by address, too. */
const RouteFrame *fields_frame(Fields *fields, const Plan *plan, int sense);

#define FIELDS_MOST_BYTES ((size_t)256 << 20)
