#include "route/relax.h"

#include <lapacke.h>
#include <string.h>

#include "base/memory.h"
#include "base/real.h"

/* The stations move so as to lower
 *
 *     E = sum of G0 l^2 / 2h + h (G1 k^2 + G2 (dk/ds)^2) + sum of h (mu max(0, m - d)^2 + wc max(0, C - d)^2),
 *
 *     k   curvature at a station, 1/m          h   step, m
 *     l   length of a step, m                 m   the margin with an allowance, m
 *     C   RELAX_COMFORT
 *     d   signed clearance of the body from one face, at each station, at even parts of the step to the next one and
 *         where that comes nearest to something, and at the tight headings of a turn on the spot. There is one
 *         term for every face, since between two opposite contacts the nearest alone would jump from one to the
 *         other.
 *
 * by Gauss and Newton's method with Levenberg's damping. Unknowns: a displacement along the normal for each inner
 * station; for each joint one along and one across the way, and its heading, or both headings if it turns on the spot;
 * for the last station one along the exit's line. In the order of the stations each unknown touches few neighbours, so
 * that the normal equations are banded (LAPACK: dpbsv). The derivatives are differences. mu rises in stages, while the
 * allowance falls: first a way through, then the exact margin. */

#define G0 0.2             /* 1: without a price of length the joints of a path would drift along corridors */
#define G1 0.02            /* m2 */
#define G2 0.01            /* m4 */
#define PROBE 1e-6         /* m or rad */
#define LONGEST 0.06       /* m, largest displacement in one iteration */
#define LARGEST 0.2        /* rad, largest turn of a heading */
#define PIN_WEIGHT 1e3     /* 1 */
#define PIN_SHARE 0.95     /* 1, of a pin's radius, that is aimed at */
#define SIGHT 0.16         /* m: faces within this clearance are looked at in an iteration */
#define HEADING_STEP 0.02  /* rad, between the headings at which a turn on the spot is measured */
#define NEARLY 0.015       /* m: places with more than this above the margin have no term of their own */
#define PART_ERROR 2e-3    /* 1, of a step, of its nearest places */
#define HEADING_ERROR 1e-3 /* rad, of its tightest headings */
#define ALMOST 0.8         /* 1, share of the margin that is enough: the last of it is expensive */
#define SETTLED 1e-3       /* 1: relative gain of an iteration that is the last one of its stage; hasten.c goes on */
#define STILL 0.01         /* m: nor does the last one move anything farther; to be straight gains little */
/* 1: nearly undamped, since in a long straight corridor E changes little across, and damped steps do not converge. */
#define FIRST_DAMPING 1e-10

enum {
    SITE_FACES = 24,
    SPOTS = 96,      /* of a turn by half a circle all of which is tight, with its minima */
    TIGHT_EVERY = 2, /* headings that are measured, of the tight ones one has terms */
    BAND = 16,
    MOST_TRIALS = 9,
    OWN_TERMS = 4,
    DIP_PARTS = 24,
    MOST_PLACES = WAY_MOST_BETWEEN + 3
};

typedef struct Stage {
    double weight;    /* mu */
    double allowance; /* m */
    double bending;   /* 1, factor of G1 and G2 */
    double spacing;   /* m */
    double hopeless;  /* m: a way that still lacks more margin than this is given up */
    int iterations;
} Stage;

static const Stage stages[] = {
    {1e4, 0.010, 1, 0.05, 0.10, 8},      {1e5, 0.005, 1, 0.05, 0.05, 8},      {1e5, 0.003, 0.25, 0.05, 0.02, 10},
    {1e6, 0.002, 0.25, 0.03, 0.006, 15}, {1e7, 0.001, 0.1, 0.025, 0.001, 15},
};
enum { STAGES = sizeof stages / sizeof *stages, NEEDED = 3 };

/* The faces near one placement of the body. */
typedef struct Site {
    int faces[SITE_FACES];
    int count;
} Site;

typedef enum UnknownKind { MOVE, TURN_BOTH, TURN_IN, TURN_OUT } UnknownKind;

