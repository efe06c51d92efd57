/// Analyses: the numbers of one point (one parameter value, one start).
///
/// A motion is first *recorded* (whirl/engine/record.h). Each *analysis* then turns the record into numbers. The
/// numbers of a point form one block of doubles; a *layout* names them. Analyses describe their fields, and case files,
/// result files and exports follow from these descriptions.
#ifndef WHIRL_ANALYZE_H
#define WHIRL_ANALYZE_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/fields.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/record.h"
#include "whirl/engine/system.h"
#include "whirl/engine/torus.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Roles of the points of a table in a study, whatever their analyses.
typedef enum whirl_role {
    WHIRL_ROLE_POINT,    ///< one point at the case's own parameters: "response"
    WHIRL_ROLE_SURVEY,   ///< points along a parameter: "sweep"
    WHIRL_ROLE_DETAIL,   ///< some of these, recorded longer: "detail"
    WHIRL_ROLE_MAP,      ///< points over two or three parameters: "map"
    WHIRL_ROLE_BASIN,    ///< starts of one machine: "basin"
    WHIRL_ROLE_BRANCHES, ///< orbits along a parameter: "branch"
    WHIRL_ROLE_CURVES,   ///< special points over two parameters: "curves"
    WHIRL_ROLE_TORI,     ///< "tori"
    WHIRL_ROLE_MOTIONS,  ///< motions that accompany studies at rest: "motions"
    WHIRL_ROLE_REST,     ///< machines at rest: "modes", "statics", ...
    WHIRL_ROLES
} whirl_role;

/// Returns the name of a role in results: "survey", "detail", ... Static text.
const char *whirl_role_name(whirl_role role);

/// Returns the role of that name; WHIRL_ROLES if there is none.
whirl_role whirl_role_of(const char *name);

// ---------------------------------------------------------------- single analyses, for any record

/// A mean with its standard error.
typedef struct whirl_estimate {
    double value, error; ///< the mean, and its standard error
} whirl_estimate;

/// Estimates the largest Lyapunov exponent per revolution (natural logarithm): the mean growth of a perturbation over
/// the watched revolutions after the first tenth. The error is the standard error of block means, plus the defect of
/// the sum of exponents if all perturbations were followed. NaN if none was followed, or the defect is too large
/// (whirl_lyapunov_spectrum).
whirl_estimate whirl_lyapunov_largest(const whirl_record *record);

/// Estimates all Lyapunov exponents per revolution [dimension], as whirl_lyapunov_largest does. Returns false, with
/// NaN, if not all perturbations were followed, or if the sum of the exponents differs from the mean divergence by more
/// than the standard errors and a thousandth of the exponents' sizes.
bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents);

/// Returns the Kaplan-Yorke dimension of the attractor in the section from exponents [count], largest first: the number
/// of exponents whose sum is not below zero, plus a fraction of the next. Exponents within 3 errors of zero, and within
/// 0.002, count as zero.
double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count);

/// Kinds of motion.
typedef enum whirl_regime {
    WHIRL_UNDETERMINED = 0, ///< the evidence does not decide
    WHIRL_PERIODIC,         ///< it returns after k revolutions: P-k
    WHIRL_QUASI_PERIODIC,   ///< it has incommensurate frequencies of its own
    WHIRL_CHAOTIC,          ///< small perturbations grow
    WHIRL_DIVERGING,        ///< it left its bounds
    WHIRL_NOT_JUDGED        ///< no verdict: the analyses have no regime, or the point is missing
} whirl_regime;

/// Longest period of a verdict.
enum { WHIRL_MAX_PERIOD = 128 };

/// Degrees of trust in a verdict.
typedef enum whirl_confidence { WHIRL_LOW = 0, WHIRL_FAIR, WHIRL_HIGH } whirl_confidence;

/// Remedies that make a verdict more certain.
typedef enum whirl_remedy {
    WHIRL_NO_REMEDY = 0,    ///< no change needed
    WHIRL_LONGER_TRANSIENT, ///< the motion has not settled: run `factor` times as many revolutions
    WHIRL_LONGER_WATCH,     ///< the section has too few points: watch `factor` times as many revolutions
    WHIRL_TIGHTER,          ///< the tolerance decides: reduce errors of a step by `factor`
    WHIRL_MORE_STEPS,       ///< fixed steps are too long: take `factor` times as many, or a method with a tolerance
    WHIRL_OTHER_START       ///< the motion stays on an unstable orbit: start near it (no option of a run does so)
} whirl_remedy;

