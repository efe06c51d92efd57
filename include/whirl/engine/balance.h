/// Balancing: from vibrations with and without trial weights, or a model, to weights that reduce them: by influence
/// coefficients of planes, or of sets of weights that act on one mode each; and trial weights that a model proposes.
///
/// Vectors are complex numbers, real and imaginary part: of unbalance (kg m) U exp(i a), the angle a on the rotor from
/// its mark with the rotation; of vibration A exp(-i l), the lag l of its peak behind the mark. Amplitudes may be of
/// any kind and unit, one for all.
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

/// As in whirl/engine/case.h.
struct whirl_problems;
/// As in whirl/engine/findings.h.
struct whirl_findings;

/// Bounds of balancing.
enum {
    WHIRL_MAX_PLANES = 16,        ///< that weights are put in; of modes, too
    WHIRL_MAX_BALANCE_PROBES = 64 ///< of which more is said than what they saw
};

/// whirl_balance_trial.plane of a set of weights.
#define WHIRL_BALANCE_SET ((size_t)-1)

/// A plane in which weights are put.
typedef struct whirl_balance_plane {
    char name[WHIRL_NAME_SIZE]; ///< as trials call it
    double radius;              ///< m, at which weights sit; 0: not said
    double limit;               ///< kg m that its weight may have at most; infinite: any
    int holes;                  ///< evenly spaced; 0: anywhere
    double first_hole;          ///< rad, of hole 1, with the rotation; the others follow the way that angles are told
    char station[WHIRL_NAME_SIZE]; ///< of the model
    double position;               ///< m along the rotor; NaN: not said
} whirl_balance_plane;

/// A trial weight, or set of them, that a run had.
typedef struct whirl_balance_trial {
    int run;          ///< number of the run
    size_t plane;     ///< index, or WHIRL_BALANCE_SET for the set of a mode, namely
    size_t mode;      ///< index
    double moment[2]; ///< kg m; of a set by what its weights are multiplied, the largest of which is 1
} whirl_balance_trial;

/// What is known of a probe beside what it saw.
typedef struct whirl_balance_probe {
    char name[WHIRL_NAME_SIZE], station[WHIRL_NAME_SIZE]; ///< its own, and of the model
    double angle;                                         ///< rad from the model's x axis towards y
    double limit, repeatability; ///< amplitudes: not to be exceeded (infinite: none), and that mean nothing
} whirl_balance_probe;

/// A mode that is balanced by itself.
typedef struct whirl_balance_mode {
    double speed;                   ///< rad/s, near its critical speed
    bool shaped;                    ///< its shape is told
    double shape[WHIRL_MAX_PLANES]; ///< at the planes
} whirl_balance_mode;

/// What a probe saw in a run.
typedef struct whirl_balance_vibration {
    int run;                     ///< number of the run
    double speed;                ///< rad/s
    char probe[WHIRL_NAME_SIZE]; ///< its name
    double vibration[2];         ///< as above
    double weight;               ///< by which its square counts
} whirl_balance_vibration;

/// An influence coefficient that is known beforehand.
typedef struct whirl_balance_coefficient {
    size_t plane;                ///< index
    double speed;                ///< rad/s
    char probe[WHIRL_NAME_SIZE]; ///< its name
    double influence[2];         ///< vibration a kg m in the plane
} whirl_balance_coefficient;

/// What is known of a rotor that is to be balanced. Arrays are its own.
typedef struct whirl_balance {
    char title[256];                                  ///< in one line
    char units[64];                                   ///< in which numbers are shown (whirl/engine/shown.h), or ""
    bool against, leads;                              ///< how the file tells angles on the rotor, and phases
    char counted[8];                                  ///< how its amplitudes are: "0-p", "p-p", "rms"; "" not said
    size_t plane_count, trial_count, vibration_count; ///< of these
    whirl_balance_plane planes[WHIRL_MAX_PLANES];     ///< [plane_count]
    whirl_balance_trial *trials;                      ///< [trial_count]
    whirl_balance_vibration *vibrations;              ///< [vibration_count]
    size_t slow_roll_count;                           ///< of slow_rolls
    whirl_balance_vibration *slow_rolls; ///< [slow_roll_count] what probes see of the shaft itself; taken off readings
    size_t coefficient_count;            ///< of coefficients; 0: they are found
    whirl_balance_coefficient *coefficients; ///< [coefficient_count]
    double mass, grade, service_speed;       ///< kg, mm/s, rad/s of what ISO 21940-11 allows; 0: not said
    char model[256];                         ///< path of a case, from where the file is; "": none
    bool by_model;                           ///< influence coefficients are the model's, in place of those of runs
    double model_error;                      ///< by which share of it the model's critical speeds may be wrong
    double kind;                             ///< amplitude of the file over one from zero to peak
    double keyphasor;                        ///< rad from the model's x axis towards y, where the mark is seen
    size_t probe_count;                      ///< of probes
    whirl_balance_probe probes[WHIRL_MAX_BALANCE_PROBES]; ///< [probe_count]
    size_t mode_count;                                    ///< of modes; 0: planes are balanced, not modes
    whirl_balance_mode modes[WHIRL_MAX_PLANES];           ///< [mode_count]
    bool keep_rigid; ///< sets of weights have no resultant and no couple: N + 2 planes for N modes
    bool least_max;  ///< the largest root of weight times |vibration| is to be the least, in place of the squares
} whirl_balance;

