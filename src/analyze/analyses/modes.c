// Modes of a machine about its equilibrium: frequencies, damping, whirl and shapes, and the critical speeds and
// thresholds between the previous point and this one.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"

enum {
    SPEED,
    FREQUENCY,
    NATURAL,
    GROWTH,
    RATIO,
    DECREMENT,
    DIRECTION,
    BEFORE,
    OVERDAMPED,
    RIGID_BODY,
    STABILITY,
    MODULO,
    KNOWN,
    SENSITIVITY,
    SENSITIVITY_FREQUENCY,
    CRITICAL,
    REST,
    SHAPE,
    TORSION,
    TWIST,
    AXIAL_SHARE,
    AXIAL,
    AXIAL_REST,
    FIELD_COUNT
};

static size_t modes_kept(const block_shape *shape) {
    return (size_t)shape->options->modes;
}

static size_t modes_that_twist(const block_shape *shape) {
    return shape->twists ? modes_kept(shape) : 0;
}

static size_t modes_along_axis(const block_shape *shape) {
    return shape->axial ? modes_kept(shape) : 0;
}

static size_t rests_along_axis(const block_shape *shape) {
    return shape->axial ? 1 : 0;
}

/// Returns the number of rows of located events: at most one crossing for each mode, and a threshold.
static size_t modes_located(const block_shape *shape) {
    return (size_t)shape->options->modes + 1;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_MODES_SPEED, "rad/s", "speed of the shaft", WHIRL_PER_POINT, 1, NULL},
    [FREQUENCY] = {WHIRL_FIELD_MODES_FREQUENCY, "rad/s", "damped natural frequency, by rising frequency",
                   WHIRL_PER_POINT, 1, modes_kept},
    [NATURAL] = {WHIRL_FIELD_MODES_NATURAL, "rad/s", "modulus of the eigenvalue", WHIRL_PER_POINT, 1, modes_kept},
    [GROWTH] = {WHIRL_FIELD_MODES_GROWTH, "1/s", "real part of the eigenvalue: below 0 the mode dies out",
                WHIRL_PER_POINT, 1, modes_kept},
    [RATIO] = {WHIRL_FIELD_MODES_DAMPING_RATIO, "1", "real part over modulus of the eigenvalue, with the other sign",
               WHIRL_PER_POINT, 1, modes_kept},
    [DECREMENT] = {WHIRL_FIELD_MODES_DECREMENT, "1", "logarithmic decrement of one turn of the mode", WHIRL_PER_POINT,
                   1, modes_kept},
    [DIRECTION] = {WHIRL_FIELD_MODES_DIRECTION, "1", "1: circles with the rotation, -1: against it, 0: neither",
                   WHIRL_PER_POINT, 1, modes_kept},
    [BEFORE] = {WHIRL_FIELD_MODES_BEFORE, "1",
                "number of the same mode at the previous value of the parameter, from 1; 0: none", WHIRL_PER_POINT, 1,
                modes_kept},
    [OVERDAMPED] = {WHIRL_FIELD_MODES_OVERDAMPED, "1/s", "eigenvalues without a frequency, largest first",
                    WHIRL_PER_POINT, 1, modes_kept},
    [RIGID_BODY] = {WHIRL_FIELD_MODES_RIGID_BODY, "1", "number of rigid-body modes, whose frequency is 0",
                    WHIRL_PER_POINT, 1, NULL},
    [STABILITY] = {WHIRL_FIELD_MODES_STABILITY, "1/s", "largest real part of all eigenvalues: stable below 0",
                   WHIRL_PER_POINT, 1, NULL},
    [MODULO] = {WHIRL_FIELD_MODES_MODULO, "rad/s",
                "frequencies are known only up to multiples of it (coefficients turn with the shaft)", WHIRL_PER_POINT,
                1, NULL},
    [KNOWN] = {WHIRL_FIELD_MODES_KNOWN, "rad/s",
               "low, high (frequencies of whirl in the tables of bearings: modes beyond are not found)",
               WHIRL_PER_POINT, 2, NULL},
    [SENSITIVITY] = {WHIRL_FIELD_MODES_SENSITIVITY, "1",
                     "largest modulus of the sensitivity of control loops (ISO 14839-3); missing without a loop",
                     WHIRL_PER_POINT, 1, NULL},
    [SENSITIVITY_FREQUENCY] = {WHIRL_FIELD_MODES_SENSITIVITY_FREQUENCY, "rad/s",
                               "frequency at which the sensitivity is largest", WHIRL_PER_POINT, 1, NULL},
    [CRITICAL] = {WHIRL_FIELD_MODES_CRITICAL, "1", "kind, value, speed, frequency, damping, direction", WHIRL_PER_POINT,
                  6, modes_located},
    [REST] = {WHIRL_FIELD_MODES_REST, "length", "x, y (from the centre)", WHIRL_PER_STATION, 2, NULL},
    [SHAPE] =
        {WHIRL_FIELD_MODES_SHAPE, "1",
         "x_cos, x_sin, y_cos, y_sin (relative: the largest amplitude is 1; missing where the mode moves no station)",
         WHIRL_PER_STATION, 4, modes_kept},
    [TORSION] = {WHIRL_FIELD_MODES_TORSION, "1",
                 "share of twists in the kinetic energy, masses lumped: 1 for a torsional mode", WHIRL_PER_POINT, 1,
                 modes_that_twist},
    [TWIST] = {WHIRL_FIELD_MODES_TWIST, "1",
               "cos, sin (twist, relative: the largest amplitude is 1; missing where the mode twists no station)",
               WHIRL_PER_STATION, 2, modes_that_twist},
    [AXIAL_SHARE] = {WHIRL_FIELD_MODES_AXIAL_SHARE, "1",
                     "share of axial displacements in the kinetic energy, masses lumped: 1 for an axial mode",
                     WHIRL_PER_POINT, 1, modes_along_axis},
    [AXIAL] = {WHIRL_FIELD_MODES_AXIAL, "1",
               "cos, sin (axial displacement, relative: the largest amplitude is 1; missing where the mode moves no "
               "station along its shaft)",
               WHIRL_PER_STATION, 2, modes_along_axis},
    [AXIAL_REST] = {WHIRL_FIELD_MODES_AXIAL_REST, "m",
                    "axial displacement at rest, in the direction of growing positions", WHIRL_PER_STATION, 1,
                    rests_along_axis},
};

