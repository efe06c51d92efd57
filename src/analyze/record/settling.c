#include "settling.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "archive.h"
#include "turns.h"
#include "whirl/engine/analyze.h"

enum { KEPT = WHIRL_MAX_PERIOD + 1, CALM = 32 };

static const double tolerance = 1e-11;

struct settling {
    size_t dimension, count;      ///< states taken
    const double *turns, *angles; ///< as in whirl_system; coordinates that turn do not count for returns
    size_t returns[KEPT];         ///< [k] consecutive revolutions that returned after k
    double states[];              ///< [KEPT][dimension], a ring
};

settling *settling_new(const whirl_system *system) {
    settling *s = calloc(1, sizeof *s + KEPT * system->dimension * sizeof(double));
    if (!s) return NULL;
    s->dimension = system->dimension;
    s->turns = system->turns;
    s->angles = system->angles;
    return s;
}

void settling_free(settling *s) {
    free(s);
}

void settling_archive(settling *s, archive *a) {
    archive_part(a, &s->count, sizeof s->count);
    archive_part(a, s->returns, sizeof s->returns);
    archive_part(a, s->states, KEPT * s->dimension * sizeof *s->states);
}

const double *settling_state(const settling *s, size_t back) {
    return back < KEPT && back < s->count ? s->states + (s->count - 1 - back) % KEPT * s->dimension : NULL;
}

static bool close_to(const settling *s, const double *a, const double *b, double square) {
    double sum = 0.0;
    for (size_t i = 0; i < s->dimension && sum <= square; i++) {
        const double away = part_apart(s->turns, s->angles, i, a, b);
        sum += away * away;
    }
    return sum <= square;
}

size_t settling_note(settling *s, const double *x) {
    double size = 0.0;
    size_t settled = 0;
    for (size_t i = 0; i < s->dimension; i++) size += turns_on(s->turns, i) ? 0.0 : x[i] * x[i];
    for (size_t k = 1; k < KEPT && k <= s->count; k++) {
        const double *before = s->states + (s->count - k) % KEPT * s->dimension;
        const bool returned = close_to(s, x, before, tolerance * tolerance * size);
        s->returns[k] = returned ? s->returns[k] + 1 : 0;
        if (settled == 0 && s->returns[k] >= 3 * k + CALM) settled = k;
    }
    memcpy(s->states + s->count % KEPT * s->dimension, x, s->dimension * sizeof *x);
    s->count++;
    return settled;
}
