#include "report/crank_figures.h"

#include "base/memory.h"
#include "visual/crank/crank_plots.h"
#include "visual/crank/crank_scene.h"

/* Design points. */
#define PICTURE_WIDTH 1027.0
#define PICTURE_HEIGHT 578.0
#define PLOT_WIDTH 505.0
#define PLOT_HEIGHT 340.0

static void paint_plot(const void *context, struct _cairo *cairo, Vec2 size, Theme theme) {
    plot_paint(&((const CrankPlots *)context)->plots[0], cairo, size, theme);
}

static void release_plot(void *context) {
    crank_plots_free(context);
    memory_free(context);
}

bool crank_figures_add_moment(Document *document, const Crank *crank, const Tree *tree, const Response *response,
                              const char *caption) {
    if (response->trace.rows < CRANK_SAMPLES)
        return false;
    Scene scene = {0};
    crank_scene_make(&scene, crank, tree, response);
    document_add_figures(document);
    document_add_scene(document, &scene, vec2(PICTURE_WIDTH, PICTURE_HEIGHT), caption,
                       "A slider crank with its coupler bent, its ball in the socket, and its force over the angle.");
    return true;
}

void crank_figures_add_plot(Document *document, const Crank *crank, const Response *response, const char *name,
                            const char *caption) {
    char fault[PLOT_CHOICE_FAULT];
    PlotChoice choice;
    CrankPlots *plots = memory_zeroed(1, sizeof *plots);
    crank_plots_choose(&choice, name, fault);
    *plots = crank_plots_make(response, crank, &choice);
    document_add_picture(document, paint_plot, plots, vec2(PLOT_WIDTH, PLOT_HEIGHT), caption, caption)->release =
        release_plot;
}
