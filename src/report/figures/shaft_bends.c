// Computes the deflection of shafts between stations: results have shapes only at stations. The machine of a point is
// built again from the result's case; its mode or response is used if it agrees with the result at all stations.
#include <complex.h>
#include <math.h>
#include <stdlib.h>

#include "figure_kinds.h"
#include "machine_along.h"
#include "machine_at.h"
#include "shaft_bends.h"
#include "whirl/engine/linear.h"

static const double degree = 3.14159265358979323846 / 180.0;

struct shaft_bends {
    const drawing *of;
    const whirl_table *table;
    size_t point;
    whirl_study study;
    whirl_batch *batch; ///< batch of the study
    whirl_placed *placed;
    whirl_machine machine;
    whirl_shaft_line line;
    whirl_modes *modes; ///< modes of the machine, computed on first use
};

shaft_bends *bends_new(const drawing *of, const whirl_table *table, size_t point) {
    shaft_bends *b = of->machine ? calloc(1, sizeof *b) : NULL;
    if (!b) return NULL;
    *b = (shaft_bends){.of = of, .table = table, .point = point};
    b->batch = machine_batch(of->machine, table, point, &b->study);
    bool good = b->batch && whirl_study_place(&b->study, b->batch, &b->placed).code == WHIRL_OK;
    good = good && b->study.machine(b->study.family, b->batch, table->values[point], &b->machine).code == WHIRL_OK;
    if (good) {
        whirl_batch batch = *b->batch;
        batch.variant = table_has(table, WHIRL_FIELD_STATICS_LOAD) ? WHIRL_WITH_STATICS : WHIRL_AS_STUDIED;
        good = whirl_case_line(of->machine, &batch, table->values[point], &b->line).code == WHIRL_OK;
    }
    if (good && b->line.count > 0) return b;
    bends_free(b);
    return NULL;
}

void bends_free(shaft_bends *b) {
    if (!b) return;
    whirl_modes_free(b->modes);
    whirl_shaft_line_free(&b->line);
    if (b->machine.release) b->machine.release(b->machine.owner);
    free(b->placed);
    free(b);
}

const whirl_shaft_line *bends_line(const shaft_bends *b) {
    return &b->line;
}

double bends_length(const shaft_bends *b) {
    return b->machine.length;
}

/// Returns the displacement of a station along x (axis: 0) or y in a vector [dimension][2].
static double complex moved_at(const whirl_probe *probe, int axis, const double *vector) {
    const double *at = vector + 2 * (axis == 0 ? probe->x : probe->y);
    return whirl_probe_sees(probe, (size_t)axis) ? at[0] + at[1] * I : 0.0;
}

/// Returns the displacement of a place on the shaft line along x (axis: 0) or y in a vector [dimension][2], in length
/// scales.
static double complex moved_on_line(const shaft_bends *b, size_t place, int axis, const double *vector, double length) {
    return (whirl_shaft_line_at(&b->line, place, axis, vector, 2) +
            whirl_shaft_line_at(&b->line, place, axis, vector + 1, 2) * I) /
           length;
}

// ---------------------------------------------------------------- modes

/// One or two complex vectors, a linear combination of which must equal the shape of a mode in the result at all
/// stations.
typedef struct fit {
    const shaft_bends *of;
    size_t mode, count;
    const double *vectors[2]; ///< [dimension][2]
    double complex factors[2];
} fit;

/// Returns the shape of the result's mode at a station along x (axis: 0) or y.
static double complex fit_wanted(const fit *f, size_t station, int axis) {
    const double *row = whirl_table_field(f->of->table, f->of->point, WHIRL_FIELD_MODES_SHAPE, station) + 4 * f->mode;
    const size_t at = 2 * (size_t)axis;
    return row[at] - row[at + 1] * I;
}

/// Returns the scalar product of two vectors over all stations, the first one conjugated; `other` NULL: the result's
/// shape.
static double complex fit_product(const fit *f, const whirl_system *system, const double *one, const double *other) {
    double complex sum = 0.0;
    for (size_t p = 0; p < 2 * system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p / 2];
        const int axis = (int)(p % 2);
        sum += conj(moved_at(probe, axis, one)) * (other ? moved_at(probe, axis, other) : fit_wanted(f, p / 2, axis));
    }
    return sum;
}

/// Finds the factors by least squares. Returns false if the sum is not the result's shape, whose largest number is 1.
static bool fit_solve(fit *f, const whirl_system *system) {
    const double complex a = fit_product(f, system, f->vectors[0], f->vectors[0]);
    const double complex p = fit_product(f, system, f->vectors[0], NULL);
    f->factors[0] = p / a;
    if (f->count == 2) {
        const double complex b = fit_product(f, system, f->vectors[0], f->vectors[1]);
        const double complex d = fit_product(f, system, f->vectors[1], f->vectors[1]);
        const double complex q = fit_product(f, system, f->vectors[1], NULL);
        const double complex whole = a * d - conj(b) * b;
        f->factors[0] = (p * d - b * q) / whole;
        f->factors[1] = (a * q - conj(b) * p) / whole;
    }
    for (size_t s = 0; s < 2 * system->probe_count; s++) {
        const int axis = (int)(s % 2);
        double complex own = 0.0;
        for (size_t k = 0; k < f->count; k++)
            own += f->factors[k] * moved_at(&system->probes[s / 2], axis, f->vectors[k]);
        if (!(cabs(own - fit_wanted(f, s / 2, axis)) <= 1e-6)) return false;
    }
    return true;
}

