#include "report/report_motion.h"

#include <cairo.h>
#include <string.h>

#include "base/memory.h"
#include "result/census.h"
#include "visual/house/house_plots.h"
#include "visual/house/plan_scene.h"

/* Design points. */
#define RAISED_WIDTH 1027.0
#define CURVE_WIDTH 498.0
#define CURVE_HEIGHT 280.0

enum { OF_CROWDS = 2 /* curves */ };

static void paint_image(const void *context, cairo_t *cairo, Vec2 size, Theme theme) {
    cairo_surface_t *image = (cairo_surface_t *)context; /* cairo counts its users */
    (void)theme;
    cairo_save(cairo);
    cairo_scale(cairo, size.x / cairo_image_surface_get_width(image), size.y / cairo_image_surface_get_height(image));
    cairo_set_source_surface(cairo, image, 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
}

static void release_image(void *context) {
    cairo_surface_destroy(context);
}

void report_motion_add_raised(Document *document, const RaisedPicture *picture, const char *name) {
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture->width, picture->height);
    if (cairo_surface_status(image) != CAIRO_STATUS_SUCCESS)
        memory_end();
    cairo_surface_flush(image);
    size_t row = 4 * (size_t)picture->width;
    for (int y = 0; y < picture->height; y++)
        memcpy(cairo_image_surface_get_data(image) + (size_t)y * (size_t)cairo_image_surface_get_stride(image),
               picture->pixels + (size_t)y * row, row);
    cairo_surface_mark_dirty(image);
    const char *caption =
        document_text(document, "%s at the end of the run; walls and doors are cut at %.1f m.", name, PLAN_SCENE_CUT);
    document_add_figures(document);
    Vec2 size = vec2(RAISED_WIDTH, RAISED_WIDTH * picture->height / picture->width);
    document_add_picture(document, paint_image, image, size, caption,
                         document_text(document, "The house seen from above at an angle. %s", caption))
        ->release = release_image;
}

static void paint_plot(const void *context, cairo_t *cairo, Vec2 size, Theme theme) {
    const HousePlots *plots = context;
    plot_paint(&plots->plots[0], cairo, size, theme);
}

static void release_plot(void *context) {
    house_plots_free(context);
    memory_free(context);
}

void report_motion_add_curves(Document *document, const Reported *run, const Reported *before) {
    static const struct {
        const char *name, *caption;
    } curves[] = {{"speed", "Speed against time."},
                  {"clearance", "Clearance of the body against time: the least since the previous value."},
                  {"force", "Contact force against time: the greatest since the previous value."},
                  {"phase", "Distance from the planned route, positive to its left, against the rate of its change."},
                  /* of crowds: */
                  {"out", "People out against time."},
                  {"flow", "People a second through each exit, mean over 10 s."}};
    size_t count = sizeof curves / sizeof *curves - (run->house->person_count > CENSUS_FEW ? 0 : OF_CROWDS);
    for (size_t c = 0; c < count; c++) {
        char fault[PLOT_CHOICE_FAULT];
        PlotChoice choice;
        house_plots_choose(&choice, curves[c].name, fault);
        HousePlots *plots = memory_zeroed(1, sizeof *plots);
        *plots = house_plots_make(run->house, run->observation, before->house, before->observation, &choice);
        if (c % 2 == 0)
            document_add_figures(document);
        document_add_picture(document, paint_plot, plots, vec2(CURVE_WIDTH, CURVE_HEIGHT), curves[c].caption,
                             curves[c].caption)
            ->release = release_plot;
    }
}