typedef struct Unknown {
    UnknownKind kind;
    size_t station; /* the first one that it moves; a joint's other one follows */
    size_t joint;
    bool both;        /* True if it moves the next station, too */
    Vec2 way;         /* unit, of a displacement */
    size_t low, high; /* stations whose terms it changes */
} Unknown;

typedef struct Relax {
    Way *way;
    const FreeSpace *space;
    const Rectangle *body;
    double mu, comfort, margin, bending;
    Site *at;          /* (count) */
    Site *middle;      /* (count x MOST_PLACES) of the step after each station */
    double *parts;     /* (count x MOST_PLACES) 1, of the step, where they are */
    int *places;       /* (count) how many of them are used */
    Site *spots;       /* (piece_count x SPOTS) */
    double *headings;  /* (piece_count x SPOTS) rad, of the spots */
    int *spot_counts;  /* (piece_count) how many of them are used */
    size_t *starts;    /* (count + 1) first term of each station */
    double *terms;     /* (starts[count]) */
    Unknown *unknowns; /* (unknown_count) */
    size_t unknown_count, unknown_capacity;
} Relax;

static Vec2 middle_of(const Relax *relax, Vec2 at, Vec2 axis) {
    return vec2_along(at, relax->body->ahead, axis);
}

static void look(const Relax *relax, Site *site, Vec2 at, Vec2 axis) {
    site->count = freespace_faces(relax->space, middle_of(relax, at, axis), axis, relax->body->half_length,
                                  relax->body->half_width, SIGHT, site->faces, SITE_FACES);
}

static double spot_clearance(const Relax *relax, Vec2 at, double heading) {
    return search_clearance(relax->space, relax->body, at, heading, SIGHT, NULL);
}

static double clearance_between(const Relax *relax, size_t s, double part) {
    return way_clearance_between(relax->way, s, part, relax->space, relax->body, SIGHT);
}

/* Returns the part of least clearance of the step from a station, or, where `spot` is not NULL, the heading of least
 * clearance in a turn there, between `low` and `high`, between which there is one minimum. */
static double nearest(const Relax *relax, size_t s, const Vec2 *spot, double low, double high, double error) {
    while (fabs(high - low) > error) {
        double third = (high - low) / 3, a = low + third, b = high - third;
        double at_a = spot ? spot_clearance(relax, *spot, a) : clearance_between(relax, s, a);
        double at_b = spot ? spot_clearance(relax, *spot, b) : clearance_between(relax, s, b);
        if (at_a < at_b)
            high = b;
        else
            low = a;
    }
    return (low + high) / 2;
}

/* Finds the headings of a turn on the spot at which the clearance has a local minimum, and some at which it is hardly
 * more than the margin: else a step lowers those minima, and finds others in their place. */
static void look_on_spot(Relax *relax, size_t piece) {
    const Joint *joint = &relax->way->joints[piece];
    Vec2 at = relax->way->stations[relax->way->pieces[piece].first].at;
    int parts = (int)ceil(fabs(joint->out - joint->in) / HEADING_STEP), count = 0;
    double step = (joint->out - joint->in) / parts, before = SIGHT, here = spot_clearance(relax, at, joint->in);
    for (int part = 0; part < parts && count < SPOTS; part++) {
        double heading = joint->in + part * step, after = spot_clearance(relax, at, heading + step);
        bool least = here < SIGHT && here <= before && here <= after;
        if (least || (part % TIGHT_EVERY == 0 && here < relax->margin + NEARLY)) {
            size_t spot = piece * SPOTS + (size_t)count++;
            relax->headings[spot] =
                part && least ? nearest(relax, 0, &at, heading - step, heading + step, HEADING_ERROR) : heading;
            look(relax, &relax->spots[spot], at, vec2_heading(relax->headings[spot]));
        }
        before = here;
        here = after;
    }
    relax->spot_counts[piece] = count;
}

/* Chooses the places between a station and the next one: even parts of the step, and where a corner of the body that
 * passes a corner of something comes nearer than the margin. Returns their number. */