/// Number of remedies.
enum { WHIRL_REMEDIES = WHIRL_OTHER_START + 1 };

/// Advice for a verdict that is more certain.
typedef struct whirl_advice {
    whirl_remedy remedy; ///< the change
    double factor;       ///< above 1 for remedies other than another start, else 1
} whirl_advice;

/// whirl_verdict.refuge of a coexisting stable equilibrium.
enum { WHIRL_REFUGE_AT_REST = -1 };

/// A verdict with its evidence.
typedef struct whirl_verdict {
    whirl_regime regime; ///< the kind of motion
    int period;          ///< k of P-k for a periodic motion, else 0
    int curves; ///< closed curves in the section of a quasi-periodic motion; 0 if it may be a surface, and for others
    /// Number of independent frequencies of a quasi-periodic motion: 2 for closed curves, and without curves if a phase
    /// that fits no revolution forces it; 3 if the section is a surface and a second exponent is zero; 0 if unknown,
    /// and for others.
    int frequencies;
    double diverged_at; ///< revolution of divergence, else 0
    double limit; ///< whirl_record.limit that a diverging motion exceeded; 0 if another bound ended it, and for others
    int limit_coordinate; ///< coordinate that exceeded it, from 0; 0 if there is no limit
    // trust
    whirl_confidence confidence; ///< trust after the second tolerance, if there was one; at most fair without it
    whirl_confidence agreement;  ///< trust in the evidence of this record for exact steps
    whirl_advice advice;         ///< advice to settle the verdict
    bool confirmed;              ///< true if it was compared with a verdict at another tolerance
    whirl_regime other_regime;   ///< regime at the other tolerance
    int other_period;            ///< k of P-k there, else 0
    double followed;             ///< total revolutions of perturbed copies of a chaotic motion beyond its end
    whirl_regime later_regime;   ///< regime of these copies: the first that is not chaotic
    int later_period;            ///< k of P-k of that copy, else 0
    // evidence
    whirl_estimate exponent; ///< largest Lyapunov exponent per revolution
    /// all perturbations were followed, but the sum of their growth is wrong: all exponents are invalid
    bool exponents_failed;
    double recurrence; ///< smallest over k of the largest return distance |z(n+k) - z(n)|, over the size of the motion
    int recurrence_period; ///< that k (the smallest k below the tolerance, if there is one)
    int longest_period;    ///< longest period searched: 128 if three of them were watched, else fewer
    /// return distance in the last quarter of the watched revolutions over that in the first: below 1 it settles
    double recurrence_trend;
    /// decimal digits to which weighted Birkhoff averages over two halves agree: high on tori, low in chaos
    double regularity;
    double chaos;    ///< K of the 0-1 test, near 1 in chaos, near 0 for regular motion; NaN for P-k
    int neighbours;  ///< quasi-periodic motion: median revolutions between visits of neighbours on a curve, else 0
    int unlocked;    ///< quasi-periodic motion: longest period excluded as locking, else 0
    double rotation; ///< quasi-periodic motion: turns around its closed curve between visits, 0 to 1/2; else NaN
    /// Undetermined motion that drifts evenly along a closed curve: revolutions for one turn around it; else NaN.
    double round;
    whirl_orbit_search orbit; ///< outcome of the search for the orbit of a motion that returns
    int orbit_period;         ///< revolutions of that orbit
    double orbit_residual, orbit_distance, orbit_modulus; ///< as in whirl_record_orbit; NaN if there is none
    double step_growth; ///< whirl_step_quality.growth; NaN for methods with a tolerance
    double step_error;  ///< whirl_step_quality.error
    double revolutions; ///< revolutions integrated
    double swelling;    ///< growth rate of the section between halves of the watched revolutions, per revolution
    bool sought;        ///< chaotic motion: true if coexisting attractors were searched
    /// coexisting attractor: k of a stable P-k, WHIRL_REFUGE_AT_REST for a stable equilibrium; 0: none found
    int refuge;
    double survived; ///< chaotic motion: total revolutions of its perturbed copies (whirl_record_survival)
    int ended;       ///< number of these copies that ended
    /// Logarithm per revolution of the slowest multiplier of the linear map that the section follows, below 0 for a
    /// motion that settles on P-1, with its error; NaN if the section follows none.
    whirl_estimate settling;
    bool settles; ///< P-1: far from settled, recognized by `settling`
    /// undetermined or slowly observed quasi-periodic motion: order of the main line at no whole order; NaN if none is
    /// clear
    double line;
    double line_share;                ///< amplitude of that line over the size of the motion
    double line_trend;                ///< growth rate of that amplitude, per revolution
    bool rests;                       ///< P-1: at a stable equilibrium; the exponent is that of its slowest mode
    double rest_distance, rest_order; ///< as in whirl_record_rest; NaN if it does not rest
} whirl_verdict;

