#include "route/quicken.h"

#include "route/hasten.h"

#define SWEPT 0.8  /* 1, share of the margin that the sweep between the poses asks for */
#define WORTH 3e-3 /* 1: a pass that gains less than this share of the time is the last one */

enum { SWEEPS = 20, PASSES = 2 };

/* 1, shares of the margin that the descent keeps at the stations: the next one where the sweep finds too little room
 * between them. */
static const double keeps[] = {SWEPT, 0.9, 1};

/* Makes a copy of a way quicker, as far as the sweep finds room between its stations: where it does not, the descent
 * begins again and keeps more of the margin. */
static bool descend(const RouteQuery *query, const Rectangle *body, double margin, const Way *from, Way *quick,
                    double *time) {
    bool whole = true, good = false;
    *quick = (Way){0};
    for (size_t k = 0; k < sizeof keeps / sizeof *keeps && whole && !good; k++) {
        way_free(quick);
        *quick = way_copy(from);
        whole = hasten_way(quick, query->space, body, query->profile, margin * keeps[k], SWEEPS, query->stop);
        good = whole && way_swept(quick, query->space, body, margin * SWEPT * SWEPT);
    }
    *time = good ? hasten_time(quick, query->space, body, query->profile) : HUGE_VAL;
    return whole;
}

/* Returns the step between the stations of the piece that has the most, m: short pieces have shorter ones. */
static double usual_step(const Way *way) {
    const WayPiece *most = way->pieces;
    for (size_t k = 1; k < way->piece_count; k++)
        if (way->pieces[k].last - way->pieces[k].first > most->last - most->first)
            most = &way->pieces[k];
    return most->step;
}

bool quicken_copy(const RouteQuery *query, const Rectangle *body, double margin, const Way *from, double spacing,
                  Way *copy, double *time) {
    Way spaced = way_copy(from);
    way_resample(&spaced, spacing * usual_step(from));
    bool whole = descend(query, body, margin, &spaced, copy, time);
    way_free(&spaced);
    return whole;
}

/* Changes of direction move only as far as the steps beside them stay even: a way that has some is spaced again and
 * made quicker once more, where the first pass was worth it. */
bool quicken_way(const RouteQuery *query, const Rectangle *body, double margin, Way *way, double *time) {
    bool whole = true, gains = true;
    for (int pass = 0; pass < PASSES && gains && whole; pass++) {
        double now;
        Way quick;
        whole = pass ? quicken_copy(query, body, margin, way, 1, &quick, &now)
                     : descend(query, body, margin, way, &quick, &now);
        bool good = now < HUGE_VAL && (pass == 0 || now < *time);
        gains = good && quick.piece_count > 1 && now < *time * (1 - WORTH);
        if (good) {
            way_free(way);
            *way = quick;
            *time = now;
        } else {
            way_free(&quick);
        }
    }
    return whole;
}

bool quicken_centre(const RouteQuery *query, const Rectangle *body, double margin, Way *way) {
    double kept = margin * SWEPT;
    Way centred = way_copy(way);
    bool whole = hasten_centre(&centred, query->space, body, query->profile, kept, SWEEPS, query->stop);
    if (whole && way_swept(&centred, query->space, body, kept * SWEPT)) {
        Way aside = *way;
        *way = centred;
        centred = aside;
    }
    way_free(&centred);
    return whole;
}