static int choose_places(const Relax *relax, size_t s) {
    double *parts = &relax->parts[s * MOST_PLACES];
    int count = way_places(relax->way, s);
    for (int i = 0; i < count; i++)
        parts[i] = (i + 1.0) / (count + 1);
    double before = HUGE_VAL, here = clearance_between(relax, s, 0), sought = relax->margin + NEARLY;
    WayPlace from = {0, here}, to = {1, clearance_between(relax, s, 1)};
    if (way_stays_clear(relax->way, s, relax->space, relax->body, from, to, sought, SIGHT))
        return count;
    for (int part = 0; part <= DIP_PARTS && count < MOST_PLACES; part++) {
        double at = (double)part / DIP_PARTS, step = 1.0 / DIP_PARTS;
        double after = part < DIP_PARTS ? clearance_between(relax, s, at + step) : HUGE_VAL;
        if (here < sought && here < before && here <= after)
            parts[count++] = nearest(relax, s, NULL, real_max(at - step, 0), real_min(at + step, 1), PART_ERROR);
        before = here;
        here = after;
    }
    return count;
}

/* Finds the faces near every placement, and gives each station its terms. */
static void look_around(Relax *relax) {
    const Way *way = relax->way;
    size_t terms = 0;
    for (size_t s = 0; s < way->count; s++) {
        const Station *station = &way->stations[s];
        const WayPiece *piece = &way->pieces[station->piece];
        relax->starts[s] = terms;
        look(relax, &relax->at[s], station->at, station->axis);
        terms += OWN_TERMS + 2 * (size_t)relax->at[s].count;
        relax->places[s] = s < piece->last ? choose_places(relax, s) : 0;
        for (int i = 0; i < relax->places[s]; i++) {
            size_t place = s * MOST_PLACES + (size_t)i;
            Site *site = &relax->middle[place];
            Station between = way_between(way, s, relax->parts[place]);
            look(relax, site, between.at, between.axis);
            terms += 2 * (size_t)site->count;
        }
        if (s == piece->first && way->joints[station->piece].turns) {
            look_on_spot(relax, station->piece);
            for (int spot = 0; spot < relax->spot_counts[station->piece]; spot++)
                terms += 2 * (size_t)relax->spots[station->piece * SPOTS + (size_t)spot].count;
        }
    }
    for (size_t p = 0; p < way->pin_count; p++)
        terms++;
    relax->starts[way->count] = terms - way->pin_count;
    memory_free(relax->terms);
    relax->terms = memory_zeroed(terms, sizeof *relax->terms);
}

/* Returns the signed curvature of the way at a station, 1/m: the angle between two steps per nominal step. Their actual
 * lengths are left out: stations that have moved together would hide a kink. */
static double curvature(const Way *way, size_t s) {
    const Station *here = &way->stations[s];
    const WayPiece *piece = &way->pieces[here->piece];
    Vec2 axis = vec2_scale(here->axis, piece->direction);
    if (s == piece->first)
        return 2 * vec2_angle_between(axis, vec2_sub(here[1].at, here->at)) / piece->step;
    Vec2 before = vec2_sub(here->at, here[-1].at);
    if (s < piece->last)
        return vec2_angle_between(before, vec2_sub(here[1].at, here->at)) / piece->step;
    if (here->piece + 1 < way->piece_count)
        return 2 * vec2_angle_between(before, axis) / piece->step;
    return 0;
}

static void face_terms(const Relax *relax, const Site *site, Vec2 at, Vec2 axis, double step, double *term) {
    Vec2 middle = middle_of(relax, at, axis);
    double hard = sqrt(relax->mu * step), soft = sqrt(relax->comfort * step);
    for (int f = 0; f < site->count; f++) {
        double clearance = freespace_face_clearance(relax->space, site->faces[f], middle, axis,
                                                    relax->body->half_length, relax->body->half_width, RELAX_COMFORT);
        *term++ = hard * real_max(relax->margin - clearance, 0);
        *term++ = soft * real_max(RELAX_COMFORT - clearance, 0);
    }
}

