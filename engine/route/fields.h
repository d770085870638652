/* Fields that several searches share: bodies of one kind that go to one goal need the same times. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

#include "route/field.h"

/* What a field is built for. Plan, space and profile are known by where they are: they must neither move nor change as
 * long as the fields live. */
typedef struct FieldKey {
    const Plan *plan;
    const FreeSpace *space;
    const Profile *profile;
    double radius; /* m, of the disc */
    bool exact;    /* the ground has no allowance for the grid's rounding */
    Goal goal;
    const volatile sig_atomic_t *stop; /* of the ground */
} FieldKey;

/* Opaque; safe to use from several threads. What is answered does not depend on who asked before. */
typedef struct Fields Fields;

Fields *fields_create(void);
/* Everything has to be given back before. */
void fields_destroy(Fields *fields);

/* The field of a key, which has its ground; built unless it is there already. fields_release it: only then it may make
 * room for others, which it does when all take more than FIELDS_MOST_BYTES. */
const Field *fields_acquire(Fields *fields, const FieldKey *key);
void fields_release(Fields *fields, const Field *field);

#define FIELDS_MOST_BYTES ((size_t)256 << 20)