/// Judges a motion. See docs/theory.md, "Verdicts".
whirl_verdict whirl_judge(const whirl_record *record);

/// Searches for coexisting attractors along a chaotic motion: stable equilibria near its section, and stable orbits
/// that motions reach within 200 revolutions, from 32 starts at a tenth of the size of the section's box from states of
/// the section. *refuge as in whirl_verdict. WHIRL_BAD_INPUT if the system has no Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_record_refuge(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record *record, int *refuge);

/// Survival of perturbed copies of a chaotic motion.
typedef struct whirl_survival {
    double revolutions; ///< total revolutions of the copies after they had separated
    double cost;        ///< revolutions integrated
    int copies, ended;  ///< number of copies, and of those that ended within these revolutions
} whirl_survival;

/// Follows perturbed copies of a chaotic motion, from states of its section displaced by a millionth of its size.
/// Counting begins when they have separated at the rate `exponent` (natural logarithm per revolution, above 0), and
/// goes on for 200 revolutions, or as many as exclude mean lives below twice the watched revolutions. A copy ends when
/// it is lost, comes to rest, or becomes regular. If none ends, mean lives below a third of the revolutions are
/// excluded at 95 %. WHIRL_BAD_INPUT if the motion has too few sections, WHIRL_NO_MEMORY.
whirl_status whirl_record_survival(const whirl_system *system, const whirl_integrate_options *integrate,
                                   const whirl_record *record, double exponent, whirl_survival *survival);

/// Compares a verdict with that on the same motion at another tolerance (whirl_integrate_tighter), and sets the
/// confidence. High requires the same regime (and period); for chaos also that a search found no coexisting attractor,
/// and that copies survived long. Different verdicts give low.
void whirl_verdict_confirm(whirl_verdict *verdict, const whirl_verdict *other);

/// Adds to a chaotic verdict that of a copy of the motion, followed for `revolutions` more than the point's own `all`.
/// If the copy is regular, chaos was a transient: the confidence is low; fair if the copy is undetermined. The order of
/// copies has no effect.
void whirl_verdict_follow(whirl_verdict *verdict, const whirl_verdict *copy, double revolutions, double all);

/// Returns options with errors of a step smaller by `factor` >= 1: tolerances are divided by it, but not below 1e-14;
/// steps of a fixed-step method are multiplied by its fourth root (rounded up; 16 gives twice the steps).
whirl_integrate_options whirl_integrate_tighter(const whirl_integrate_options *options, double factor);

/// Changes options by an advice (not for another start). Length of the record and samples of its waveform stay, and
/// with them the layout of a point's block.
void whirl_advice_apply(whirl_advice advice, whirl_integrate_options *integrate, whirl_record_options *record);

/// Returns "periodic", "quasi-periodic", "chaotic", "diverged" or "undetermined". Static text.
const char *whirl_regime_name(whirl_regime regime);

/// Returns "low", "fair" or "high". Static text.
const char *whirl_confidence_name(whirl_confidence confidence);

/// Writes a verdict in words, at most `size` bytes: "P-2", "rests", "quasi-periodic (1 curve)", "chaotic", "diverged at
/// revolution 17", "undetermined".
void whirl_verdict_name(const whirl_verdict *verdict, char *text, size_t size);