/* True if a station is where it was before a probe moved some of those from `low` to `high`. */
static bool stands(const Way *way, const Station *before, size_t low, size_t high, size_t s) {
    return s > high || memcmp(&before[s - low], &way->stations[s], sizeof *before) == 0;
}

/* Fills in the terms of the stations low to high. `before` holds these stations as they were before a probe, with
 * relax->terms, which are taken over where the body has not moved; NULL: every term is computed. */
static void evaluate(const Relax *relax, size_t low, size_t high, const Station *before, double *terms) {
    const Way *way = relax->way;
    double bend = curvature(way, low);
    bool still = before && stands(way, before, low, high, low);
    for (size_t s = low; s <= high; s++) {
        const Station *station = &way->stations[s];
        const WayPiece *piece = &way->pieces[station->piece];
        double *term = terms + (relax->starts[s] - relax->starts[low]), step = piece->step;
        double next = s + 1 < way->count ? curvature(way, s + 1) : 0;
        bool here = still; /* True if the body has not moved at the station; `still`: nor at the next one */
        still = before && stands(way, before, low, high, s + 1);
        *term++ = sqrt(relax->bending * G1 * step) * bend;
        *term++ = s < piece->last ? sqrt(relax->bending * G2 / step) * (next - bend) : 0;
        Vec2 along = s < piece->last ? vec2_sub(station[1].at, station->at) : vec2(0, 0);
        *term++ = sqrt(G0 / (2 * step)) * along.x;
        *term++ = sqrt(G0 / (2 * step)) * along.y;
        bend = next;
        if (here && still) {
            size_t first = relax->starts[s] + OWN_TERMS;
            memcpy(term, relax->terms + first, (relax->starts[s + 1] - first) * sizeof *term);
            continue;
        }
        size_t faces = (size_t)relax->at[s].count;
        if (here)
            memcpy(term, relax->terms + relax->starts[s] + OWN_TERMS, 2 * faces * sizeof *term);
        else
            face_terms(relax, &relax->at[s], station->at, station->axis, step, term);
        term += 2 * faces;
        for (int i = 0; i < relax->places[s]; i++) {
            size_t place = s * MOST_PLACES + (size_t)i;
            const Site *site = &relax->middle[place];
            if (!site->count)
                continue;
            Station between = way_between(way, s, relax->parts[place]);
            face_terms(relax, site, between.at, between.axis, step, term);
            term += 2 * site->count;
        }
        if (s == piece->first && way->joints[station->piece].turns)
            for (int i = 0; i < relax->spot_counts[station->piece]; i++) {
                size_t spot = station->piece * SPOTS + (size_t)i;
                face_terms(relax, &relax->spots[spot], station->at, vec2_heading(relax->headings[spot]), step, term);
                term += 2 * relax->spots[spot].count;
            }
    }
}

static void evaluate_pins(const Relax *relax, double *terms) {
    const Way *way = relax->way;
    for (size_t p = 0; p < way->pin_count; p++) {
        const WayPin *pin = &way->pins[p];
        double away = vec2_distance(way->stations[pin->station].at, pin->at) - PIN_SHARE * pin->radius;
        terms[relax->starts[way->count] + p] = sqrt(PIN_WEIGHT) * real_max(away, 0);
    }
}

static double energy(const Relax *relax) {
    size_t count = relax->starts[relax->way->count] + relax->way->pin_count;
    double sum = 0;
    evaluate(relax, 0, relax->way->count - 1, NULL, relax->terms);
    evaluate_pins(relax, relax->terms);
    for (size_t i = 0; i < count; i++)
        sum += relax->terms[i] * relax->terms[i];
    return sum;
}

static void add_unknown(Relax *relax, UnknownKind kind, size_t station, size_t joint, bool both, Vec2 way) {
    size_t last = relax->way->count - 1, end = station + both;
    relax->unknowns =
        memory_reserve(relax->unknowns, &relax->unknown_capacity, relax->unknown_count + 1, sizeof *relax->unknowns);
    relax->unknowns[relax->unknown_count++] =
        (Unknown){kind, station, joint, both, way, station < 2 ? 0 : station - 2, end + 2 > last ? last : end + 2};
}