/// What a model says of a probe at a speed.
typedef struct whirl_modelled_row {
    double speed;                           ///< rad/s
    const char *probe;                      ///< of the whirl_balance
    double influence[WHIRL_MAX_PLANES][2];  ///< a kg m in each plane, in the amplitudes of the file
    double shifted[2][WHIRL_MAX_PLANES][2]; ///< the same, were critical speeds higher, and lower, by model_error
} whirl_modelled_row;

/// What a model says of a rotor that is to be balanced.
typedef struct whirl_balance_model {
    size_t row_count;                                    ///< of rows
    whirl_modelled_row *rows;                            ///< [row_count]
    char bearing[WHIRL_MAX_PLANES][WHIRL_NAME_SIZE];     ///< station of the bearing nearest to each plane, or ""
    double load[WHIRL_MAX_PLANES];                       ///< N that it carries at rest; NaN: not known
    double position[WHIRL_MAX_PLANES];                   ///< m, of planes along their shaft; NaN: on none
    double natural[WHIRL_MAX_PLANES];                    ///< rad/s, of the modes without a shape in the file
    double shape[WHIRL_MAX_PLANES][WHIRL_MAX_PLANES][2]; ///< of these: how weights in the planes excite them, at most 1
} whirl_balance_model;

/// A probe at a speed: what is to be reduced.
typedef struct whirl_balance_row {
    double speed;                          ///< rad/s
    const char *probe;                     ///< of the whirl_balance
    double weight;                         ///< by which its square counts
    double before[2], after[2];            ///< vibration without weights, and with the correction
    double influence[WHIRL_MAX_PLANES][2]; ///< a kg m in each plane, or of each set (whirl_correction.by_set)
    const whirl_modelled_row *model;       ///< what the model says of it, borrowed, or NULL
    double worst;                          ///< of |after|, were the model's critical speeds wrong; NaN: no model's
} whirl_balance_row;

/// What decides how large a trial weight is.
typedef enum whirl_trial_reason {
    WHIRL_TRIAL_BY_FORCE,  ///< its force is a tenth of the load on the bearing
    WHIRL_TRIAL_BY_LEAST,  ///< a tenth would hardly be seen: a probe changes by 30 %, and 5 times its repeatability
    WHIRL_TRIAL_BY_MOST,   ///< a tenth would change a probe by more than 100 %
    WHIRL_TRIAL_BY_LIMIT,  ///< more would take a probe beyond its limit
    WHIRL_TRIAL_BY_NOTHING ///< nothing that was read near its speed vibrates: there is none
} whirl_trial_reason;

/// A trial weight of a plane, or for the set of a mode, that a model proposes.
typedef struct whirl_balance_proposal {
    double moment[2];          ///< kg m, of a set as whirl_balance_trial has it
    whirl_trial_reason reason; ///< of its size
    double speed, load;        ///< rad/s, N: of the force that it goes by; load NaN: not known
    size_t bearing;            ///< plane whose bearing that is
    size_t row;                ///< of the correction, which decides or else changes most
    double change;             ///< of that row's vibration, over what it is
    bool unclear;              ///< no probe changes by 30 % and 5 times its repeatability
    size_t over;               ///< row that the model predicts above its limit, or row_count
    double predicted[2];       ///< vibration of that row, else of the one that decides
} whirl_balance_proposal;

/// The correction without the plane or set that is least needed.
typedef struct whirl_balance_reduced {
    bool there;                         ///< an unknown acts nearly as the others do
    size_t without;                     ///< index of the plane, or of the set where there are modes
    double moment[WHIRL_MAX_PLANES][2]; ///< kg m in the planes
    double left;                        ///< as whirl_correction.left
} whirl_balance_reduced;

/// Significance below which a plane acts nearly as the others do (Darlow 1982).
#define WHIRL_BALANCE_SIGNIFICANT 0.2