/// Writes the reason for a verdict from its evidence in one sentence, at most `size` bytes.
void whirl_verdict_reason(const whirl_verdict *verdict, char *text, size_t size);

/// Writes the advice of a verdict, at most `size` bytes: "let it run 3 times as long"; "" for none.
void whirl_verdict_advice(const whirl_verdict *verdict, char *text, size_t size);

/// Most lines of a spectrum.
enum { WHIRL_MAX_LINES = 16 };

/// A line of a spectrum. Amplitudes are zero to peak.
typedef struct whirl_line {
    double order;             ///< frequency over the running speed, > 0
    double x, y;              ///< amplitudes of the two coordinates
    double forward, backward; ///< amplitudes of its two circular motions (full spectrum of x + iy)
} whirl_line;

/// The synchronous (1X) part of a motion: of x, of y, and of its circular motions with the rotation (forward) and
/// against it (backward), in this order. Phases count from the mark on the shaft, which is on the x axis at tau = 0, 2
/// pi, ...: an unbalance at angle 0 then points along x. x is amplitude[0] cos(tau - lag[0]), y likewise; forward is
/// the vector at the angle tau - lag[2], backward at -(tau - lag[3]).
typedef struct whirl_synchronous {
    double amplitude[4]; ///< zero to peak
    /// Lag behind the mark in degrees, 0 <= ... < 360, of the peak, or of the vector's passage through the x axis; NaN
    /// for an amplitude below 1e-12 of the largest displacement.
    double lag[4];
} whirl_synchronous;

/// Spectra of one probe over the record: Hann window over all samples, mean removed, resolution 1/record orders.
typedef struct whirl_spectrum {
    size_t count;                       ///< orders 0 .. highest
    double resolution;                  ///< orders between two bins
    double *x, *y, *forward, *backward; ///< [count] amplitudes, zero to peak; one block, freed by whirl_spectrum_free
    size_t line_count;                  ///< number of lines
    whirl_line lines[WHIRL_MAX_LINES];  ///< interpolated peaks, largest first
    double line_share;                  ///< share of the lines in the variance of the motion; NaN if nothing moves
    whirl_synchronous synchronous;      ///< NaN for fewer than 3 samples per revolution
} whirl_spectrum;

/// Computes the spectrum of probe `probe` up to `highest_order`; lines also above it, up to 99 % of the motion.
/// WHIRL_BAD_INPUT if the record has no waveform.
whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum);

/// Frees a spectrum; accepts NULL.
void whirl_spectrum_free(whirl_spectrum *spectrum);

// ---------------------------------------------------------------- peaks of responses

/// Methods of finding an amplification factor.
typedef enum whirl_amplification_way {
    WHIRL_BY_HALF_POWER, ///< speed/(high - low)
    WHIRL_BY_ONE_SIDE,   ///< speed over twice the distance of the only half-power point
    WHIRL_BY_PHASE_SLOPE ///< half of the speed times the slope of the lag: there is no half-power point
} whirl_amplification_way;

/// A peak of a response over the speed.
typedef struct whirl_response_peak {
    double speed, amplitude;     ///< its maximum, by cubic interpolation
    double low, high;            ///< speeds with 1/sqrt(2) of the amplitude; NaN if it rises again before
    double amplification;        ///< amplification factor
    whirl_amplification_way way; ///< method by which it was found
    double points;               ///< points of the response in the width speed/amplification: few give a rough value
} whirl_response_peak;

/// Finds the peaks of a response [count] at rising speeds, at most `most` of them, by rising speed; returns their
/// number. lags: degrees by which its phase is behind. Ends are not peaks. (Amplification by half power: API 617, API
/// 684; closed form of a damped rotor: docs/theory.md.)
size_t whirl_response_peaks(size_t count, const double *speeds, const double *amplitudes, const double *lags,
                            size_t most, whirl_response_peak *peaks);

/// Returns the maximum of a response [count] at rising speeds from `low` to `high`: at points, at peaks between them
/// and at both ends of that range, by cubic interpolation; NaN if the points do not cover it.
double whirl_response_largest(size_t count, const double *speeds, const double *amplitudes, double low, double high);

