/* The layers of a displayed house. */
#include "laboratory/house/runs.h"

enum { GHOSTS_MOST = 60 /* people: larger crowds have no ghosts, since no person could be recognised */ };

#define OUTSIDE 1.0 /* m, margin around exits, in which people are seen to leave */

/* Returns the box of the plan and the space outside its exits: it stays the same wherever people drive and after
 * they leave. */
static Box box_of(const House *house) {
    Box box = house->outline.box;
    for (size_t e = 0; e < house->plan.exit_count; e++) {
        const Exit *exit = &house->plan.exits[e];
        Vec2 across = vec2_scale(vec2_left(vec2_unit(vec2_sub(exit->to, exit->from))), OUTSIDE);
        box = box_include(box_include(box, vec2_add(exit->from, across)), vec2_sub(exit->from, across));
        box = box_include(box_include(box, vec2_add(exit->to, across)), vec2_sub(exit->to, across));
    }
    return box_expand(box, HOUSE_SCENE_MARGIN);
}

static int hidden_of(unsigned layers) {
    static const int bits[][2] = {{LAYER_RINGS, FILM_RINGS},   {LAYER_LOCI, FILM_LOCI}, {LAYER_GHOST, FILM_GHOST},
                                  {LAYER_DANGER, FILM_DANGER}, {LAYER_GRID, FILM_GRID}, {LAYER_NAMES, FILM_NAMES},
                                  {LAYER_FORCES, FILM_FORCES}};
    int hidden = 0;
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++)
        hidden |= layers & 1u << bits[i][0] ? 0 : bits[i][1];
    return hidden;
}

void house_show_make(HouseSession *session, double time) {
    size_t epoch = session->runs[RUN_SHOWN] ? house_run_epoch(session->runs[RUN_SHOWN], time) : 0;
    size_t falling = house_fall_count(session, time);
    if (epoch != session->epoch || falling != session->fall.drawn)
        house_session_void_film(session);
    if (house_session_has_film(session) || !session->runs[RUN_SHOWN])
        return;
    if (session->film)
        film_destroy(session->film);
    bool last = epoch + 1 == session->runs[RUN_SHOWN]->wish.epoch_count;
    const House *house = last && session->runs[RUN_EARLY] ? &session->runs[RUN_EARLY]->house
                                                          : house_run_house(session->runs[RUN_SHOWN], epoch);
    Before ghost = house_runs_compared(session);
    bool is_crowd = ghost.house && ghost.house->person_count > GHOSTS_MOST;
    bool ways = house_runs_is_over(session, RUN_ROUTES) && session->layers & 1u << LAYER_WIDTHS;
    FilmOptions options = {
        .camera = session->camera,
        .bare = true,
        .shown = session->layers & 1u << LAYER_CIRCLES ? FILM_CIRCLES : 0,
        .hidden = hidden_of(session->layers),
        .before = is_crowd ? (Before){.house = NULL} : ghost,
        .live = true,
        .ahead = session->whole && session->ghost == GHOST_BEFORE && ghost.house, /* both are complete */
        .observed = house == &session->runs[RUN_SHOWN]->house ? NULL : &session->runs[RUN_SHOWN]->house,
        .trails = session->trails.trails,
        .ways = ways ? &session->runs[RUN_ROUTES]->ways : NULL,
        .falling = session->fall.pieces,
        .falling_count = falling,
        .box = box_of(&session->runs[RUN_SHOWN]->house)};
    session->epoch = epoch;
    session->fall.drawn = falling;
    session->film = film_create(house, session->observation, &options);
    session->film_is_stale = false;
    session->fresh = true;
}
