/// Tolerances: parameters with distributions, the samples of a study of tolerances, and statistics over them.
///
/// A study of tolerances computes every point of another study at many *samples* of the parameters. Samples are points
/// of scrambled Sobol sequences: `WHIRL_REPLICATES` independent scramblings take turns, so that the differences of
/// their estimates give the error of the whole. With `indices` each sample has parameters + 2 *machines*: the sample A,
/// another sample B, and A with one parameter after the other as in B (Saltelli et al. 2010).
#ifndef WHIRL_TOLERANCES_H
#define WHIRL_TOLERANCES_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of studies of tolerances.
enum {
    WHIRL_MAX_TOLERANCES = 16,   ///< parameters with tolerances
    WHIRL_MIN_SAMPLES = 64,      ///< fewest samples
    WHIRL_MAX_SAMPLES = 1 << 20, ///< most samples
    WHIRL_REPLICATES = 16        ///< independent scramblings, from whose differences standard errors follow
};

/// The distribution of a parameter.
typedef struct whirl_tolerance {
    const char *name; ///< the parameter; borrowed
    double low, high; ///< bounds, in SI; infinite: none
    /// Mean and standard deviation of the normal distribution that the bounds cut off, in SI; deviation 0: uniform.
    double mean, deviation;
} whirl_tolerance;

/// Options of a study of tolerances.
typedef struct whirl_tolerance_options {
    int samples;    ///< number of samples, a power of two; 0: no such study
    int parameters; ///< number of parameters with tolerances
    int seed;       ///< seed of the scrambling
    bool indices;   ///< true to compute also the machines for sensitivity indices
} whirl_tolerance_options;

/// Returns the members of these options for cases (part "tolerances"); static, ended by a member without a part.
const whirl_member *whirl_tolerance_members(void);

/// Returns the number of machines of all samples; 0 without samples.
size_t whirl_tolerance_machines(const whirl_tolerance_options *options);

/// Returns the number of machines of one sample: 1, or parameters + 2 with indices.
size_t whirl_tolerance_each(const whirl_tolerance_options *options);

/// Fills values [options->parameters] with the parameters of a machine, from 0, in SI: a pure function of its
/// arguments. Machine `sample * each` is the sample itself (A), the next one B, then A with parameter i of B.
void whirl_tolerance_values(const whirl_tolerance_options *options, const whirl_tolerance *tolerances, size_t machine,
                            double *values);

/// Returns the quantile of a distribution: a draw is below it with the probability `share`, above 0 and below 1.
double whirl_tolerance_value(const whirl_tolerance *tolerance, double share);

/// Returns coordinate `dimension` (from 0, below 2 * WHIRL_MAX_TOLERANCES) of point `index` of the Sobol sequence with
/// the direction numbers of Joe and Kuo 2008, as 32 binary digits after the point, without scrambling.
unsigned whirl_sobol(size_t index, size_t dimension);

#ifdef __cplusplus
}
#endif
#endif