/// Returns the critical speed ratio (speed over the first critical speed on rigid supports) above which a machine with
/// that mean gas density (kg/m3) is in region B of the screening diagram of API 617: 2.5, falling from 16.53 to 2.0 at
/// 60 kg/m3, 0 beyond. Check the edition that applies.
double whirl_screening_ratio(double density);

/// Returns the separation margin required for a peak of that amplification A, in percent of the lowest (or, `above`,
/// the highest) running speed: 17 (1 - 1/(A - 1.5)), and 10 more above; 0 below A = 2.5. After API 617; check the
/// edition that applies, and its caps.
double whirl_margin_required(double amplification, bool above);

// ---------------------------------------------------------------- analyses by name, and their fields

/// A field: one named group of numbers in the block of a point. For every point, station (probe) or contact it is an
/// array [rows][columns] (1 x 1: a number), row-major. Missing values are NaN.
typedef struct whirl_field {
    char name[WHIRL_NAME_SIZE]; ///< "analysis/quantity", as "lyapunov/largest"
    const char *unit; ///< "length", "force", "1", "revolution", "1/revolution", "order"; "length" is the case's scale
    const char *meaning;  ///< one line; for columns their names, separated by ", "
    whirl_extent extent;  ///< extent: point, station or contact
    size_t rows, columns; ///< size of the array
    size_t repeat;        ///< 1, or the number of stations or contacts
    size_t offset;        ///< index of its first number in the block; the next repetition follows after rows * columns
} whirl_field;

/// Most fields of a block, and most columns with names.
enum { WHIRL_MAX_FIELDS = 256, WHIRL_MAX_COLUMNS = 32 };

/// The fields of a point's block.
typedef struct whirl_layout {
    size_t field_count;                   ///< number of fields
    whirl_field fields[WHIRL_MAX_FIELDS]; ///< in the order of the block
    size_t size;                          ///< doubles of the block
} whirl_layout;

/// A kind of points: their common behaviour. Users of batches and tables read these members instead of comparing kinds.
typedef struct whirl_kind {
    const char *name;   ///< "motion", "rest", "branch", "torus"
    const char *asked;  ///< the way a case asks for its analyses, a sentence
    const char *method; ///< the method of finding its points; NULL: integration, by the method of their options
    const char *begins; ///< the start from which its points are followed; NULL: values of the parameter
    const char *beside; ///< remark after the name of that method, or ""
    /// True if its points are motions: with a start, a transient, a record and a verdict, and so with several starts,
    /// confirmation and refinement.
    bool moves;
    bool settles; ///< motions are at least integrated until they settle
    /// True if a run finds its points: their number, at most record.trace.points, and their parameter values are known
    /// at the end. Their options also include those of whirl_trace_members.
    bool found;
    double cost; ///< approximate cost of a point in revolutions, 1 at rest; 0: those of its motion
    bool still;  ///< also for machines at speed 0, which have no revolutions
} whirl_kind;

