#include "command/beam_files.h"

#include <stdio.h>

#include "command/house_file.h"
#include "command/output.h"
#include "plot/plot_write.h"
#include "visual/beam/beam_plots.h"

bool beam_files_begin(BeamFiles *files, const Options *options) {
    char message[PLOT_CHOICE_FAULT];
    const char *words = options->plot_words ? options->plot_words : BEAM_PLOTS_USUAL;
    const char *needing = options->plot_words ? "--plots" : options->measured ? "--measured" : NULL;
    *files = (BeamFiles){.plots.count = 0};
    if (needing && !options->out) {
        fprintf(stderr, "clearance: %s needs --out DIR, where the plots are written\n", needing);
        return false;
    }
    if (!beam_plots_choose(&files->plots, words, message)) {
        fprintf(stderr, "clearance: --plots %s: %s\n", words, message);
        return false;
    }
    Fault fault = {0};
    size_t count;
    const MeasuredKind *kinds = beam_plots_kinds(&count);
    if (options->measured && !measured_read(&files->measured, options->measured, kinds, count, &fault)) {
        house_file_report(&fault);
        return false;
    }
    return true;
}

bool beam_files_write(const BeamFiles *files, const Response *response, const Beam *beam, const Options *options) {
    if (!options->out)
        return true;
    char path[PLOT_WRITE_PATH];
    int error = 0;
    BeamPlots plots = beam_plots_make(response, beam, &files->measured, &files->plots);
    for (size_t i = 0; i < plots.choice.count && !error; i++)
        error = plot_write_files(&plots.plots[i], beam_plots_name(plots.choice.indices[i]), options->out,
                                 options->width, options->height, options->theme, path);
    beam_plots_free(&plots);
    if (error)
        output_failed(path, error);
    return !error;
}

void beam_files_end(BeamFiles *files) {
    measured_free(&files->measured);
}
