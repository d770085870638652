#include "route/decide.h"

#include "base/digest.h"
#include "base/memory.h"
#include "base/real.h"
#include "route/doorway.h"
#include "route/hasten.h"
#include "route/quicken.h"
#include "route/relax.h"
#include "route/way.h"

/* A coarse search proposes, continuous optimisation decides.
 *
 * The search (search.c) knows where a body may go only to the width of its cells, so that in a tight place it finds a
 * way, or none, or one with a needless change of direction, by luck. Here it only proposes: it looks for the way of a
 * body that is smaller than the true one by more than its own error (`relief`), first without a change of direction,
 * then with some. Each proposal becomes a way whose stations move until the true body is free (relax.c) and then until
 * no small change makes it quicker (hasten.c). A proposal that does not come free is dropped, which proves nothing: if
 * it had no change of direction, later proposals must have one, since the search would find the same way again, except
 * for bodies of nearly the true size. A way with changes of direction is tried with arcs in place of its turns on the
 * spot, without its short pieces, and compared with what is found with fewer changes. The best way that changes its
 * direction or turns on the spot is made quicker once more, with its stations closer, since there the descent ends
 * where their places let it. No way is tried twice that did not come free. What the chair waits for shut doors that it
 * swings against counts among the ways that are free, though the descent does not know it. A no is given only after a
 * search with more states where the others had to give up. The budget is counted in expansions, proposals and sweeps,
 * never in time, so that the answer is always the same. */

#define SPACING 0.05         /* m, of the stations */
#define ALIKE 3e-3           /* 1: ways whose times differ by less than this share are one */
#define WORTH_HASTENING 1.15 /* 1: ways that take longer than the quickest by this factor are left */
#define MARGIN 0.005         /* m, kept from everything, unless the start has less */
#define BARELY 1e-3          /* m, kept where there is no room for the margin */
#define HAIR 5e-4            /* m */
#define SHORT 0.6            /* m: pieces of a way up to this length may be needless */
#define HARDLY 0.006         /* m, more relief than this is another body */
#define LACKING 0.02         /* m, of the margin: less comfort does not free a way that lacks more than this */
#define TOO_LONG 1.5         /* 1: ways that are proposed with so many times the best one's time are left */

enum { SURE = 2, ASK_WHETHER_IT_FITS = 2 };

static const SearchGrain coarse = {.cell = 0.10, .turn = M_PI / 18, .step = 0.15, .weight = 1.5, .most_nodes = 8000};
static const SearchGrain middle = {.cell = 0.05, .turn = M_PI / 36, .step = 0.10, .weight = 1.5, .most_nodes = 24000};

/* With changes of direction a search has to try every state of a room or two before it finds the right one. */
static const SearchGrain coarse_back = {
    .cell = 0.10, .turn = M_PI / 18, .step = 0.15, .weight = 1.5, .most_nodes = 30000};
static const SearchGrain coarse_long = {
    .cell = 0.10, .turn = M_PI / 18, .step = 0.15, .weight = 1.5, .most_nodes = 60000};
static const SearchGrain coarse_far = {
    .cell = 0.10, .turn = M_PI / 18, .step = 0.15, .weight = 1.5, .most_nodes = 120000};
static const SearchGrain middle_back = {
    .cell = 0.05, .turn = M_PI / 36, .step = 0.10, .weight = 1.5, .most_nodes = 150000};

/* A stage begins only when no earlier one has found a way. */
typedef enum Stage { STAGE_ONWARDS, STAGE_BACK, STAGE_LAST } Stage;

typedef struct Rung {
    const SearchGrain *grain;
    double relief; /* m, by which the body is smaller on every side */
    Stage stage;   /* after the first the way may change its direction */
} Rung;

