/* Opens the window. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text.h"
#include "command/command.h"
#include "command/output.h"
#include "window/window.h"

static bool is_set(const char *name) {
    const char *value = getenv(name);
    return value && *value;
}

/* True if there is a display, or if none is needed since a script or a benchmark is run. */
static bool can_be_seen(const Options *options) {
    return options->script || options->benchmark > 0 || options->benchmark_edit > 0 || is_set("DISPLAY") ||
           is_set("WAYLAND_DISPLAY") || is_set("SDL_VIDEODRIVER");
}

int command_open(const Options *options) {
    if (!can_be_seen(options)) {
        fprintf(stderr,
                "clearance: there is no display for a window; use `clearance run %s` to simulate without one, or "
                "see `clearance --help`\n",
                options->file_count ? options->files[0] : "FILE");
        return EXIT_WRONG_INPUT;
    }
    WindowOptions window = {.file = options->file_count ? options->files[0] : NULL,
                            .settings = options->settings,
                            .setting_count = options->setting_count,
                            .route = options->route,
                            .driving = options->driving,
                            .seed = options->seed,
                            .width = options_given(options, "--size") ? options->width : 0,
                            .height = options_given(options, "--size") ? options->height : 0,
                            .theme = options_given(options, "--theme") ? options->theme : -1,
                            .text = options->text,
                            .reduced_motion = options->reduced_motion,
                            .script = options->script,
                            .benchmark = options->benchmark,
                            .benchmark_edit = options->benchmark_edit,
                            .jobs = options->jobs};
    text_read_regular_only();
    signal(SIGINT, SIG_DFL); /* SDL closes the window at these signals, but only if they have no other handler */
    signal(SIGTERM, SIG_DFL);
    output_warn_of_fonts();
    return window_run(&window);
}
