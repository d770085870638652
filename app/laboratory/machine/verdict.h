/* The motion of a machine from rest, as `clearance run` prints it: the verdict first, then the type and advice. */
#pragma once

#include "base/stop.h"
#include "base/text.h"
#include "laboratory/machine/machine.h"
#include "study/types.h"

typedef struct MachineVerdict {
    const MachineKind *kind;
    Machine machine;    /* which the verdict is for */
    MachineFacts facts; /* empty until the verdict is known */
    bool typed;         /* the type is known */
    TypesKind type;
    char *advice; /* sentences, one per line; NULL: none; machine_verdict_clear releases the advice and the facts */
} MachineVerdict;

/* Runs the machine and fills the verdict. False: the run was stopped, or a fault. */
bool machine_verdict_decide(MachineVerdict *verdict, const MachineKind *kind, const Machine *machine, const Stop *stop);

/* Also determines the type; progress as in TypesTask. False: the search was stopped, or a fault, and the verdict is
 * unchanged. */
bool machine_verdict_tell_type(MachineVerdict *verdict, int jobs, const Stop *stop,
                               void (*progress)(void *context, size_t done, size_t all), void *context);

enum { MACHINE_BANDS_MOST = 16 /* values whose types are told along an orbit diagram */ };

/* Tells the type at one value of a parameter by quick runs. Returns TYPES_UNRESOLVED where it is unknown or was
 * stopped. */
TypesKind machine_verdict_type_at(const MachineKind *kind, const Machine *machine, const char *name, double value,
                                  int jobs, const Stop *stop);

/* Confirms a quick verdict by motions that are watched (survival.h), and replaces it. False: stopped, or a fault, and
 * the verdict is unchanged. */
bool machine_verdict_confirm(MachineVerdict *verdict, int jobs, const Stop *stop);

/* Returns a copy with its own rows and advice. */
MachineVerdict machine_verdict_copy(const MachineVerdict *verdict);

void machine_verdict_clear(MachineVerdict *verdict);