static const Rung rungs[] = {
    {&coarse, 0.040, STAGE_ONWARDS},   {&coarse, 0.025, STAGE_ONWARDS},   {&middle, 0.030, STAGE_ONWARDS},
    {&middle, 0.018, STAGE_ONWARDS},   {&middle, 0.010, STAGE_ONWARDS},   {&coarse_back, 0.030, STAGE_BACK},
    {&coarse_back, 0.020, STAGE_BACK}, {&coarse_back, 0.040, STAGE_BACK}, {&coarse_back, 0.010, STAGE_BACK},
    {&coarse_long, 0.006, STAGE_LAST}, {&coarse_long, 0.012, STAGE_LAST}, {&middle_back, 0.006, STAGE_LAST},
    {&middle, 0.020, STAGE_LAST},      {&middle, 0.012, STAGE_LAST},      {&coarse_far, 0.040, STAGE_LAST},
};
enum { RUNGS = sizeof rungs / sizeof *rungs };

/* For ways with a change of direction where one without any is long to drive: the finer grain finds headings at which
 * to turn back that the coarse one leaves out. */
static const Rung turning[] = {
    {&middle_back, 0.018, STAGE_BACK}, {&middle_back, 0.030, STAGE_BACK}, {&coarse_back, 0.030, STAGE_BACK},
    {&coarse_back, 0.020, STAGE_BACK}, {&coarse_back, 0.040, STAGE_BACK}, {&coarse_back, 0.010, STAGE_BACK},
};
enum { TURNINGS = sizeof turning / sizeof *turning };

#define MOST_RELIEF 0.040 /* m */

/* With the true body. */
static const SearchGrain true_grains[] = {
    {.cell = 0.10, .turn = M_PI / 18, .step = 0.15, .weight = 1.5, .most_nodes = 60000},
    {.cell = 0.05, .turn = M_PI / 36, .step = 0.10, .weight = 1.5, .most_nodes = 150000},
    {.cell = 0.025, .turn = M_PI / 72, .step = 0.06, .weight = 2.0, .most_nodes = 150000},
    {.cell = 0.0125, .turn = M_PI / 144, .step = 0.03, .weight = 2.0, .most_nodes = 300000},
};
enum { TRUE_RUNGS = sizeof true_grains / sizeof *true_grains };

/* With skids, the turns of which are as fine as the grain. */
static const SearchGrain skidding_grains[] = {
    {.cell = 0.025, .turn = M_PI / 72, .step = 0.06, .skids = true, .weight = 2.0, .most_nodes = 150000},
    {.cell = 0.0125, .turn = M_PI / 144, .step = 0.03, .skids = true, .weight = 2.0, .most_nodes = 300000},
};
enum { SKIDDING_RUNGS = sizeof skidding_grains / sizeof *skidding_grains };

/* 1, weights of comfort (relax.h). One is enough for a way onwards, whose stations the descent on time moves on. The
 * cusps of a way with changes of direction hardly move there, so that it is tried with cusps nearer to walls, too. */
static const double comforts[] = {20, 2};

/* 1, of the step between the stations of the way that is the best so far: that of its copies that are made quicker. */
static const double spacings[] = {0.7, 1, 0.7, 1};

/* 1, of the turn on the spot at a change of direction, up to the heading that is tried in its place. */
static const double shares[] = {0.5, 0.75};

/* The answer of a rung's search with any number of changes of direction. */
typedef struct Asked {
    bool asked;
    SearchAnswer answer;
    int reversals; /* of the way that was found */
} Asked;

/* A way that could not be made free. */
typedef struct Stuck {
    uint64_t digest; /* of the way as it was proposed, and of the comfort */
    double lacking;  /* m, of the margin */
} Stuck;

