/* A library to preload: it fails the n-th allocation or the n-th write of a program, its libraries included, as a full
 * memory or a full disk would. CLEARANCE_FAIL=allocation:N or write:N chooses; allocation:count and write:count print
 * at the end how many there were. Standard error is never failed, nor an allocation that Mesa makes, which draws less
 * without a word when it has no memory. The object whose allocation failed is printed. Only for the GNU C library. */
#undef _FILE_OFFSET_BITS /* or `open` would be a name of `open64` */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *block, size_t size);

typedef struct Kind {
    const char *name;
    atomic_long seen;
    long fails_at; /* 0: never */
    bool counts;
} Kind;

static Kind allocation = {.name = "allocation"}, writing = {.name = "write"};

static void read_kind(Kind *kind, const char *wish) {
    size_t length = strlen(kind->name);
    if (!wish || strncmp(wish, kind->name, length) != 0 || wish[length] != ':')
        return;
    kind->counts = strcmp(wish + length + 1, "count") == 0;
    kind->fails_at = kind->counts ? 0 : strtol(wish + length + 1, NULL, 10);
}

/* Programs that this one starts are left alone. */
__attribute__((constructor)) static void begin(void) {
    const char *wish = getenv("CLEARANCE_FAIL");
    read_kind(&allocation, wish);
    read_kind(&writing, wish);
    atomic_store(&allocation.seen, 0);
    atomic_store(&writing.seen, 0);
    unsetenv("CLEARANCE_FAIL");
    unsetenv("LD_PRELOAD");
}

__attribute__((destructor)) static void print_counts(void) {
    const Kind *kinds[] = {&allocation, &writing};
    for (size_t k = 0; k < 2; k++) {
        char text[64];
        if (!kinds[k]->counts)
            continue;
        int length = snprintf(text, sizeof text, "%ss: %ld\n", kinds[k]->name, atomic_load(&kinds[k]->seen));
        (void)!write(STDERR_FILENO, text, (size_t)length);
    }
}

static bool fails(Kind *kind, int error) {
    if (!kind->counts && !kind->fails_at)
        return false;
    if (atomic_fetch_add(&kind->seen, 1) + 1 != kind->fails_at)
        return false;
    errno = error;
    return true;
}

static bool write_fails(int file) {
    return file != STDERR_FILENO && fails(&writing, ENOSPC);
}

/* Marks the stream as the C library does when a write fails. */
static bool stream_fails(FILE *stream) {
    enum { ERROR_SEEN = 0x20 /* _IO_ERR_SEEN */ };
    if (stream == stderr || !fails(&writing, ENOSPC))
        return false;
    stream->_flags |= ERROR_SEEN;
    return true;
}

static const char *object_of(const void *caller) {
    Dl_info object;
    const char *path = dladdr(caller, &object) && object.dli_fname ? object.dli_fname : "?", *name = strrchr(path, '/');
    return name ? name + 1 : path;
}

/* Fails the n-th allocation, or the next one that is not Mesa's. */
static bool allocation_fails(const void *caller) {
    if (!fails(&allocation, ENOMEM))
        return false;
    const char *object = object_of(caller);
    if (strstr(object, "libOSMesa")) {
        atomic_fetch_sub(&allocation.seen, 1);
        return false;
    }
    char text[128];
    int length = snprintf(text, sizeof text, "allocation failed in %s\n", object);
    (void)!write(STDERR_FILENO, text, (size_t)length);
    return true;
}

#define NEXT(name) __typeof__(name) *next = (__typeof__(name) *)dlsym(RTLD_NEXT, #name)

