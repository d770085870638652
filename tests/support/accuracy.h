/* How far the functions of base/real are from the C library's of long double, over random arguments. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* A function and where its arguments come from. */
typedef struct AccuracyCase {
    const char *name;
    void (*draw)(uint64_t *state, double *x, double *y);
    double (*own)(double x, double y);
    long double (*reference)(double x, double y);
    double (*library)(double x, double y); /* the C library's, of double, for its speed */
} AccuracyCase;

extern const AccuracyCase accuracy_list[];
extern const size_t accuracy_count;

typedef struct Accuracy {
    double worst; /* units in the last place of the reference */
    double x, y;  /* the arguments */
} Accuracy;

Accuracy accuracy_measure(const AccuracyCase *what, long arguments);

/* A number of either sign whose exponent is evenly spread between two. */
double accuracy_spread(uint64_t *state, double low, double high);
