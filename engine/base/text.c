#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

enum { WORD_LONGEST = 63 /* characters compared; longer words are compared by their beginning */ };

static size_t text_difference(const char *a, const char *b) {
    size_t n = strnlen(a, WORD_LONGEST), m = strnlen(b, WORD_LONGEST);
    size_t row[WORD_LONGEST + 1];
    for (size_t j = 0; j <= m; j++)
        row[j] = j;
    for (size_t i = 1; i <= n; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= m; j++) {
            size_t replace = diagonal + (a[i - 1] != b[j - 1]);
            size_t change = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            diagonal = row[j];
            row[j] = replace < change ? replace : change;
        }
    }
    return row[m];
}

const char *text_nearest(const char *word, const char *const *words, size_t count) {
    size_t allowed = strlen(word) / 3 > 2 ? strlen(word) / 3 : 2;
    const char *nearest = NULL;
    for (size_t i = 0; i < count; i++) {
        size_t difference = text_difference(word, words[i]);
        if (difference <= allowed && difference < strlen(words[i])) {
            allowed = difference ? difference - 1 : 0;
            nearest = words[i];
            if (!difference)
                break;
        }
    }
    return nearest;
}

/* Returns the size in bytes of the UTF-8 character that begins the text; 0 at the end. */
static size_t character_size(const char *text) {
    const unsigned char *byte = (const unsigned char *)text;
    if (byte[0] < 0x80)
        return 1;
    size_t size = byte[0] >= 0xf0 ? 4 : byte[0] >= 0xe0 ? 3 : 2;
    unsigned long code = byte[0] & (0x7fu >> size);
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
    for (size_t i = 1; i < size; i++) {
        if ((byte[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (byte[i] & 0x3f);
    }
    bool good = byte[0] >= 0xc0 && byte[0] < 0xf8 && code >= least[size] && code <= 0x10ffff &&
                !(code >= 0xd800 && code <= 0xdfff);
    return good ? size : 0;
}

int text_fitting(const char *text, int most) {
    int length = (int)strnlen(text, (size_t)most + 1);
    if (length <= most)
        return length;
    for (length = most; length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80;)
        length--;
    return length;
}

void text_make_plain(char *line) {
    for (char *c = line; *c;) {
        size_t size = character_size(c);
        if (!size)
            *c = '?';
        else if ((unsigned char)*c < ' ' || *c == 127)
            *c = ' ';
        c += size ? size : 1;
    }
}

static bool regular_only;

void text_read_regular_only(void) {
    regular_only = true;
}

/* Returns 0, or errno for a kind of file that is not read: EMEDIUMTYPE if it is a pipe, a device or a socket. */
static int refusal_of(const struct stat *status) {
    return S_ISDIR(status->st_mode) ? EISDIR : regular_only && !S_ISREG(status->st_mode) ? EMEDIUMTYPE : 0;
}

int text_read_refusal(const char *path) {
    struct stat status;
    return stat(path, &status) ? errno : refusal_of(&status);
}

const char *text_read_reason(int error) {
    return error == EINTR ? "interrupted" : error == EMEDIUMTYPE ? "it is not a regular file" : strerror(error);
}

/* True once a signal has ended the wait for a pipe: the next reader must not wait for the same pipe again. */
static atomic_bool interrupted;

bool text_read_interrupted(void) {
    return atomic_load(&interrupted);
}

static void note_interruption(int error) {
    if (error == EINTR)
        atomic_store(&interrupted, true);
}

/* Opens a file to read it. Returns -1 with errno set if that is not possible. */
static int open_to_read(const char *path, struct stat *status) {
    int error = regular_only ? text_read_refusal(path) : 0;
    if (atomic_load(&interrupted) && stat(path, status) == 0 && !S_ISREG(status->st_mode))
        error = EINTR;
    int file = error ? -1 : open(path, O_RDONLY | O_CLOEXEC | (regular_only ? O_NONBLOCK : 0));
    if (!error)
        error = file < 0 || fstat(file, status) ? errno : refusal_of(status);
    note_interruption(error);
    if (error && file >= 0)
        close(file);
    errno = error;
    return error ? -1 : file;
}

char *text_read_file(const char *path, size_t largest, size_t *size) {
    struct stat status;
    int file = open_to_read(path, &status), error = 0;
    if (file < 0)
        return NULL;
    char *text = NULL;
    size_t capacity = 0, used = 0;
    while (!error) {
        text = memory_reserve(text, &capacity, used + 65536, 1);
        ssize_t got = read(file, text + used, capacity - used - 1);
        if (got == 0)
            break;
        if (got < 0)
            error = errno == EINTR && S_ISREG(status.st_mode) ? 0 : errno;
        else
            used += (size_t)got;
        if (used > largest)
            error = EFBIG;
    }
    close(file);
    note_interruption(error);
    if (error) {
        memory_free(text);
        errno = error;
        return NULL;
    }
    text[used] = 0;
    *size = used;
    return text;
}

char *text_copy(const char *text) {
    return strcpy(memory_zeroed(strlen(text) + 1, 1), text);
}

bool text_is_among(const char *text, const char *const *words, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(words[i], text) == 0)
            return true;
    return false;
}

void text_of_number(char text[TEXT_NUMBER], double value, int digits) {
    const int most = 17; /* enough to tell any two numbers apart */
    do
        snprintf(text, TEXT_NUMBER, "%.*g", digits, value);
    while (strtod(text, NULL) != value && digits++ < most);
}

void text_add(Text *text, const char *more) {
    size_t length = strlen(more);
    text->text = memory_reserve(text->text, &text->capacity, text->used + length + 1, 1);
    memcpy(text->text + text->used, more, length + 1);
    text->used += length;
}

static void add_printed(Text *text, const char *format, va_list arguments) __attribute__((format(printf, 2, 0)));
static void add_printed(Text *text, const char *format, va_list arguments) {
    va_list measured;
    va_copy(measured, arguments);
    int length = vsnprintf(NULL, 0, format, measured);
    va_end(measured);
    text->text = memory_reserve(text->text, &text->capacity, text->used + (size_t)length + 1, 1);
    vsnprintf(text->text + text->used, (size_t)length + 1, format, arguments);
    text->used += (size_t)length;
}

void text_format(Text *text, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    add_printed(text, format, arguments);
    va_end(arguments);
}

char *text_printed(const char *format, va_list arguments) {
    Text text = {0};
    add_printed(&text, format, arguments);
    return text.text;
}

const char *text_vin_arena(Arena *arena, const char *format, va_list arguments) {
    char *text = text_printed(format, arguments);
    const char *kept = arena_text(arena, text);
    memory_free(text);
    return kept;
}

const char *text_in_arena(Arena *arena, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const char *kept = text_vin_arena(arena, format, arguments);
    va_end(arguments);
    return kept;
}

int text_make_folder(const char *path) {
    char *part = text_copy(path);
    int error = 0;
    for (size_t end = 0; path[end] && !error; part[end] = path[end]) {
        end += 1 + strcspn(path + end + 1, "/");
        part[end] = 0;
        error = mkdir(part, 0777) && errno != EEXIST ? errno : 0;
    }
    memory_free(part);
    struct stat status;
    if (!error && stat(path, &status) == 0 && !S_ISDIR(status.st_mode))
        error = ENOTDIR;
    return error ? error : access(path, W_OK | X_OK) ? errno : 0;
}
