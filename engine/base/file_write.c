#include "base/file_write.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"

/* Temporary files are named .clearance-PROCESS-COUNT.part. Their process locks them, and the system unlocks them when
 * the process ends, so that an unlocked one was left by a killed process. */
#define PART_BEGIN ".clearance-"
#define PART_END ".part"
#define COPY_END ".before-saving"

enum { LINKS_MOST = 40, COPIES_MOST = 99, BLOCK = 1 << 16 /* bytes */, PART_NAME = 80 /* bytes */ };

struct FileWrite {
    char *path;         /* of the file itself, behind all links */
    const char *name;   /* last part of the path */
    struct stat before; /* the file as it was; only if it exists */
    bool exists, to_disk;
    bool in_place; /* a rename would lose something */
    int folder;    /* descriptor; -1 for special files */
    int special;   /* descriptor of a pipe or a device; -1: it is a regular file */
    int part;      /* descriptor of the new contents */
    int part_folder;
    char part_name[PART_NAME]; /* empty: the new contents are in memory */
    char *part_path;
    FILE *stream;
    int stream_error; /* the first error of the stream, as errno; 0: none */
};

/* Bytes ------------------------------------------------------------------------------------------------------------ */

/* Returns 0 or errno. Regular files are written to their end; a signal ends the wait for the reader of a pipe. */
static int write_bytes(int file, const char *bytes, size_t size, bool is_regular) {
    while (size > 0) {
        ssize_t now = write(file, bytes, size);
        if (now < 0 && (errno != EINTR || !is_regular))
            return errno;
        if (now == 0)
            return EIO;
        bytes += now > 0 ? now : 0;
        size -= now > 0 ? (size_t)now : 0;
    }
    return 0;
}

/* Copies all bytes of a file to the current place of another one. */
static int copy_bytes(int to, int from, bool is_regular) {
    char *block = memory_zeroed(BLOCK, 1);
    int error = 0;
    for (off_t at = 0; !error;) {
        ssize_t got = pread(from, block, BLOCK, at);
        if (got == 0)
            break;
        if (got < 0)
            error = errno == EINTR ? 0 : errno;
        else
            error = write_bytes(to, block, (size_t)got, is_regular);
        at += got > 0 ? got : 0;
    }
    memory_free(block);
    return error;
}

static int sync_file(int file) {
    while (fsync(file))
        if (errno != EINTR)
            return errno;
    return 0;
}

/* Syncs a folder, if it may be read and its file system syncs folders. */
static int sync_folder(int folder) {
    int error = sync_file(folder);
    return error == EBADF || error == EINVAL || error == EROFS || error == ENOTSUP ? 0 : error;
}

/* Overwrites a file in place. It is cut at the end, so that a full disk is found while most of the old bytes stand. */
static int overwrite(int file, int from) {
    struct stat status;
    if (fstat(from, &status) || lseek(file, 0, SEEK_SET) < 0)
        return errno;
    if (status.st_size > 0 && fallocate(file, FALLOC_FL_KEEP_SIZE, 0, status.st_size) &&
        (errno == ENOSPC || errno == EDQUOT || errno == EFBIG))
        return errno;
    int error = copy_bytes(file, from, true);
    if (!error && ftruncate(file, status.st_size))
        error = errno;
    return error ? error : sync_file(file);
}

/* Paths ------------------------------------------------------------------------------------------------------------ */