typedef struct Decide {
    const RouteQuery *query;
    const Rectangle *body;
    const Goal *goals;
    size_t goal_count;
    bool any;      /* True to end with the first free way, however slow it is */
    bool coarsely; /* True to search only at the coarse grains */
    double margin; /* m, that the start leaves, at most MARGIN */
    Way best;
    double kept;           /* m, the margin of the best */
    double time;           /* s, of the best, with what it waits for doors */
    int confirmed;         /* number of proposals that have led to about this time */
    double before;         /* s, the time of the best before the latest proposal */
    double latest;         /* s, the least time that the latest proposal has led to with this margin */
    bool vain[TRUE_RUNGS]; /* True if a smaller body was searched for in every state at this grain, in vain */
    bool proposed;         /* True if a search has found a way of a smaller body */
    bool dropped_onwards;  /* True if one without a change of direction has not come free */
    double spent[RUNGS];   /* m2 rad, of states that a rung has tried until it gave up; 0: it did not */
    Asked asked[RUNGS];
    Stuck *stuck; /* (stuck_count) owned */
    size_t stuck_count, stuck_capacity;
    double lacking; /* m, of the margin, at the latest way that should be made free; 0: it is free */
} Decide;

static Rectangle relieved(const Rectangle *body, double by) {
    Rectangle smaller = *body;
    smaller.half_length = fmax(body->half_length - by, 0.01);
    smaller.half_width = fmax(body->half_width - by, 0.01);
    return smaller;
}

double decide_radius(const Rectangle *body) {
    Rectangle least = relieved(body, MOST_RELIEF);
    return fmax(fmin(least.half_width, least.half_length - fabs(least.ahead)), 0);
}

static SearchAnswer propose(const Decide *decide, const Rung *rung, int least_reversals, int most_reversals,
                            SearchTrack *track) {
    Rectangle body = relieved(decide->body, rung->relief - decide->margin + SEARCH_CLEARANCE);
    SearchGrain grain = *rung->grain;
    grain.least_reversals = least_reversals;
    return search_legs(decide->query, decide->goals, decide->goal_count, &body, decide_radius(decide->body), &grain,
                       most_reversals, track, NULL);
}

static bool turns_on_spot(const Way *way) {
    bool turns = false;
    for (size_t k = 0; k < way->piece_count; k++)
        turns |= way->joints[k].turns;
    return turns;
}

/* Returns the time for which the chair waits on a way until the doors are open that it must open, s. */
static double delay_by_doors(const Decide *decide, const Way *way) {
    const RouteQuery *query = decide->query;
    SearchTrack track = {0};
    search_track_add(&track, (Pose){query->at, query->heading, 0, 0});
    way_write(way, &track);
    DoorwayPlace *places = memory_zeroed(track.count, sizeof *places);
    for (size_t i = 0; i < track.count; i++)
        places[i] = (DoorwayPlace){track.poses[i].at, vec2_heading(track.poses[i].heading)};
    double delay = doorway_delay(places, track.count, query->plan, query->profile);
    memory_free(places);
    search_track_clear(&track);
    return delay;
}

/* Makes a way that keeps a margin quicker, and keeps it if it is the best: one with the whole margin goes before one
 * that has hardly any. Takes the way over. Returns false if interrupted. */
static bool improve(Decide *decide, Way *way, double margin) {
    const RouteQuery *query = decide->query;
    if (query->rolls && turns_on_spot(way)) {
        way_free(way);
        return true;
    }
    double time = hasten_time(way, query->space, decide->body, query->profile);
    bool whole = true;
    if (margin > decide->kept) {
        decide->time = HUGE_VAL;
        decide->kept = margin;
        decide->latest = HUGE_VAL;
        decide->confirmed = 0;
    }
    if (!decide->any && margin == decide->kept && time < WORTH_HASTENING * decide->time)
        whole = quicken_way(query, decide->body, margin, way, &time);
    if (!decide->any)
        time += delay_by_doors(decide, way);
    if (whole && margin == decide->kept) {
        decide->latest = fmin(decide->latest, time);
        if (time < decide->time) {
            way_free(&decide->best);
            decide->best = *way;
            decide->time = time;
            return true;
        }
    }
    way_free(way);
    return whole;
}

/* Returns the way among those that could not be made free; NULL: it was not tried, or could. */
static const Stuck *find_stuck(const Decide *decide, uint64_t digest) {
    for (size_t i = 0; i < decide->stuck_count; i++)
        if (decide->stuck[i].digest == digest)
            return &decide->stuck[i];
    return NULL;
}

