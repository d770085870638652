/* `--script FILE`: the actions of a person as a text file, for tests and lessons. One command per line; words are
 * separated by blanks, and quoted with " if they contain any (\" \\ \n \t within); # begins a comment.
 *
 *     key Ctrl+M        type "2.5"         mouse X Y           click X Y [left|right|double]
 *     drag X1 Y1 X2 Y2  wheel NOTCHES      wait FRAMES         until complete|idle|answered|shaken [SECONDS]
 *     press [double]    release            at X Y              hold Ctrl|Shift|Alt|nothing
 *     open FILE         laboratory house|beam                  set NAME VALUE       select NAME
 *     play  pause       seek SECONDS       speed TIMES         resize WIDTH HEIGHT
 *     picture FILE      view FILE          state FILE          expect NAME VALUE [TOLERANCE]       quit
 *     texts FILE
 */
#pragma once

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "base/memory.h"

typedef enum ScriptKind {
    SCRIPT_KEY,   /* word: "Ctrl+M" */
    SCRIPT_TYPE,  /* word */
    SCRIPT_MOUSE, /* numbers: x, y, pixels of the window */
    SCRIPT_CLICK, /* numbers: x, y; choice: ScriptClick */
    SCRIPT_DRAG,  /* numbers: x, y, x, y */
    SCRIPT_AT,    /* numbers: x, y, m on the floor, where the mouse moves to */
    SCRIPT_PRESS, /* the left button at the position of the mouse; choice 1: the second press of a double click */
    SCRIPT_RELEASE,
    SCRIPT_HOLD,       /* choice: ScriptHold, the only modifier that is held from now on */
    SCRIPT_WHEEL,      /* number: notches, up positive */
    SCRIPT_WAIT,       /* number: frames */
    SCRIPT_UNTIL,      /* choice: ScriptUntil; number: s of the wall clock after which it fails */
    SCRIPT_OPEN,       /* word: file */
    SCRIPT_LABORATORY, /* word: "house", "beam"; choice: index among `laboratories` */
    SCRIPT_SET,        /* words: name, value as typed; number: value, or NAN */
    SCRIPT_SELECT,     /* word: name of a thing, as Tab reads it */
    SCRIPT_PLAY,
    SCRIPT_PAUSE,
    SCRIPT_SEEK,    /* number: s */
    SCRIPT_SPEED,   /* number: 1 */
    SCRIPT_RESIZE,  /* numbers: pixels */
    SCRIPT_PICTURE, /* word: file, of the whole window */
    SCRIPT_VIEW,    /* word: file, of the plan or the beam alone */
    SCRIPT_STATE,   /* word: file, to which a line is added */
    SCRIPT_TEXTS,   /* word: file, to which a line with the texts of the widgets is added */
    SCRIPT_EXPECT,  /* words: name, value; numbers: value, or NAN, and tolerance */
    SCRIPT_QUIT,
    SCRIPT_KINDS,
} ScriptKind;

typedef enum ScriptClick { SCRIPT_LEFT, SCRIPT_RIGHT, SCRIPT_DOUBLE } ScriptClick;
typedef enum ScriptHold { SCRIPT_NOTHING, SCRIPT_SHIFT, SCRIPT_CTRL, SCRIPT_ALT } ScriptHold;
typedef enum ScriptUntil { SCRIPT_COMPLETE, SCRIPT_IDLE, SCRIPT_ANSWERED, SCRIPT_SHAKEN } ScriptUntil;

enum { SCRIPT_WORDS = 2, SCRIPT_NUMBERS = 4, SCRIPT_PATIENCE = 60 /* s, that `until` waits by default */ };

typedef struct ScriptCommand {
    ScriptKind kind;
    const char *words[SCRIPT_WORDS];
    double numbers[SCRIPT_NUMBERS];
    int choice;
    int line; /* from 1 */
} ScriptCommand;

/* Zero is empty; script_free releases it. */
typedef struct Script {
    const char *path;
    ScriptCommand *commands; /* (count) */
    size_t count, capacity;
    size_t at; /* of the next */
    Arena arena;
} Script;

/* Reads a script. False: a fault `file:line:column: what` for each invalid line, and `script` is unchanged. */
bool script_read(Script *script, const char *path, Fault *fault);
void script_free(Script *script);

/* Returns the next command; NULL: the script has ended. */
const ScriptCommand *script_next(Script *script);

/* Returns the word of a kind, "click". */
const char *script_word(ScriptKind kind);

/* Adds a fault `file:line:1: what` about a command that failed. */
void script_fault(const Script *script, const ScriptCommand *command, Fault *fault, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* True if `state` has the value that an `expect` names. NAME is a path, "answer.title", "people.0.time"; numbers are
 * compared within the tolerance, texts exactly, true, false and null by these words. False: a fault gives the actual
 * value. */
bool script_expect(const Script *script, const ScriptCommand *command, const json_t *state, Fault *fault);
