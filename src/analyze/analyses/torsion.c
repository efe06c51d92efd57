// Steady response of stations that twist to harmonic torques: angles of stations and torques between them, for each
// frequency of the excitations and summed over all.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "whirl/engine/torsion.h"

enum {
    SPEED,
    NATURAL,
    DAMPING_RATIO,
    FIXED,
    ORDER,
    FREQUENCY,
    UNBALANCED,
    STATION_SPEED,
    ANGLE,
    LAG,
    RATE,
    ANGLE_SUM,
    TORQUE_OF,
    STEADY,
    TORQUE,
    TORQUE_LAG,
    TORQUE_SUM,
    STRESS,
    POWER,
    FIELD_COUNT
};

static size_t torsion_modes(const block_shape *shape) {
    return (size_t)shape->options->modes;
}
static size_t torsion_excitations(const block_shape *shape) {
    return shape->excitation_count;
}
static size_t torsion_paths(const block_shape *shape) {
    return shape->path_count;
}
static size_t torsion_paths_and_excitations(const block_shape *shape) {
    return shape->path_count * shape->excitation_count;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_TORSION_SPEED, "rad/s", "speed of the shaft", WHIRL_PER_POINT, 1, NULL},
    [NATURAL] = {WHIRL_FIELD_TORSION_NATURAL, "rad/s", "damped natural frequencies of torsional modes, rising",
                 WHIRL_PER_POINT, 1, torsion_modes},
    [DAMPING_RATIO] = {WHIRL_FIELD_TORSION_DAMPING_RATIO, "1", "damping ratios of these modes", WHIRL_PER_POINT, 1,
                       torsion_modes},
    [FIXED] = {WHIRL_FIELD_TORSION_FIXED, "1", "1: the frequency of the excitation does not depend on the speed",
               WHIRL_PER_POINT, 1, torsion_excitations},
    [ORDER] = {WHIRL_FIELD_TORSION_ORDER, "order", "frequency of the excitation over the speed of the shaft",
               WHIRL_PER_POINT, 1, torsion_excitations},
    [FREQUENCY] = {WHIRL_FIELD_TORSION_FREQUENCY, "rad/s", "frequency of the excitation", WHIRL_PER_POINT, 1,
                   torsion_excitations},
    [UNBALANCED] = {WHIRL_FIELD_TORSION_UNBALANCED, "N m",
                    "steady torque that nothing takes up, referred to the speed of the shaft; 0: torques balance",
                    WHIRL_PER_POINT, 1, NULL},
    [STATION_SPEED] = {WHIRL_FIELD_TORSION_STATION_SPEED, "rad/s", "speed of the station, by its gears",
                       WHIRL_PER_STATION, 1, NULL},
    [ANGLE] = {WHIRL_FIELD_TORSION_ANGLE, "rad",
               "amplitude (zero to peak) of the twist by each excitation (missing at stations that do not twist)",
               WHIRL_PER_STATION, 1, torsion_excitations},
    [LAG] = {WHIRL_FIELD_TORSION_LAG, "deg",
             "angle by which the peak of the twist comes after phase 0 of the excitation", WHIRL_PER_STATION, 1,
             torsion_excitations},
    [RATE] = {WHIRL_FIELD_TORSION_RATE, "rad/s", "amplitude (zero to peak) of the angular velocity by each excitation",
              WHIRL_PER_STATION, 1, torsion_excitations},
    [ANGLE_SUM] = {WHIRL_FIELD_TORSION_ANGLE_SUM, "rad", "sum of the amplitudes of all excitations: the worst case",
                   WHIRL_PER_STATION, 1, NULL},
    [TORQUE_OF] = {WHIRL_FIELD_TORSION_TORQUE_OF, "1",
                   "kind, first, second (0 of a shaft, coupling or spring between two stations, 5 of a mesh, 6 of a "
                   "rigid gear, 7 of a spring with play; indices of stations from 0, -1: between stations, or the "
                   "ground)",
                   WHIRL_PER_POINT, 3, torsion_paths},
    [STEADY] =
        {WHIRL_FIELD_TORSION_STEADY, "N m",
         "steady torque, positive where the first station drives the second (missing where steady torques do not "
         "balance)",
         WHIRL_PER_POINT, 1, torsion_paths},
    [TORQUE] = {WHIRL_FIELD_TORSION_TORQUE, "N m",
                "amplitude (zero to peak) by each excitation: all excitations of the first torque, then of the next",
                WHIRL_PER_POINT, 1, torsion_paths_and_excitations},
    [TORQUE_LAG] = {WHIRL_FIELD_TORSION_TORQUE_LAG, "deg",
                    "angle by which the peak of the torque comes after phase 0 of the excitation", WHIRL_PER_POINT, 1,
                    torsion_paths_and_excitations},
    [TORQUE_SUM] = {WHIRL_FIELD_TORSION_TORQUE_SUM, "N m", "sum of the amplitudes of all excitations: the worst case",
                    WHIRL_PER_POINT, 1, torsion_paths},
    [STRESS] = {WHIRL_FIELD_TORSION_STRESS, "Pa",
                "shear stress by that sum in the weakest section (missing where its diameter is not known)",
                WHIRL_PER_POINT, 1, torsion_paths},
    [POWER] = {WHIRL_FIELD_TORSION_POWER, "W", "power taken by the damping of the shaft, coupling or mesh, on average",
               WHIRL_PER_POINT, 1, torsion_paths},
};

