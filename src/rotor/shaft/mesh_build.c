// Adds the mesh of shafts to an assembly: inertia at nodes, then stiffness, coupling mass, gyroscopic moments and
// damping of the pieces between them.
#include <math.h>

#include "mesh.h"

/// Sets the speed of a station by its shaft.
static void mesh_turn_station(const mesh *from, size_t shaft, assembly_station *at) {
    at->ratio = from->shafts[shaft].ratio;
    at->spool = from->shafts[shaft].spool;
    at->carrier = shaft + 1;
}

void mesh_turn(const mesh *from, assembly *to) {
    for (size_t i = 0; i < from->node_count; i++)
        mesh_turn_station(from, from->nodes[i].shaft, &to->stations[from->nodes[i].station]);
    // Stations of shafts without segments have only the speed of their shaft.
    for (size_t s = 0; s < to->station_count - from->hidden; s++) {
        if (from->lumped[s] == NO_SHAFT) continue;
        to->stations[s].lumped = true;
        mesh_turn_station(from, from->lumped[s], &to->stations[s]);
    }
}

void mesh_inertia(const mesh *from, assembly *to) {
    // Set the positions of stations on shafts.
    for (size_t i = 0; i < from->node_count; i++) {
        assembly_station *at = &to->stations[from->nodes[i].station];
        at->shaft = from->nodes[i].shaft;
        at->position = from->nodes[i].z;
        at->hidden = !at->name;
        at->twists = at->twists || from->shafts[at->shaft].twists;
        at->axial = at->axial || from->shafts[at->shaft].axial;
    }
    // Add the inertia of pieces at both ends.
    for (size_t i = 0; i < from->piece_count; i++) {
        piece_matrices matrices;
        piece_fill(&from->pieces[i].piece, &matrices);
        const bool lumped = from->shafts[from->pieces[i].shaft].lumped;
        for (size_t end = 0; end < 2; end++) {
            assembly_station *at = &to->stations[from->nodes[from->pieces[i].node[end]].station];
            const double mass = lumped ? matrices.lumped_mass[end] : matrices.weight[2 * end];
            at->mass += mass;
            at->diametral += matrices.lumped_diametral[end];
            at->pull_moment += lumped ? 0.0 : matrices.weight[2 * end + 1];
            const double polar = matrices.twist.inertia[2 * end] + matrices.twist.inertia[1];
            at->turned_polar += polar;
            if (from->shafts[from->pieces[i].shaft].twists) at->shaft_polar += polar;
            if (!from->shafts[from->pieces[i].shaft].axial) continue;
            at->shaft_mass += mass;
            at->shaft_axial += matrices.stretch.inertia[2 * end] + matrices.stretch.inertia[1];
        }
    }
}

/// A piece that is being added to the assembly, and its coordinates in both planes.
typedef struct laying {
    const shaft_settings *shaft;
    assembly *to;
    size_t at[2][4]; ///< coordinates along x and tilt_x of both ends; along y and tilt_y
} laying;

/// Adds -factor times a matrix: forces in plane `row` by displacements or velocities in plane `column`.
static void add_block(const laying *l, body_kind kind, size_t row, size_t column, double factor,
                      const matrix4 *matrix) {
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++)
            body_add(&l->to->body, l->at[row][i], l->at[column][j], kind, -factor * matrix->at[i][j]);
}

static void add_both(const laying *l, body_source of, body_rate rate, double factor, const matrix4 *matrix) {
    for (size_t plane = 0; plane < 2; plane++)
        add_block(l, (body_kind){of, rate, BODY_STEADY}, plane, plane, factor, matrix);
}

/// Adds forces in each plane by the other plane, with opposite signs: they drive forward whirl.
static void add_across(const laying *l, body_source of, body_rate rate, double factor, const matrix4 *matrix) {
    const body_kind kind = {of, rate, BODY_STEADY};
    add_block(l, kind, 0, 1, factor, matrix);
    add_block(l, kind, 1, 0, -factor, matrix);
}

