// Growth of a small perturbation (Benettin et al. 1980), by a perturbed copy that is rescaled every revolution.
#include "record.h"

#include <float.h>
#include <math.h>

#include "numerics.h"

/// Size of the perturbation relative to the state: far above rounding, far below anything nonlinear. Also in
/// tolerances.
static const double least_share = 1e-8, most_share = 1e-4, share_in_tolerances = 1e4;

/// The distance stays the same until the state is this many times larger or smaller than when it was chosen.
static const double outgrown = 1e3;

/// Norm of the coordinates that do not turn.
static double twin_norm(const trajectory_twin *twin, const double *x) {
    double sum = 0.0;
    for (size_t i = 0; i < twin->dimension; i++) sum += turns_on(twin->turns, i) ? 0.0 : x[i] * x[i];
    return sqrt(sum);
}

/// Places the copy. Angles are not perturbed, and keep their number of turns.
static void twin_place(trajectory_twin *twin, const double *x) {
    for (size_t i = 0; i < twin->dimension; i++)
        twin->x[i] = turns_on(twin->turns, i) ? x[i] : x[i] + twin->distance / sqrt((double)twin->dimension);
}

trajectory_twin twin_of(const whirl_integrate_options *integrate, const whirl_system *system, double *x) {
    const whirl_method *method;
    const bool known = whirl_method_find(integrate->method, &method).code == WHIRL_OK;
    const bool apart = known && method->adaptive && !method->follows;
    return (trajectory_twin){.dimension = system->dimension,
                             .turns = system->turns,
                             .angles = system->angles,
                             .share = apart ? fmin(fmax(share_in_tolerances * integrate->rtol, least_share), most_share)
                                            : least_share,
                             .least = apart ? share_in_tolerances * integrate->atol : 0.0,
                             .x = x};
}

static double distance_beside(const trajectory_twin *twin, double size) {
    return fmax(twin->share * (size > 1e-12 ? size : 1.0), twin->least);
}

void twin_begin(trajectory_twin *twin, const double *x) {
    twin->distance = distance_beside(twin, twin_norm(twin, x));
    twin_place(twin, x);
}

double twin_growth(trajectory_twin *twin, const double *x, bool bounded) {
    double distance = 0.0;
    for (size_t i = 0; i < twin->dimension; i++) {
        const double d = part_apart(twin->turns, twin->angles, i, twin->x, x);
        distance += d * d;
    }
    distance = sqrt(distance);
    const double size = twin_norm(twin, x), before = twin->distance, next = distance_beside(twin, size);
    const bool lost = !(distance > DBL_EPSILON * size);
    if (next > outgrown * before || next < before / outgrown) twin->distance = next;
    if (lost || !bounded || !isfinite(distance)) {
        twin_place(twin, x);
        return lost && bounded ? log(DBL_EPSILON / twin->share) : -log(twin->share);
    }
    const double factor = twin->distance / distance;
    for (size_t i = 0; i < twin->dimension; i++)
        twin->x[i] = x[i] + factor * part_apart(twin->turns, twin->angles, i, twin->x, x);
    return log(distance / before);
}
