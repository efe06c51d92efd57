/// Verification: dependence of states, exponents and verdicts on the method and its tolerance.
#ifndef WHIRL_VERIFY_H
#define WHIRL_VERIFY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/study.h"
#include "whirl/internal/film_tables.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Number of methods compared, and of tolerances of each.
enum { WHIRL_VERIFY_METHODS = 2, WHIRL_VERIFY_LEVELS = 3 };

/// Options of verification.
typedef struct whirl_verify_options {
    /// The second method, an adaptive one; "": the first adaptive method of whirl_method_at that is not the batch's.
    char method[WHIRL_NAME_SIZE];
    int revolutions; ///< revolutions from the start to the comparison of states, >= 1
} whirl_verify_options;

/// Results of one method for a point at one tolerance.
typedef struct whirl_verify_run {
    /// Largest difference of a coordinate from the reference at that revolution, in the state's units; NaN: diverged.
    double difference;
    /// Largest distance of a point of the section from the nearest one of the reference, in coordinates of the
    /// stations, if both motions have the same period; else NaN.
    double section;
    whirl_verdict verdict; ///< with the exponent's error increased by its difference from the method's next tolerance
} whirl_verify_run;

/// Results of all methods and tolerances for a point.
typedef struct whirl_verify_point {
    double value;                                                     ///< value of the parameter, NaN if nothing varies
    double second;                                                    ///< second parameter of a map or basin, else NaN
    double third;                                                     ///< third parameter of a map, else NaN
    whirl_verify_run runs[WHIRL_VERIFY_METHODS][WHIRL_VERIFY_LEVELS]; ///< by method, then by tolerance
    /// Convergence of the states of the three levels: the order in the step of a fixed-step method, the power of the
    /// tolerance of an adaptive one. NaN if rounding (differences below 1e-13 of the state) or chaos (above 0.1) hides
    /// it.
    double order[WHIRL_VERIFY_METHODS];
    double exponent_spread; ///< largest difference between the exponents of any two runs; NaN if one has none
    bool agreed;            ///< true if all runs give the same regime and period
} whirl_verify_point;

/// Verification of points. The first method is that of the study: with its steps, two and four times as many, or at its
/// tolerances, a tenth and a hundredth of them. The second method has the same tolerances; its last level is the
/// reference of all differences.
typedef struct whirl_verification {
    char table[WHIRL_NAME_SIZE], parameter[WHIRL_NAME_SIZE]; ///< the table, and its varied parameter
    char second[WHIRL_NAME_SIZE];                            ///< second parameter of a map or basin, else ""
    char third[WHIRL_NAME_SIZE];                             ///< third parameter of a map with planes, else ""
    char film_tables[WHIRL_FILM_TABLES_TEXT];                ///< whirl_result_film_tables of the first method's runs
    int revolutions;                                         ///< revolutions to the comparison of states
    whirl_integrate_options integrate[WHIRL_VERIFY_METHODS][WHIRL_VERIFY_LEVELS]; ///< options of each method and level
    size_t count;                                                                 ///< number of points
    whirl_verify_point *points;                                                   ///< [count]
} whirl_verification;

/// Computes the points of a study of one batch, each from its machine's start, by both methods at three tolerances.
/// Progress is reported for each method. WHIRL_BAD_INPUT for invalid options, and for a method that is unknown, not
/// adaptive or the batch's own; WHIRL_STOPPED without a verification. Freed by whirl_verification_free.
whirl_status whirl_study_verify(const whirl_study *study, const whirl_verify_options *options,
                                const whirl_run_options *run, whirl_verification **verification);

/// Frees a verification; accepts NULL.
void whirl_verification_free(whirl_verification *verification);

/// Writes the verification as one JSON document.
whirl_status whirl_verification_write_json(const whirl_verification *verification, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
