#include "command/movie.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/memory.h"
#include "command/output.h"

struct Movie {
    const char *path;
    char beside[OUTPUT_PATH]; /* temporary file of ffmpeg, which takes the kind of film from the ending */
    size_t picture;           /* bytes */
    int pipe;                 /* end for writing */
    pid_t ffmpeg;
};

/* Writes a name in the same directory with the same ending. It must not begin with "word:", which ffmpeg takes for a
 * protocol. */
static void name_beside(char beside[OUTPUT_PATH], const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    snprintf(beside, OUTPUT_PATH, "%s%.*s.%ld.%s", *path == '/' ? "" : "./", (int)(name - path), path, (long)getpid(),
             name);
}

extern char **environ;

/* Starts ffmpeg with the reading end of the pipe as its standard input. Returns 0 or errno. */
static int spawn(Movie *movie, int reading, char *const *words) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, reading, STDIN_FILENO);
    posix_spawnattr_init(&attributes);
    /* own process group: Ctrl-C ends the pictures, and ffmpeg finishes the film with those that it has */
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    int error = posix_spawnp(&movie->ffmpeg, words[0], &actions, &attributes, words, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/* Returns 0 or errno. */
static int start(Movie *movie, int reading, int width, int height, double fps) {
    char size[32], rate[32];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(rate, sizeof rate, "%g", fps);
    /* stop if the disk is full; pad to even sides, which the format requires; write no date of creation */
    char *words[] = {"ffmpeg",      "-hide_banner",
                     "-loglevel",   "error",
                     "-xerror",     "-y",
                     "-f",          "rawvideo",
                     "-pix_fmt",    "bgr0",
                     "-s",          size,
                     "-r",          rate,
                     "-i",          "-",
                     "-vf",         "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                     "-pix_fmt",    "yuv420p",
                     "-preset",     "veryfast",
                     "-crf",        "18",
                     "-movflags",   "+faststart",
                     "-fflags",     "+bitexact",
                     "-flags:v",    "+bitexact",
                     movie->beside, NULL};
    return spawn(movie, reading, words);
}

Movie *movie_begin(const char *path, int width, int height, double fps) {
    Movie *movie = memory_zeroed(1, sizeof *movie);
    int ends[2];
    *movie = (Movie){.path = path, .picture = (size_t)width * (size_t)height * 4};
    name_beside(movie->beside, path);
    int error = pipe2(ends, O_CLOEXEC) ? errno : 0;
    if (!error) {
        error = start(movie, ends[0], width, height, fps);
        close(ends[0]);
        movie->pipe = ends[1];
        if (error)
            close(ends[1]);
    }
    if (!error) {
        signal(SIGPIPE, SIG_IGN); /* a broken pipe is reported as an error and does not end the program */
        return movie;
    }
    if (error == ENOENT)
        fprintf(stderr, "clearance: --movie needs ffmpeg, which is not installed: apt-get install ffmpeg\n");
    else
        fprintf(stderr, "clearance: --movie needs ffmpeg, which cannot be started: %s\n", strerror(error));
    memory_free(movie);
    return NULL;
}

int movie_add(Movie *movie, const unsigned char *pixels) {
    for (size_t done = 0; done < movie->picture;) {
        ssize_t now = write(movie->pipe, pixels + done, movie->picture - done);
        if (now < 0 && errno != EINTR)
            return errno;
        done += now > 0 ? (size_t)now : 0;
    }
    return 0;
}

bool movie_end(Movie *movie) {
    int status = 0, error = 0;
    close(movie->pipe);
    while (waitpid(movie->ffmpeg, &status, 0) < 0 && errno == EINTR)
        continue;
    bool whole = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (whole && rename(movie->beside, movie->path))
        error = errno;
    if (!whole || error) {
        if (error)
            fprintf(stderr, "clearance: %s cannot be written: %s\n", movie->path, strerror(error));
        else
            fprintf(stderr, "clearance: %s cannot be written, for the reason that ffmpeg gives above\n", movie->path);
        unlink(movie->beside);
    }
    memory_free(movie);
    return whole && !error;
}