static void choose_unknowns(Relax *relax) {
    const Way *way = relax->way;
    relax->unknown_count = 0;
    if (way->joints[0].turns)
        add_unknown(relax, TURN_OUT, 0, 0, false, vec2(0, 0));
    for (size_t k = 0; k < way->piece_count; k++) {
        const WayPiece *piece = &way->pieces[k];
        for (size_t s = piece->first + 1; s < piece->last; s++)
            add_unknown(relax, MOVE, s, k, false, vec2_left(way->stations[s].axis));
        if (k + 1 == way->piece_count)
            break;
        Vec2 axis = way->stations[piece->last].axis;
        add_unknown(relax, MOVE, piece->last, k + 1, true, axis);
        add_unknown(relax, MOVE, piece->last, k + 1, true, vec2_left(axis));
        if (way->joints[k + 1].turns) {
            add_unknown(relax, TURN_IN, piece->last, k + 1, true, axis);
            add_unknown(relax, TURN_OUT, piece->last, k + 1, true, axis);
        } else {
            add_unknown(relax, TURN_BOTH, piece->last, k + 1, true, axis);
        }
    }
    Vec2 line = vec2_unit(vec2_sub(way->exit->to, way->exit->from));
    add_unknown(relax, MOVE, way->count - 1, 0, false, line);
}

/* Changes an unknown, without the axes. */
static void change(Way *way, const Unknown *unknown, double by) {
    if (unknown->kind == MOVE) {
        for (size_t s = unknown->station; s <= unknown->station + unknown->both; s++)
            way->stations[s].at = vec2_along(way->stations[s].at, by, unknown->way);
        return;
    }
    Joint *joint = &way->joints[unknown->joint];
    joint->in += unknown->kind == TURN_OUT ? 0 : by;
    joint->out += unknown->kind == TURN_IN ? 0 : by;
}

/* The derivative of the terms in one unknown: the terms from `first` on, then those of the pins. */
typedef struct Column {
    size_t first, count;
    double *slopes; /* (count) */
    double *pins;   /* (pin_count) */
} Column;

static void differentiate(Relax *relax, const Unknown *unknown, const Column *column, double *room) {
    Way *way = relax->way;
    Station kept[8];
    Joint joint = way->joints[unknown->joint];
    size_t low = unknown->low, count = unknown->high - low + 1;
    memcpy(kept, way->stations + low, count * sizeof *kept);
    change(way, unknown, PROBE);
    way_set_axes(way, low, unknown->high);
    evaluate(relax, low, unknown->high, kept, room);
    for (size_t i = 0; i < column->count; i++)
        column->slopes[i] = (room[i] - relax->terms[column->first + i]) / PROBE;
    for (size_t p = 0; p < way->pin_count; p++) {
        const WayPin *pin = &way->pins[p];
        double away = vec2_distance(way->stations[pin->station].at, pin->at) - PIN_SHARE * pin->radius;
        column->pins[p] = (sqrt(PIN_WEIGHT) * real_max(away, 0) - relax->terms[relax->starts[way->count] + p]) / PROBE;
    }
    memcpy(way->stations + low, kept, count * sizeof *kept);
    way->joints[unknown->joint] = joint;
}

static double product(const Column *a, const Column *b, size_t pins) {
    size_t first = a->first > b->first ? a->first : b->first;
    size_t end_a = a->first + a->count, end_b = b->first + b->count, end = end_a < end_b ? end_a : end_b;
    double sum = 0;
    for (size_t i = first; i < end; i++)
        sum += a->slopes[i - a->first] * b->slopes[i - b->first];
    for (size_t p = 0; p < pins; p++)
        sum += a->pins[p] * b->pins[p];
    return sum;
}

