#include "planar_map.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

enum { PLANE = 2, COLUMNS = 2 };

typedef struct Place {
    const PlanarMap *map;
    double point[PLANE], tangent[PLANE][PLANE], peak[CYCLE_SIDES];
    size_t tangents;
    CycleStatus status;
} Place;

static size_t states_of(const void *given) {
    (void)given;
    return PLANE;
}

static double one(const void *given) {
    (void)given;
    return 1;
}

static double small(const void *given) {
    (void)given;
    return 1e-6;
}

static void *create(const void *given, size_t tangents, const Stop *stop) {
    (void)stop;
    Place *place = memory_zeroed(1, sizeof *place);
    *place = (Place){.map = given, .tangents = tangents};
    return place;
}

static void copy(void *to, const void *from) {
    memcpy(to, from, sizeof(Place));
}

static void state_of(const void *motion, double *state) {
    memcpy(state, ((const Place *)motion)->point, sizeof(double[PLANE]));
}

static void set_state(void *motion, const double *state) {
    memcpy(((Place *)motion)->point, state, sizeof(double[PLANE]));
}

static void tangent_of(const void *motion, size_t index, double *tangent) {
    memcpy(tangent, ((const Place *)motion)->tangent[index], sizeof(double[PLANE]));
}

static void set_tangent(void *motion, size_t index, const double *tangent) {
    memcpy(((Place *)motion)->tangent[index], tangent, sizeof(double[PLANE]));
}

static void unit_tangents(void *motion) {
    Place *place = motion;
    for (size_t t = 0; t < place->tangents; t++)
        for (size_t i = 0; i < PLANE; i++)
            place->tangent[t][i] = i == t;
}

static CycleStatus run(void *motion) {
    Place *place = motion;
    double d[PLANE * PLANE];
    place->map->move(place->map->numbers, place->point, d);
    for (size_t t = 0; t < place->tangents; t++) {
        double x = place->tangent[t][0], y = place->tangent[t][1];
        place->tangent[t][0] = d[0] * x + d[2] * y;
        place->tangent[t][1] = d[1] * x + d[3] * y;
    }
    place->peak[0] = fmax(place->peak[0], fabs(place->point[0]));
    double most = place->map->diverges;
    if (most > 0 && !(fabs(place->point[0]) < most && fabs(place->point[1]) < most))
        place->status = CYCLE_DIVERGED;
    return place->status;
}

static CycleStatus status_of(const void *motion) {
    return ((const Place *)motion)->status;
}

static CycleTally tally_of(const void *motion) {
    (void)motion;
    return (CycleTally){0};
}

static double *peaks_of(void *motion) {
    return ((Place *)motion)->peak;
}

static void sample(void *motion, int part, double *row) {
    (void)part;
    row[1] = ((Place *)motion)->point[0];
}

static size_t saved_size(const void *given) {
    (void)given;
    return PLANE;
}

Cycle planar_map_cycle(const PlanarMap *map) {
    static const TraceColumn columns[COLUMNS] = {{"time", "s"}, {"x", "1"}};
    static const CycleKind kind = {.columns = columns,
                                   .column_count = COLUMNS,
                                   .samples = 1,
                                   .closing = 1e-11,
                                   .cycles_least = 2000,
                                   .cycles_most = 16000,
                                   .lane_apart = 300,
                                   .together = 16,
                                   .states = states_of,
                                   .period = one,
                                   .rest_tip = small,
                                   .rest_state = small,
                                   .create = create,
                                   .destroy = memory_free,
                                   .copy = copy,
                                   .state = state_of,
                                   .set_state = set_state,
                                   .tangent = tangent_of,
                                   .set_tangent = set_tangent,
                                   .unit_tangents = unit_tangents,
                                   .run = run,
                                   .status = status_of,
                                   .tally = tally_of,
                                   .peaks = peaks_of,
                                   .tip = state_of,
                                   .sample = sample,
                                   .saved_size = saved_size,
                                   .save = state_of,
                                   .restore = set_state};
    return (Cycle){&kind, map};
}

/* Maps ------------------------------------------------------------------------------------------------------------- */

static void put(double *derivative, double xx, double yx, double xy, double yy) {
    derivative[0] = xx;
    derivative[1] = yx;
    derivative[2] = xy;
    derivative[3] = yy;
}

void planar_map_logistic(const void *numbers, double *point, double *derivative) {
    double r = ((const double *)numbers)[0], x = point[0];
    point[0] = r * x * (1 - x);
    point[1] = x;
    put(derivative, r * (1 - 2 * x), 1, 0, 0);
}

