/// Records made by hand from maps, whose regimes and exponents are known.
#ifndef TESTS_ANALYZE_SYNTHETIC_H
#define TESTS_ANALYZE_SYNTHETIC_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/analyze.h"

enum { MAX_DIMENSIONS = 8 };

/// Carries z over one step, and the tangent v with it.
typedef void (*map_fn)(const double *parameters, size_t step, double *z, double *v);

/// A map with what it starts from. `embed` (may be NULL) gives the section from the state.
typedef struct map_system {
    map_fn map;
    void (*embed)(const double *z, double *point);
    size_t dimension, section_dimension;
    double parameters[4], start[MAX_DIMENSIONS];
} map_system;

static inline double normalize(double *v, size_t dimension) {
    double squares = 0.0;
    for (size_t i = 0; i < dimension; i++) squares += v[i] * v[i];
    const double length = sqrt(squares);
    for (size_t i = 0; i < dimension; i++) v[i] = length > 0.0 ? v[i] / length : i == 0;
    return log(length);
}

static inline void record_bounds(whirl_record *record) {
    const size_t d = record->dimension;
    for (size_t i = 0; i < d; i++) {
        record->low[i] = INFINITY;
        record->high[i] = -INFINITY;
        for (size_t n = record->section_count - record->record_count; n < record->section_count; n++) {
            record->low[i] = fmin(record->low[i], record->section[n * d + i]);
            record->high[i] = fmax(record->high[i], record->section[n * d + i]);
        }
    }
}

/// Iterates `transient` steps, then records `watch` more, of which `count` are the record. Freed by free().
static inline whirl_record *record_map(const map_system *system, size_t transient, size_t watch, size_t count) {
    const size_t d = system->section_dimension;
    whirl_record *record = calloc(1, sizeof *record + (watch * (d + 1) + 2 * d) * sizeof(double));
    if (!record) abort();
    record->dimension = d;
    record->section_count = record->growth_count = watch;
    record->record_count = count;
    record->section = (double *)(record + 1);
    record->growth = record->section + watch * d;
    record->low = record->growth + watch;
    record->high = record->low + d;
    double z[MAX_DIMENSIONS], v[MAX_DIMENSIONS];
    memcpy(z, system->start, sizeof z);
    for (size_t i = 0; i < system->dimension; i++) v[i] = 1.0 / (double)(i + 1);
    for (size_t n = 0; n < transient + watch; n++) {
        system->map(system->parameters, n, z, v);
        const double growth = normalize(v, system->dimension);
        if (n < transient) continue;
        record->growth[n - transient] = growth;
        double *point = record->section + (n - transient) * d;
        if (system->embed) {
            system->embed(z, point);
        } else {
            memcpy(point, z, d * sizeof(double));
        }
    }
    record_bounds(record);
    return record;
}

// ---------------------------------------------------------------- maps

/// x' = r x (1 - x)
static inline void logistic_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    v[0] *= p[0] * (1.0 - 2.0 * z[0]);
    z[0] = p[0] * z[0] * (1.0 - z[0]);
}

/// x' = 1 - a x^2 + y, y' = b x (Henon 1976)
static inline void henon_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    const double x = z[0], vx = v[0];
    v[0] = -2.0 * p[0] * x * vx + v[1];
    v[1] = p[1] * vx;
    z[0] = 1.0 - p[0] * x * x + z[1];
    z[1] = p[1] * x;
}

/// theta' = theta + Omega - K/(2 pi) sin(2 pi theta) (Arnold 1961), in turns
static inline void circle_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    const double two_pi = 6.283185307179586;
    v[0] *= 1.0 - p[1] * cos(two_pi * z[0]);
    z[0] = fmod(z[0] + p[0] - p[1] / two_pi * sin(two_pi * z[0]), 1.0);
}

static inline void on_circle(const double *z, double *point) {
    point[0] = cos(6.283185307179586 * z[0]);
    point[1] = sin(6.283185307179586 * z[0]);
}

/// x' = a x (1 - y), y' = x: the delayed logistic map, with a Neimark-Sacker bifurcation at a = 2
static inline void delayed_logistic_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    const double x = z[0], vx = v[0];
    v[0] = p[0] * (1.0 - z[1]) * vx - p[0] * x * v[1];
    v[1] = vx;
    z[0] = p[0] * x * (1.0 - z[1]);
    z[1] = x;
}

/// A spiral into (or out of) a point: modulus p[0], angle p[1] turns a step
static inline void spiral_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    const double c = p[0] * cos(6.283185307179586 * p[1]), s = p[0] * sin(6.283185307179586 * p[1]);
    double *const pairs[2] = {z, v};
    for (size_t i = 0; i < 2; i++) {
        double *u = pairs[i];
        const double x = c * u[0] - s * u[1];
        u[1] = s * u[0] + c * u[1];
        u[0] = x;
    }
}

/// x' = x + y', y' = y + K/(2 pi) sin(2 pi x): the standard map, in turns
static inline void standard_map(const double *p, size_t step, double *z, double *v) {
    (void)step;
    const double two_pi = 6.283185307179586;
    v[1] += p[0] * cos(two_pi * z[0]) * v[0];
    v[0] += v[1];
    z[1] = z[1] + p[0] / two_pi * sin(two_pi * z[0]);
    z[0] = fmod(z[0] + z[1], 1.0);
}

#endif
