// Growth of a small perturbation (Benettin et al. 1980), by a perturbed copy that is rescaled every revolution.
#include "perturbed_copy.h"

#include <float.h>
#include <math.h>

#include "turns.h"

/// Size of the perturbation relative to the motion: least_share is far above rounding, most_share far below anything
/// nonlinear. Between both, it is `share_in_tolerances` relative tolerances for methods whose errors have a history.
static const double least_share = 1e-8, most_share = 1e-4, share_in_tolerances = 1e4;

/// The distance stays the same until the motion is this many times larger or smaller than when it was chosen.
/// At first, when only the state at the section was known, the motion may be `outgrown_first` times larger.
static const double outgrown = 1e3, outgrown_first = 10.0;

/// Returns the norm of the coordinates that do not turn.
static double perturbed_copy_norm(const perturbed_copy *copy, const double *x) {
    double sum = 0.0;
    for (size_t i = 0; i < copy->dimension; i++) sum += turns_on(copy->turns, i) ? 0.0 : x[i] * x[i];
    return sqrt(sum);
}

/// Places the copy. Angles are not perturbed, and keep their number of turns.
static void perturbed_copy_place(perturbed_copy *copy, const double *x) {
    for (size_t i = 0; i < copy->dimension; i++)
        copy->x[i] = turns_on(copy->turns, i) ? x[i] : x[i] + copy->distance / sqrt((double)copy->dimension);
}

perturbed_copy perturbed_copy_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x) {
    const whirl_method *method;
    const bool known = whirl_method_find(integrate->method, &method).code == WHIRL_OK;
    const bool apart = known && method->adaptive && !method->follows;
    return (perturbed_copy){.dimension = system->dimension,
                            .turns = system->turns,
                            .angles = system->angles,
                            .share = apart ? fmin(fmax(share_in_tolerances * integrate->rtol, least_share), most_share)
                                           : least_share,
                            .least = apart ? share_in_tolerances * integrate->atol : 0.0,
                            .x = x};
}

static double distance_at_size(const perturbed_copy *copy, double size) {
    return fmax(copy->share * (size > 1e-12 ? size : 1.0), copy->least);
}

void perturbed_copy_begin(perturbed_copy *copy, const double *x) {
    copy->distance = distance_at_size(copy, perturbed_copy_norm(copy, x));
    perturbed_copy_place(copy, x);
}

void perturbed_copy_size(perturbed_copy *copy, const double *low, const double *high) {
    double sum = 0.0;
    for (size_t i = 0; i < copy->dimension; i++) {
        const double half = turns_on(copy->turns, i) ? 0.0 : 0.5 * (high[i] - low[i]);
        sum += half * half;
    }
    copy->range = isfinite(sum) ? sqrt(sum) : 0.0;
}

double perturbed_copy_growth(perturbed_copy *copy, const double *x, bool first, bool bounded) {
    double distance = 0.0;
    for (size_t i = 0; i < copy->dimension; i++) {
        const double d = part_apart(copy->turns, copy->angles, i, copy->x, x);
        distance += d * d;
    }
    distance = sqrt(distance);
    const double size = fmax(perturbed_copy_norm(copy, x), copy->range), before = copy->distance,
                 next = distance_at_size(copy, size);
    const bool lost = !(distance > DBL_EPSILON * size);
    if (next > (first ? outgrown_first : outgrown) * before || next < before / outgrown) copy->distance = next;
    if (lost || !bounded || !isfinite(distance)) {
        perturbed_copy_place(copy, x);
        return lost && bounded ? log(DBL_EPSILON / copy->share) : -log(copy->share);
    }
    const double factor = copy->distance / distance;
    for (size_t i = 0; i < copy->dimension; i++)
        copy->x[i] = x[i] + factor * part_apart(copy->turns, copy->angles, i, copy->x, x);
    return log(distance / before);
}
