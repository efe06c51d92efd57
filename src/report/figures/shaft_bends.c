// How shafts bend between stations. Results hold shapes at stations alone; the machine of a point is made once more
// from the result's case, and what it does is taken where it is the same at the stations.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure_kinds.h"
#include "whirl/engine/linear.h"

static const double degree = 3.14159265358979323846 / 180.0;

struct shaft_bends {
    const drawing *of;
    const whirl_table *table;
    size_t point;
    whirl_study study;
    whirl_batch *batch; ///< of the study
    whirl_placed *placed;
    whirl_machine machine;
    whirl_shaft_line line;
    whirl_modes *modes; ///< of the machine, once they are asked for
};

shaft_bends *bends_new(const drawing *of, const whirl_table *table, size_t point) {
    shaft_bends *b = of->machine ? calloc(1, sizeof *b) : NULL;
    if (!b) return NULL;
    *b = (shaft_bends){.of = of, .table = table, .point = point};
    b->batch = machine_batch(of->machine, table, point, &b->study);
    bool good = b->batch && whirl_study_place(&b->study, b->batch, &b->placed).code == WHIRL_OK;
    good = good && b->study.machine(b->study.family, b->batch, table->values[point], &b->machine).code == WHIRL_OK;
    if (good && table_has(table, WHIRL_FIELD_STATICS_LOAD)) b->batch->variant = WHIRL_WITH_STATICS;
    good = good && whirl_case_line(of->machine, b->batch, table->values[point], &b->line).code == WHIRL_OK;
    if (b->batch) b->batch->variant = WHIRL_AS_STUDIED;
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

// ---------------------------------------------------------------- complex numbers, real and imaginary parts

typedef struct part {
    double re, im;
} part;

static part part_times(part a, part b) {
    return (part){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

static part part_plus(part a, part b) {
    return (part){a.re + b.re, a.im + b.im};
}

static part part_conjugate(part a) {
    return (part){a.re, -a.im};
}

static part part_over(part a, part b) {
    const double size = b.re * b.re + b.im * b.im;
    const part up = part_times(a, part_conjugate(b));
    return (part){up.re / size, up.im / size};
}

/// What a vector [dimension][2] moves of a station along x (axis: 0) or y.
static part part_at(const whirl_probe *probe, int axis, const double *vector) {
    const double *at = vector + 2 * (axis == 0 ? probe->x : probe->y);
    return whirl_probe_sees(probe, (size_t)axis) ? (part){at[0], at[1]} : (part){0.0, 0.0};
}

// ---------------------------------------------------------------- modes

/// Vectors, one or two of them, whose sum, each times a number, is to be the shape of a result.
typedef struct fit {
    const shaft_bends *of;
    size_t mode, count;
    const double *vectors[2]; ///< [dimension][2]
    part factors[2];
} fit;

/// The result's own number of a station.
static part fit_wanted(const fit *f, size_t station, int axis) {
    const double *row = whirl_table_field(f->of->table, f->of->point, WHIRL_FIELD_MODES_SHAPE, station) + 4 * f->mode;
    const size_t at = 2 * (size_t)axis;
    return (part){row[at], -row[at + 1]};
}

/// Sum over all stations of what a vector has, conjugate, times what another one has; NULL: the result.
static part fit_product(const fit *f, const whirl_system *system, const double *one, const double *other) {
    part sum = {0.0, 0.0};
    for (size_t p = 0; p < 2 * system->probe_count; p++) {
        const whirl_probe *probe = &system->probes[p / 2];
        const int axis = (int)(p % 2);
        const part b = other ? part_at(probe, axis, other) : fit_wanted(f, p / 2, axis);
        sum = part_plus(sum, part_times(part_conjugate(part_at(probe, axis, one)), b));
    }
    return sum;
}

/// Finds the factors by least squares; false where the sum is not the result's shape, whose largest number is 1.
static bool fit_solve(fit *f, const whirl_system *system) {
    const part a = fit_product(f, system, f->vectors[0], f->vectors[0]);
    const part p = fit_product(f, system, f->vectors[0], NULL);
    f->factors[0] = part_over(p, a);
    if (f->count == 2) {
        const part b = fit_product(f, system, f->vectors[0], f->vectors[1]);
        const part d = fit_product(f, system, f->vectors[1], f->vectors[1]);
        const part q = fit_product(f, system, f->vectors[1], NULL);
        const part minus = {-1.0, 0.0};
        const part whole = part_plus(part_times(a, d), part_times(minus, part_times(part_conjugate(b), b)));
        f->factors[0] = part_over(part_plus(part_times(p, d), part_times(minus, part_times(b, q))), whole);
        f->factors[1] =
            part_over(part_plus(part_times(a, q), part_times(minus, part_times(part_conjugate(b), p))), whole);
    }
    for (size_t s = 0; s < 2 * system->probe_count; s++) {
        part own = {0.0, 0.0};
        for (size_t k = 0; k < f->count; k++)
            own =
                part_plus(own, part_times(f->factors[k], part_at(&system->probes[s / 2], (int)(s % 2), f->vectors[k])));
        const part wanted = fit_wanted(f, s / 2, (int)(s % 2));
        if (!(hypot(own.re - wanted.re, own.im - wanted.im) <= 1e-6)) return false;
    }
    return true;
}

/// The modes of a machine nearest to a mode of the result: one, or two of one eigenvalue, whose shapes are any mixture.
static void fit_choose(fit *f, const shaft_bends *b, const whirl_modes *modes, double clock) {
    const double rate = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_FREQUENCY, 0)[f->mode] / clock;
    const double growth = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_GROWTH, 0)[f->mode] / clock;
    for (size_t i = 0; i < modes->count && f->count < 2; i++) {
        const whirl_mode *own = &modes->modes[i];
        if (!(hypot(own->real - growth, own->imaginary - rate) <= 1e-6 * hypot(growth, rate))) continue;
        f->vectors[f->count++] = modes->vectors + 2 * i * modes->dimension;
    }
}

static void fit_draw(const fit *f, double length, double *moved) {
    const whirl_shaft_line *line = &f->of->line;
    for (size_t i = 0; i < 2 * line->count; i++) {
        part sum = {0.0, 0.0};
        for (size_t k = 0; k < f->count; k++) {
            const part own = {whirl_shaft_line_at(line, i / 2, (int)(i % 2), f->vectors[k], 2) / length,
                              whirl_shaft_line_at(line, i / 2, (int)(i % 2), f->vectors[k] + 1, 2) / length};
            sum = part_plus(sum, part_times(f->factors[k], own));
        }
        moved[2 * i] = sum.re;
        moved[2 * i + 1] = -sum.im;
    }
}

/// The modes of a machine that has them at one frequency of whirl alone are those of another machine at each.
static bool bends_mode_at(shaft_bends *b, size_t mode, double *moved) {
    whirl_machine machine;
    whirl_modes *modes = NULL;
    whirl_batch batch = *b->batch;
    fit f = {.of = b, .mode = mode};
    batch.asynchronous = true;
    batch.frequency = whirl_table_field(b->table, b->point, WHIRL_FIELD_MODES_FREQUENCY, 0)[mode];
    if (b->study.machine(b->study.family, &batch, b->table->values[b->point], &machine).code != WHIRL_OK) return false;
    bool good = whirl_modes_new(machine.system, machine.start, &modes).code == WHIRL_OK;
    if (good) fit_choose(&f, b, modes, machine.clock);
    good = good && f.count > 0 && fit_solve(&f, machine.system);
    if (good) fit_draw(&f, machine.length, moved);
    whirl_modes_free(modes);
    machine.release(machine.owner);
    return good;
}

bool bends_mode(shaft_bends *b, size_t mode, double *moved) {
    fit f = {.of = b, .mode = mode};
    const whirl_system *system = b->machine.system;
    if (system->frequency_count > 0) return bends_mode_at(b, mode, moved);
    if (!b->modes && whirl_modes_new(system, b->machine.start, &b->modes).code != WHIRL_OK) return false;
    fit_choose(&f, b, b->modes, b->machine.clock);
    if (f.count == 0 || !fit_solve(&f, system)) return false;
    fit_draw(&f, b->machine.length, moved);
    return true;
}

// ---------------------------------------------------------------- response to unbalance

/// Whether a response [dimension][2] is that of the result at all stations.
static bool is_response(const shaft_bends *b, const double *response) {
    const whirl_system *system = b->machine.system;
    double largest = 0.0, apart = 0.0;
    for (size_t i = 0; i < 2 * system->probe_count; i++) {
        const double size = whirl_table_field(b->table, b->point, WHIRL_FIELD_UNBALANCE_AMPLITUDE, i / 2)[i % 2];
        const double lag = whirl_table_field(b->table, b->point, WHIRL_FIELD_UNBALANCE_LAG, i / 2)[i % 2];
        const part own = part_at(&system->probes[i / 2], (int)(i % 2), response);
        const double angle = isfinite(lag) ? -lag * degree : 0.0;
        largest = fmax(largest, size);
        apart = fmax(apart, hypot(own.re - size * cos(angle), own.im - size * sin(angle)));
    }
    return apart <= 1e-6 * largest;
}

bool bends_response(shaft_bends *b, double *moved) {
    const whirl_system *system = b->machine.system;
    double *rest = calloc(3 * system->dimension + 1, sizeof *rest), *response = rest ? rest + system->dimension : NULL;
    const bool good = rest && whirl_forced_response(system, b->machine.start, rest, response).code == WHIRL_OK &&
                      is_response(b, response);
    for (size_t i = 0; i < 2 * b->line.count && good; i++) {
        moved[2 * i] = whirl_shaft_line_at(&b->line, i / 2, (int)(i % 2), response, 2) / b->machine.length;
        moved[2 * i + 1] = -whirl_shaft_line_at(&b->line, i / 2, (int)(i % 2), response + 1, 2) / b->machine.length;
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
