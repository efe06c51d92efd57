// Coexisting attractors on which a chaotic motion may end. After a boundary crisis, chaotic transients can last
// thousands of revolutions near the former attractor; they end on a stable motion in the region that they visit. See
// docs/theory.md, "Transient chaos".
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/stable_orbits.h"

/// Margin around the motion's box within which an attractor counts as near, over the size of the box.
static const double margin = 0.1;

/// Returns true if x [dimension] is in the box of the record, or near it.
static bool coexisting_is_within(const whirl_record *record, const double *x) {
    for (size_t i = 0; i < record->dimension; i++) {
        const double reach = margin * (record->high[i] - record->low[i]);
        if (!(x[i] >= record->low[i] - reach && x[i] <= record->high[i] + reach)) return false;
    }
    return true;
}

/// Returns true if the equations do not depend on time; `work` has 2 dimension + forcing_count numbers.
static bool coexisting_is_free(const whirl_system *system, const double *x, double *work) {
    enum { INSTANTS = 7 };
    const size_t d = system->dimension;
    for (int k = 0; k < INSTANTS; k++) {
        const double t = system->period * k / INSTANTS;
        if (system->forcing) system->forcing(system->model, t, work + 2 * d);
        system->rhs(system->model, t, work + 2 * d, x, work + (k > 0 ? d : 0));
        if (k > 0 && memcmp(work, work + d, d * sizeof *work) != 0) return false;
    }
    return true;
}

/// Searches a stable equilibrium from some states of the section.
static whirl_status coexisting_rest(const whirl_system *system, const whirl_record *record, int *coexisting) {
    enum { STATES = 8 };
    const size_t d = record->dimension;
    double *work = malloc((2 * d + system->forcing_count + 1) * sizeof *work);
    const bool free_of_time =
        work && record->section_count >= STATES && coexisting_is_free(system, record->section, work);
    whirl_status status = work ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for an equilibrium");
    for (size_t k = 0; k < STATES && free_of_time && *coexisting == 0 && status.code == WHIRL_OK; k++) {
        whirl_modes *modes;
        status = whirl_modes_new(system, record->section + k * (record->section_count / STATES) * d, &modes);
        if (status.code == WHIRL_OK && modes->growth < 0.0 && coexisting_is_within(record, modes->rest))
            *coexisting = WHIRL_COEXISTING_AT_REST;
        if (status.code != WHIRL_NO_MEMORY) status = whirl_ok(); // this state leads to no equilibrium
        whirl_modes_free(modes);
    }
    free(work);
    return status;
}

/// Number of orbit searches. They start near states of the section, from its end backwards at equal distances.
enum { STARTS = 32 };

/// Returns the options for orbit searches: the motion's own method, or one that is exact enough to tell stability.
static whirl_collect_options coexisting_options(const whirl_integrate_options *integrate, const double *low,
                                                const double *high, const double *around) {
    const whirl_method *method;
    whirl_collect_options options = whirl_collect_default(low, high);
    options.starts = options.around_count = STARTS;
    options.around = around;
    options.settle = 40;
    options.most_revolutions = 200;
    options.longest = 16;
    options.orbit.integrate = *integrate;
    options.orbit.tolerance = 1e-9;
    options.orbit.most_steps = 8;
    whirl_integrate_options *own = &options.orbit.integrate;
    const bool follows = whirl_method_find(own->method, &method).code == WHIRL_OK && method->follows;
    if (!follows) snprintf(own->method, sizeof own->method, "auto");
    if (!follows || whirl_method_is_adaptive(own->method)) own->rtol = fmin(own->rtol, 1e-10);
    return options;
}

/// Searches a stable orbit to which motions lead from near states of the section.
static whirl_status coexisting_orbits(const whirl_system *system, const whirl_integrate_options *integrate,
                                      const whirl_record *record, int *coexisting) {
    const size_t d = record->dimension, apart = record->section_count / STARTS;
    double *low = malloc(2 * d * sizeof *low), *around = malloc(STARTS * d * sizeof *around);
    whirl_status status = low && around ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for orbits");
    whirl_collection *found = NULL;
    for (size_t i = 0; i < d && status.code == WHIRL_OK; i++) {
        low[d + i] = margin * (record->high[i] - record->low[i]);
        low[i] = -low[d + i];
    }
    for (size_t k = 0; k < STARTS && status.code == WHIRL_OK; k++)
        memcpy(around + k * d, record->section + (record->section_count - 1 - k * apart) * d, d * sizeof *around);
    const whirl_collect_options options = coexisting_options(integrate, low, low + d, around);
    if (status.code == WHIRL_OK) status = whirl_orbit_collect(system, &options, &found);
    for (size_t i = 0; status.code == WHIRL_OK && i < found->count; i++)
        if (*coexisting == 0 || (int)found->orbits[i]->revolutions < *coexisting)
            *coexisting = (int)found->orbits[i]->revolutions;
    whirl_collection_free(found);
    free(around);
    free(low);
    return status;
}

whirl_status whirl_record_coexisting(const whirl_system *system, const whirl_integrate_options *integrate,
                                     const whirl_record *record, int *coexisting) {
    *coexisting = 0;
    if (!system->tangent || system->turns || record->motion != WHIRL_BOUNDED || record->section_count == 0)
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "the search for coexisting attractors needs a Jacobian and a bounded motion without turning phases");
    const whirl_status status = coexisting_rest(system, record, coexisting);
    return status.code != WHIRL_OK || *coexisting != 0 ? status
                                                       : coexisting_orbits(system, integrate, record, coexisting);
}