static const double degree = 3.14159265358979323846 / 180.0;

/// Returns the degrees by which the peak of Re(z exp(i w t)) comes after t = 0.
static double torsion_lag(const double z[2]) {
    return z[0] != 0.0 || z[1] != 0.0 ? fmod(360.0 - atan2(z[1], z[0]) / degree, 360.0) : (double)NAN;
}

static whirl_status torsion_fill_modes(const whirl_resting *point, const whirl_record_options *options,
                                       const block_view *view) {
    whirl_modes *modes = NULL;
    const whirl_status status = whirl_modes_new(point->system, point->start, &modes);
    if (status.code != WHIRL_OK) return status;
    size_t row = 0;
    for (size_t i = 0; i < modes->count && row < (size_t)options->modes; i++) {
        const whirl_mode *mode = &modes->modes[i];
        if (whirl_mode_kind_of(mode->torsion, mode->axial) != WHIRL_TORSIONAL_MODE || whirl_mode_is_overdamped(mode))
            continue;
        view_numbers(view, NATURAL, 0)[row] = point->clock * mode->imaginary;
        view_numbers(view, DAMPING_RATIO, 0)[row++] = -mode->real / hypot(mode->real, mode->imaginary);
    }
    whirl_modes_free(modes);
    return whirl_ok();
}

static void torsion_fill_machine(const whirl_resting *point, const block_view *view) {
    const whirl_torsion *torsion = point->system->torsion;
    const void *model = point->system->model;
    for (size_t p = 0; p < point->system->probe_count; p++)
        *view_numbers(view, STATION_SPEED, p) = torsion->speed(model, p);
    for (size_t k = 0; k < torsion->path_count; k++) {
        whirl_torque_path path;
        torsion->path(model, k, &path);
        double *of = view_numbers(view, TORQUE_OF, 0) + 3 * k;
        of[0] = (double)path.kind;
        for (size_t end = 0; end < 2; end++)
            of[1 + end] = path.station[end] < point->system->probe_count ? (double)path.station[end] : -1.0;
    }
}

/// Fills in the steady torques, unless they do not balance. v and drive [dimension][2] are workspace.
static whirl_status torsion_fill_steady(const whirl_resting *point, const block_view *view, const double *rest,
                                        double *drive, double *v, double *turn) {
    static const double rounding = 1e-9;
    const whirl_system *system = point->system;
    const whirl_torsion *torsion = system->torsion;
    double size, power;
    const double left = torsion->unbalanced(system->model, &size);
    const bool balanced = fabs(left) <= rounding * size;
    *view_numbers(view, UNBALANCED, 0) = balanced ? 0.0 : left;
    if (!balanced) return whirl_ok();
    torsion->drive(system->model, torsion->excitation_count, drive);
    torsion->turn(system->model, turn);
    double *force = turn + system->dimension, *moved = force + system->dimension;
    for (size_t i = 0; i < system->dimension; i++) force[i] = drive[2 * i];
    const whirl_status status = whirl_static_response(system, rest, turn, force, moved);
    for (size_t i = 0; i < system->dimension; i++) v[2 * i] = moved[i], v[2 * i + 1] = 0.0;
    for (size_t k = 0; k < torsion->path_count && status.code == WHIRL_OK; k++) {
        double torque[2];
        torsion->carry(system->model, k, torsion->excitation_count, rest, v, torque, &power);
        view_numbers(view, STEADY, 0)[k] = fabs(torque[0]) > rounding * size || size == 0.0 ? torque[0] : 0.0;
    }
    return status;
}

