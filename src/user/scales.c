// Chooses scales of a user's coordinates: units in which tolerances, perturbations and bounds of the library fit
// micrometres, kelvins and pascals alike. Scales that the user gives are used. Others are 1 if motions have an ordinary
// size, so that ordinary systems are computed as written, else powers of two, which change no digit.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number_text.h"
#include "user.h"
#include "whirl/status.h"

/// Range of ordinary sizes of a coordinate.
static const double smallest = 1e-2, largest = 1e2;

/// A coordinate that grows by more than this factor from one half of a motion's record to the other has no definite
/// size.
static const double steady = 4.0;

static whirl_status scales_check(const whirl_user_system *system) {
    const size_t d = system->displacements;
    const double *scales = system->scales;
    for (size_t k = 0; scales && k < system->dimension; k++) {
        if (scales[k] > 0.0 && system->angles && system->angles[k] > 0.0)
            return whirl_fail(WHIRL_BAD_INPUT,
                              "coordinate %zu is an angle with a scale, expected none: a turn is its scale", k);
        if (k < d && scales[k] > 0.0 && scales[d + k] > 0.0 && scales[k] != scales[d + k])
            return whirl_fail(WHIRL_BAD_INPUT,
                              "displacement %zu has a scale of %g and its velocity one of %g, expected one for both", k,
                              scales[k], scales[d + k]);
    }
    return whirl_ok();
}

/// Maximum number of slope evaluations per trial revolution, so that a solver with tiny steps does not delay the study.
static const long most_calls = 20000;

/// A trial run of points of a study, to observe the sizes of coordinates.
typedef struct look {
    const whirl_user_system *system;
    int transient, record; ///< revolutions; record 0: only the start is observed
    double *sizes;         ///< [dimension] largest sizes observed so far, in the user's units
} look;

static void raise_size(const look *at, size_t k, double value) {
    const double unit = at->system->units ? at->system->units[k] : 1.0;
    at->sizes[k] = fmax(at->sizes[k], fabs(value) * unit);
}

/// Observes the start, and how far its slopes lead within period/(2 pi), a radian of an oscillation.
static void see_start(const look *at, const whirl_machine *machine, double *slopes) {
    const whirl_system *system = machine->system;
    const double radian = system->period / (2.0 * acos(-1.0)), t = 0.0;
    system->rhs(system->model, t, &t, machine->start, slopes);
    for (size_t k = 0; k < system->dimension; k++) {
        raise_size(at, k, machine->start[k]);
        if (isfinite(slopes[k])) raise_size(at, k, radian * slopes[k]);
    }
}

/// Observes a motion over its last revolutions. A motion that diverges or uses all remaining calls has no known size if
/// it had a transient, and is ignored if it had none.
static whirl_status see_motion(const look *at, const whirl_machine *machine, const whirl_integrate_options *options) {
    whirl_record_options record = whirl_record_default();
    whirl_integrate_options integrate = *options;
    whirl_record *seen = NULL;
    record.transient = at->transient;
    record.record = record.watch = at->record;
    record.waveform_revolutions = 0;
    integrate.limit = 1e300;
    whirl_system alone = *machine->system;
    alone.lanes = NULL; // a single motion fills no lanes
    const whirl_status status = whirl_record_motion(&alone, &integrate, &record, machine->start, NULL, &seen);
    const bool whole = status.code == WHIRL_OK && seen->motion == WHIRL_BOUNDED && *at->system->calls_left >= 0;
    for (size_t k = 0; whole && k < alone.dimension; k++) {
        raise_size(at, k, seen->low[k]);
        raise_size(at, k, seen->high[k]);
    }
    const bool lost = status.code == WHIRL_OK && !whole && at->transient > 0;
    for (size_t k = 0; lost && k < alone.dimension; k++) at->sizes[k] = INFINITY;
    whirl_record_free(seen);
    return status;
}

/// Observes the first, the middle and the last point.
static whirl_status see_points(const whirl_study *study, const look *at) {
    const whirl_batch *batch = &study->batches[0];
    const size_t points[] = {0, batch->count / 2, batch->count - 1}, count = batch->count < 3 ? batch->count : 3;
    double slopes[USER_MAX_STATES];
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        whirl_batch one = *batch;
        whirl_machine machine;
        if (batch->second_values) one.second_value = batch->second_values[points[i]];
        if (batch->third_values) one.third_value = batch->third_values[points[i]];
        status = study->machine(study->family, &one, batch->values ? batch->values[points[i]] : 0.0, &machine);
        if (status.code != WHIRL_OK) break;
        *at->system->calls_left = most_calls * (at->transient + at->record + 1);
        if (at->record > 0)
            status = see_motion(at, &machine, &batch->integrate);
        else
            see_start(at, &machine, slopes);
        if (machine.release) machine.release(machine.owner);
    }
    return status;
}

static bool is_ordinary(double size) {
    return size == 0.0 || (size >= smallest && size <= largest);
}

/// Returns true if every coordinate has an ordinary size or a given scale.
static bool are_ordinary(const whirl_user_system *system, const double *sizes) {
    for (size_t k = 0; k < system->dimension; k++)
        if (!is_ordinary(sizes[k]) && !(system->scales && system->scales[k] > 0.0)) return false;
    return true;
}

static double nearest_power(double size) {
    return exp2(round(log2(size)));
}

/// Returns the unit of coordinate k for its size.
static double scales_unit_of(const whirl_user_system *system, size_t k, double size) {
    const bool is_angle = system->angles && system->angles[k] > 0.0;
    return is_angle || is_ordinary(size) ? 1.0 : nearest_power(size);
}

