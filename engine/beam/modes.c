#include "beam/modes.h"

#include <assert.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"

/* a squared frequency below this fraction of the largest is a rigid-body mode. */
static const double RIGID = 1e-13;

/* Solves K x = lambda M x of `size`: ascending values, M-orthonormal vectors in place of K; M is destroyed. */
static bool solve_modes(double *stiffness, double *mass, double *values, size_t size) {
    lapack_int n = (lapack_int)size;
    return n == 0 || LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'U', n, stiffness, n, mass, n, values) == 0;
}

/* Returns the boundary freedoms, then the others. */
static size_t *order_freedoms(const ElementMesh *mesh, const size_t *boundary, size_t boundary_count) {
    size_t *order = memory_zeroed(mesh->freedoms, sizeof *order), at = boundary_count;
    for (size_t b = 0; b < boundary_count; b++)
        order[b] = boundary[b];
    for (size_t f = 0; f < mesh->freedoms; f++) {
        bool is_boundary = false;
        for (size_t b = 0; b < boundary_count; b++)
            is_boundary |= boundary[b] == f;
        if (!is_boundary)
            order[at++] = f;
    }
    assert(at == mesh->freedoms); /* each boundary freedom is named once */
    return order;
}

/* Returns the block of a matrix of size `all` that starts at `row` and `column` of the ordered freedoms. */
static double *take_block(const double *matrix, size_t all, const size_t *order, size_t row, size_t rows, size_t column,
                          size_t columns) {
    double *block = memory_zeroed(rows * columns + 1, sizeof *block);
    for (size_t c = 0; c < columns; c++)
        for (size_t r = 0; r < rows; r++)
            block[c * rows + r] = matrix[order[column + c] * all + order[row + r]];
    return block;
}

/* Returns the Craig-Bampton basis (freedoms x reduced, one shape after another): constraint modes, then fixed-
 * interface modes. */
