#include "platform/export.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/memory.h"
#include "base/text.h"
#include "platform/folder.h"

enum {
    NAME_LONGEST = 100, /* bytes of a file's name, without number and ending */
    NUMBERS_MOST = 100000,
    LINE_MOST = 1000, /* characters of a line of the child's standard error */
    FAILED = 2,       /* the program's exit code when it fails */
};

/* s: how long a cancelled child may take to finish its file, and how long it may take when the window closes. */
static const double PATIENCE = 5, LAST_PATIENCE = 1;

/* Where ------------------------------------------------------------------------------------------------------------ */

char *export_place(void) {
    const char *home = getenv("HOME");
    char place[PATH_MAX];
    bool homeless = !home || !*home;
    if (access("out", W_OK | X_OK) == 0 || homeless)
        snprintf(place, sizeof place, homeless ? "clearance" : "out/clearance");
    else
        snprintf(place, sizeof place, "%s/clearance", home);
    return text_copy(place);
}

char *export_folder(Fault *fault) {
    const char *home = getenv("HOME");
    char in_home[NAME_MAX + PATH_MAX] = "";
    if (home && *home)
        snprintf(in_home, sizeof in_home, "%s/clearance", home);
    const char *places[] = {access("out", W_OK | X_OK) == 0 ? "out/clearance" : "", in_home, "clearance"};
    int error = 0;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        error = *places[i] ? text_make_folder(places[i]) : error;
        if (*places[i] && !error)
            return text_copy(places[i]);
    }
    fault_add(fault, "no folder for exports can be made, neither %s nor clearance/ in the current folder: %s",
              *in_home ? in_home : "$HOME/clearance", strerror(error));
    return NULL;
}

/* Adds a name without the characters that are awkward in file names, in a shell or on another system. */
static void add_name(Text *path, const char *name) {
    size_t begin = path->used;
    for (const char *c = name; *c; c++) {
        bool inside = ((unsigned char)*c & 0xc0) == 0x80; /* a continuation byte of UTF-8 */
        bool plain = (unsigned char)*c > ' ' && *c != 127 && !strchr("/\\:*?\"'<>|$&;`()[]{}!#~^", *c);
        bool first = path->used == begin, after_blank = !first && path->text[path->used - 1] == '-';
        if (path->used - begin >= NAME_LONGEST && !inside)
            break;
        if (plain && !(first && strchr(".-", *c)))
            text_add(path, (char[]){*c, 0});
        else if (!plain && !first && !after_blank)
            text_add(path, "-");
    }
    while (path->used > begin && path->text[path->used - 1] == '-')
        path->text[--path->used] = 0;
    if (path->used == begin)
        text_add(path, "picture");
}

static bool is_free(const char *path, const char *const *endings) {
    Text whole = {0};
    bool free = true;
    for (; *endings && free; endings++) {
        whole.used = 0;
        text_format(&whole, "%s%s%s", path, **endings ? "." : "", *endings);
        free = access(whole.text, F_OK) != 0;
    }
    memory_free(whole.text);
    return free;
}

char *export_free_name(const char *folder, const char *name, const char *const *endings) {
    Text path = {0};
    text_format(&path, "%s/", folder);
    add_name(&path, name);
    size_t used = path.used;
    for (int number = 2; number < NUMBERS_MOST && !is_free(path.text, endings); number++) {
        path.used = used;
        text_format(&path, "-%d", number);
    }
    return path.text;
}

/* A command -------------------------------------------------------------------------------------------------------- */

/* Adds a word, in quotes where a shell would read it as something else. */
static void add_quoted(Text *text, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (*word && !word[strspn(word, plain)]) {
        text_add(text, word);
        return;
    }
    text_add(text, "'");
    for (; *word; word++)
        text_add(text, *word == '\'' ? "'\\''" : (char[]){*word, 0});
    text_add(text, "'");
}

char *export_command(const char *const *words, size_t count) {
    Text text = {0};
    text_add(&text, "clearance");
    for (size_t i = 0; i < count; i++) {
        text_add(&text, " ");
        add_quoted(&text, words[i]);
    }
    return text.text;
}

struct Export {
    pid_t child; /* 0: the child has ended */
    int pipe;    /* the child's standard error */
    bool cancelled;
    double asked;     /* s, when the child was asked to end */
    Text line;        /* the unfinished line of the child */
    bool overwrites;  /* the line began with a carriage return, so it is progress */
    Text doing, said; /* the last progress, and the last other line */
    const char *out, *movie;
    const char **files; /* (file_count) */
    size_t file_count, file_capacity;
    ExportStatus status;
    Arena arena; /* holds the names of the files */
};

