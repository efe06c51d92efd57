#include "settling.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/analyze.h"

enum { KEPT = WHIRL_MAX_PERIOD + 1, CALM = 32 };

static const double tolerance = 1e-11;

struct settling {
    size_t dimension, count; ///< states taken
    size_t returns[KEPT];    ///< [k] revolutions in a row that returned after k
    double states[];         ///< [KEPT][dimension], in turn
};

settling *settling_new(size_t dimension) {
    settling *s = calloc(1, sizeof *s + KEPT * dimension * sizeof(double));
    if (s) s->dimension = dimension;
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

static bool close_to(const double *a, const double *b, size_t dimension, double square) {
    double sum = 0.0;
    for (size_t i = 0; i < dimension && sum <= square; i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum <= square;
}

bool settling_note(settling *s, const double *x) {
    double size = 0.0;
    bool settled = false;
    for (size_t i = 0; i < s->dimension; i++) size += x[i] * x[i];
    for (size_t k = 1; k < KEPT && k <= s->count; k++) {
        const double *before = s->states + (s->count - k) % KEPT * s->dimension;
        const bool returned = close_to(x, before, s->dimension, tolerance * tolerance * size);
        s->returns[k] = returned ? s->returns[k] + 1 : 0;
        settled = settled || s->returns[k] >= 3 * k + CALM;
    }
    memcpy(s->states + s->count % KEPT * s->dimension, x, s->dimension * sizeof *x);
    s->count++;
    return settled;
}