static const char *last_part(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Returns the folder of a path, as text; memory_free it. */
static char *folder_of(const char *path) {
    size_t length = (size_t)(last_part(path) - path);
    Text text = {0};
    text_format(&text, "%.*s", length ? (int)length : 1, length ? path : ".");
    return text.text;
}

/* Returns "FOLDER/NAME"; memory_free it. */
static char *join(const char *folder, const char *name) {
    Text text = {0};
    text_format(&text, "%s/%s", folder, name);
    return text.text;
}

/* Returns the descriptor of this process that a path stands for, as /dev/stdout does; -1: none. */
static int own_descriptor(const char *path) {
    char own[PATH_MAX], wanted[64], *end;
    char *folder = folder_of(path);
    const char *whole = realpath(folder, own), *name = last_part(path);
    memory_free(folder);
    snprintf(wanted, sizeof wanted, "/proc/%ld/fd", (long)getpid());
    long descriptor = strtol(name, &end, 10);
    return whole && strcmp(whole, wanted) == 0 && *name && !*end && descriptor <= INT_MAX ? (int)descriptor : -1;
}

/* Replaces *path by the path of the file that it leads to through symbolic links, which need not exist. Stops at a link
 * to a descriptor of this process. */
static int follow_links(char **path) {
    struct stat status;
    char link[PATH_MAX];
    if (stat(*path, &status) && errno != ENOENT)
        return errno; /* among them: links that the system does not let this user follow */
    for (int links = 0; lstat(*path, &status) == 0 && S_ISLNK(status.st_mode) && own_descriptor(*path) < 0; links++) {
        ssize_t length = readlink(*path, link, sizeof link - 1);
        if (length < 0 || links == LINKS_MOST)
            return length < 0 ? errno : ELOOP;
        link[length] = 0;
        char *folder = folder_of(*path), *next = *link == '/' ? text_copy(link) : join(folder, link);
        memory_free(folder);
        memory_free(*path);
        *path = next;
    }
    return 0;
}

static int open_folder(const char *path) {
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return folder < 0 && errno == EACCES ? open(path, O_PATH | O_DIRECTORY | O_CLOEXEC) : folder;
}

static const char *temporary_folder(void) {
    const char *folder = getenv("TMPDIR");
    return folder && *folder == '/' ? folder : "/tmp";
}

/* Temporary files -------------------------------------------------------------------------------------------------- */

/* Removes a temporary file unless its process is alive. */
static void sweep_file(int folder, const char *name) {
    struct stat status;
    int file = openat(folder, name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && flock(file, LOCK_EX | LOCK_NB) == 0)
        unlinkat(folder, name, 0);
    close(file);
}

static void sweep_folder(int folder) {
    int again = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *stream = again >= 0 ? fdopendir(again) : NULL;
    for (const struct dirent *entry; stream && (entry = readdir(stream));)
        if (strncmp(entry->d_name, PART_BEGIN, strlen(PART_BEGIN)) == 0 && strstr(entry->d_name, PART_END))
            sweep_file(folder, entry->d_name);
    if (stream)
        closedir(stream);
    else if (again >= 0)
        close(again);
}

/* Sweeps a folder when this process first writes there: thousands of pictures may follow. */
static void sweep_once(int folder) {
    enum { FOLDERS = 32 /* remembered; those swept earlier are swept again, which costs time only */ };
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    static struct {
        dev_t device;
        ino_t inode;
    } swept[FOLDERS];
    static size_t next;
    struct stat status;
    if (fstat(folder, &status))
        return;
    bool known = false;
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < FOLDERS && !known; i++)
        known = swept[i].device == status.st_dev && swept[i].inode == status.st_ino;
    if (!known) {
        swept[next % FOLDERS].device = status.st_dev;
        swept[next++ % FOLDERS].inode = status.st_ino;
        sweep_folder(folder);
    }
    pthread_mutex_unlock(&lock);
}