static char *copy_in(Arena *arena, const char *text) {
    size_t size = strlen(text) + 1;
    return memcpy(arena_allocate(arena, size), text, size);
}

/* Returns the child's arguments, copied into the arena, as posix_spawn may change them; release the array by
 * memory_free. */
static char **make_arguments(const ExportOrder *order, Arena *arena) {
    char **arguments = memory_zeroed(order->argument_count + order->option_count + 6, sizeof *arguments);
    char **end = arguments;
    *end++ = copy_in(arena, "clearance");
    for (size_t i = 0; i < order->argument_count; i++)
        *end++ = copy_in(arena, order->arguments[i]);
    for (size_t i = 0; i < order->option_count; i++)
        *end++ = copy_in(arena, order->options[i]);
    if (order->out) {
        *end++ = copy_in(arena, "--out");
        *end++ = copy_in(arena, order->out);
    }
    if (order->movie) {
        *end++ = copy_in(arena, "--movie");
        *end++ = copy_in(arena, order->movie);
    }
    return arguments;
}

extern char **environ;

/* Returns the environment with the variable that makes the child print progress; release the array by memory_free. */
static char **make_environment(Arena *arena) {
    size_t count = 0;
    while (environ[count])
        count++;
    char **copy = memory_zeroed(count + 2, sizeof *copy);
    memcpy(copy, environ, count * sizeof *copy);
    copy[count] = copy_in(arena, "CLEARANCE_PROGRESS=1");
    return copy;
}

/* Starts the child in a process group of its own: Ctrl-C in a terminal ends the window, and the window ends the child.
 * Returns 0 or errno. */
static int spawn(Export *export, const ExportOrder *order, int writing) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGINT);
    sigaddset(&usual, SIGPIPE);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, writing, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    char **arguments = make_arguments(order, &export->arena), **environment = make_environment(&export->arena);
    const char *program = order->program ? order->program : "/proc/self/exe";
    int error = posix_spawn(&export->child, program, &actions, &attributes, arguments, environment);
    memory_free(arguments);
    memory_free(environment);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

Export *export_begin(const ExportOrder *order, Fault *fault) {
    int ends[2], error = pipe2(ends, O_CLOEXEC) ? errno : 0;
    Export *export = memory_zeroed(1, sizeof *export);
    if (!error) {
        error = spawn(export, order, ends[1]);
        close(ends[1]);
        export->pipe = ends[0];
        fcntl(export->pipe, F_SETFL, O_NONBLOCK);
        if (error)
            close(ends[0]);
    }
    if (error) {
        fault_add(fault, "the program cannot start itself: %s", strerror(error));
        arena_clear(&export->arena);
        memory_free(export);
        return NULL;
    }
    export->out = order->out ? arena_text(&export->arena, order->out) : "";
    export->movie = order->movie ? arena_text(&export->arena, order->movie) : NULL;
    text_add(&export->doing, "");
    text_add(&export->said, "");
    text_add(&export->line, "");
    return export;
}

static void replace(Text *text, const char *words, size_t length) {
    text->used = 0;
    text_format(text, "%.*s", (int)length, words);
}

/* Returns the length of a line without the blanks at its end. */
static size_t length_of(const Text *line) {
    size_t length = line->used;
    while (length && line->text[length - 1] == ' ')
        length--;
    return length;
}

/* Takes the line as progress or as a message: text after a carriage return is progress, unless a message follows it. */
static void read_line(Export *export, bool ended) {
    const char *words = export->line.text, *sentence = strstr(words, "clearance: ");
    size_t length = length_of(&export->line);
    if (length && export->overwrites && !sentence)
        replace(&export->doing, words, length);
    else if (length && ended && sentence && export->overwrites)
        replace(&export->said, sentence, length - (size_t)(sentence - words));
    else if (length && ended)
        replace(&export->said, words, length);
    export->line.used = 0;
    export->line.text[0] = 0;
    export->overwrites = !ended;
}

static void read_said(Export *export) {
    char said[4096];
    ssize_t got;
    while ((got = read(export->pipe, said, sizeof said)) > 0)
        for (ssize_t i = 0; i < got; i++) {
            if (said[i] == '\r' || said[i] == '\n')
                read_line(export, said[i] == '\n');
            else if (said[i] && export->line.used < LINE_MOST)
                text_add(&export->line, (char[]){said[i], 0});
        }
    /* the newest progress is at the end of the output, with nothing behind it yet */
    size_t length = length_of(&export->line);
    if (export->overwrites && length && !strstr(export->line.text, "clearance: "))
        replace(&export->doing, export->line.text, length);
}