void *malloc(size_t size) {
    return allocation_fails(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
    return allocation_fails(__builtin_return_address(0)) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *block, size_t size) {
    return allocation_fails(__builtin_return_address(0)) ? NULL : __libc_realloc(block, size);
}

ssize_t write(int file, const void *bytes, size_t count) {
    NEXT(write);
    return write_fails(file) ? -1 : next(file, bytes, count);
}

ssize_t pwrite(int file, const void *bytes, size_t count, off_t at) {
    NEXT(pwrite);
    return write_fails(file) ? -1 : next(file, bytes, count, at);
}

ssize_t pwrite64(int file, const void *bytes, size_t count, off64_t at) {
    NEXT(pwrite64);
    return write_fails(file) ? -1 : next(file, bytes, count, at);
}

int fsync(int file) {
    NEXT(fsync);
    return write_fails(file) ? -1 : next(file);
}

int fdatasync(int file) {
    NEXT(fdatasync);
    return write_fails(file) ? -1 : next(file);
}

int rename(const char *from, const char *to) {
    NEXT(rename);
    return write_fails(-1) ? -1 : next(from, to);
}

int renameat(int from_folder, const char *from, int to_folder, const char *to) {
    NEXT(renameat);
    return write_fails(-1) ? -1 : next(from_folder, from, to_folder, to);
}

int memfd_create(const char *name, unsigned flags) {
    NEXT(memfd_create);
    return write_fails(-1) ? -1 : next(name, flags);
}

#define SIZE(name, offset)                                                                                             \
    int name(int file, offset size) {                                                                                  \
        NEXT(name);                                                                                                    \
        return write_fails(file) ? -1 : next(file, size);                                                              \
    }
SIZE(ftruncate, off_t)
SIZE(ftruncate64, off64_t)

#define ALLOCATE(name, offset)                                                                                         \
    int name(int file, int mode, offset at, offset size) {                                                             \
        NEXT(name);                                                                                                    \
        return write_fails(file) ? -1 : next(file, mode, at, size);                                                    \
    }
ALLOCATE(fallocate, off_t)
ALLOCATE(fallocate64, off64_t)

static bool creates(int flags) {
    return (flags & O_ACCMODE) != O_RDONLY;
}

#define OPEN(name)                                                                                                     \
    int name(const char *path, int flags, ...) {                                                                       \
        va_list rest;                                                                                                  \
        va_start(rest, flags);                                                                                         \
        mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(rest, mode_t) : 0;                                      \
        va_end(rest);                                                                                                  \
        NEXT(name);                                                                                                    \
        return creates(flags) && write_fails(-1) ? -1 : next(path, flags, mode);                                       \
    }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                                                                   \
    int name(int folder, const char *path, int flags, ...) {                                                           \
        va_list rest;                                                                                                  \
        va_start(rest, flags);                                                                                         \
        mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(rest, mode_t) : 0;                                      \
        va_end(rest);                                                                                                  \
        NEXT(name);                                                                                                    \
        return creates(flags) && write_fails(-1) ? -1 : next(folder, path, flags, mode);                               \
    }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(name)                                                                                                    \
    FILE *name(const char *path, const char *mode) {                                                                   \
        NEXT(name);                                                                                                    \
        return *mode != 'r' && write_fails(-1) ? NULL : next(path, mode);                                              \
    }
FOPEN(fopen)
FOPEN(fopen64)

FILE *fdopen(int file, const char *mode) {
    NEXT(fdopen);
    return *mode != 'r' && write_fails(file) ? NULL : next(file, mode);
}

size_t fwrite(const void *bytes, size_t size, size_t count, FILE *stream) {
    NEXT(fwrite);
    return stream_fails(stream) ? 0 : next(bytes, size, count, stream);
}

int fputs(const char *text, FILE *stream) {
    NEXT(fputs);
    return stream_fails(stream) ? EOF : next(text, stream);
}

int fputc(int letter, FILE *stream) {
    NEXT(fputc);
    return stream_fails(stream) ? EOF : next(letter, stream);
}

int puts(const char *text) {
    NEXT(puts);
    return stream_fails(stdout) ? EOF : next(text);
}

int putchar(int letter) {
    NEXT(putchar);
    return stream_fails(stdout) ? EOF : next(letter);
}

int vfprintf(FILE *stream, const char *format, va_list values) {
    NEXT(vfprintf);
    return stream_fails(stream) ? -1 : next(stream, format, values);
}

int fprintf(FILE *stream, const char *format, ...) {
    va_list values;
    va_start(values, format);
    int done = vfprintf(stream, format, values);
    va_end(values);
    return done;
}

int printf(const char *format, ...) {
    va_list values;
    va_start(values, format);
    int done = vfprintf(stdout, format, values);
    va_end(values);
    return done;
}

int fflush(FILE *stream) {
    NEXT(fflush);
    return stream && stream_fails(stream) ? EOF : next(stream);
}

/* A stream that is only read has nothing to lose. */
int fclose(FILE *stream) {
    enum { NO_WRITES = 0x8 /* _IO_NO_WRITES */ };
    NEXT(fclose);
    bool lost = !(stream->_flags & NO_WRITES) && write_fails(fileno(stream));
    int done = next(stream);
    if (lost)
        errno = ENOSPC;
    return lost ? EOF : done;
}