void planar_map_cubic(const void *numbers, double *point, double *derivative) {
    double r = ((const double *)numbers)[0], x = point[0] - 1;
    point[1] = point[0];
    point[0] = 1 + r * x - x * x * x;
    put(derivative, r - 3 * x * x, 1, 0, 0);
}

void planar_map_henon(const void *numbers, double *point, double *derivative) {
    const double *n = numbers;
    double x = point[0];
    point[0] = 1 - n[0] * x * x + point[1];
    point[1] = n[1] * x;
    put(derivative, -2 * n[0] * x, n[1], 1, 0);
}

void planar_map_delayed(const void *numbers, double *point, double *derivative) {
    double r = *(const double *)numbers, x = point[0], y = point[1];
    point[0] = r * x * (1 - y);
    point[1] = x;
    put(derivative, r * (1 - y), 1, -r * x, 0);
}

void planar_map_spiral(const void *numbers, double *point, double *derivative) {
    const double *n = numbers;
    double c = n[1] * cos(2 * M_PI * n[0]), s = n[1] * sin(2 * M_PI * n[0]), x = point[0], y = point[1];
    point[0] = c * x - s * y;
    point[1] = s * x + c * y;
    put(derivative, c, s, -s, c);
}

void planar_map_ring(const void *numbers, double *point, double *derivative) {
    const double *n = numbers;
    double c = cos(2 * M_PI * n[0]), s = sin(2 * M_PI * n[0]), x = point[0], y = point[1], rate = n[1];
    double stretch = 1 + rate * (1 - x * x - y * y),
           a[4] = {stretch - 2 * rate * x * x, -2 * rate * x * y, -2 * rate * x * y, stretch - 2 * rate * y * y};
    point[0] = stretch * (c * x - s * y);
    point[1] = stretch * (s * x + c * y);
    put(derivative, c * a[0] - s * a[1], s * a[0] + c * a[1], c * a[2] - s * a[3], s * a[2] + c * a[3]);
}

/* An oscillator that hits a stop ------------------------------------------------------------------------------------
 */

/* A motion between impacts: gamma sin(omega t), and swing cos + push sin of the time since `from`. */
typedef struct Flight {
    double omega, gamma, from, swing, push;
} Flight;

static Flight take_off(double omega, double from, const double *point) {
    double gamma = 1 / (1 - omega * omega);
    return (Flight){omega, gamma, from, point[0] - gamma * sin(omega * from),
                    point[1] - gamma * omega * cos(omega * from)};
}

static void fly(const Flight *flight, double time, double *point) {
    double c = cos(time - flight->from), s = sin(time - flight->from), turn = flight->omega * time;
    point[0] = flight->gamma * sin(turn) + flight->swing * c + flight->push * s;
    point[1] = flight->gamma * flight->omega * cos(turn) - flight->swing * s + flight->push * c;
}

/* Returns when a flight reaches the gap from below, or `end`. */
static double find_impact(const Flight *flight, double gap, double end) {
    enum { LOOKS = 400, HALVINGS = 60 };
    double before = flight->from, point[PLANE];
    for (int i = 1; i <= LOOKS; i++) {
        double after = flight->from + (end - flight->from) * i / LOOKS;
        fly(flight, after, point);
        for (int k = 0; k < HALVINGS && point[0] > gap; k++) {
            double middle = (before + after) / 2, there[PLANE];
            fly(flight, middle, there);
            *(there[0] > gap ? &after : &before) = middle;
        }
        if (point[0] > gap)
            return after;
        before = after;
    }
    return end;
}

/* Turns the derivative (2 x 2, column by column) by a flight of so long. */
static void carry(double *d, double time) {
    double c = cos(time), s = sin(time);
    for (double *column = d; column < d + PLANE * PLANE; column += PLANE) {
        double x = column[0], y = column[1];
        column[0] = c * x + s * y;
        column[1] = c * y - s * x;
    }
}

void planar_map_impact(const void *numbers, double *point, double *derivative) {
    const double *n = numbers, period = 2 * M_PI / n[1];
    put(derivative, 1, 0, 0, 1);
    for (double from = 0; from < period;) {
        Flight flight = take_off(n[1], from, point);
        double time = find_impact(&flight, n[0], period);
        fly(&flight, time, point);
        carry(derivative, time - from);
        if (time < period) {
            /* an impact that is earlier by dx / v leaves -r dx, and -r dv + (1 + r) acceleration dx / v */
            double late = (1 + n[2]) * (sin(n[1] * time) - n[0]) / point[1];
            for (double *column = derivative; column < derivative + PLANE * PLANE; column += PLANE) {
                column[1] = late * column[0] - n[2] * column[1];
                column[0] *= -n[2];
            }
            point[0] = n[0];
            point[1] *= -n[2];
        }
        from = time;
    }
}