/// Chooses the modes of a machine with the eigenvalue of the result's mode: one, or two with equal eigenvalues, whose
/// shapes may be mixed.
static void fit_choose(fit *f, const whirl_modes *modes, double clock) {
    const shaft_bends *b = f->of;
    const double rate = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_FREQUENCY, 0)[f->mode] / clock;
    const double growth = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_GROWTH, 0)[f->mode] / clock;
    for (size_t i = 0; i < modes->count && f->count < 2; i++) {
        const whirl_mode *own = &modes->modes[i];
        if (!(hypot(own->real - growth, own->imaginary - rate) <= 1e-6 * hypot(growth, rate))) continue;
        f->vectors[f->count++] = modes->vectors + 2 * i * modes->dimension;
    }
}

/// Writes the shape of the result's mode along the shaft line from the modes of a machine. Returns false if none of
/// them is that mode.
static bool fit_draw(const shaft_bends *b, size_t mode, const whirl_machine *machine, const whirl_modes *modes,
                     double *moved) {
    fit f = {.of = b, .mode = mode};
    fit_choose(&f, modes, machine->clock);
    if (f.count == 0 || !fit_solve(&f, machine->system)) return false;
    for (size_t i = 0; i < 2 * b->line.count; i++) {
        double complex sum = 0.0;
        for (size_t k = 0; k < f.count; k++)
            sum += f.factors[k] * moved_on_line(b, i / 2, (int)(i % 2), f.vectors[k], machine->length);
        moved[2 * i] = creal(sum);
        moved[2 * i + 1] = -cimag(sum);
    }
    return true;
}

/// Like bends_mode, for a machine whose coefficients depend on the whirl frequency: builds it again at the mode's
/// frequency.
static bool bends_mode_at(const shaft_bends *b, size_t mode, double *moved) {
    whirl_machine machine;
    whirl_modes *modes = NULL;
    whirl_batch batch = *b->batch;
    batch.asynchronous = true;
    batch.frequency = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode];
    if (b->study.machine(b->study.family, &batch, b->table->values[b->point], &machine).code != WHIRL_OK) return false;
    const bool good = whirl_modes_new(machine.system, machine.start, &modes).code == WHIRL_OK &&
                      fit_draw(b, mode, &machine, modes, moved);
    whirl_modes_free(modes);
    machine.release(machine.owner);
    return good;
}

bool bends_mode(shaft_bends *b, size_t mode, double *moved) {
    const whirl_system *system = b->machine.system;
    if (system->frequency_count > 0) return bends_mode_at(b, mode, moved);
    if (!b->modes && whirl_modes_new(system, b->machine.start, &b->modes).code != WHIRL_OK) return false;
    return fit_draw(b, mode, &b->machine, b->modes, moved);
}

// ---------------------------------------------------------------- response to unbalance

/// Returns true if a response [dimension][2] is that of the result at all stations.
static bool is_response(const shaft_bends *b, const double *response) {
    const whirl_system *system = b->machine.system;
    double largest = 0.0, apart = 0.0;
    for (size_t i = 0; i < 2 * system->probe_count; i++) {
        const double size = whirl_table_field(b->table, b->point, WHIRL_FIELD_UNBALANCE_AMPLITUDE, i / 2)[i % 2];
        const double lag = whirl_table_field(b->table, b->point, WHIRL_FIELD_UNBALANCE_LAG, i / 2)[i % 2];
        const double angle = isfinite(lag) ? -lag * degree : 0.0;
        const double complex wanted = size * cos(angle) + size * sin(angle) * I;
        largest = fmax(largest, size);
        apart = fmax(apart, cabs(moved_at(&system->probes[i / 2], (int)(i % 2), response) - wanted));
    }
    return apart <= 1e-6 * largest;
}

bool bends_response(shaft_bends *b, double *moved) {
    const whirl_system *system = b->machine.system;
    double *rest = calloc(3 * system->dimension + 1, sizeof *rest), *response = rest ? rest + system->dimension : NULL;
    const bool good = rest && whirl_forced_response(system, b->machine.start, rest, response).code == WHIRL_OK &&
                      is_response(b, response);
    for (size_t i = 0; i < 2 * b->line.count && good; i++) {
        const double complex own = moved_on_line(b, i / 2, (int)(i % 2), response, b->machine.length);
        moved[2 * i] = creal(own);
        moved[2 * i + 1] = -cimag(own);
    }
    free(rest);
    return good;
}

// ---------------------------------------------------------------- drawing

void bends_draw(whirl_figure *figure, whirl_series *to, const shaft_bends *b, const machine_along *along,
                const double *moved, size_t columns, size_t column) {
    for (size_t i = 0; i < b->line.count; i++) {
        if (i > 0 && b->line.shaft[i] != b->line.shaft[i - 1]) series_break(figure, to);
        series_add(figure, to, along->start[b->line.shaft[i] - 1] + b->line.position[i] / along->unit,
                   moved[columns * i + column]);
    }
    series_break(figure, to);
}