// clang-format off
/// Studies of machines at rest: name, meaning, source, and `STILL` if also for machines at speed 0, else `TURNING`.
/// Each is both an analysis and a part of a study of that name.
#define WHIRL_STUDIES_AT_REST(study)                                                                                   \
    study(modes, "frequencies, damping, whirl and shapes of small motions about the position of rest",                 \
          "Friswell, Penny, Garvey, Lees 2010; Floquet 1883 where coefficients turn with the shaft", STILL)            \
    study(unbalance, "synchronous response to unbalance about the position of rest",                                   \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(critical_speeds, "critical speeds without damping, all at once, forward and backward",                       \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(stability, "decrements over the cross coupling of stages, its limit, and the effect of seals and impellers", \
          "Wachel, von Nimitz 1981; API 617", TURNING)                                                                 \
    study(statics, "sag, bending moments and loads of bearings by the weight, and elevations of bearings",             \
          "Przemieniecki 1968", STILL)
// clang-format on

/// Description of an analysis.
typedef struct whirl_analysis {
    const char *name;       ///< as written in a case file: "poincare", "spectrum", ...
    const char *meaning;    ///< one line
    const char *source;     ///< author, year; "" if nothing is cited
    bool usual;             ///< true if computed by default
    bool kept;              ///< true if it is computed exactly when waveforms are stored (whirl_analysis_fit)
    const whirl_kind *kind; ///< kind of its points
} whirl_analysis;

/// Returns all analyses; static, ended by an entry whose name is NULL.
const whirl_analysis *whirl_analyses(void);

/// A set of analyses, one bit per index in whirl_analyses().
typedef unsigned whirl_analysis_set;

/// Adds the analysis of that name; false if there is none.
bool whirl_analysis_add(whirl_analysis_set *set, const char *name);

/// Returns true if a set has the analysis of that name.
bool whirl_analysis_has(whirl_analysis_set set, const char *name);

/// Returns the kind of points of a set, which is the same for all of its analyses; that of motions for an empty set.
/// Static.
const whirl_kind *whirl_analysis_kind(whirl_analysis_set set);

/// Returns the default analyses.
whirl_analysis_set whirl_analysis_usual(void);

/// Returns the name of the analysis whose fields hold the verdict.
const char *whirl_analysis_of_verdicts(void);

/// Returns the name of the analysis of the ranges of laws, which every set for motions or machines at rest has.
const char *whirl_analysis_of_ranges(void);

/// Returns the set with all analyses of stored waveforms if some are stored, and without them if none are.
whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options);

/// Makes options record the inputs of the analyses: the waveform, the growth of perturbations. Other options stay.
void whirl_analysis_needs(whirl_analysis_set set, whirl_record_options *options);

/// Builds the layout of a point's block for a system, options and analyses. WHIRL_BAD_INPUT for contradicting options.
whirl_status whirl_layout_new(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options, whirl_analysis_set set, whirl_layout *layout);

/// Builds the layout of all fields, for a machine of one station and one contact, with several rows for each field that
/// can have them.
whirl_status whirl_layout_known(whirl_layout *layout);

/// Checks the layout of a table of branches or tori that was read: all fields of these analyses exist, with the rows
/// required by the options and the dimension (from the first field), and with bounded revolutions and nodes.
/// WHIRL_BAD_INPUT names the error.
whirl_status whirl_layout_check(const whirl_layout *layout, whirl_analysis_set set,
                                const whirl_record_options *options);

/// Checks a block of such a table in the same way.
whirl_status whirl_block_check(const whirl_layout *layout, const double *block, const whirl_record_options *options);

/// Returns true if blocks hold a verdict.
bool whirl_layout_has_verdict(const whirl_layout *layout);

/// Returns the field of that name, or NULL.
const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name);

/// Writes the names of a field's columns, "x", "y"; false if they have none.
bool whirl_field_column_names(const whirl_field *field, char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE]);

/// Ways of counting a displacement.
typedef enum whirl_counting {
    WHIRL_FROM_CENTRE = 0, ///< a position, an extent, the size of a part: only one way
    WHIRL_ZERO_TO_PEAK,    ///< a distance from the centre: zero to peak for any `units`, as it is not sinusoidal
    WHIRL_AMPLITUDE        ///< amplitude of a sinusoid: stored zero to peak, shown as `units` require
} whirl_counting;

/// Returns the unit of a column, as whirl_field.unit, and also "length/radian", "rad/s" and "parameter" (SI), for
/// columns whose name gives them. Static text, or the field's.
const char *whirl_column_unit(const whirl_field *field, size_t column);

/// Returns the way of counting the lengths of a field: its meaning says "0-p amplitude" for sinusoids, "0-p" for other
/// distances.
whirl_counting whirl_field_counting(const whirl_field *field);

/// Returns true if the analyses have a field of that name with rows, also if options give it a single row.
bool whirl_analysis_has_rows(const char *field);

/// Fills `block` [layout->size] with the analyses of a record.
whirl_status whirl_analyze(const whirl_record *record, const whirl_record_options *options, whirl_analysis_set set,
                           const whirl_layout *layout, double *block);

/// Kinds of points located between two values of a parameter.
typedef enum whirl_critical_kind {
    WHIRL_CRITICAL_SPEED = 1, ///< a mode's damped frequency is the speed of the shaft
    WHIRL_ONSET,              ///< the machine loses its stability as the parameter grows
    WHIRL_RECOVERY            ///< the machine regains its stability as the parameter grows
} whirl_critical_kind;