/// Fills in the response to an excitation, v [dimension][2], and adds it to the sums.
static void torsion_fill_response(const whirl_resting *point, const block_view *view, size_t index, double frequency,
                                  const double *rest, const double *v, double *shape) {
    const whirl_system *system = point->system;
    const whirl_torsion *torsion = system->torsion;
    const size_t excitations = torsion->excitation_count;
    whirl_torque_path path;
    system->twist(system->model, v, shape);
    // Fill in the angles of stations that twist.
    for (size_t p = 0; p < system->probe_count; p++) {
        const double size = hypot(shape[2 * p], shape[2 * p + 1]);
        double *sum = view_numbers(view, ANGLE_SUM, p);
        if (!torsion->twists(system->model, p)) continue;
        view_numbers(view, ANGLE, p)[index] = size;
        view_numbers(view, LAG, p)[index] = torsion_lag(shape + 2 * p);
        view_numbers(view, RATE, p)[index] = frequency * size;
        *sum = (isnan(*sum) ? 0.0 : *sum) + size;
    }
    // Sum up the torques on the parts that carry them, and the power lost there.
    for (size_t k = 0; k < torsion->path_count; k++) {
        double torque[2], power;
        double *sum = view_numbers(view, TORQUE_SUM, 0) + k, *lost = view_numbers(view, POWER, 0) + k;
        torsion->carry(system->model, k, index, rest, v, torque, &power);
        torsion->path(system->model, k, &path);
        view_numbers(view, TORQUE, 0)[k * excitations + index] = hypot(torque[0], torque[1]);
        view_numbers(view, TORQUE_LAG, 0)[k * excitations + index] = torsion_lag(torque);
        *sum = (isnan(*sum) ? 0.0 : *sum) + hypot(torque[0], torque[1]);
        *lost = (isnan(*lost) ? 0.0 : *lost) + power;
        if (path.modulus > 0.0) view_numbers(view, STRESS, 0)[k] = *sum / path.modulus;
    }
}

static whirl_status torsion_check_system(const whirl_system *system) {
    if (!system->torsion)
        return whirl_fail(WHIRL_BAD_INPUT, "no station twists, expected stations with moves: twist or all, or shafts "
                                           "with twist: yes");
    if (system->torsion->excitation_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "nothing excites torsion, expected an element pulsation, a force with a "
                                           "torque, or a gear with an error");
    if (system->torsion->path_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "nothing joins two twists, expected a coupling, a spring, a gear or a shaft");
    return whirl_ok();
}

static whirl_status torsion_check_rest(const whirl_resting *point, const block_view *view, const double *rest) {
    const whirl_torsion *torsion = point->system->torsion;
    whirl_status status = torsion->check(point->system->model);
    if (status.code != WHIRL_OK) return status;
    if (torsion->excitation_count != view->fields[ORDER]->rows)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the torques have %zu frequencies here and %zu elsewhere, expected as many at all values of "
                          "the parameter",
                          torsion->excitation_count, view->fields[ORDER]->rows);
    const char *open = torsion->open(point->system->model, rest);
    if (open)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "the gear or spring at station '%s' rests within its play, where it carries nothing, expected "
            "steady torques that close it (force, steady_torque), or none",
            open);
    return whirl_ok();
}

static whirl_status torsion_compute(const whirl_resting *point, const whirl_record_options *options,
                                    const block_view *view) {
    const whirl_system *system = point->system;
    const whirl_torsion *torsion = system->torsion;
    const size_t d = system->dimension;
    whirl_status status = torsion_check_system(system);
    if (status.code != WHIRL_OK) return status;
    double *rest = calloc(8 * d + 2 * system->probe_count + 1, sizeof *rest);
    if (!rest) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", d);
    double *drive = rest + d, *v = drive + 2 * d, *turn = v + 2 * d, *shape = turn + 3 * d;
    // Compute the equilibrium and modes, steady torques, then the response to one excitation after another.
    memcpy(rest, point->start, d * sizeof *rest);
    status = whirl_equilibrium(system, rest);
    *view_numbers(view, SPEED, 0) = point->speed;
    if (status.code == WHIRL_OK) status = torsion_check_rest(point, view, rest);
    if (status.code == WHIRL_OK) status = torsion_fill_modes(point, options, view);
    if (status.code == WHIRL_OK) torsion_fill_machine(point, view);
    if (status.code == WHIRL_OK) status = torsion_fill_steady(point, view, rest, drive, v, turn);
    for (size_t i = 0; i < torsion->excitation_count && status.code == WHIRL_OK; i++) {
        whirl_excitation own;
        torsion->excitation(system->model, i, &own);
        view_numbers(view, FIXED, 0)[i] = own.fixed ? 1.0 : 0.0;
        view_numbers(view, ORDER, 0)[i] = own.order;
        view_numbers(view, FREQUENCY, 0)[i] = own.frequency;
        torsion->drive(system->model, i, drive);
        status = whirl_harmonic_response(system, rest, own.frequency / point->clock, drive, v);
        if (status.code == WHIRL_OK) torsion_fill_response(point, view, i, own.frequency, rest, v, shape);
    }
    free(rest);
    return status;
}

const analysis_plan torsion_analysis = {.fields = fields,
                                        .field_count = FIELD_COUNT,
                                        .check_system = torsion_check_system,
                                        .compute_resting = torsion_compute};
