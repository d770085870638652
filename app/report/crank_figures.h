/* Pictures of a slider crank in a document. What they show must outlive the document. */
#pragma once

#include "crank/crank_cycle.h"
#include "cycle/response.h"
#include "document/document.h"

/* Adds the picture of the largest force in the recorded revolutions; false: less than one revolution is recorded. */
bool crank_figures_add_moment(Document *document, const Crank *crank, const Tree *tree, const Response *response,
                              const char *caption);

/* Adds a plot by its name (crank_plots.h), in the current row of pictures. */
void crank_figures_add_plot(Document *document, const Crank *crank, const Response *response, const char *name,
                            const char *caption);