/// A critical speed, or a threshold of stability.
typedef struct whirl_critical {
    whirl_critical_kind kind; ///< its kind
    double value;             ///< value of the parameter, in SI
    double speed;             ///< speed of the shaft there, rad/s
    double frequency, ratio;  ///< frequency of the mode, rad/s, and its damping ratio
    double direction;         ///< direction of its whirl
} whirl_critical;

/// Variants of a machine.
typedef enum whirl_variant {
    WHIRL_AS_STUDIED,     ///< as in the study, possibly with springs as bearings
    WHIRL_AS_GIVEN,       ///< with its own bearings
    WHIRL_BEARINGS_OF_IT, ///< its bearings only, on stations of 1 kg
    WHIRL_WITH_STAGES,    ///< with its bearings and `value` times its stages, without seals and other impellers
    WHIRL_WITH_DRAG_AT,   ///< with its bearings, and the seals and impellers at station `value`
    WHIRL_HELD,           ///< with springs of `value` N/m to the ground as bearings, also under their housings
    WHIRL_WITH_STATICS,   ///< as WHIRL_AS_GIVEN, with the effects of weight on its shafts
} whirl_variant;

/// A machine at rest, for its analyses.
typedef struct whirl_resting {
    const whirl_system *system;     ///< the machine
    const double *start;            ///< [dimension] start of the search for its equilibrium
    double clock, speed;            ///< rad/s: of the system's time, and of the shaft
    const whirl_modes *modes;       ///< its modes if requested, else NULL
    size_t critical_count;          ///< number of critical points
    const whirl_critical *critical; ///< critical points between the preceding point and this one
    const size_t *before; ///< [modes->count] matching mode of the preceding point, from 1; 0: none; NULL: unknown
    /// Makes the same machine at another speed (rad/s; 0: its own), which the caller releases; `value` of the variant.
    /// Errors as those of machines.
    whirl_status (*at_speed)(const void *context, double speed, whirl_variant variant, double value,
                             whirl_machine *machine);
    /// Makes the same machine with its coefficients at a frequency of whirl, rad/s.
    whirl_status (*at_frequency)(const void *context, double frequency, whirl_variant variant, double value,
                                 whirl_machine *machine);
    const void *context;        ///< passed to at_speed and at_frequency
    size_t placed_count;        ///< number of placed unbalances
    const whirl_placed *placed; ///< [placed_count] unbalances that replace its own
    const double *rest;         ///< [dimension] equilibrium found from the start; may be NULL without `elsewhere`
    const double *elsewhere;    ///< [dimension] another equilibrium, found from a neighbouring value's; NULL: none
    double elsewhere_growth;    ///< largest real part of all eigenvalues there, per unit of the system's time
} whirl_resting;

/// Computes kxx, kxy, ... of the bearings at a speed (rad/s) about the machine's equilibrium, coefficients
/// [probe_count][8] as in whirl_bearing_coefficients; 0 for a cavitating film with a centred journal, whose derivatives
/// depend on the side. Errors as these.
whirl_status whirl_bearings_at(const whirl_resting *point, double speed, double *coefficients);

/// Fills `block` [layout->size] with analyses of machines at rest. Errors as whirl_forced_response.
whirl_status whirl_analyze_resting(const whirl_resting *point, const whirl_record_options *options,
                                   whirl_analysis_set set, const whirl_layout *layout, double *block);

/// Fills `block` [layout->size] for a machine without an equilibrium. `share` is whirl_equilibrium_share, or 1 if only
/// another machine that the analyses need has none. All numbers but ranges/rest are missing.
void whirl_unfound_at_rest(const whirl_layout *layout, double share, double *block);

/// A point of a branch within a study.
typedef struct whirl_trace {
    const whirl_system *system; ///< its machine
    whirl_branch_point point;   ///< the orbit there, and its kind
    size_t branch;              ///< number of its branch, from 1 in the order in which they were found
    /// number of the branch from which that one begins; 0: it begins at a settled motion or an equilibrium
    size_t parent;
    double end; ///< whirl_branch_end at the last point of the branch, else NaN
} whirl_trace;

