/* The picture of a displayed house: its film, and the plots next to it.
 *
 * The plots describe the selected person, or all people. While a run is in progress their axes end at round numbers and
 * only grow; for a complete run they fit the data. */
#pragma once

#include "laboratory/house/session_state.h"

/* Makes the film stale: it is rebuilt before it is displayed. */
static inline void house_picture_void_film(HouseSession *session) {
    session->film_is_stale = true;
    session->changed |= LABORATORY_VIEW;
}

static inline bool house_picture_has_film(const HouseSession *session) {
    return session->film && !session->film_is_stale;
}

/* Rebuilds the film for a time, s, if it is missing or stale. */
void house_picture_make_film(HouseSession *session, double time);

/* Makes the picture of the plan alone, for a house that cannot be run. */
void house_picture_make_plain(HouseSession *session);

/* Makes the plots of the displayed run; `restart`: for another run, person or ghost, not only with more rows. */
void house_picture_make_plots(HouseSession *session, bool restart);
void house_picture_clear_plots(HouseSession *session);

/* Returns a plot, by its index in house_plots_name; the plots must have been made. */
LaboratoryPlot house_picture_plot(const HouseSession *session, size_t index);
