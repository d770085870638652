#include "beam/element.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/order.h"

/* Stations closer than this fraction of the length coincide. */
static const double SAME_STATION = 1e-9;

/* Sorts both ends and the stations, removes duplicates, and returns the number. */
static size_t sort_stations(double *sorted, double length, const double *stations, size_t count) {
    for (size_t i = 0; i < count; i++)
        sorted[i] = stations[i];
    sorted[count] = 0;
    sorted[count + 1] = length;
    qsort(sorted, count + 2, sizeof *sorted, order_rising);
    size_t kept = 1;
    for (size_t i = 1; i < count + 2; i++)
        if (sorted[i] - sorted[kept - 1] > SAME_STATION * length)
            sorted[kept++] = sorted[i];
    return kept;
}

/* Adds `factor` times the 4 x 4 matrix of the element between nodes i and i + 1. */
static void add_element(double *matrix, size_t freedoms, size_t i, const double element[4][4], double factor) {
    for (size_t row = 0; row < 4; row++)
        for (size_t column = 0; column < 4; column++)
            matrix[(2 * i + column) * freedoms + 2 * i + row] += factor * element[row][column];
}

static void assemble(ElementMesh *mesh, double bending_stiffness, double mass_per_length) {
    for (size_t i = 0; i + 1 < mesh->nodes; i++) {
        double l = mesh->place[i + 1] - mesh->place[i], ll = l * l;
        const double stiffness[4][4] = {{12, 6 * l, -12, 6 * l},
                                        {6 * l, 4 * ll, -6 * l, 2 * ll},
                                        {-12, -6 * l, 12, -6 * l},
                                        {6 * l, 2 * ll, -6 * l, 4 * ll}};
        const double mass[4][4] = {{156, 22 * l, 54, -13 * l},
                                   {22 * l, 4 * ll, 13 * l, -3 * ll},
                                   {54, 13 * l, 156, -22 * l},
                                   {-13 * l, -3 * ll, -22 * l, 4 * ll}};
        add_element(mesh->stiffness, mesh->freedoms, i, stiffness, bending_stiffness / (l * ll));
        add_element(mesh->mass, mesh->freedoms, i, mass, mass_per_length * l / 420);
    }
}

void element_build(ElementMesh *mesh, double length, double bending_stiffness, double mass_per_length, size_t elements,
                   const double *stations, size_t station_count) {
    assert(elements > 0);
    double *ends = memory_zeroed(station_count + 2, sizeof *ends);
    size_t parts = sort_stations(ends, length, stations, station_count) - 1;
    mesh->place = memory_zeroed(elements + parts + 1, sizeof *mesh->place);
    mesh->nodes = 0;
    for (size_t p = 0; p < parts; p++) {
        double size = ends[p + 1] - ends[p];
        size_t pieces = (size_t)fmax(1, ceil((double)elements * size / length - SAME_STATION * (double)elements));
        for (size_t i = 0; i < pieces; i++)
            mesh->place[mesh->nodes++] = ends[p] + size * (double)i / (double)pieces;
    }
    mesh->place[mesh->nodes++] = length;
    memory_free(ends);
    size_t freedoms = mesh->freedoms = 2 * mesh->nodes;
    mesh->mass = memory_zeroed(freedoms * freedoms, sizeof(double));
    mesh->stiffness = memory_zeroed(freedoms * freedoms, sizeof(double));
    mesh->damping = memory_zeroed(freedoms * freedoms, sizeof(double));
    assemble(mesh, bending_stiffness, mass_per_length);
}

void element_clear(ElementMesh *mesh) {
    memory_free(mesh->place);
    memory_free(mesh->mass);
    memory_free(mesh->stiffness);
    memory_free(mesh->damping);
    *mesh = (ElementMesh){0};
}

size_t element_deflection(const ElementMesh *mesh, double place) {
    size_t nearest = 0;
    for (size_t i = 1; i < mesh->nodes; i++)
        if (fabs(mesh->place[i] - place) < fabs(mesh->place[nearest] - place))
            nearest = i;
    return 2 * nearest;
}

void element_add_mass(ElementMesh *mesh, size_t freedom, double mass) {
    mesh->mass[freedom * mesh->freedoms + freedom] += mass;
}

void element_add_spring(ElementMesh *mesh, size_t freedom, double stiffness) {
    mesh->stiffness[freedom * mesh->freedoms + freedom] += stiffness;
}

void element_add_dashpot(ElementMesh *mesh, size_t freedom, double damping) {
    mesh->damping[freedom * mesh->freedoms + freedom] += damping;
}