/* Makes a way free with a weight of comfort, and improves a copy of the free way. If it cannot be made free, it becomes
 * a way without pieces. Returns false if interrupted. */
static bool make_free(Decide *decide, Way *way, double comfort) {
    const RouteQuery *query = decide->query;
    RelaxOptions options = {decide->margin, BARELY, comfort, query->whether, query->stop};
    uint64_t digest = digest_mix(way_digest(way), comfort);
    const Stuck *stuck = find_stuck(decide, digest);
    double kept = stuck ? 0 : relax_way(way, query->space, decide->body, &options, &decide->lacking);
    if (stop_requested(query->stop))
        return false;
    if (kept > 0) {
        Way copy = way_copy(way);
        decide->lacking = 0;
        return improve(decide, &copy, kept);
    }
    if (stuck) {
        decide->lacking = stuck->lacking;
    } else {
        decide->stuck =
            memory_reserve(decide->stuck, &decide->stuck_capacity, decide->stuck_count + 1, sizeof *decide->stuck);
        decide->stuck[decide->stuck_count++] = (Stuck){digest, decide->lacking};
    }
    way_free(way);
    return true;
}

/* True if the latest proposal has led to about the time of the best way, too. */
static bool confirms(const Decide *decide) {
    return decide->confirmed > 0 && decide->time >= decide->before * (1 - ALIKE) &&
           decide->latest < decide->time * (1 + ALIKE);
}

/* True if the decision needs no more ways. */
static bool settled(const Decide *decide) {
    return decide->any ? decide->time < HUGE_VAL : decide->confirmed == SURE - 1 && confirms(decide);
}

/* Tries a free way with one heading at each change of direction at which it turns on the spot. Returns false if
 * interrupted. */
static bool straighten_cusps(Decide *decide, const Way *free_way, double comfort) {
    bool whole = true;
    for (size_t k = 0; k < sizeof shares / sizeof *shares && whole && !settled(decide); k++) {
        Way way = way_copy(free_way);
        if (way_straighten_cusps(&way, shares[k]))
            whole = make_free(decide, &way, comfort);
        way_free(&way);
    }
    return whole;
}

/* Makes a proposed way free, with each weight of comfort that it is worth, then replaces the turns on the spot of each
 * free way by narrow bends and makes the result free. Returns false if interrupted. */
static bool free_and_bend(Decide *decide, const Way *proposed) {
    bool whole = true;
    double lacking = 0; /* m, of the way as it was proposed */
    size_t count = proposed->piece_count > 1 ? sizeof comforts / sizeof *comforts : 1;
    for (size_t c = 0; c < count && whole && lacking <= LACKING && !settled(decide); c++) {
        Way way = way_copy(proposed);
        whole = make_free(decide, &way, comforts[c]);
        lacking = decide->lacking;
        if (whole && way.piece_count > 0 && !settled(decide) && way_join(&way))
            whole = make_free(decide, &way, comforts[c]);
        if (whole && way.piece_count > 0)
            whole = straighten_cusps(decide, &way, comforts[c]);
        way_free(&way);
    }
    return whole;
}

/* Improves a proposed way, with its turns on the spot and with narrow bends in their place, and counts whether it
 * confirms the best time. Takes the way over. Returns false if interrupted. */
static bool realise_way(Decide *decide, Way *way) {
    bool whole = true;
    decide->before = decide->time;
    decide->latest = HUGE_VAL;
    if (way->piece_count > 0)
        whole = free_and_bend(decide, way) && (settled(decide) || !way_join(way) || free_and_bend(decide, way));
    way_free(way);
    if (confirms(decide))
        decide->confirmed++;
    else if (decide->latest < HUGE_VAL && (decide->confirmed == 0 || decide->time < decide->before * (1 - ALIKE)))
        decide->confirmed = 1;
    return whole;
}

/* True if a proposed way takes so long, for a smaller body and with the kinks of the search's grid, that it is not
 * likely to become the best one. */
