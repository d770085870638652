#include "route/start.h"

#include <math.h>

#include "plan/plan_geometry.h"

#define EASED_STEP 0.002      /* m */
#define CLEARING_STEP 0.01    /* m */
enum { MOST_CLEARINGS = 30 }; /* steps straight back or ahead from an obstacle, or as many as the overlap takes */
enum { MOST_EASINGS = 12 };   /* steps to push the start pose clear of each obstacle in turn */

enum { FACES = 16 /* that are looked at */ };

static bool is_line(const Plan *plan, const Face *face) {
    return face->owner == OWNER_WALL && plan->walls[face->index].closed_exit;
}

static bool has_lines(const Plan *plan) {
    bool found = false;
    for (size_t w = 0; w < plan->wall_count; w++)
        found |= plan->walls[w].closed_exit;
    return found;
}

/* Returns how deep the body is in anything but the lines of closed exits, which do not touch it: the least clearance,
 * m, at most 0. */
static double depth_in_solids(const RouteQuery *query, const Rectangle *body, Vec2 at) {
    Vec2 axis = vec2_heading(query->heading), centre = vec2_along(at, body->ahead, axis);
    int faces[FACES];
    int count = freespace_faces(query->space, centre, axis, body->half_length, body->half_width, 0, faces, FACES);
    double least = count < FACES ? 0 : -HUGE_VAL;
    for (int f = 0; f < count; f++)
        if (!is_line(query->plan, &query->space->outline->faces[faces[f]]))
            least = fmin(least, freespace_face_clearance(query->space, faces[f], centre, axis, body->half_length,
                                                         body->half_width, 0));
    return least;
}

/* True if the reference point would cross the line of a closed exit, which holds it. */
static bool crosses_line(const Plan *plan, Vec2 from, Vec2 to) {
    for (size_t w = 0; w < plan->wall_count; w++) {
        const Vec2 *ends = plan->walls[w].points.at;
        if (plan->walls[w].closed_exit && plan_geometry_leads_out(&(Exit){.from = ends[0], .to = ends[1]}, from, to))
            return true;
    }
    return false;
}

int start_go_clear(const RouteQuery *query, const Rectangle *body, Vec2 *at) {
    bool lines = has_lines(query->plan);
    double start = lines ? fmin(depth_in_solids(query, body, query->at), -ROUTE_EASED) : -query->pressed;
    double before[2] = {start, start};
    int most = (int)fmax(MOST_CLEARINGS, (query->pressed + ROUTE_EASED) / CLEARING_STEP + 1);
    for (int n = 1; n <= most; n++)
        for (int direction = -1; direction <= 1; direction += 2) {
            double *clearance = &before[direction > 0];
            Vec2 there = vec2_along(query->at, direction * n * CLEARING_STEP, vec2_heading(query->heading));
            double now = search_clearance(query->space, body, there, query->heading, ROUTE_EASED, NULL);
            double depth = lines ? depth_in_solids(query, body, there) : now;
            if (!(*clearance > -HUGE_VAL) || depth < *clearance || crosses_line(query->plan, query->at, there)) {
                *clearance = -HUGE_VAL; /* something is in the way, and stays there */
                continue;
            }
            if (now >= ROUTE_EASED) {
                *at = there;
                return direction;
            }
            *clearance = depth;
        }
    return 0;
}

bool start_ease_off(const RouteQuery *query, const Rectangle *body, Vec2 *at) {
    int face;
    Vec2 here = query->at;
    double best = search_clearance(query->space, body, here, query->heading, ROUTE_EASED, &face), clearance = best;
    *at = here;
    if (!(query->pressed > 0) || best < -query->pressed)
        return best >= 0;
    for (int n = 0; n < MOST_EASINGS && clearance < ROUTE_EASED && face >= 0; n++) {
        /* Resolve the full overlap, but only half of the missing comfort: there may be an obstacle on the other side.
         */
        double move = clearance < 0 ? EASED_STEP - clearance : fmax((ROUTE_EASED - clearance) / 2, EASED_STEP);
        here = vec2_along(here, move, query->space->outline->faces[face].normal);
        clearance = search_clearance(query->space, body, here, query->heading, ROUTE_EASED, &face);
        if (clearance > best && vec2_distance(here, query->at) <= 2 * (query->pressed + ROUTE_EASED)) {
            best = clearance;
            *at = here;
        }
    }
    return best >= 0;
}

void start_push_off(const FreeSpace *space, double radius, Vec2 *at) {
    for (int n = 0; n < MOST_EASINGS; n++) {
        int face;
        double distance = freespace_exact(space, *at, radius, &face);
        if (face < 0 || distance >= radius)
            return;
        const Face *near = &space->outline->faces[face];
        Vec2 away = vec2_sub(*at, vec2_nearest_on_segment(*at, near->a, near->b));
        away = distance > 0 ? vec2_scale(away, 1 / distance) : near->normal;
        *at = vec2_along(*at, radius - distance + EASED_STEP, away);
    }
}
