/// Balancing: correction weights from vibrations with and without trial weights, or from a model. It uses influence
/// coefficients of planes, or of weight sets that act on one mode each; a model can also propose trial weights.
///
/// Vectors are complex numbers, real and imaginary part. Unbalance (kg m) is U exp(i a), the angle a on the rotor from
/// its mark, with the rotation; vibration is A exp(-i l), the lag l of its peak behind the mark. Amplitudes are of any
/// kind and unit, one for all.
#ifndef WHIRL_BALANCE_H
#define WHIRL_BALANCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Declared in whirl/engine/case.h.
struct whirl_problems;
/// Declared in whirl/internal/findings.h.
struct whirl_findings;

/// Limits of balancing.
enum {
    WHIRL_MAX_PLANES = 16,        ///< planes for weights; also modes
    WHIRL_MAX_BALANCE_PROBES = 64 ///< probes with more data than their readings
};

/// whirl_balance_trial.plane of a weight set.
#define WHIRL_BALANCE_SET ((size_t)-1)

/// A plane for weights.
typedef struct whirl_balance_plane {
    char name[WHIRL_NAME_SIZE]; ///< its name in trials
    double radius;              ///< m, of the weights; 0: not given
    double limit;               ///< largest unbalance of its weight, kg m; infinite: any
    int holes;                  ///< number of evenly spaced holes; 0: any angle
    /// rad, of hole 1, with the rotation; the others follow in the direction in which the file counts angles.
    double first_hole;
    char station[WHIRL_NAME_SIZE]; ///< its station in the model
    double position;               ///< m along the rotor; NaN: not given
} whirl_balance_plane;

/// A trial weight or weight set of a run.
typedef struct whirl_balance_trial {
    int run;          ///< number of the run
    size_t plane;     ///< index, or WHIRL_BALANCE_SET for the set of `mode`
    size_t mode;      ///< index of a set's mode
    double moment[2]; ///< kg m; for a set the factor of its weights, the largest of which is 1
} whirl_balance_trial;

/// Data of a probe, apart from its readings.
typedef struct whirl_balance_probe {
    char name[WHIRL_NAME_SIZE], station[WHIRL_NAME_SIZE]; ///< its name, and its station in the model
    double angle;                                         ///< rad from the model's x axis towards y
    double limit, repeatability; ///< amplitudes: the permitted one (infinite: none), and the smallest meaningful change
} whirl_balance_probe;

/// A mode to be balanced on its own.
typedef struct whirl_balance_mode {
    double speed;                   ///< rad/s, near its critical speed
    bool shaped;                    ///< its shape is given
    double shape[WHIRL_MAX_PLANES]; ///< its shape at the planes
} whirl_balance_mode;

/// A reading of a probe in a run.
typedef struct whirl_balance_vibration {
    int run;                     ///< number of the run
    double speed;                ///< rad/s
    char probe[WHIRL_NAME_SIZE]; ///< its name
    double vibration[2];         ///< A exp(-i l), see the head of this file
    double weight;               ///< factor of its square
} whirl_balance_vibration;

/// An influence coefficient given in the file.
typedef struct whirl_balance_coefficient {
    size_t plane;                ///< index
    double speed;                ///< rad/s
    char probe[WHIRL_NAME_SIZE]; ///< its name
    double influence[2];         ///< vibration per kg m in the plane
} whirl_balance_coefficient;

/// A balancing file. It owns its arrays.
typedef struct whirl_balance {
    char title[256]; ///< in one line
    char units[64];  ///< units in which numbers are shown (whirl/internal/shown.h), or ""
    /// True if the file counts angles on the rotor against the rotation; true if it gives phases as leads, not lags.
    bool against, leads;
    char counted[8];                                  ///< kind of its amplitudes: "0-p", "p-p", "rms"; "" not given
    size_t plane_count, trial_count, vibration_count; ///< lengths of the following arrays
    whirl_balance_plane planes[WHIRL_MAX_PLANES];     ///< [plane_count]
    whirl_balance_trial *trials;                      ///< [trial_count]
    whirl_balance_vibration *vibrations;              ///< [vibration_count]
    size_t slow_roll_count;                           ///< number of slow-roll readings
    whirl_balance_vibration *slow_rolls;     ///< [slow_roll_count] readings of the runout; subtracted from the others
    size_t coefficient_count;                ///< number of coefficients; 0: to be determined
    whirl_balance_coefficient *coefficients; ///< [coefficient_count]
    /// kg, mm/s, rad/s for the permissible residual unbalance of ISO 21940-11; 0: not given.
    double mass, grade, service_speed;
    char model[256];    ///< path of a case, from the folder of the file; "": none
    bool by_model;      ///< influence coefficients come from the model instead of the runs
    double model_error; ///< relative error of the model's critical speeds
    double kind;        ///< factor from zero-to-peak amplitudes to those of the file
    double keyphasor;   ///< rad from the model's x axis towards y, at which the mark is sensed
    size_t probe_count; ///< number of probes
    whirl_balance_probe probes[WHIRL_MAX_BALANCE_PROBES]; ///< [probe_count]
    size_t mode_count;                                    ///< number of modes; 0: planes are balanced, not modes
    whirl_balance_mode modes[WHIRL_MAX_PLANES];           ///< [mode_count]
    bool keep_rigid; ///< weight sets have no resultant and no couple: N + 2 planes for N modes
    bool least_max;  ///< minimize the largest root of weight times |vibration| instead of the sum of squares
} whirl_balance;

