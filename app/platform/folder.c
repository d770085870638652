#include "platform/folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"

enum { HEAD = 4096 /* bytes at the beginning of a file, in which it names its format */ };

/* Compares two runs of digits as numbers, without leading zeros. */
static int compare_numbers(const char **a, const char **b) {
    *a += strspn(*a, "0");
    *b += strspn(*b, "0");
    size_t length_a = strspn(*a, "0123456789"), length_b = strspn(*b, "0123456789");
    int order = length_a != length_b ? (length_a < length_b ? -1 : 1) : strncmp(*a, *b, length_a);
    *a += length_a;
    *b += length_b;
    return order;
}

int folder_compare(const char *a, const char *b) {
    const char *first = a, *second = b;
    while (*a && *b) {
        int order;
        if (isdigit((unsigned char)*a) && isdigit((unsigned char)*b))
            order = compare_numbers(&a, &b);
        else
            order = tolower((unsigned char)*a++) - tolower((unsigned char)*b++);
        if (order)
            return order;
    }
    return *a || *b ? (*a ? 1 : -1) : strcmp(first, second);
}

static bool is_json(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot && strcasecmp(dot, ".json") == 0;
}

/* Returns the word W of the format "clearance-W" that a file's first lines name, in the folder's arena; NULL: they name
 * none. */
static const char *format_of(Folder *folder, int stream, const char *name) {
    static const char begin[] = "\"clearance-";
    char head[HEAD + 1];
    int file = openat(stream, name, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    ssize_t got = file >= 0 ? read(file, head, HEAD) : -1;
    if (file >= 0)
        close(file);
    if (got <= 0)
        return NULL;
    head[got] = 0;
    const char *format = strstr(head, begin);
    size_t length = format ? strspn(format + sizeof begin - 1, "abcdefghijklmnopqrstuvwxyz-") : 0;
    if (!length || format[sizeof begin - 1 + length] != '"')
        return NULL;
    return text_in_arena(&folder->arena, "%.*s", (int)length, format + sizeof begin - 1);
}

/* True if the entry is listed: a folder or a file of these kinds that is not hidden. */
static bool kind_of(int stream, const char *name, bool (*also)(const char *name), FolderKind *kind) {
    struct stat status;
    if (*name == '.' || fstatat(stream, name, &status, 0) != 0)
        return false;
    *kind = S_ISDIR(status.st_mode) ? FOLDER_FOLDER : FOLDER_FILE;
    return S_ISDIR(status.st_mode) || (S_ISREG(status.st_mode) && (is_json(name) || (also && also(name))));
}

static const char *path_of(Folder *folder, const char *name) {
    return text_in_arena(&folder->arena, "%s%s%s", folder->path, strcmp(folder->path, "/") == 0 ? "" : "/", name);
}

static void add_above(Folder *folder) {
    const char *slash = strrchr(folder->path, '/');
    if (strcmp(folder->path, "/") == 0)
        return;
    const char *above =
        slash == folder->path ? "/" : text_in_arena(&folder->arena, "%.*s", (int)(slash - folder->path), folder->path);
    folder->entries[folder->count++] = (FolderEntry){"..", above, FOLDER_ABOVE, NULL};
}

static int by_kind_and_name(const void *a, const void *b) {
    const FolderEntry *first = a, *second = b;
    return first->kind != second->kind ? (int)first->kind - (int)second->kind
                                       : folder_compare(first->name, second->name);
}

static void read_entries(Folder *folder, DIR *stream, bool (*also)(const char *name)) {
    folder->entries = memory_zeroed(FOLDER_MOST + 1, sizeof *folder->entries);
    add_above(folder);
    for (struct dirent *entry; (entry = readdir(stream));) {
        FolderKind kind;
        if (!kind_of(dirfd(stream), entry->d_name, also, &kind))
            continue;
        if (folder->count > FOLDER_MOST) {
            folder->left_out++;
            continue;
        }
        const char *name = arena_text(&folder->arena, entry->d_name);
        const char *format = kind == FOLDER_FILE ? format_of(folder, dirfd(stream), name) : NULL;
        folder->entries[folder->count++] = (FolderEntry){name, path_of(folder, name), kind, format};
    }
    qsort(folder->entries, folder->count, sizeof *folder->entries, by_kind_and_name);
}

bool folder_read(Folder *folder, const char *path, bool (*also)(const char *name), Fault *fault) {
    char *whole = realpath(*path ? path : ".", NULL);
    DIR *stream = whole ? opendir(whole) : NULL;
    if (!stream) {
        fault_add(fault, "%s cannot be opened: %s", path, strerror(errno));
        free(whole);
        return false;
    }
    Folder read = {.count = 0};
    read.path = arena_text(&read.arena, whole);
    free(whole);
    read_entries(&read, stream, also);
    closedir(stream);
    folder_clear(folder);
    *folder = read;
    return true;
}

void folder_clear(Folder *folder) {
    memory_free(folder->entries);
    arena_clear(&folder->arena);
    *folder = (Folder){.count = 0};
}
