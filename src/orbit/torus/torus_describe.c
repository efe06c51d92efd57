// Describes a torus that was found.
#include "torus_describe.h"
#include "harmonics.h"
#include "section_map.h"
#include "torus_equations.h"
#include "two_pi.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static whirl_torus *torus_describe_allocate(const torus_equations *e) {
    const size_t d = e->map->dimension;
    whirl_torus *torus = calloc(1, sizeof *torus + (e->count * d + 2 * e->n) * sizeof(double));
    if (!torus) return NULL;
    *torus = (whirl_torus){.dimension = d,
                           .revolutions = e->revolutions,
                           .node_count = e->count,
                           .exponent_count = e->n > 0 ? e->n - 1 : 0};
    torus->nodes = (double *)(torus + 1);
    torus->exponents = torus->nodes + e->count * d;
    torus->exponent_errors = torus->exponents + e->n;
    return torus;
}

void whirl_torus_free(whirl_torus *torus) {
    free(torus);
}

/// Returns the error of the equations half way between nodes.
static double error_between(torus_equations *e, const double *u) {
    const size_t n = e->n;
    const double half = 0.5 * two_pi / (double)e->count, angle = u[e->count * n];
    double *points = e->workspace, *turned = points + e->count * n, *images = turned + e->count * n, error = 0.0;
    harmonics_of(e->count, n, u, e->series);
    harmonics_spread(e->count, n, e->series, half, e->count, points, NULL);
    harmonics_spread(e->count, n, e->series, half + angle, e->count, turned, NULL);
    if (!section_map_carry(e->map, e->count, points, images, NULL, NULL)) return INFINITY;
    for (size_t i = 0; i < e->count * n; i++) error = fmax(error, fabs(images[i] - turned[i]));
    return error;
}

/// Returns the size of the last two harmonics divided by that of the largest.
static double tail_of(torus_equations *e, const double *u) {
    const size_t last = e->count / 2;
    double largest = 0.0;
    harmonics_of(e->count, e->n, u, e->series);
    for (size_t h = 1; h <= last; h++) largest = fmax(largest, harmonics_size(e->n, e->series, h));
    return fmax(harmonics_size(e->n, e->series, last), harmonics_size(e->n, e->series, last - 1)) / largest;
}

static size_t resonance_of(double rotation) {
    enum { MAX_DENOMINATOR = 12 };
    const double near = 0.05;
    for (size_t q = 1; q <= MAX_DENOMINATOR; q++) {
        const double turns = (double)q * rotation;
        if (fabs(turns - round(turns)) < near / (double)q) return q;
    }
    return 0;
}

whirl_status torus_describe(torus_equations *e, const double *u, double residual, whirl_torus **out) {
    whirl_torus *torus = torus_describe_allocate(e);
    *out = NULL;
    if (!torus) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a torus of %zu nodes", e->count);
    for (size_t j = 0; j < e->count; j++) section_map_put(e->map, u + j * e->n, torus->nodes + j * torus->dimension);
    torus->radius = torus_equations_radius(e, u);
    torus->rotation = u[e->count * e->n] / two_pi;
    torus->residual = residual;
    torus->resonance = resonance_of(torus->rotation);
    torus->volume = e->volume / (double)e->revolutions;
    torus->tail = tail_of(e, u);
    if (!torus_find_exponents(e, u, torus)) {
        whirl_torus_free(torus);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the exponents of a torus of %zu nodes", e->count);
    }
    torus->error = error_between(e, u) / torus->radius;
    *out = torus;
    return whirl_ok();
}

void whirl_torus_at(const whirl_torus *torus, double theta, double *x) {
    const size_t d = torus->dimension, count = torus->node_count;
    memset(x, 0, d * sizeof *x);
    for (size_t k = 0; k < count; k++) {
        const double away = theta - two_pi * (double)k / (double)count, c = cos(away), s = sin(away);
        double sum = 0.5, cosine = 1.0, sine = 0.0;
        for (size_t h = 1; h <= count / 2; h++) {
            const double before = cosine;
            cosine = before * c - sine * s;
            sine = sine * c + before * s;
            sum += cosine;
        }
        for (size_t i = 0; i < d; i++) x[i] += 2.0 * sum / (double)count * torus->nodes[k * d + i];
    }
}

// ---------------------------------------------------------------- nodes

bool torus_is_accurate(const torus_equations *e, const double *u, const whirl_torus *torus) {
    const double slight = 10.0 * e->options->tolerance * torus_equations_reach(e, u) / torus->radius;
    return torus->error <= fmax(e->options->accuracy, slight);
}

/// Returns the size of the harmonics from `first` on.
static double rest_from(const torus_equations *e, size_t first) {
    double sum = 0.0;
    for (size_t h = first; h <= e->count / 2; h++) sum += harmonics_size(e->n, e->series, h);
    return sum;
}

/// Returns the number of missing harmonics, by the decay of the present ones.
static size_t torus_describe_missing(const torus_equations *e, double error) {
    const size_t last = e->count / 2, middle = (last + 1) / 2, least = 1 + last / 5, most = last + 1;
    const double early = harmonics_size(e->n, e->series, middle), late = harmonics_size(e->n, e->series, last);
    const double rate = log(early / late) / (double)(last - middle + (last == middle));
    const double need = log(2.0 * error / e->options->accuracy) / rate;
    if (!(rate > 0.0 && isfinite(need))) return most;
    return need < (double)least ? least : need > (double)most ? most : (size_t)need;
}

size_t torus_nodes_wanted(torus_equations *e, const double *u, double error) {
    enum { SPARE = 2 };
    const double slight = 0.02 * e->options->accuracy * torus_equations_radius(e, u);
    size_t last = e->count / 2;
    harmonics_of(e->count, e->n, u, e->series);
    if (!(error <= e->options->accuracy)) {
        last += torus_describe_missing(e, error);
    } else {
        while (last > SPARE && rest_from(e, last - SPARE) <= slight) last--;
    }
    const size_t wanted = 2 * last + 1;
    return wanted < WHIRL_MIN_TORUS_NODES    ? WHIRL_MIN_TORUS_NODES
           : wanted > e->options->most_nodes ? e->options->most_nodes
                                             : wanted;
}

bool torus_resample(const torus_equations *e, size_t count, const double *from, size_t many, double *to) {
    const size_t n = e->n, extra = torus_equations_unknowns(e) - e->count * n;
    double *series = malloc(count * n * sizeof *series);
    if (!series) return false;
    harmonics_of(count, n, from, series);
    memmove(to + many * n, from + count * n, extra * sizeof *to);
    harmonics_spread(count, n, series, 0.0, many, to, NULL);
    free(series);
    return true;
}

void torus_say_rough(const torus_equations *e, const whirl_torus *torus, char *text, size_t size) {
    const double turns = (double)torus->resonance * torus->rotation;
    const int length =
        snprintf(text, size,
                 "the curve is not smooth enough: with %zu nodes it is off by %.3g of its radius between "
                 "them, expected %.3g; its rotation number is %.6f",
                 torus->node_count, torus->error, e->options->accuracy, torus->rotation);
    if (length < 0 || (size_t)length >= size || torus->resonance == 0) return;
    snprintf(text + length, size - (size_t)length, ", near %.0f/%zu, where motions lock", round(turns),
             torus->resonance);
}