/// Influence coefficients of a model for a probe at a speed.
typedef struct whirl_modelled_row {
    double speed;                           ///< rad/s
    const char *probe;                      ///< borrowed from the whirl_balance
    double influence[WHIRL_MAX_PLANES][2];  ///< per kg m in each plane, in amplitudes of the file
    double shifted[2][WHIRL_MAX_PLANES][2]; ///< the same with critical speeds higher, and lower, by model_error
} whirl_modelled_row;

/// A model of a rotor to be balanced.
typedef struct whirl_balance_model {
    size_t row_count;                                ///< number of rows
    whirl_modelled_row *rows;                        ///< [row_count]
    char bearing[WHIRL_MAX_PLANES][WHIRL_NAME_SIZE]; ///< station of the bearing nearest to each plane, or ""
    double load[WHIRL_MAX_PLANES];                   ///< N on that bearing at rest; NaN: not known
    double position[WHIRL_MAX_PLANES];               ///< m, of planes along their shaft; NaN: on no shaft
    double natural[WHIRL_MAX_PLANES];                ///< rad/s, of the modes that have no shape in the file
    /// Shapes of these modes: excitation of each by weights in the planes, scaled to at most 1.
    double shape[WHIRL_MAX_PLANES][WHIRL_MAX_PLANES][2];
} whirl_balance_model;

/// Vibration of a probe at a speed, before and after the correction.
typedef struct whirl_balance_row {
    double speed;                          ///< rad/s
    const char *probe;                     ///< borrowed from the whirl_balance
    double weight;                         ///< factor of its square
    double before[2], after[2];            ///< vibration without weights, and with the correction
    double influence[WHIRL_MAX_PLANES][2]; ///< per kg m in each plane, or for each set (whirl_correction.by_set)
    const whirl_modelled_row *model;       ///< the model's coefficients, borrowed, or NULL
    double worst; ///< largest |after| for the errors of the model's critical speeds; NaN: no model
} whirl_balance_row;

/// Reasons for the size of a proposed trial weight.
typedef enum whirl_trial_reason {
    WHIRL_TRIAL_BY_FORCE,  ///< its force is a tenth of the load on the bearing
    WHIRL_TRIAL_BY_MIN,    ///< a tenth is hardly visible: the weight changes a probe by 30 % and 5 repeatabilities
    WHIRL_TRIAL_BY_MAX,    ///< a tenth would change a probe by more than 100 %
    WHIRL_TRIAL_BY_LIMIT,  ///< more would exceed the limit of a probe
    WHIRL_TRIAL_BY_NOTHING ///< no weight: no reading near its speed has a vibration
} whirl_trial_reason;

/// A trial weight of a plane, or for the set of a mode, proposed by a model.
typedef struct whirl_balance_proposal {
    double moment[2];          ///< kg m, for a set as in whirl_balance_trial
    whirl_trial_reason reason; ///< reason for its size
    double speed, load;        ///< rad/s, N: speed and bearing load that set its force; load NaN: not known
    size_t bearing;            ///< index of the plane next to that bearing
    size_t row;                ///< row of the correction that limits the weight, or else changes most
    double change;             ///< change of that row's vibration, relative to it
    bool unclear;              ///< no probe changes by 30 % and 5 times its repeatability
    size_t over;               ///< row with a predicted vibration above its limit, or row_count
    double predicted[2];       ///< predicted vibration of that row, or else of `row`
} whirl_balance_proposal;

/// The correction without one plane or set that is hardly significant: of several, the one whose removal leaves the
/// least vibration.
typedef struct whirl_balance_reduced {
    bool there;                         ///< true if one plane or set acts nearly as the others do
    size_t without;                     ///< index of the plane, or of the set if there are modes
    double moment[WHIRL_MAX_PLANES][2]; ///< kg m in the planes
    double left;                        ///< remaining vibration as whirl_correction.left
} whirl_balance_reduced;

/// Significance below which a plane acts nearly as the others do (Darlow 1982).
#define WHIRL_BALANCE_SIGNIFICANT 0.2