static bool is_too_long(const Decide *decide, const Way *way) {
    Rectangle smaller = relieved(decide->body, MOST_RELIEF);
    return decide->kept >= decide->margin && decide->time < HUGE_VAL &&
           hasten_time(way, decide->query->space, &smaller, decide->query->profile) > TOO_LONG * decide->time;
}

static bool realise(Decide *decide, const SearchTrack *track) {
    const Exit *exit = &decide->query->plan->exits[track->exit];
    Way way = way_of_track(track, exit, decide->goals, decide->goal_count - 1, SPACING);
    if (way.piece_count > 0 && is_too_long(decide, &way))
        way_free(&way);
    return realise_way(decide, &way);
}

/* Tries the best way without each of its short pieces, one after another, until every one that is left is needed.
 * Returns false if interrupted. */
static bool drop_short(Decide *decide) {
    bool whole = true;
    for (size_t k = 0; k + 1 < decide->best.piece_count && whole;) {
        double before = decide->time;
        Way way = way_copy(&decide->best);
        if (!way_drop(&way, k, SHORT)) {
            way_free(&way);
            k++;
            continue;
        }
        whole = realise_way(decide, &way);
        k = decide->time < before ? 0 : k + 1;
    }
    return whole;
}

/* Looks for ways with fewer changes of direction than the best one has, except by rungs that have proposed such a way
 * already, or found none with more. Returns false if interrupted. */
static bool try_fewer(Decide *decide, SearchTrack *proposal) {
    bool whole = true;
    for (int r = 0; r < RUNGS && whole; r++) {
        int reversals = way_reversals(&decide->best);
        const Asked *asked = &decide->asked[r];
        bool vain = asked->asked &&
                    (asked->answer == SEARCH_NONE || (asked->answer == SEARCH_FOUND && asked->reversals < reversals));
        if (rungs[r].stage != STAGE_BACK || reversals == 0 || vain)
            continue;
        SearchAnswer answer = propose(decide, &rungs[r], 0, reversals - 1, proposal);
        whole = answer != SEARCH_INTERRUPTED && (answer != SEARCH_FOUND || realise(decide, proposal));
    }
    return whole;
}

/* Returns the time that the best way loses by being driven backwards, s. */
static double lost_backwards(const Decide *decide) {
    const Way *way = &decide->best;
    const Profile *profile = decide->query->profile;
    double slower = 1 / fmin(profile->reversing_speed, profile->free_speed) - 1 / profile->free_speed, lost = 0;
    for (size_t k = 0; k < way->piece_count; k++)
        if (way->pieces[k].direction < 0)
            lost += slower * way->pieces[k].step * (double)(way->pieces[k].last - way->pieces[k].first);
    return lost;
}

/* Looks for ways with one to `most` changes of direction. Returns false if interrupted. */
static bool try_changes(Decide *decide, int most, SearchTrack *proposal) {
    bool whole = true;
    for (int t = 0; t < TURNINGS && whole; t++) {
        SearchAnswer answer = propose(decide, &turning[t], 1, most, proposal);
        whole = answer != SEARCH_INTERRUPTED && (answer != SEARCH_FOUND || realise(decide, proposal));
    }
    return whole;
}

/* Looks for ways with one change of direction, or else with more, where the best one has none and is driven backwards
 * for so long that a change costs less time. Returns false if interrupted. */
static bool try_turning(Decide *decide, SearchTrack *proposal) {
    const RouteQuery *query = decide->query;
    int most = query->most_reversals;
    if (most < 1 || way_reversals(&decide->best) > 0 || lost_backwards(decide) < query->profile->reversing_time)
        return true;
    return try_changes(decide, 1, proposal) &&
           (most == 1 || way_reversals(&decide->best) > 0 || try_changes(decide, most, proposal));
}

/* Makes the best way quicker once more where much hangs on the places of its stations: where it changes its direction
 * or turns on the spot. Returns false if interrupted. */
