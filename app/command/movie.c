#include "command/movie.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file_write.h"
#include "base/memory.h"
#include "base/text.h"
#include "command/output.h"

struct Movie {
    const char *path;
    FileWrite *file;
    char *part;     /* its temporary file; ffmpeg takes the kind of film from the ending */
    size_t picture; /* bytes */
    int pipe;       /* end for writing */
    pid_t ffmpeg;
    int error; /* errno of the first picture that could not be added, or 0 */
};

/* Begins the file and names its temporary one. That name must not begin with "word:", which ffmpeg takes for a
 * protocol. Returns 0 or errno. */
static int begin_file(Movie *movie) {
    const char *slash = strrchr(movie->path, '/'), *dot = strrchr(slash ? slash : movie->path, '.');
    int error = 0;
    movie->file = file_write_begin_named(movie->path, dot ? dot : "", &error);
    if (movie->file) {
        const char *part = file_write_part(movie->file);
        Text text = {0};
        text_format(&text, "%s%s", *part == '/' ? "" : "./", part);
        movie->part = text.text;
    }
    return error;
}

static void release(Movie *movie) {
    memory_free(movie->part);
    memory_free(movie);
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
    char *words[] = {"ffmpeg",    "-hide_banner",
                     "-loglevel", "error",
                     "-xerror",   "-y",
                     "-f",        "rawvideo",
                     "-pix_fmt",  "bgr0",
                     "-s",        size,
                     "-r",        rate,
                     "-i",        "-",
                     "-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                     "-pix_fmt",  "yuv420p",
                     "-preset",   "veryfast",
                     "-crf",      "18",
                     "-movflags", "+faststart",
                     "-fflags",   "+bitexact",
                     "-flags:v",  "+bitexact",
                     movie->part, NULL};
    return spawn(movie, reading, words);
}

Movie *movie_begin(const char *path, int width, int height, double fps) {
    Movie *movie = memory_zeroed(1, sizeof *movie);
    int ends[2];
    *movie = (Movie){.path = path, .picture = (size_t)width * (size_t)height * 4};
    int error = begin_file(movie);
    if (error) {
        output_failed(path, error);
        release(movie);
        return NULL;
    }
    error = pipe2(ends, O_CLOEXEC) ? errno : 0;
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
    file_write_end(movie->file, error);
    release(movie);
    return NULL;
}

int movie_add(Movie *movie, const unsigned char *pixels) {
    for (size_t done = 0; done < movie->picture;) {
        ssize_t now = write(movie->pipe, pixels + done, movie->picture - done);
        if (now < 0 && errno != EINTR)
            return movie->error = errno;
        done += now > 0 ? (size_t)now : 0;
    }
    return 0;
}

bool movie_end(Movie *movie) {
    int status = 0;
    close(movie->pipe);
    while (waitpid(movie->ffmpeg, &status, 0) < 0 && errno == EINTR)
        continue;
    bool whole = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    int error = file_write_end(movie->file, whole ? movie->error : ECANCELED);
    if (!whole)
        fprintf(stderr, "clearance: %s cannot be written, for the reason that ffmpeg gives above\n", movie->path);
    else if (error)
        output_failed(movie->path, error);
    release(movie);
    return whole && !error;
}