/// The correction that minimizes the sum of weight |vibration|^2, or the largest of these (whirl_balance.least_max).
typedef struct whirl_correction {
    size_t row_count;                   ///< number of rows
    whirl_balance_row *rows;            ///< [row_count]
    double moment[WHIRL_MAX_PLANES][2]; ///< kg m
    bool found;                         ///< false if no weights were tried yet: all moments are 0
    bool by_set;                        ///< influence is per set
    double left;                        ///< root of the weighted mean of |after|^2, or the largest |after|
    double condition;                   ///< condition of the influence matrix: largest over smallest singular value
    /// Significance of each plane, or of each set if there are modes: the part of its effect that no combination of the
    /// others has, over its whole effect (Darlow 1982); NaN for those that the correction does not use.
    double significance[WHIRL_MAX_PLANES];
    whirl_balance_reduced reduced; ///< the correction without one of them, if that one is hardly needed
    size_t set_count;              ///< number of sets: whirl_balance.mode_count
    double sets[WHIRL_MAX_PLANES][WHIRL_MAX_PLANES][2]; ///< weights in the planes that act on one mode only
    bool used[WHIRL_MAX_PLANES];                        ///< true if the correction uses this set
    double amount[WHIRL_MAX_PLANES][2];                 ///< kg m, factor of each set
    size_t proposal_count; ///< number of planes, or of sets if there are modes; 0: no proposals
    whirl_balance_proposal proposals[WHIRL_MAX_PLANES]; ///< [proposal_count]
} whirl_correction;

/// Reads a balancing file (YAML, docs/guide/14-balancing.md). Problems as for cases. Freed by whirl_balance_free.
whirl_status whirl_balance_load(const char *path, struct whirl_problems *problems, whirl_balance **balance);

/// Does the same from memory; `name` is the file's name in messages.
whirl_status whirl_balance_parse(const char *text, size_t length, const char *name, struct whirl_problems *problems,
                                 whirl_balance **balance);

/// Frees a balancing file; accepts NULL.
void whirl_balance_free(whirl_balance *balance);

/// Returns the groups of keys of such a file, as whirl_case_groups for cases; static, ended by NULL.
const whirl_group *const *whirl_balance_groups(void);

/// Computes the model of the balancing file: the case that it names, relative to the folder of that file (`path`). The
/// model has influence coefficients, from small motions about the equilibrium at each speed, static loads of bearings,
/// and for each mode without a shape the mode that responds most to weights in the planes at its speed. *model is NULL
/// if the file names none. Problems are those of the case. WHIRL_BAD_INPUT with a sentence. Freed by
/// whirl_balance_model_free.
whirl_status whirl_balance_consult(const whirl_balance *balance, const char *path, struct whirl_problems *problems,
                                   whirl_balance_model **model);

/// Frees a model; accepts NULL.
void whirl_balance_model_free(whirl_balance_model *model);

/// Computes the correction (Goodman 1964). Influence coefficients come from least squares over all runs, vibration =
/// before + sum of influence times trial, or from the model. With modes, the correction consists of the shortest weight
/// sets that excite one mode and none of the others. Without trials the model proposes some. Rows are in the order in
/// which probes and speeds first occur. model: NULL, or must outlive the correction. WHIRL_BAD_INPUT with a sentence if
/// a row has fewer runs than planes plus one, trials do not distinguish some planes, there are too few planes for the
/// modes, or a model is needed; WHIRL_NO_MEMORY. Freed by whirl_correction_free.
whirl_status whirl_balance_solve(const whirl_balance *balance, const whirl_balance_model *model,
                                 whirl_correction **correction);

/// Computes the weight in a plane for a proposal, by index.
void whirl_balance_proposed(const whirl_correction *correction, size_t proposal, size_t plane, double moment[2]);

/// Frees a correction; accepts NULL.
void whirl_correction_free(whirl_correction *correction);

/// Splits a moment (kg m) between the two holes of a plane next to its angle: hole [2] from 1, moments [2]. moments[1]
/// is 0 if the angle is that of a hole. With fewer than three holes all of the moment goes to the nearest one.
void whirl_balance_split(const whirl_balance *balance, size_t plane, const double moment[2], int hole[2],
                         double moments[2]);

/// Returns the permissible residual unbalance of ISO 21940-11 for the whole rotor, kg m: mass grade/speed (grade in
/// mm/s; check the edition that applies). NaN if mass, grade or speed are not given.
double whirl_balance_allowed(const whirl_balance *balance);

/// Returns the largest difference between influence coefficients of the model and of the runs, over the largest of the
/// runs; NaN if either are missing.
double whirl_balance_difference(const whirl_balance *balance, const whirl_correction *correction);

/// Builds findings in the units that the words `units` choose, as in whirl_shown_units_alone (NULL: those of the file);
/// amplitudes are of the file's kind unless a unit sets it. Borrows nothing. Freed by whirl_findings_free.
/// WHIRL_NO_MEMORY, WHIRL_BAD_INPUT for words that are not units.
whirl_status whirl_balance_findings(const whirl_balance *balance, const whirl_balance_model *model,
                                    const whirl_correction *correction, const char *units,
                                    struct whirl_findings **findings);

/// Writes all as one JSON object: moments in kg m, amplitudes in m, angles in radians in the sense of the file; and
/// findings in these units. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT.
whirl_status whirl_balance_write_json(const whirl_balance *balance, const whirl_balance_model *model,
                                      const whirl_correction *correction, const char *units, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