/* Forms the normal equations: the upper band, column by column as LAPACK has it, and the right side. */
static void form(Relax *relax, double *band, double *side) {
    size_t n = relax->unknown_count, pins = relax->way->pin_count, total = 0, widest = 0;
    Column *columns = memory_zeroed(n, sizeof *columns);
    for (size_t u = 0; u < n; u++) {
        const Unknown *unknown = &relax->unknowns[u];
        size_t count = relax->starts[unknown->high + 1] - relax->starts[unknown->low];
        total += count + pins;
        widest = count > widest ? count : widest;
    }
    double *slopes = memory_zeroed(total, sizeof *slopes), *room = memory_zeroed(widest, sizeof *room), *free = slopes;
    for (size_t u = 0; u < n; u++) {
        const Unknown *unknown = &relax->unknowns[u];
        size_t first = relax->starts[unknown->low], count = relax->starts[unknown->high + 1] - first;
        columns[u] = (Column){first, count, free, free + count};
        free += count + pins;
        differentiate(relax, unknown, &columns[u], room);
    }
    for (size_t u = 0; u < n; u++) {
        const Column *column = &columns[u];
        side[u] = 0;
        for (size_t i = 0; i < column->count; i++)
            side[u] -= column->slopes[i] * relax->terms[column->first + i];
        for (size_t p = 0; p < pins; p++)
            side[u] -= column->pins[p] * relax->terms[relax->starts[relax->way->count] + p];
        for (size_t v = u > BAND ? u - BAND : 0; v <= u; v++)
            band[u * (BAND + 1) + BAND - (u - v)] = product(column, &columns[v], pins);
    }
    memory_free(slopes);
    memory_free(room);
    memory_free(columns);
}

/* Solves the damped equations; the side becomes the step. Returns false if they cannot be solved. */
static bool solve(const double *band, const double *side, double damping, size_t n, double *factor, double *step) {
    memcpy(factor, band, n * (BAND + 1) * sizeof *factor);
    memcpy(step, side, n * sizeof *step);
    for (size_t u = 0; u < n; u++)
        factor[u * (BAND + 1) + BAND] += damping * (band[u * (BAND + 1) + BAND] + 1e-3);
    lapack_int size = (lapack_int)n;
    return LAPACKE_dpbsv(LAPACK_COL_MAJOR, 'U', size, BAND, 1, factor, BAND + 1, step, size) == 0;
}

/* Shortens a step to what one iteration may do, and takes it. Returns its largest displacement, m, a heading's by the
 * same share of what it may do. */
static double take(Relax *relax, const double *step) {
    double longest = 0;
    for (size_t u = 0; u < relax->unknown_count; u++)
        longest = fmax(longest, fabs(step[u]) / (relax->unknowns[u].kind == MOVE ? LONGEST : LARGEST));
    double scale = longest > 1 ? 1 / longest : 1;
    for (size_t u = 0; u < relax->unknown_count; u++)
        change(relax->way, &relax->unknowns[u], scale * step[u]);
    Way *way = relax->way;
    Station *end = &way->stations[way->count - 1];
    double low, high, length = vec2_distance(way->exit->from, way->exit->to);
    Vec2 line = vec2_scale(vec2_sub(way->exit->to, way->exit->from), 1 / length);
    double at = vec2_dot(vec2_sub(end->at, way->exit->from), line);
    way_exit_range(way, &low, &high);
    end->at = vec2_along(end->at, real_clamp(at, low, high) - at, line);
    way_set_axes(way, 0, way->count - 1);
    return real_min(longest, 1) * LONGEST;
}

/* True if a way can be driven: it reaches its goals, has stations enough in its bends, and keeps a margin. */
static bool is_drivable(const Way *way, const FreeSpace *space, const Rectangle *body, double margin) {
    return way_reaches_goals(way) && way_is_smooth(way, 0, way->count - 1) && way_swept(way, space, body, margin);
}

/* True if, besides, it has that margin at its stations: this is sooner known of a way that has not. */
static bool is_free(const Way *way, const FreeSpace *space, const Rectangle *body, double margin) {
    return way_clearance(way, space, body, margin) >= margin && is_drivable(way, space, body, margin);
}