static double *make_basis(const ElementMesh *mesh, const size_t *order, size_t outer, size_t fixed, bool *good) {
    size_t all = mesh->freedoms, inner = all - outer, reduced = outer + fixed;
    double *basis = memory_zeroed(all * reduced, sizeof *basis);
    double *stiffness = take_block(mesh->stiffness, all, order, outer, inner, outer, inner);
    double *mass = take_block(mesh->mass, all, order, outer, inner, outer, inner);
    double *static_shapes = take_block(mesh->stiffness, all, order, outer, inner, 0, outer);
    double *factor = take_block(mesh->stiffness, all, order, outer, inner, outer, inner);
    double *values = memory_zeroed(inner + 1, sizeof *values);
    lapack_int n = (lapack_int)inner;
    *good = (n == 0 || outer == 0 ||
             LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', n, (lapack_int)outer, factor, n, static_shapes, n) == 0) &&
            solve_modes(stiffness, mass, values, inner);
    for (size_t c = 0; c < reduced; c++) {
        const double *from = c < outer ? static_shapes + c * inner : stiffness + (c - outer) * inner;
        double sign = c < outer ? -1 : 1;
        for (size_t i = 0; i < inner; i++)
            basis[c * all + order[outer + i]] = sign * from[i];
        if (c < outer)
            basis[c * all + order[c]] = 1;
    }
    memory_free(stiffness);
    memory_free(mass);
    memory_free(static_shapes);
    memory_free(factor);
    memory_free(values);
    return basis;
}

/* Returns basis^T matrix basis, (columns x columns). */
static double *project(const double *matrix, size_t all, const double *basis, size_t columns) {
    double *product = memory_zeroed(all * columns, sizeof *product);
    double *projected = memory_zeroed(columns * columns, sizeof *projected);
    for (size_t c = 0; c < columns; c++)
        for (size_t k = 0; k < all; k++)
            for (size_t r = 0; r < all; r++)
                product[c * all + r] += matrix[k * all + r] * basis[c * all + k];
    for (size_t c = 0; c < columns; c++)
        for (size_t r = 0; r < columns; r++)
            for (size_t k = 0; k < all; k++)
                projected[c * columns + r] += basis[r * all + k] * product[c * all + k];
    memory_free(product);
    return projected;
}

/* Stores the lowest modes as shapes of the mesh: the basis times the reduced vectors. */
static void keep_modes(Modes *modes, const double *basis, const double *vectors, const double *values, size_t reduced) {
    for (size_t i = 0; i < modes->count; i++) {
        modes->frequency[i] = sqrt(fmax(0, values[i] > RIGID * values[reduced - 1] ? values[i] : 0));
        for (size_t c = 0; c < reduced; c++)
            for (size_t f = 0; f < modes->freedoms; f++)
                modes->shape[i * modes->freedoms + f] += basis[c * modes->freedoms + f] * vectors[i * reduced + c];
    }
}

bool modes_reduce(Modes *modes, const ElementMesh *mesh, const size_t *boundary, size_t boundary_count, size_t fixed,
                  size_t count) {
    size_t all = mesh->freedoms, inner = all - boundary_count;
    fixed = fixed < inner ? fixed : inner;
    size_t reduced = boundary_count + fixed;
    *modes = (Modes){.count = count < reduced ? count : reduced, .freedoms = all};
    modes->place = memory_zeroed(mesh->nodes, sizeof(double));
    memcpy(modes->place, mesh->place, mesh->nodes * sizeof(double));
    modes->frequency = memory_zeroed(modes->count, sizeof(double));
    modes->shape = memory_zeroed(modes->count * all, sizeof(double));
    modes->tip = memory_zeroed(modes->count, sizeof(double));
    modes->shaker = memory_zeroed(modes->count, sizeof(double));
    bool good;
    size_t *order = order_freedoms(mesh, boundary, boundary_count);
    double *basis = make_basis(mesh, order, boundary_count, fixed, &good);
    double *stiffness = project(mesh->stiffness, all, basis, reduced);
    double *mass = project(mesh->mass, all, basis, reduced);
    double *values = memory_zeroed(reduced, sizeof *values);
    good = good && solve_modes(stiffness, mass, values, reduced);
    if (good)
        keep_modes(modes, basis, stiffness, values, reduced);
    modes->damping = project(mesh->damping, all, modes->shape, modes->count);
    memory_free(order);
    memory_free(basis);
    memory_free(stiffness);
    memory_free(mass);
    memory_free(values);
    if (!good)
        modes_clear(modes);
    return good;
}

/* Returns the deflection of a freedom under a unit force, m/N; 0 if the mesh is not supported. */
static double static_compliance(const ElementMesh *mesh, size_t freedom) {
    lapack_int n = (lapack_int)mesh->freedoms;
    double *factor = memory_zeroed(mesh->freedoms * mesh->freedoms, sizeof *factor);
    double *moved = memory_zeroed(mesh->freedoms, sizeof *moved);
    memcpy(factor, mesh->stiffness, mesh->freedoms * mesh->freedoms * sizeof *factor);
    moved[freedom] = 1;
    bool good = LAPACKE_dposv(LAPACK_COL_MAJOR, 'U', n, 1, factor, n, moved, n) == 0;
    double compliance = good ? moved[freedom] : 0;
    memory_free(factor);
    memory_free(moved);
    return compliance;
}

static void mesh_of_beam(ElementMesh *mesh, const Beam *beam) {
    double area = beam->width * beam->thickness;
    double second_moment = area * beam->thickness * beam->thickness / 12;
    element_build(mesh, beam->length, beam->youngs_modulus * second_moment, beam->density * area,
                  (size_t)beam->elements, (double[]){beam->pivot_position, beam->shaker_position}, 2);
    size_t pivot = element_deflection(mesh, beam->pivot_position);
    size_t shaker = element_deflection(mesh, beam->shaker_position);
    element_add_spring(mesh, pivot, beam->pivot_stiffness);
    element_add_spring(mesh, pivot + 1, beam->pivot_rotational);
    element_add_spring(mesh, shaker, beam->shaker_stiffness);
    element_add_dashpot(mesh, shaker, beam->shaker_damping);
    element_add_mass(mesh, shaker, beam->shaker_mass);
    element_add_mass(mesh, mesh->freedoms - 2, beam->tip_mass);
}

bool modes_of_beam(Modes *modes, const Beam *beam) {
    ElementMesh mesh;
    mesh_of_beam(&mesh, beam);
    size_t pivot = element_deflection(&mesh, beam->pivot_position);
    size_t shaker = element_deflection(&mesh, beam->shaker_position), tip = mesh.freedoms - 2;
    size_t boundary[4] = {tip, pivot + 1}, boundary_count = 2, kept = (size_t)beam->modes;
    if (pivot != tip)
        boundary[boundary_count++] = pivot;
    if (shaker != tip && shaker != pivot)
        boundary[boundary_count++] = shaker;
    bool good = modes_reduce(modes, &mesh, boundary, boundary_count, kept, kept);
    if (good) {
        modes->tip_compliance = modes->residual = static_compliance(&mesh, tip);
        for (size_t i = 0; i < modes->count; i++) {
            modes->tip[i] = modes->shape[i * mesh.freedoms + tip];
            modes->shaker[i] = modes->shape[i * mesh.freedoms + shaker];
            modes->damping[i * modes->count + i] += 2 * beam->damping_ratio * modes->frequency[i];
            modes->residual -= modes->tip[i] * modes->tip[i] / (modes->frequency[i] * modes->frequency[i]);
        }
    }
    element_clear(&mesh);
    bool held = good && modes->frequency[0] > 0 && modes->tip_compliance > 0;
    if (good && !held)
        modes_clear(modes);
    return held;
}

void modes_align(Modes *modes, const Modes *like) {
    size_t count = modes->count;
    for (size_t i = 0; i < count && i < like->count; i++) {
        if ((modes->tip[i] < 0) == (like->tip[i] < 0))
            continue;
        modes->tip[i] = -modes->tip[i];
        modes->shaker[i] = -modes->shaker[i];
        for (size_t k = 0; k < modes->freedoms; k++)
            modes->shape[i * modes->freedoms + k] *= -1;
        for (size_t k = 0; k < count; k++) { /* the diagonal twice, which changes nothing */
            modes->damping[i * count + k] *= -1;
            modes->damping[k * count + i] *= -1;
        }
    }
}

void modes_clear(Modes *modes) {
    memory_free(modes->place);
    memory_free(modes->frequency);
    memory_free(modes->shape);
    memory_free(modes->damping);
    memory_free(modes->tip);
    memory_free(modes->shaker);
    *modes = (Modes){0};
}