/// Gives each displacement and its velocity one unit.
static void pair_units(whirl_user_system *system) {
    const size_t d = system->displacements;
    for (size_t k = 0; k < d; k++)
        system->units[k] = system->units[d + k] = nearest_power(sqrt(system->units[k] * system->units[d + k]));
}

/// Sets units by observed sizes [4][dimension]: of the first revolutions, of half of a longer time, of all of it, and
/// of the start with its slopes. A coordinate that keeps growing has no definite size, and one that was not observed no
/// known size: that of the start is used or, if it is 0, that of the first revolutions.
static void take_sizes(whirl_user_system *system, const double *sizes) {
    const size_t n = system->dimension;
    for (size_t k = 0; k < n; k++) {
        const double at_once = sizes[k], half = fmax(at_once, sizes[n + k]), all = fmax(half, sizes[2 * n + k]);
        const double start = sizes[3 * n + k] > 0.0 ? sizes[3 * n + k] : at_once;
        const double size = all > 0.0 && all <= steady * half ? all : start;
        system->units[k] = scales_unit_of(system, k, size);
    }
    pair_units(system);
}

static void take_given(whirl_user_system *system) {
    const size_t d = system->displacements;
    for (size_t k = 0; system->scales && k < system->dimension; k++) {
        if (!(system->scales[k] > 0.0)) continue;
        system->units[k] = system->scales[k];
        if (k < 2 * d) system->units[k < d ? d + k : k - d] = system->scales[k];
    }
}

/// Widens the bound of motions, which may grow to sizes that were not observed: no bound becomes tighter than without
/// scales.
static void widen_limit(const whirl_user_system *system, whirl_study *study) {
    double least = 1.0;
    for (size_t k = 0; k < system->dimension; k++)
        if (!(system->scales && system->scales[k] > 0.0)) least = fmin(least, system->units[k]);
    for (size_t i = 0; i < study->batch_count; i++) study->batches[i].integrate.limit /= least;
}

/// Observes the sizes [4][dimension] for take_sizes: in the first revolutions and, if these are not ordinary, in both
/// halves of a longer time, for which coordinates are scaled by their starts.
static whirl_status see_sizes(whirl_user_system *system, const whirl_study *study, double *sizes) {
    enum { AT_ONCE = 2, LONGER = 64 };
    const size_t n = system->dimension;
    double *units = system->units;
    system->units = NULL;
    whirl_status status = see_points(study, &(look){system, 0, 0, sizes});
    system->units = units;
    for (size_t k = 0; k < n; k++) units[k] = scales_unit_of(system, k, sizes[k]);
    pair_units(system);
    memcpy(sizes + 3 * n, sizes, n * sizeof *sizes);
    memset(sizes, 0, n * sizeof *sizes);
    if (status.code == WHIRL_OK) status = see_points(study, &(look){system, 0, AT_ONCE, sizes});
    if (status.code != WHIRL_OK || are_ordinary(system, sizes)) return status;
    status = see_points(study, &(look){system, 0, LONGER / 2, sizes + n});
    return status.code == WHIRL_OK ? see_points(study, &(look){system, LONGER / 2, LONGER / 2, sizes + 2 * n}) : status;
}

whirl_status user_choose_units(whirl_user_system *copy, whirl_study *study) {
    const size_t n = copy->dimension;
    long calls = 0;
    bool counts = false;
    copy->units = NULL;
    whirl_status status = scales_check(copy);
    if (status.code != WHIRL_OK) return status;
    double *sizes = calloc(4 * n, sizeof *sizes);
    copy->units = malloc(n * sizeof *copy->units);
    if (!sizes || !copy->units) {
        free(sizes);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for scales");
    }
    // Choose units by observed sizes. If a motion cannot be observed, the study itself reports why.
    copy->calls_left = &calls;
    if (see_sizes(copy, study, sizes).code != WHIRL_OK) memset(sizes, 0, 4 * n * sizeof *sizes);
    copy->calls_left = NULL;
    take_sizes(copy, sizes);
    take_given(copy);
    free(sizes);
    // Keep the units unless all are 1.
    for (size_t k = 0; k < n; k++) counts = counts || copy->units[k] != 1.0;
    if (counts) {
        widen_limit(copy, study);
        return status;
    }
    free(copy->units);
    copy->units = NULL;
    return status;
}

void user_put_units(const whirl_user_system *system, FILE *out) {
    char number[NUMBER_SIZE];
    for (size_t k = 0; k < system->dimension; k++) {
        number_text(system->units[k], number);
        fprintf(out, "%s%s", k > 0 ? ", " : "; coordinates in ", number);
    }
}

whirl_status user_warn_of_units(const whirl_user_system *system, whirl_result *result) {
    const double far = 1e4;
    char text[256];
    size_t least = 0, most = 0;
    for (size_t k = 0; system->units && k < system->dimension; k++) {
        if (system->units[k] < system->units[least]) least = k;
        if (system->units[k] > system->units[most]) most = k;
    }
    const bool given = system->scales && system->scales[least] > 0.0 && system->scales[most] > 0.0;
    if (!system->units || given || !(system->units[most] > far * system->units[least])) return whirl_ok();
    snprintf(
        text, sizeof text,
        "coordinates %zu and %zu have very different sizes, about %.1g and %.1g: their scales are taken from the first "
        "revolutions; give them where motions have other sizes later",
        least, most, system->units[least], system->units[most]);
    return whirl_result_add_fact(result, "warning 1", text);
}