static bool polish(Decide *decide) {
    const RouteQuery *query = decide->query;
    bool whole = true, gains = decide->best.piece_count > 1 || turns_on_spot(&decide->best);
    for (size_t k = 0; k < sizeof spacings / sizeof *spacings && whole && gains; k++) {
        double time, before = decide->time;
        Way way;
        whole = quicken_copy(query, decide->body, decide->kept, &decide->best, spacings[k], &way, &time);
        if (whole && time < HUGE_VAL)
            time += delay_by_doors(decide, &way);
        gains = whole && time < before * (1 - ALIKE);
        if (whole && time < before) {
            way_free(&decide->best);
            decide->best = way;
            decide->time = time;
        } else {
            way_free(&way);
        }
    }
    return whole;
}

static void give_track(const Decide *decide, SearchTrack *track) {
    const RouteQuery *query = decide->query;
    search_track_clear(track);
    search_track_add(track, (Pose){query->at, query->heading, 0, 0});
    way_write(&decide->best, track);
    track->exit = (size_t)(decide->best.exit - query->plan->exits);
}

/* Returns the most of the space of states that a search can try, m2 rad. */
static double extent_of(const SearchGrain *grain) {
    return (double)grain->most_nodes * grain->cell * grain->cell * grain->turn;
}

/* True if a search with more nodes cannot find more, since the same one with fewer did not give up. */
static bool is_known(const Decide *decide, const Rung *rung) {
    bool gave_up = false;
    for (int r = 0; r < RUNGS; r++)
        gave_up |= decide->spent[r] > 0 && rungs[r].relief >= rung->relief && rungs[r].grain->cell == rung->grain->cell;
    return rung->grain == &coarse_far && !gave_up;
}

/* True if a search need not be tried, since a body that is hardly larger gave up, with as many changes of direction,
 * after it had tried as much of the space as this one could; or, with the true body, since smaller ones gave up and
 * none found a way. */
static bool is_vain(const Decide *decide, const SearchGrain *grain, double relief, Stage stage) {
    bool vain = false;
    for (int r = 0; r < RUNGS; r++)
        if (decide->spent[r] > 0 && (stage == STAGE_ONWARDS || rungs[r].stage != STAGE_ONWARDS))
            vain |= (rungs[r].relief >= relief - HARDLY && decide->spent[r] >= extent_of(grain)) ||
                    (relief <= 0 && !decide->proposed);
    return vain;
}

/* Searches with the true body, ever finer: what is found is free, though not by much. */
static SearchAnswer search_truly(const Decide *decide, SearchTrack *track, size_t *pins) {
    const RouteQuery *query = decide->query;
    SearchAnswer answer = SEARCH_NONE;
    for (int t = 0; t < TRUE_RUNGS; t++) {
        if (decide->vain[t] || is_vain(decide, &true_grains[t], 0, STAGE_LAST))
            continue;
        /* The finest grain cannot succeed if the previous one exhausted its nodes. */
        if ((decide->coarsely && t > 0) || (t == TRUE_RUNGS - 1 && answer == SEARCH_GAVE_UP))
            break;
        answer = search_legs(query, decide->goals, decide->goal_count, decide->body, decide_radius(decide->body),
                             &true_grains[t], query->most_reversals, track, pins);
        if (answer == SEARCH_FOUND || answer == SEARCH_INTERRUPTED)
            break;
    }
    return answer;
}