/// Fills `block` [layout->size] of the analysis "trace" with a point. WHIRL_BAD_INPUT if an orbit has more revolutions
/// or segments than the options allow.
whirl_status whirl_analyze_trace(const whirl_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Reads the point of a block at a parameter value, without bounds and system: *trace, whose orbit is freed by
/// whirl_orbit_free. WHIRL_BAD_INPUT if it holds none, WHIRL_NO_MEMORY.
whirl_status whirl_block_trace(const whirl_layout *layout, const double *block, double value,
                               const whirl_record_options *options, whirl_trace *trace);

/// Returns "fold", "period doubling", "Neimark-Sacker", ...; "" for a regular point. Static text.
const char *whirl_special_name(whirl_special special);

/// Writes the event at a special point in words, with the sense of its criticality if known, at most `size` bytes.
void whirl_special_text(const whirl_branch_point *point, char *text, size_t size);

/// Writes the name of an orbit, at most `size` bytes: "P-2", "limit cycle", "equilibrium".
void whirl_orbit_name(const whirl_orbit *orbit, char *text, size_t size);

/// Returns the reason for the end of a branch, in words. Static text.
const char *whirl_branch_end_text(whirl_branch_end end);

/// Value of whirl_torus_trace.end if no torus was found at the point.
enum { WHIRL_TORUS_NONE = WHIRL_TORUS_STOPPED + 1 };

/// A torus of a branch within a study.
typedef struct whirl_torus_trace {
    const whirl_system *system;   ///< its machine
    const whirl_torus *torus;     ///< NULL if none was found
    const whirl_torus_view *view; ///< its view
    size_t number; ///< number of its branch of tori, from 1 in the order of the points at which these begin
    size_t branch; ///< number of the branch of orbits at which it begins
    size_t point;  ///< Neimark-Sacker point in the table of branches, from 1
    double begins; ///< parameter value of that point
    double end;    ///< whirl_torus_end or WHIRL_TORUS_NONE at the last torus of the branch, else NaN
    double limit;  ///< whirl_torus_branch.limit there, else NaN
} whirl_torus_trace;

/// Fills `block` [layout->size] of the analysis "torus". WHIRL_BAD_INPUT if a torus has more nodes or revolutions than
/// the options allow.
whirl_status whirl_analyze_torus(const whirl_torus_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Writes the reason for the end of a branch of tori, at most `size` bytes; its last torus is near the resonance p/q
/// (NaN: none): "it locks near 2/5".
void whirl_torus_end_text(double end, double p, double q, char *text, size_t size);

/// Returns the verdict of a block; regime WHIRL_NOT_JUDGED with NaN evidence if it holds none.
whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block);

/// Searches for coexisting attractors (whirl_record_refuge) if the block's verdict is chaos by clear evidence, and
/// stores the outcome in the block. WHIRL_NO_MEMORY is the only error.
whirl_status whirl_block_seek_refuge(const whirl_layout *layout, double *block, const whirl_system *system,
                                     const whirl_integrate_options *integrate, const whirl_record *record);

/// Follows perturbed copies (whirl_record_survival) if the block's verdict is chaos with high agreement and without a
/// coexisting attractor, and stores their survival in the block; adds their revolutions to those integrated.
/// WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status whirl_block_survive(const whirl_layout *layout, double *block, const whirl_system *system,
                                 const whirl_integrate_options *integrate, const whirl_record *record);

/// Confirms (whirl_verdict_confirm) the verdict of a block with that at another tolerance.
void whirl_block_confirm(const whirl_layout *layout, double *block, const whirl_verdict *other);

/// Adds the verdict on a copy of the motion (whirl_verdict_follow) to that of a block.
void whirl_block_follow(const whirl_layout *layout, double *block, const whirl_verdict *later, double revolutions);

/// Adds to the errors of a block's exponents their differences from those of the same motion at another tolerance, in a
/// block of another layout: these are errors of the method.
void whirl_block_compare_exponents(const whirl_layout *layout, double *block, const whirl_layout *other_layout,
                                   const double *other);

#ifdef __cplusplus
}
#endif
#endif
