/* What the sessions of machines whose motion repeats have in common: numbers, presets, choices, the verdict and the
 * orbit diagram of the present machine. It is the first member of a session, so that a session is one of these, too;
 * the functions below that take a context are those of a Laboratory. */
#pragma once

#include "laboratory/laboratory.h"
#include "laboratory/machine/answer.h"
#include "laboratory/machine/diagram.h"
#include "laboratory/machine/map.h"
#include "laboratory/machine/picture.h"

enum { MACHINE_CHOICE_SWEEP, MACHINE_CHOICE_OVER, MACHINE_CHOICES, MACHINE_CHOICES_MOST = 4 };

typedef struct MachineSession MachineSession;

struct MachineSession {
    const MachineKind *kind;
    char *path;
    Machine now; /* the present machine */
    MachineControls controls;
    MachinePicture picture;
    MachineDiagram diagram;
    MachineMap map;
    MachineWorker *worker;
    MachineAnswer answer;
    MachineVerdict verdict;
    bool has_verdict; /* the verdict is known */
    size_t looked;    /* front of the record when the answer was last written */
    double shown;     /* s, the displayed time */
    unsigned news;    /* LABORATORY_... bits of the next update */
    PanelChoice choices[MACHINE_CHOICES_MOST];
    size_t choice_count;
    Arena command_words;
    const char *command[3 + 2 * MACHINE_VALUES];
    char where[64]; /* "300.0 Hz, gap 0.25 mm" */

    /* Changes the record from the end of the displayed cycle on. False: a fault, and the record is unchanged. */
    bool (*change_record)(MachineSession *session, const Machine *machine, Fault *fault);

    /* Writes the state of the running motion at phase 0; returns the count, at most MACHINE_STATES_MOST, or 0: unknown.
     * NULL: orbits cannot be followed. */
    size_t (*state)(const MachineSession *session, double *state);

    /* Draws the record at a time into the picture, and shows its plots. True: the static layer has changed. */
    bool (*draw)(MachineSession *session, double time);

    /* Rewrites the answer if the record has grown. */
    void (*look)(MachineSession *session);
};

/* Opens a zeroed session, whose functions are set, with a copy of the path. `opened` is the file's machine changed
 * by the settings, `file` the one without them; their texts must outlive it. */
void machine_session_open(MachineSession *session, const MachineKind *kind, const char *path, int jobs,
                          const Machine *opened, const Machine *file);
void machine_session_close(MachineSession *session);

/* Asks for the orbit diagram of the present machine and, if wanted, for its verdict. */
void machine_session_ask(MachineSession *session, bool verdict);

/* Writes the answer of a record whose last cycles show `lately`. */
void machine_session_write(MachineSession *session, CycleStatus status, bool changed, const MachineLately *lately);

const PanelParameter *machine_session_parameters(const void *context, size_t *count);
bool machine_session_set(void *context, const char *name, double value, Fault *fault);
void machine_session_reset(void *context);
const Preset *machine_session_presets(const void *context, size_t *count);
void machine_session_apply_preset(void *context, size_t preset);
const PanelChoice *machine_session_choices(void *context, size_t *count);
void machine_session_choose(void *context, size_t choice, size_t word);
const char *const *machine_session_command(void *context, size_t *count);
bool machine_session_follow(void *context);
void machine_session_note_plots(void *context, const char *names);
unsigned machine_session_update(void *context, double time);
Result machine_session_answer(void *context);
const PanelRow *machine_session_rows(const void *context, size_t *count);