/* Reads the share that is done out of "picture 40 of 300" or "types: 40 of at most 768 runs"; NAN if it is not known.
 */
static double part_of(const char *doing) {
    size_t done, all;
    const char *number = doing + strcspn(doing, "0123456789");
    bool known =
        sscanf(number, "%zu of %zu", &done, &all) == 2 || sscanf(number, "%zu of at most %zu", &done, &all) == 2;
    return known && all && done <= all ? (double)done / (double)all : NAN;
}

static int is_shown(const struct dirent *entry) {
    return *entry->d_name != '.';
}

static int by_name(const struct dirent **a, const struct dirent **b) {
    return folder_compare((*a)->d_name, (*b)->d_name);
}

static void add_file(Export *export, const char *name) {
    export->files =
        memory_reserve(export->files, &export->file_capacity, export->file_count + 1, sizeof *export->files);
    export->files[export->file_count++] = arena_text(&export->arena, name);
}

/* Lists the files of a folder, and those of the folders in it: "frames/frame-00001.png". */
static void list_folder(Export *export, const char *folder, const char *before) {
    struct dirent **entries = NULL;
    int count = scandir(folder, &entries, is_shown, by_name);
    for (int i = 0; i < count; i++) {
        const char *name = text_in_arena(&export->arena, "%s%s", before, entries[i]->d_name);
        const char *path = text_in_arena(&export->arena, "%s/%s", folder, entries[i]->d_name);
        struct stat status;
        if (lstat(path, &status) == 0 && S_ISDIR(status.st_mode))
            list_folder(export, path, text_in_arena(&export->arena, "%s/", name));
        else
            add_file(export, name);
        free(entries[i]);
    }
    free(entries);
}

static void list_files(Export *export) {
    if (*export->out)
        list_folder(export, export->out, "");
    if (export->movie && access(export->movie, F_OK) == 0)
        add_file(export, export->movie);
}

static void conclude(Export *export, int how) {
    ExportStatus *status = &export->status;
    bool ended = WIFEXITED(how);
    int code = ended ? WEXITSTATUS(how) : 0;
    export->child = 0;
    list_files(export);
    if (ended && (code == 0 || (code == 1 && !export->cancelled))) {
        status->stage = EXPORT_DONE;
        status->no = code == 1;
        return;
    }
    status->stage = export->cancelled ? EXPORT_CANCELLED : EXPORT_FAILED;
    if (export->cancelled)
        replace(&export->said, "cancelled", strlen("cancelled"));
    else if (!ended)
        replace(&export->said, strsignal(WTERMSIG(how)), LINE_MOST);
    else if (!export->said.used)
        text_format(&export->said, "the export ended with exit code %d", code);
}

const ExportStatus *export_update(Export *export) {
    int how;
    if (export->child) {
        pid_t ended = waitpid(export->child, &how, WNOHANG);
        read_said(export);
        if (ended < 0)
            how = FAILED << 8; /* the exit code is lost */
        if (ended)
            conclude(export, how);
        else if (export->cancelled && stopwatch_now() - export->asked > PATIENCE)
            kill(export->child, SIGKILL);
    }
    ExportStatus *status = &export->status;
    bool over = status->stage != EXPORT_RUNNING;
    status->doing = over ? "" : export->doing.text;
    status->part = status->stage == EXPORT_DONE ? 1 : part_of(status->doing);
    status->reason = over && status->stage != EXPORT_DONE ? export->said.text : "";
    status->folder = *export->out || !export->movie ? export->out : export->movie;
    status->files = export->files;
    status->file_count = export->file_count;
    return status;
}

void export_cancel(Export *export) {
    if (!export->child || export->cancelled)
        return;
    export->cancelled = true;
    export->asked = stopwatch_now();
    kill(export->child, SIGINT);
}

/* Ends the child, after a moment in which it may finish its file. */
static void end_child(Export *export) {
    export_cancel(export);
    export->asked = stopwatch_now();
    while (export_update(export)->stage == EXPORT_RUNNING) {
        if (stopwatch_now() - export->asked > LAST_PATIENCE)
            kill(export->child, SIGKILL);
        usleep(10000);
    }
}

void export_end(Export *export) {
    if (export->child)
        end_child(export);
    close(export->pipe);
    memory_free(export->line.text);
    memory_free(export->doing.text);
    memory_free(export->said.text);
    memory_free(export->files);
    arena_clear(&export->arena);
    memory_free(export);
}