DecideAnswer decide_directly(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                             bool coarsely, double depth, SearchTrack *track, size_t *pins, FitPlace *tightest) {
    double clearance = search_clearance(query->space, body, query->at, query->heading, MARGIN + HAIR, NULL);
    Decide decide = {.query = query,
                     .body = body,
                     .goals = goals,
                     .goal_count = goal_count,
                     .any = coarsely || query->any,
                     .coarsely = coarsely,
                     .margin = fmax(clearance - HAIR, BARELY),
                     .time = HUGE_VAL};
    SearchTrack proposal = {0};
    DecideAnswer result = DECIDE_NONE;
    bool whole = true;
    int enough = decide.any ? 1 : SURE;
    for (int r = 0; r < RUNGS && whole && result == DECIDE_NONE && decide.confirmed < enough; r++) {
        bool begins = r > 0 && rungs[r].stage != rungs[r - 1].stage;
        if (begins && (decide.confirmed > 0 || query->most_reversals == 0))
            break;
        bool too_fine = coarsely && rungs[r].grain->cell < coarse.cell;
        if (!too_fine && !is_known(&decide, &rungs[r]) &&
            !is_vain(&decide, rungs[r].grain, rungs[r].relief, rungs[r].stage)) {
            bool onwards = rungs[r].stage == STAGE_ONWARDS;
            /* A body of nearly the true size is led along other ways without a change of direction, too. */
            bool again = onwards || rungs[r].grain == &coarse_long;
            int least = !again && decide.dropped_onwards;
            SearchAnswer answer = propose(&decide, &rungs[r], least, onwards ? 0 : query->most_reversals, &proposal);
            decide.asked[r] = (Asked){least == 0, answer, proposal.reversals};
            if (answer == SEARCH_GAVE_UP)
                decide.spent[r] = extent_of(rungs[r].grain);
            decide.proposed |= answer == SEARCH_FOUND;
            bool all = rungs[r].stage != STAGE_ONWARDS && !decide.dropped_onwards;
            for (int t = 0; t < TRUE_RUNGS && answer == SEARCH_NONE && all; t++)
                decide.vain[t] |= true_grains[t].cell == rungs[r].grain->cell;
            whole = answer != SEARCH_INTERRUPTED && (answer != SEARCH_FOUND || realise(&decide, &proposal));
            decide.dropped_onwards |= answer == SEARCH_FOUND && proposal.reversals == 0 && decide.confirmed == 0;
        }
        if (whole && r + 1 == ASK_WHETHER_IT_FITS && decide.confirmed == 0) {
            whole = fit_margin(query, body, goals, goal_count, -depth, 0, tightest) == FIT_KNOWN;
            if (whole && tightest->margin < -FIT_RESOLUTION)
                result = DECIDE_TOO_NARROW;
        }
    }
    if (whole && decide.confirmed == 0 && result == DECIDE_NONE) {
        SearchAnswer answer = search_truly(&decide, &proposal, pins);
        whole = answer != SEARCH_INTERRUPTED && (answer != SEARCH_FOUND || realise(&decide, &proposal));
        if (whole && answer == SEARCH_FOUND && decide.confirmed == 0 && !query->rolls) {
            search_track_clear(track);
            *track = proposal;
            proposal = (SearchTrack){0};
            result = DECIDE_SEARCHED;
        }
    }
    bool better = decide.confirmed > 0 && !decide.any;
    whole = whole && (!better || (drop_short(&decide) && try_fewer(&decide, &proposal) &&
                                  try_turning(&decide, &proposal) && drop_short(&decide) && polish(&decide) &&
                                  quicken_centre(query, body, decide.kept, &decide.best)));
    if (whole && decide.confirmed > 0) {
        give_track(&decide, track);
        result = DECIDE_FOUND;
    }
    search_track_clear(&proposal);
    way_free(&decide.best);
    memory_free(decide.stuck);
    return whole ? result : DECIDE_INTERRUPTED;
}

SearchAnswer decide_with_skids(const RouteQuery *query, const Rectangle *body, const Goal *goals, size_t goal_count,
                               SearchTrack *track) {
    SearchAnswer answer = SEARCH_NONE;
    for (int s = 0; s < SKIDDING_RUNGS && answer != SEARCH_FOUND && answer != SEARCH_INTERRUPTED; s++) {
        if (s == SKIDDING_RUNGS - 1 && answer == SEARCH_GAVE_UP)
            break;
        answer = search_legs(query, goals, goal_count, body, decide_radius(body), &skidding_grains[s],
                             query->most_reversals, track, NULL);
    }
    return answer;
}