/// The correction that makes the sum of weight |vibration|^2 the least, or the largest of them
/// (whirl_balance.least_max).
typedef struct whirl_correction {
    size_t row_count;                   ///< of rows
    whirl_balance_row *rows;            ///< [row_count]
    double moment[WHIRL_MAX_PLANES][2]; ///< kg m
    bool found;                         ///< there are weights; false where nothing was tried yet: all are 0 then
    bool by_set;                        ///< influence is that of sets
    double left;                        ///< root of the weighted mean of |after|^2, or the largest |after|
    double condition;                   ///< of the influence matrix: largest over smallest singular value
    /// Of each plane, or set where there are modes: the part of its effect that no combination of the others has, over
    /// all of its effect (Darlow 1982); NaN of those that the correction has not.
    double significance[WHIRL_MAX_PLANES];
    whirl_balance_reduced reduced; ///< the correction without one of them, if that is hardly needed
    size_t set_count;              ///< of sets: whirl_balance.mode_count
    double sets[WHIRL_MAX_PLANES][WHIRL_MAX_PLANES][2]; ///< weights in the planes that act on a mode alone
    bool used[WHIRL_MAX_PLANES];                        ///< whether the correction has this set
    double amount[WHIRL_MAX_PLANES][2];                 ///< kg m, of each set
    size_t proposal_count;                              ///< of planes, or of sets where there are some; 0: none
    whirl_balance_proposal proposals[WHIRL_MAX_PLANES]; ///< [proposal_count]
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

/// What the model of the file says, a case that is read from beside `path`, the file's own: small motions about where
/// the machine rests at each speed, its static loads, and its modes, which are those that answer most to weights in the
/// planes at their speeds. *model NULL where the file names none. Problems are those of the case. WHIRL_BAD_INPUT with
/// a sentence. Freed by whirl_balance_model_free.
whirl_status whirl_balance_consult(const whirl_balance *balance, const char *path, struct whirl_problems *problems,
                                   whirl_balance_model **model);

/// Frees it; NULL is none.
void whirl_balance_model_free(whirl_balance_model *model);

/// Influence coefficients by least squares over all runs, vibration = before + sum of influence times trial, or the
/// model's, and from them the correction (Goodman 1964); with modes that of the sets of weights which excite one of
/// them and none of the others, the shortest ones of these. Without trials the model proposes some. Rows are in the
/// order in which probes and speeds come first. model: NULL, or must outlive the correction. WHIRL_BAD_INPUT with a
/// sentence where a row has fewer runs than planes and one, trials tell some planes not apart, planes are too few for
/// the modes, or a model is needed; WHIRL_NO_MEMORY. Freed by whirl_correction_free.
whirl_status whirl_balance_solve(const whirl_balance *balance, const whirl_balance_model *model,
                                 whirl_correction **correction);

/// The weight in a plane that the proposal of an index puts there.
void whirl_balance_proposed(const whirl_correction *correction, size_t proposal, size_t plane, double moment[2]);

/// Frees it; NULL is none.
void whirl_correction_free(whirl_correction *correction);

/// Splits a moment (kg m) on the two holes of a plane beside its angle: hole [2] from 1, moments [2]; what stands at a
/// hole goes there alone, moments[1] is 0 then. The plane has three holes or more.
void whirl_balance_split(const whirl_balance *balance, size_t plane, const double moment[2], int hole[2],
                         double moments[2]);

/// kg m of residual unbalance that ISO 21940-11 allows in all, mass grade/speed (grade in mm/s; the edition that counts
/// is for the user to check); NaN where mass, grade or speed are not said.
double whirl_balance_allowed(const whirl_balance *balance);

/// The largest difference of the model's influence coefficients from those of runs, over the largest of these; NaN
/// where there are not both.
double whirl_balance_difference(const whirl_balance *balance, const whirl_correction *correction);

/// What was found, in the units that `units` (NULL: the file) says (whirl_shown_units_alone); amplitudes are counted as
/// the file has them where no unit says how. Borrows nothing. Freed by whirl_findings_free. WHIRL_NO_MEMORY,
/// WHIRL_BAD_INPUT for words that are no units.
whirl_status whirl_balance_findings(const whirl_balance *balance, const whirl_balance_model *model,
                                    const whirl_correction *correction, const char *units,
                                    struct whirl_findings **findings);

/// Writes it as one JSON object: moments in kg m, amplitudes in m, angles in radians as the file tells them; and the
/// findings, in these units. WHIRL_NO_MEMORY, WHIRL_BAD_INPUT.
whirl_status whirl_balance_write_json(const whirl_balance *balance, const whirl_balance_model *model,
                                      const whirl_correction *correction, const char *units, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
