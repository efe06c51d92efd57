/// Balancing by influence coefficients: from vibrations with and without trial weights to weights that reduce them.
///
/// Vectors are complex numbers, real and imaginary part: of unbalance (kg m) U exp(i a), the angle a on the rotor from
/// its mark with the rotation; of vibration A exp(-i l), the lag l of its peak behind the mark. Amplitudes may be of
/// any kind and unit, one for all.
#ifndef WHIRL_BALANCE_H
#define WHIRL_BALANCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/descriptor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// As in whirl/case.h.
struct whirl_problems;

/// The most planes that weights are put in.
enum { WHIRL_MAX_PLANES = 16 };

/// A plane in which weights are put.
typedef struct whirl_balance_plane {
    char name[WHIRL_NAME_SIZE]; ///< as trials call it
    double radius;              ///< m, at which weights sit; 0: not said
    int holes;                  ///< evenly spaced; 0: anywhere
    double first_hole;          ///< rad, of hole 1, with the rotation; the others follow the way that angles are told
} whirl_balance_plane;

/// A trial weight that a run had.
typedef struct whirl_balance_trial {
    int run;          ///< number of the run
    size_t plane;     ///< index
    double moment[2]; ///< kg m
} whirl_balance_trial;

/// What a probe saw in a run.
typedef struct whirl_balance_vibration {
    int run;                     ///< number of the run
    double speed;                ///< rad/s
    char probe[WHIRL_NAME_SIZE]; ///< its name
    double vibration[2];         ///< as above
    double weight;               ///< by which its square counts
} whirl_balance_vibration;

/// What is known of a rotor that is to be balanced. Arrays are its own.
typedef struct whirl_balance {
    char title[256];                                  ///< in one line
    bool against, leads;                              ///< how the file tells angles on the rotor, and phases
    size_t plane_count, trial_count, vibration_count; ///< of these
    whirl_balance_plane planes[WHIRL_MAX_PLANES];     ///< [plane_count]
    whirl_balance_trial *trials;                      ///< [trial_count]
    whirl_balance_vibration *vibrations;              ///< [vibration_count]
    double mass, grade, service_speed;                ///< kg, mm/s, rad/s of what ISO 21940-11 allows; 0: not said
} whirl_balance;

/// A probe at a speed: what is to be reduced.
typedef struct whirl_balance_row {
    double speed;                          ///< rad/s
    const char *probe;                     ///< of the whirl_balance
    double weight;                         ///< by which its square counts
    double before[2], after[2];            ///< vibration without weights, and with the correction
    double influence[WHIRL_MAX_PLANES][2]; ///< a kg m in each plane
} whirl_balance_row;

/// The correction that makes sum of weight |vibration|^2 the least.
typedef struct whirl_correction {
    size_t row_count;                   ///< of rows
    whirl_balance_row *rows;            ///< [row_count]
    double moment[WHIRL_MAX_PLANES][2]; ///< kg m
} whirl_correction;

/// Reads a file (YAML, docs/guide/14-balancing.md). Problems as for cases. Freed by whirl_balance_free.
whirl_status whirl_balance_load(const char *path, struct whirl_problems *problems, whirl_balance **balance);

/// The same from memory; `name` stands for the file in messages.
whirl_status whirl_balance_parse(const char *text, size_t length, const char *name, struct whirl_problems *problems,
                                 whirl_balance **balance);

/// Frees it; NULL is none.
void whirl_balance_free(whirl_balance *balance);

/// The groups of keys of such a file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_balance_groups(void);

/// Influence coefficients by least squares over all runs, vibration = before + sum of influence times trial, and from
/// them the correction (Goodman 1964). Rows are in the order in which probes and speeds come first. WHIRL_BAD_INPUT
/// with a sentence where a row has fewer runs than planes and one, or trials tell some planes not apart;
/// WHIRL_NO_MEMORY. Freed by whirl_correction_free.
whirl_status whirl_balance_solve(const whirl_balance *balance, whirl_correction **correction);

/// Frees it; NULL is none.
void whirl_correction_free(whirl_correction *correction);

/// Splits a moment (kg m) on the two holes of a plane beside its angle: hole [2] from 1, moments [2]; what stands at a
/// hole goes there alone, moments[1] is 0 then. The plane has three holes or more.
void whirl_balance_split(const whirl_balance *balance, size_t plane, const double moment[2], int hole[2],
                         double moments[2]);

/// kg m of residual unbalance that ISO 21940-11 allows in all, mass grade/speed (grade in mm/s; the edition that counts
/// is for the user to check); NaN where mass, grade or speed are not said.
double whirl_balance_allowed(const whirl_balance *balance);

/// Writes what was found in lines of text, each ended by a line feed: influence, correction, vibration before and
/// after.
whirl_status whirl_balance_write_summary(const whirl_balance *balance, const whirl_correction *correction,
                                         FILE *stream);

/// Writes it as one JSON object: moments in kg m, amplitudes in m, angles in radians as the file tells them.
/// WHIRL_NO_MEMORY.
whirl_status whirl_balance_write_json(const whirl_balance *balance, const whirl_correction *correction, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
