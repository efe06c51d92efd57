/// Verification: how far states, exponents and verdicts depend on the method and its tolerance.
#ifndef WHIRL_VERIFY_H
#define WHIRL_VERIFY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/analyze.h"
#include "whirl/engine/film_tables.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/study.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Methods that are compared, and tolerances of each.
enum { WHIRL_VERIFY_METHODS = 2, WHIRL_VERIFY_LEVELS = 3 };

/// By what points are verified.
typedef struct whirl_verify_options {
    /// The second method, an adaptive one; "": the first adaptive method of whirl_method_at that is not the batch's.
    char method[WHIRL_NAME_SIZE];
    int revolutions; ///< from the start, after which states are compared; >= 1
} whirl_verify_options;

/// What one method says of a point at one tolerance.
typedef struct whirl_verify_run {
    /// Largest of a coordinate from the reference after the revolutions, state's units; NaN: diverged
    double difference;
    double section; ///< largest distance of a point of the section from the nearest one of the reference, in the
                    ///< coordinates of the stations, where both motions are periodic with the same period; else NaN
    whirl_verdict verdict; ///< the exponent's error with its difference from the same method's next tolerance
} whirl_verify_run;

/// What all methods and tolerances say of a point.
typedef struct whirl_verify_point {
    double value;  ///< of the parameter, NaN when nothing varies
    double second; ///< of the second parameter of a map or basin, else NaN
    double third;  ///< of the third parameter of a map, else NaN
    whirl_verify_run runs[WHIRL_VERIFY_METHODS][WHIRL_VERIFY_LEVELS]; ///< by method, then by tolerance
    /// By the states of the three levels: the order in the step of a fixed-step method, the power of the tolerance of
    /// an adaptive one. NaN where rounding (differences below 1e-13 of the state) or chaos (above 0.1) leaves nothing
    /// to see.
    double order[WHIRL_VERIFY_METHODS];
    double exponent_spread; ///< largest difference between the exponents of any two runs; NaN where one has none
    bool agreed;            ///< all runs give the same regime and period
} whirl_verify_point;

/// The first method is that of the study: with its steps, two and four times as many, or at its tolerances, a tenth and
/// a hundredth of them. So is the second one, whose last level is the reference of all differences.
typedef struct whirl_verification {
    char table[WHIRL_NAME_SIZE], parameter[WHIRL_NAME_SIZE]; ///< whose points they are, and what varies
    char second[WHIRL_NAME_SIZE];                            ///< of a map or basin, else ""
    char third[WHIRL_NAME_SIZE];                             ///< of a map with planes, else ""
    char film_tables[WHIRL_FILM_TABLES_TEXT];                ///< whirl_result_film_tables of the first method's runs
    int revolutions;                                         ///< after which states are compared
    whirl_integrate_options integrate[WHIRL_VERIFY_METHODS][WHIRL_VERIFY_LEVELS]; ///< by what they were computed
    size_t count;                                                                 ///< of points
    whirl_verify_point *points;                                                   ///< [count]
} whirl_verification;

/// Computes the points of a study of one batch, each from its machine's start, by both methods at three tolerances.
/// Progress is told for each method. WHIRL_BAD_INPUT for options that make no sense or a method that is unknown, not
/// adaptive or the batch's own; WHIRL_STOPPED without a verification. Freed by whirl_verification_free.
whirl_status whirl_study_verify(const whirl_study *study, const whirl_verify_options *options,
                                const whirl_run_options *run, whirl_verification **verification);

/// Frees a verification; NULL is none.
void whirl_verification_free(whirl_verification *verification);

/// Writes the verification as one JSON document.
whirl_status whirl_verification_write_json(const whirl_verification *verification, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