/* One stage. Returns false if interrupted. */
static bool run_stage(Relax *relax, int iterations, const RelaxOptions *options) {
    Way *way = relax->way;
    double damping = FIRST_DAMPING;
    for (int iteration = 0; iteration < iterations; iteration++) {
        if (stop_requested(options->stop))
            return false;
        if (options->soon && is_free(way, relax->space, relax->body, options->margin * ALMOST))
            break;
        look_around(relax);
        choose_unknowns(relax);
        size_t n = relax->unknown_count, size = n * (BAND + 1);
        double *band = memory_zeroed(2 * size + 2 * n, sizeof *band), *factor = band + size, *side = factor + size;
        double before = energy(relax), after = before, moved = 0;
        form(relax, band, side);
        Way kept = way_copy(way);
        for (int trial = 0; trial < MOST_TRIALS && !(after < before); trial++) {
            if (solve(band, side, damping, n, factor, side + n)) {
                moved = take(relax, side + n);
                after = energy(relax);
            }
            if (after < before)
                damping *= 0.3;
            else {
                damping = 5 * damping + 1e-3;
                memcpy(way->stations, kept.stations, way->count * sizeof *way->stations);
                memcpy(way->joints, kept.joints, way->piece_count * sizeof *way->joints);
            }
        }
        way_free(&kept);
        memory_free(band);
        if (!(after < before) || (moved < STILL && !(after < before * (1 - SETTLED))))
            break;
    }
    return true;
}

static void relax_reserve(Relax *relax) {
    size_t count = relax->way->count;
    relax->at = memory_zeroed(count, sizeof *relax->at);
    relax->middle = memory_zeroed(count * MOST_PLACES, sizeof *relax->middle);
    relax->parts = memory_zeroed(count * MOST_PLACES, sizeof *relax->parts);
    relax->places = memory_zeroed(count, sizeof *relax->places);
    relax->spots = memory_zeroed(relax->way->piece_count * SPOTS, sizeof *relax->spots);
    relax->headings = memory_zeroed(relax->way->piece_count * SPOTS, sizeof *relax->headings);
    relax->spot_counts = memory_zeroed(relax->way->piece_count, sizeof *relax->spot_counts);
    relax->starts = memory_zeroed(count + 1, sizeof *relax->starts);
}

static void relax_release(Relax *relax) {
    memory_free(relax->at);
    memory_free(relax->middle);
    memory_free(relax->parts);
    memory_free(relax->places);
    memory_free(relax->spots);
    memory_free(relax->headings);
    memory_free(relax->spot_counts);
    memory_free(relax->starts);
    memory_free(relax->terms);
    memory_free(relax->unknowns);
}

double relax_way(Way *way, const FreeSpace *space, const Rectangle *body, const RelaxOptions *options,
                 double *lacking) {
    double enough = options->margin * ALMOST, clearance = 0;
    Way good = {0}; /* the latest drivable one, with even steps if there is such a one */
    bool done = false, good_is_even = false;
    *lacking = 0;
    for (int s = 0; s < STAGES && !done; s++) {
        const Stage *stage = &stages[s];
        Relax relax = {.way = way,
                       .space = space,
                       .body = body,
                       .mu = stage->weight,
                       .comfort = options->comfort,
                       .margin = options->margin + stage->allowance,
                       .bending = stage->bending};
        way_resample(way, stage->spacing);
        relax_reserve(&relax);
        bool whole = run_stage(&relax, stage->iterations, options);
        relax_release(&relax);
        if (!whole) {
            way_free(&good);
            return 0;
        }
        clearance = way_clearance(way, space, body, options->margin);
        bool free = clearance >= enough && is_drivable(way, space, body, enough);
        bool even = way_is_even(way, 0, way->count - 1);
        if (free && (even || !good_is_even)) {
            way_free(&good);
            good = way_copy(way);
            good_is_even = even;
        }
        done = (free && (options->soon || (even && s + 1 >= NEEDED))) || clearance < options->margin - stage->hopeless;
    }
    if (good.count) {
        way_free(way);
        *way = good;
        return options->margin;
    }
    *lacking = real_max(options->margin - clearance, 0);
    return clearance > options->barely && is_drivable(way, space, body, options->barely) ? options->barely : 0;
}
