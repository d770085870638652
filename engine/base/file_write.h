/* Writes files for all others, so that nothing is lost. After an error a file holds its old contents. If the process is
 * killed or the power fails, the file holds its old or its new contents, or, where it is written in place, a copy next
 * to it holds the old ones.
 *
 * The new contents are written to a temporary file in the same folder, which is then renamed. Symbolic links are
 * followed to the file that they name, which need not exist. Mode, owner, group, access lists and the extended
 * attributes user.* of the old file are kept; other attributes, such as labels of the security system, are given to the
 * new file by the system. Where a rename would lose one of these or a hard link, or where it is impossible (the
 * folder is not writable, the file is a mount point), the contents are written in place; meanwhile a copy of the old
 * contents stands next to the file as NAME.before-saving (in the temporary folder if its own folder is not writable),
 * and restores the file after an error. A process that is killed in the meantime leaves a file that may hold parts of
 * both contents, and the copy, which the user removes. Pipes, devices and the process's own descriptors (/dev/stdout)
 * are written directly. Files without permission to write are refused. Temporary files that a killed process left are
 * removed by the next process that writes to their folder.
 *
 * All functions may be called by several threads. They return 0 or errno; file_write_reason says it in words. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Writes the bytes, and waits until the file and its folder are on the disk. */
int file_write_bytes(const char *path, const char *bytes, size_t size);

/* Writes a file as above, but does not wait for the disk: for many files that can be created again. */
int file_write_quickly(const char *path, const char *bytes, size_t size);

/* A file in work. */
typedef struct FileWrite FileWrite;

/* Begins to write a file piece by piece. Returns NULL, with *error set, if the file cannot be written. The named kind
 * is for libraries and programs that open their file themselves: its temporary file has a name, which ends in `ending`.
 */
FileWrite *file_write_begin(const char *path, int *error);
FileWrite *file_write_begin_named(const char *path, const char *ending, int *error);

/* Returns the stream for the new contents, which file_write_end closes. */
FILE *file_write_stream(FileWrite *file);

/* Returns the name of the temporary file; only for the named kind. It lives as long as the file is in work. */
const char *file_write_part(const FileWrite *file);

/* Ends the work: puts the new contents in place and waits for the disk, or, if `error` (errno) is not 0, leaves the
 * file as it was. Releases the work. Returns 0 or errno. */
int file_write_end(FileWrite *file, int error);

/* True if a path stands for a pipe, a device or a descriptor of this process: it is written directly, whatever is there
 * already. */
bool file_write_is_direct(const char *path);

/* Returns the words for an error (errno) of a file that cannot be written, without a full stop: "the disk is full". */
const char *file_write_reason(int error);