/// Adds forces across the planes in proportion to the speed of a shaft whose speed is its own: factor times 1 rad/s.
static void add_across_own(const laying *l, body_source of, body_rate rate, double factor, const matrix4 *matrix) {
    const int value = assembly_spool_value(l->to, l->shaft->spool, &factor);
    add_block(l, (body_kind){of, rate, value}, 0, 1, factor, matrix);
    add_block(l, (body_kind){of, rate, value}, 1, 0, -factor, matrix);
}

/// Adds internal damping (Zorzi, Nelson 1977, eqs. 14 and 15): viscous F = -eta_V K (q' - i ratio Omega q), and
/// hysteretic F = -((1 + eta_H) q - i eta_H q)/sqrt(1 + eta_H^2) K, q = x + i y.
static void add_internal(const laying *l, const matrix4 *stiffness) {
    const shaft_settings *shaft = l->shaft;
    const double loss = shaft->hysteretic / sqrt(1.0 + shaft->hysteretic * shaft->hysteretic);
    add_both(l, BODY_VELOCITY, RATE_DAMPING, shaft->viscous, stiffness);
    if (shaft->spool)
        add_across_own(l, BODY_PLACE, RATE_STATIC, shaft->viscous, stiffness);
    else
        add_across(l, BODY_PLACE, RATE_FOLLOWING, shaft->viscous * shaft->ratio, stiffness);
    add_across(l, BODY_PLACE, RATE_STATIC, shaft->ratio * l->to->turn < 0.0 ? -loss : loss, stiffness);
}

static void average(const matrix4 *one, const matrix4 *other, double sign, matrix4 *out) {
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++) out->at[i][j] = 0.5 * (one->at[i][j] + sign * other->at[i][j]);
}

/// Adds half the difference of both principal stiffnesses, which acts at twice the shaft's angle. The normal of the
/// flats, along which the shaft is softer, is at angle + tau.
static void add_unequal(const laying *l, double angle, const matrix4 *difference) {
    const double c = -cos(2.0 * angle), s = -sin(2.0 * angle); // minus: the direction is the softer one
    const body_kind cosine = {BODY_PLACE, RATE_STATIC, COS_2TAU}, sine = {BODY_PLACE, RATE_STATIC, SIN_2TAU};
    for (size_t plane = 0; plane < 2; plane++) {
        const double sign = plane == 0 ? 1.0 : -1.0;
        add_block(l, cosine, plane, plane, sign * c, difference);
        add_block(l, sine, plane, plane, -sign * s, difference);
        add_block(l, sine, plane, 1 - plane, c, difference);
        add_block(l, cosine, plane, 1 - plane, s, difference);
    }
}

static void add_stiffness(const laying *l, const mesh_piece *own, const piece_matrices *matrices) {
    matrix4 mean, difference;
    const double eta = l->shaft->hysteretic;
    average(&matrices->stiffness[0], &matrices->stiffness[1], 1.0, &mean);
    add_both(l, BODY_PLACE, RATE_STATIC, (1.0 + eta) / sqrt(1.0 + eta * eta), &mean);
    add_both(l, BODY_PLACE, RATE_STATIC, 1.0, &matrices->axial);
    add_both(l, BODY_VELOCITY, RATE_DAMPING, l->shaft->beta, &mean);
    add_internal(l, &mean);
    if (own->piece.flats == 0.0) return;
    average(&matrices->stiffness[0], &matrices->stiffness[1], -1.0, &difference);
    add_unequal(l, own->angle, &difference);
}