/// Largest share of twists or axial displacements in the kinetic energy of a mode which counts as rounding.
static const double unmoved = 1e-18;

/// Fills in the twists or the axial displacements of a mode, which `fill` computes (whirl_system.twist), at the instant
/// at which the largest of them peaks. share: share of these coordinates in the mode's kinetic energy.
static void fill_line(const whirl_system *system, double (*fill)(const void *model, const double *v, double *shape),
                      double share, const double *v, size_t field, size_t row, const block_view *view) {
    double shape[2 * WHIRL_MAX_PROBES];
    shape_peak peak = {0.0, 1.0, 0.0};
    if (!view_numbers(view, field, 0) || !(share > unmoved)) return;
    fill(system->model, v, shape);
    for (size_t p = 0; p < system->probe_count; p++) shape_peak_note(&peak, shape + 2 * p);
    for (size_t p = 0; p < system->probe_count && peak.size > 0.0; p++)
        shape_peak_write(&peak, shape + 2 * p, view_numbers(view, field, p) + 2 * row);
}

/// Fills in the axial displacements at rest, m. rest [dimension].
static whirl_status fill_axial_rest(const whirl_system *system, const double *rest, const block_view *view) {
    double shape[2 * WHIRL_MAX_PROBES];
    if (!view_numbers(view, AXIAL_REST, 0)) return whirl_ok();
    double *v = calloc(2 * system->dimension, sizeof *v);
    if (!v) return whirl_fail(WHIRL_NO_MEMORY, "no memory for axial displacements");
    for (size_t i = 0; i < system->dimension; i++) v[2 * i] = rest[i];
    system->axial(system->model, v, shape);
    for (size_t p = 0; p < system->probe_count; p++) *view_numbers(view, AXIAL_REST, p) = shape[2 * p];
    free(v);
    return whirl_ok();
}