/* Creates and locks a temporary file. A process that sweeps in the moment between makes it start again. */
static int create_part(FileWrite *file, int folder, const char *ending, mode_t mode) {
    static unsigned count;
    for (;;) {
        struct stat status;
        snprintf(file->part_name, sizeof file->part_name, PART_BEGIN "%ld-%u" PART_END "%.16s", (long)getpid(),
                 __atomic_fetch_add(&count, 1, __ATOMIC_RELAXED), ending);
        file->part = openat(folder, file->part_name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (file->part < 0 && errno == EEXIST)
            continue;
        if (file->part < 0) {
            *file->part_name = 0;
            return errno;
        }
        file->part_folder = folder;
        flock(file->part, LOCK_EX);
        if (fstat(file->part, &status) || status.st_nlink > 0)
            return 0;
        close(file->part);
    }
}

static bool is_forbidden(int error) {
    return error == EACCES || error == EPERM || error == EROFS;
}

/* Creates a temporary file that has a name, in the temporary folder. */
static int create_part_elsewhere(FileWrite *file, const char *ending) {
    const char *path = temporary_folder();
    int folder = open_folder(path), error = folder < 0 ? errno : 0;
    if (!error) {
        sweep_once(folder);
        error = create_part(file, folder, ending, 0600);
        if (error)
            close(folder);
        else
            file->part_path = join(path, file->part_name);
    }
    return error;
}

/* Creates the place of the new contents: in the file's folder or, if that is not possible and the file is written in
 * place, in memory or in the temporary folder. */
static int open_part(FileWrite *file, const char *ending) {
    int error = EACCES;
    if (file->special < 0) {
        sweep_once(file->folder);
        error = create_part(file, file->folder, ending ? ending : "", file->exists ? 0600 : 0666);
        if (!error) {
            char *folder = folder_of(file->path);
            file->part_path = join(folder, file->part_name);
            memory_free(folder);
        }
        if (!error || !file->exists || !is_forbidden(error))
            return error;
        file->in_place = true;
    }
    if (ending)
        return create_part_elsewhere(file, ending);
    file->part = memfd_create("clearance", MFD_CLOEXEC);
    return file->part < 0 ? errno : 0;
}

static void remove_part(FileWrite *file) {
    if (*file->part_name)
        unlinkat(file->part_folder, file->part_name, 0);
    *file->part_name = 0;
}

/* Installing ------------------------------------------------------------------------------------------------------- */

/* Copies the access lists and the attributes user.*. False: one of them may be lost. */
static bool keep_attributes(int part, const char *path) {
    static const char list_of_access[] = "system.posix_acl_access";
    char names[BLOCK];
    bool good = true;
    fremovexattr(part, list_of_access); /* it may come from the folder */
    ssize_t size = listxattr(path, names, sizeof names);
    if (size < 0)
        return errno == ENOTSUP;
    for (char *name = names; name < names + size && good; name += strlen(name) + 1) {
        if (strncmp(name, "user.", 5) != 0 && strcmp(name, list_of_access) != 0)
            continue;
        char value[BLOCK];
        ssize_t length = getxattr(path, name, value, sizeof value);
        good = length >= 0 && fsetxattr(part, name, value, (size_t)length, 0) == 0;
    }
    return good;
}

/* Gives the temporary file all that belongs to the old one. False: something would be lost. */
static bool keep_ownership(const FileWrite *file) {
    const struct stat *before = &file->before;
    struct stat now;
    if (fstat(file->part, &now))
        return false;
    if ((now.st_uid != before->st_uid || now.st_gid != before->st_gid) &&
        fchown(file->part, before->st_uid, before->st_gid))
        return false;
    return keep_attributes(file->part, file->path) && fchmod(file->part, before->st_mode & 07777) == 0;
}

/* Creates the copy of the old contents, synced, under a free name: NAME.before-saving, NAME.before-saving-2, ... A long
 * name is cut between two letters. */
static int create_copy(int folder, const char *name, char copy[NAME_MAX + 1], int from) {
    int length = (int)strnlen(name, NAME_MAX - sizeof COPY_END - 3), file = -1;
    while (length > 0 && ((unsigned char)name[length] & 0xc0) == 0x80)
        length--;
    for (int i = 1; i <= COPIES_MOST && file < 0; i++) {
        char number[16] = "";
        if (i > 1)
            snprintf(number, sizeof number, "-%d", i);
        snprintf(copy, NAME_MAX + 1, "%.*s" COPY_END "%s", length, name, number);
        file = openat(folder, copy, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (file < 0 && errno != EEXIST)
            return -1;
    }
    int error = file < 0 ? errno : copy_bytes(file, from, true);
    if (!error)
        error = sync_file(file);
    if (!error)
        error = sync_folder(folder);
    if (error && file >= 0) {
        unlinkat(folder, copy, 0);
        close(file);
    }
    errno = error;
    return error ? -1 : file;
}

/* Writes the new contents over the old ones. After an error the copy restores the file; the copy is kept if the
 * restoration fails, or if the process is killed meanwhile. */
static int write_in_place(FileWrite *file) {
    char name[NAME_MAX + 1];
    int target = openat(file->folder, file->name, O_RDWR | O_CLOEXEC), folder = file->folder, other = -1;
    if (target < 0)
        return errno;
    int copy = create_copy(folder, file->name, name, target);
    if (copy < 0 && is_forbidden(errno) && (other = open_folder(temporary_folder())) >= 0)
        copy = create_copy(folder = other, file->name, name, target);
    int error = copy < 0 ? errno : overwrite(target, file->part);
    if (copy >= 0 && (!error || overwrite(target, copy) == 0))
        unlinkat(folder, name, 0);
    if (copy >= 0)
        close(copy);
    if (other >= 0)
        close(other);
    if (close(target) && !error && errno != EINTR)
        error = errno;
    return error;
}

/* Renames the temporary file. *lost is set if the old file cannot be replaced without a loss. */
static int put(FileWrite *file, bool *lost) {
    *lost = file->exists && !keep_ownership(file);
    if (*lost)
        return 0;
    int error = file->to_disk ? sync_file(file->part) : 0;
    if (!error && renameat(file->part_folder, file->part_name, file->folder, file->name)) {
        error = errno;
        *lost = file->exists && (error == EBUSY || error == EXDEV || is_forbidden(error));
        return *lost ? 0 : error;
    }
    if (!error)
        *file->part_name = 0;
    return !error && file->to_disk ? sync_folder(file->folder) : error;
}

static int install(FileWrite *file) {
    if (file->special >= 0)
        return copy_bytes(file->special, file->part, false);
    bool lost = file->in_place;
    int error = lost ? 0 : put(file, &lost);
    if (!error && lost)
        error = write_in_place(file);
    remove_part(file);
    return !error && lost ? sync_folder(file->folder) : error;
}

/* Work ------------------------------------------------------------------------------------------------------------- */

/* Refuses a file without permission to write, also for a user to whom the system allows everything. */
static int refusal(const char *path, mode_t mode) {
    if (!(mode & 0222))
        return EPERM;
    if (faccessat(AT_FDCWD, path, W_OK, AT_EACCESS))
        return errno == EACCES ? EPERM : errno;
    return 0;
}

/* True if the path, behind all links, is written directly. */
static bool is_direct(const char *path) {
    struct stat status;
    return own_descriptor(path) >= 0 ||
           (stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode));
}

bool file_write_is_direct(const char *path) {
    char *target = text_copy(path);
    bool direct = *path && follow_links(&target) == 0 && is_direct(target);
    memory_free(target);
    return direct;
}

/* Opens the file's folder, or the file itself if it is a pipe or a device. */
static int open_target(FileWrite *file) {
    int error = *file->path ? follow_links(&file->path) : ENOENT;
    if (error)
        return error;
    file->name = last_part(file->path);
    int own = own_descriptor(file->path);
    file->exists = stat(file->path, &file->before) == 0;
    if (is_direct(file->path)) {
        file->special = own >= 0 ? fcntl(own, F_DUPFD_CLOEXEC, 0) : open(file->path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
        return file->special < 0 ? errno : 0;
    }
    if (!*file->name || (file->exists && S_ISDIR(file->before.st_mode)))
        return EISDIR;
    error = file->exists ? refusal(file->path, file->before.st_mode) : 0;
    if (error)
        return error;
    char *folder = folder_of(file->path);
    file->in_place = file->exists && file->before.st_nlink > 1;
    file->folder = open_folder(folder);
    error = file->folder < 0 ? errno : 0;
    memory_free(folder);
    return error;
}

static void close_if_open(int file) {
    if (file >= 0)
        close(file);
}

static void release(FileWrite *file) {
    remove_part(file);
    close_if_open(file->part);
    close_if_open(file->special);
    if (file->part_folder != file->folder)
        close_if_open(file->part_folder);
    close_if_open(file->folder);
    memory_free(file->part_path);
    memory_free(file->path);
    memory_free(file);
}

static FileWrite *begin(const char *path, const char *ending, bool to_disk, int *error) {
    FileWrite *file = memory_zeroed(1, sizeof *file);
    file->path = text_copy(path);
    file->to_disk = to_disk;
    file->folder = file->special = file->part = file->part_folder = -1;
    *error = open_target(file);
    if (!*error)
        *error = open_part(file, ending);
    if (!*error)
        return file;
    release(file);
    return NULL;
}

FileWrite *file_write_begin(const char *path, int *error) {
    return begin(path, NULL, true, error);
}

FileWrite *file_write_begin_named(const char *path, const char *ending, int *error) {
    return begin(path, ending, true, error);
}

/* Writes bytes of the stream, and notes the first error: a later call may change errno. */
static ssize_t write_streamed(void *cookie, const char *bytes, size_t size) {
    FileWrite *file = cookie;
    int error = write_bytes(file->part, bytes, size, true);
    if (error && !file->stream_error)
        file->stream_error = error;
    errno = error;
    return error ? 0 : (ssize_t)size;
}

FILE *file_write_stream(FileWrite *file) {
    if (!file->stream)
        file->stream = fopencookie(file, "w", (cookie_io_functions_t){.write = write_streamed});
    return file->stream;
}

const char *file_write_part(const FileWrite *file) {
    return file->part_path;
}

int file_write_end(FileWrite *file, int error) {
    if (file->stream) {
        bool failed = ferror(file->stream);
        failed |= fclose(file->stream) != 0;
        if (failed && !error)
            error = file->stream_error ? file->stream_error : EIO;
    }
    if (!error)
        error = install(file);
    release(file);
    return error;
}

static int write_all(const char *path, const char *bytes, size_t size, bool to_disk) {
    int error;
    FileWrite *file = begin(path, NULL, to_disk, &error);
    return file ? file_write_end(file, write_bytes(file->part, bytes, size, true)) : error;
}

int file_write_bytes(const char *path, const char *bytes, size_t size) {
    return write_all(path, bytes, size, true);
}

int file_write_quickly(const char *path, const char *bytes, size_t size) {
    return write_all(path, bytes, size, false);
}

const char *file_write_reason(int error) {
    switch (error) {
    case ENOSPC:
        return "the disk is full";
    case EDQUOT:
        return "the disk quota is used up";
    case EPERM:
        return "the file is write-protected";
    case EROFS:
        return "the disk is write-protected";
    case EINTR:
        return "interrupted";
    case EEXIST: /* create_copy found no free name */
        return "too many copies named .before-saving are left next to it; remove those that are not needed";
    case ELOOP:
        return "its symbolic links lead in a circle";
    case EFBIG:
        return "the file would be larger than the system allows";
    case EISDIR:
        return "a folder has this name";
    case ENOTDIR:
        return "a file stands where a folder has to be";
    case ENAMETOOLONG:
        return "the name is too long";
    default:
        return strerror(error);
    }
}