/// Adds the mass matrix without the inertia at the nodes, damping proportional to it, and gyroscopic moments.
static void add_mass(const laying *l, const piece_matrices *matrices) {
    matrix4 mass = {{{0.0}}}, polar = {{{0.0}}};
    const bool lumped = l->shaft->lumped;
    double own[4];
    for (size_t end = 0; end < 2; end++) {
        own[2 * end] = lumped ? matrices->lumped_mass[end] : matrices->weight[2 * end];
        own[2 * end + 1] = matrices->lumped_diametral[end];
        mass.at[2 * end][2 * end] = own[2 * end];
        mass.at[2 * end + 1][2 * end + 1] = own[2 * end + 1];
        polar.at[2 * end + 1][2 * end + 1] = matrices->lumped_polar[end];
    }
    if (!lumped) {
        mass = matrices->mass;
        polar = matrices->polar;
    }
    for (size_t plane = 0; plane < 2 && !lumped; plane++)
        for (size_t i = 0; i < 4; i++)
            for (size_t j = i; j < 4; j++)
                assembly_inertance(l->to, l->at[plane][i], l->at[plane][j], mass.at[i][j] - (i == j ? own[i] : 0.0));
    add_both(l, BODY_VELOCITY, RATE_DAMPING, l->shaft->alpha, &mass);
    // Gyroscopic moments: I_d phi'' - i I_p Omega phi' = M, phi = tilt_x + i tilt_y.
    if (l->shaft->gyroscopic && l->shaft->spool) add_across_own(l, BODY_VELOCITY, RATE_DAMPING, 1.0, &polar);
    if (l->shaft->gyroscopic && !l->shaft->spool) add_across(l, BODY_VELOCITY, RATE_GYRO, l->shaft->ratio, &polar);
}

/// Adds stiffness, damping and the coupling part of the inertia against twist or along the axis. The damping
/// proportional to the inertia acts between both ends and the ground and, where the inertia couples the ends, between
/// them. modulus: as in joining.
static void add_line(const mesh_piece *own, axis along, const line_matrices *matrices, double modulus, const mesh *from,
                     assembly *to) {
    const double stiffness = matrices->stiffness, coupled = matrices->inertia[1];
    const shaft_settings *shaft = &own->settings;
    const joining between = {.stiffness = stiffness,
                             .modulus = modulus,
                             .damping = (shaft->beta + shaft->viscous) * stiffness - shaft->alpha * coupled,
                             .inertance = shaft->lumped ? 0.0 : 0.0 - coupled};
    size_t station[2];
    for (size_t end = 0; end < 2; end++) {
        const joining to_ground = {.damping = shaft->alpha * (matrices->inertia[2 * end] + coupled)};
        station[end] = from->nodes[own->node[end]].station;
        assembly_link(to, along, station[end], NO_STATION, &to_ground);
    }
    assembly_link(to, along, station[0], station[1], &between);
}

/// Returns the section modulus of the weaker end of a piece, m3 (twist_link).
static double weakest_modulus(const shaft_piece *piece) {
    const double *outer = piece->outer, *inner = piece->inner;
    return fmin(joining_modulus(outer[0], inner[0]), joining_modulus(outer[1], inner[1]));
}

void mesh_build(const mesh *from, assembly *to) {
    for (size_t i = 0; i < from->piece_count; i++) {
        const mesh_piece *own = &from->pieces[i];
        piece_matrices matrices;
        laying l = {.shaft = &own->settings, .to = to};
        for (size_t end = 0; end < 2; end++) {
            const size_t *coordinate = to->stations[from->nodes[own->node[end]].station].coordinate;
            l.at[0][2 * end] = coordinate[AXIS_X];
            l.at[0][2 * end + 1] = coordinate[AXIS_TILT_X];
            l.at[1][2 * end] = coordinate[AXIS_Y];
            l.at[1][2 * end + 1] = coordinate[AXIS_TILT_Y];
        }
        piece_fill(&own->piece, &matrices);
        add_stiffness(&l, own, &matrices);
        add_mass(&l, &matrices);
        if (from->shafts[own->shaft].twists)
            add_line(own, AXIS_TWIST, &matrices.twist, weakest_modulus(&own->piece), from, to);
        if (from->shafts[own->shaft].axial) add_line(own, AXIS_AXIAL, &matrices.stretch, 0.0, from, to);
    }
}