static void fill_modes(const whirl_resting *point, const whirl_modes *modes, size_t most, const block_view *view) {
    const double rate = point->clock;
    const size_t count = modes->count < most ? modes->count : most;
    for (size_t i = 0; i < count; i++) {
        const whirl_mode *mode = &modes->modes[i];
        const double size = hypot(mode->real, mode->imaginary);
        view_numbers(view, FREQUENCY, 0)[i] = rate * mode->imaginary;
        view_numbers(view, NATURAL, 0)[i] = rate * size;
        view_numbers(view, GROWTH, 0)[i] = rate * mode->real;
        view_numbers(view, RATIO, 0)[i] = (0.0 - mode->real) / size;
        view_numbers(view, DECREMENT, 0)[i] = 6.283185307179586476925 * (0.0 - mode->real) / mode->imaginary;
        view_numbers(view, DIRECTION, 0)[i] = mode->direction;
        if (view_numbers(view, TORSION, 0)) view_numbers(view, TORSION, 0)[i] = mode->torsion;
        if (view_numbers(view, AXIAL_SHARE, 0)) view_numbers(view, AXIAL_SHARE, 0)[i] = mode->axial;
        if (point->before) view_numbers(view, BEFORE, 0)[i] = point->before[i] <= most ? (double)point->before[i] : 0.0;
    }
    for (size_t i = 0; i < modes->real_count && i < most; i++)
        view_numbers(view, OVERDAMPED, 0)[i] = rate * modes->reals[i];
}

static void fill_critical(const whirl_resting *point, size_t most, const block_view *view) {
    for (size_t i = 0; i < point->critical_count && i < most; i++) {
        const whirl_critical *found = &point->critical[i];
        double *row = view_numbers(view, CRITICAL, 0) + 6 * i;
        row[0] = found->kind;
        row[1] = found->value;
        row[2] = found->speed;
        row[3] = found->frequency;
        row[4] = found->ratio;
        row[5] = found->direction;
    }
}

static whirl_status modes_compute(const whirl_resting *point, const whirl_record_options *options,
                                  const block_view *view) {
    const whirl_modes *modes = point->modes;
    const size_t most = (size_t)options->modes;
    // Fill in the speed, and the stability that follows from all eigenvalues.
    *view_numbers(view, SPEED, 0) = point->speed;
    *view_numbers(view, RIGID_BODY, 0) = (double)modes->free;
    *view_numbers(view, STABILITY, 0) = point->clock * modes->growth;
    if (modes->period > 0.0) *view_numbers(view, MODULO, 0) = point->clock * 6.283185307179586476925 / modes->period;
    for (size_t i = 0; i < 2 && point->system->frequency_count > 0; i++)
        view_numbers(view, KNOWN, 0)[i] = point->system->frequencies[i * (point->system->frequency_count - 1)];
    for (size_t p = 0; p < point->system->probe_count; p++) {
        const whirl_probe *probe = &point->system->probes[p];
        for (size_t c = 0; c < 2; c++) view_numbers(view, REST, p)[c] = whirl_probe_value(probe, modes->rest, c);
    }
    whirl_status status = fill_axial_rest(point->system, modes->rest, view);
    if (status.code != WHIRL_OK) return status;
    // Fill in the sensitivity of control loops.
    whirl_sensitivity_peak sensitivity;
    status = whirl_loops_peak(point->system, modes, &sensitivity);
    *view_numbers(view, SENSITIVITY, 0) = sensitivity.peak;
    *view_numbers(view, SENSITIVITY_FREQUENCY, 0) = point->clock * sensitivity.frequency;
    // Fill in modes, their shapes, and critical speeds.
    fill_modes(point, modes, most, view);
    for (size_t i = 0; i < modes->count && i < most; i++) {
        const double *shape = modes->vectors + 2 * i * modes->dimension;
        fill_shape(point->system, shape, i, SHAPE, view);
        fill_line(point->system, point->system->twist, modes->modes[i].torsion, shape, TWIST, i, view);
        fill_line(point->system, point->system->axial, modes->modes[i].axial, shape, AXIAL, i, view);
    }
    fill_critical(point, most + 1, view);
    return status;
}

const analysis_plan modes_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute_resting = modes_compute};
