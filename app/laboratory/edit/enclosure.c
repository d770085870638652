/* The axes of the walls, cut where they meet, are the edges of a planar graph; loose ends are cut away. From the edge
 * that a ray from the place meets first, the boundary of the face to its left is followed: at each node along the next
 * edge clockwise. If that boundary runs clockwise, it belongs to an island within the room, and the ray goes on. */
#include "laboratory/edit/enclosure.h"

#include <math.h>

#include "base/memory.h"

static const double SAME = 0.005; /* m: points closer than this coincide */

typedef struct Edge {
    size_t from, to;
} Edge;

typedef struct Graph {
    Vec2 *nodes;
    Edge *edges;
    size_t node_count, node_capacity, edge_count, edge_capacity;
} Graph;

static size_t node_at(Graph *graph, Vec2 at) {
    for (size_t i = 0; i < graph->node_count; i++)
        if (vec2_distance(graph->nodes[i], at) < SAME)
            return i;
    graph->nodes = memory_reserve(graph->nodes, &graph->node_capacity, graph->node_count + 1, sizeof *graph->nodes);
    graph->nodes[graph->node_count] = at;
    return graph->node_count++;
}

static void add_edge(Graph *graph, size_t from, size_t to) {
    for (size_t i = 0; i < graph->edge_count; i++)
        if ((graph->edges[i].from == from && graph->edges[i].to == to) ||
            (graph->edges[i].from == to && graph->edges[i].to == from))
            return;
    graph->edges = memory_reserve(graph->edges, &graph->edge_capacity, graph->edge_count + 1, sizeof *graph->edges);
    graph->edges[graph->edge_count++] = (Edge){from, to};
}

/* Returns where a segment meets another one, as a share of the first; NAN: nowhere. */
static double meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    Vec2 own = vec2_sub(b, a), other = vec2_sub(d, c);
    double across = vec2_cross(own, other), length = vec2_length(own), reach = SAME / vec2_length(other);
    if (fabs(across) < 1e-9 * length * vec2_length(other))
        return NAN;
    double share = vec2_cross(vec2_sub(c, a), other) / across, part = vec2_cross(vec2_sub(c, a), own) / across;
    return part >= -reach && part <= 1 + reach && share >= -SAME / length && share <= 1 + SAME / length ? share : NAN;
}

/* Adds a segment, cut where other walls meet it. */
static void add_segment(Graph *graph, const Plan *plan, Vec2 a, Vec2 b) {
    double *cuts = NULL;
    size_t count = 0, capacity = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++) {
            double share = meeting(a, b, plan->walls[w].points.at[s], plan->walls[w].points.at[s + 1]);
            if (isnan(share))
                continue;
            cuts = memory_reserve(cuts, &capacity, count + 1, sizeof *cuts);
            size_t place = count++;
            for (; place && cuts[place - 1] > share; place--)
                cuts[place] = cuts[place - 1];
            cuts[place] = share;
        }
    size_t last = node_at(graph, a);
    for (size_t i = 0; i <= count; i++) {
        size_t next = node_at(graph, i < count ? vec2_along(a, cuts[i], vec2_sub(b, a)) : b);
        if (next != last)
            add_edge(graph, last, next);
        last = next;
    }
    memory_free(cuts);
}

static size_t degree(const Graph *graph, size_t node) {
    size_t count = 0;
    for (size_t i = 0; i < graph->edge_count; i++)
        count += graph->edges[i].from == node || graph->edges[i].to == node;
    return count;
}

static void cut_loose_ends(Graph *graph) {
    for (size_t i = 0; i < graph->edge_count;) {
        if (degree(graph, graph->edges[i].from) > 1 && degree(graph, graph->edges[i].to) > 1) {
            i++;
            continue;
        }
        graph->edges[i] = graph->edges[--graph->edge_count];
        i = 0;
    }
}

/* Returns the neighbour of `at` that follows clockwise after the one it was reached from. */
static size_t next_node(const Graph *graph, size_t from, size_t at) {
    Vec2 back = vec2_sub(graph->nodes[from], graph->nodes[at]);
    double least = HUGE_VAL;
    size_t next = from;
    for (size_t i = 0; i < graph->edge_count; i++) {
        const Edge *edge = &graph->edges[i];
        if ((edge->from != at && edge->to != at) || edge->from == from || edge->to == from)
            continue;
        size_t other = edge->from == at ? edge->to : edge->from;
        Vec2 way = vec2_sub(graph->nodes[other], graph->nodes[at]);
        double turn = -atan2(vec2_cross(back, way), vec2_dot(back, way)); /* clockwise from the way back */
        turn += turn <= 0 ? 2 * M_PI : 0;
        if (turn < least) {
            least = turn;
            next = other;
        }
    }
    return next;
}

/* Follows the face to the left of an edge. Returns its number of points; 0: too many. */
static size_t follow(const Graph *graph, Edge edge, Vec2 *points, size_t most, double *area) {
    size_t from = edge.from, at = edge.to, count = 0;
    *area = 0;
    do {
        if (count == most)
            return 0;
        points[count++] = graph->nodes[from];
        *area += vec2_cross(graph->nodes[from], graph->nodes[at]) / 2;
        size_t next = next_node(graph, from, at);
        from = at;
        at = next;
    } while (from != edge.from || at != edge.to);
    return count;
}

/* Removes points between two segments of one direction. */
static size_t simplify(Vec2 *points, size_t count) {
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        Vec2 before = kept ? points[kept - 1] : points[count - 1], after = points[(i + 1) % count];
        Vec2 to = vec2_unit(vec2_sub(points[i], before)), on = vec2_unit(vec2_sub(after, points[i]));
        if (fabs(vec2_cross(to, on)) > 1e-6)
            points[kept++] = points[i];
    }
    return kept;
}

/* Finds the first edge beyond `beyond` that a ray to the right meets, with the place to its left. */
static bool first_edge(const Graph *graph, Vec2 at, double *beyond, Edge *found) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < graph->edge_count; i++) {
        Vec2 a = graph->nodes[graph->edges[i].from], b = graph->nodes[graph->edges[i].to];
        if ((a.y > at.y) == (b.y > at.y))
            continue;
        double x = a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x <= *beyond || x >= least)
            continue;
        least = x;
        *found = b.y > a.y ? graph->edges[i] : (Edge){graph->edges[i].to, graph->edges[i].from};
    }
    *beyond = least;
    return least < HUGE_VAL;
}

size_t enclosure_find(const Plan *plan, Vec2 at, Vec2 *points, size_t most) {
    Graph graph = {.nodes = NULL};
    Edge edge;
    double beyond = at.x, area = 0;
    size_t count = 0;
    for (size_t w = 0; w < plan->wall_count; w++)
        for (size_t s = 0; s + 1 < plan->walls[w].points.count; s++)
            add_segment(&graph, plan, plan->walls[w].points.at[s], plan->walls[w].points.at[s + 1]);
    cut_loose_ends(&graph);
    while (!count && first_edge(&graph, at, &beyond, &edge)) {
        count = follow(&graph, edge, points, most, &area);
        count = area > 0 ? count : 0;
    }
    memory_free(graph.nodes);
    memory_free(graph.edges);
    return simplify(points, count);
}
