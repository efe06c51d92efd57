#include "rest_equations.h"
#include "shooting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/linear.h"

bool rest_slope(shooting *s, const double *node, double *slope, bool derivatives) {
    const size_t d = s->dimension, n = s->kept_count;
    double *all = malloc((d + d * d + 1) * sizeof *all);
    if (!all) return false;
    const double *jacobian = all + d;
    bool good = whirl_rest_slope(s->system, node, all, all + d).code == WHIRL_OK;
    for (size_t i = 0; i < n && good; i++) {
        slope[i] = all[s->kept[i]];
        good = isfinite(slope[i]);
    }
    if (derivatives) s->volume = 0.0;
    for (size_t i = 0; i < n && good && derivatives; i++) {
        for (size_t k = 0; k < n; k++) s->matrices[i * n + k] = jacobian[s->kept[i] * d + s->kept[k]];
        s->volume += s->matrices[i * n + i];
    }
    free(all);
    return good;
}

double rest_rate(const shooting *s) {
    const size_t n = s->kept_count;
    double rate = 0.0;
    for (size_t i = 0; i < n; i++) {
        double sum = 0.0;
        for (size_t k = 0; k < n; k++) sum += fabs(s->matrices[i * n + k]);
        rate = fmax(rate, sum);
    }
    return rate;
}

double rest_size(const shooting *s, const double *slope, double size, double rate) {
    double largest = 0.0;
    for (size_t i = 0; i < s->kept_count; i++) largest = fmax(largest, fabs(slope[i]));
    return size * rate > 0.0 ? largest / (size * rate) : largest;
}
