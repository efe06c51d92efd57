/// Analyses: what is said of one point (one parameter set, one start).
///
/// First a motion is *recorded* (whirl/engine/record.h). Then each *analysis* turns the record into numbers. The
/// numbers of a point lie in one block of doubles whose *layout* names them: analyses describe their fields, and case
/// files, result files and exports follow from that.
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

/// What the points of a table are in a study, whatever their analyses.
typedef enum whirl_role {
    WHIRL_ROLE_POINT,    ///< the machine as it stands: "response"
    WHIRL_ROLE_SURVEY,   ///< along a parameter: "sweep"
    WHIRL_ROLE_DETAIL,   ///< some of these, for longer: "detail"
    WHIRL_ROLE_MAP,      ///< over two or three parameters: "map"
    WHIRL_ROLE_BASIN,    ///< starts of one machine: "basin"
    WHIRL_ROLE_BRANCHES, ///< orbits followed along a parameter: "branch"
    WHIRL_ROLE_CURVES,   ///< special points followed over two: "curves"
    WHIRL_ROLE_TORI,     ///< "tori"
    WHIRL_ROLE_MOTIONS,  ///< motions beside studies at rest: "motions"
    WHIRL_ROLE_REST,     ///< machines at rest: "modes", "statics", ...
    WHIRL_ROLES
} whirl_role;

/// "survey", "detail", ...: as results have it. Static text.
const char *whirl_role_name(whirl_role role);

/// The role of that name; WHIRL_ROLES where it is none.
whirl_role whirl_role_of(const char *name);

// ---------------------------------------------------------------- single analyses, for any record

/// A mean with its standard error.
typedef struct whirl_estimate {
    double value, error; ///< the mean, its standard error
} whirl_estimate;

/// Largest Lyapunov exponent per revolution (natural logarithm): the mean growth of a perturbation over the watched
/// revolutions after the first tenth, with the standard error of block means and, where all perturbations were
/// followed, by what the sum of their exponents misses. NaN where nothing was followed, or that is too much
/// (whirl_lyapunov_spectrum).
whirl_estimate whirl_lyapunov_largest(const whirl_record *record);

/// All Lyapunov exponents per revolution [dimension], as whirl_lyapunov_largest has the first one. False, and NaN,
/// where not all perturbations were followed, or where the sum of the exponents misses that by the divergence by more
/// than their standard errors and by more than a thousandth of their sizes.
bool whirl_lyapunov_spectrum(const whirl_record *record, whirl_estimate *exponents);

/// Kaplan and Yorke's dimension of the attractor in the section, from exponents [count], largest first: how many of
/// them sum to zero or more, the next one in part. Exponents within 3 errors of zero, and within 0.002, count as zero.
double whirl_kaplan_yorke(const whirl_estimate *exponents, size_t count);

/// What kind of motion a record is of.
typedef enum whirl_regime {
    WHIRL_UNDETERMINED = 0, ///< the evidence does not decide
    WHIRL_PERIODIC,         ///< it returns after some revolutions: P-k
    WHIRL_QUASI_PERIODIC,   ///< it has frequencies of its own
    WHIRL_CHAOTIC,          ///< small perturbations grow
    WHIRL_DIVERGING,        ///< it left its bounds
    WHIRL_NOT_JUDGED        ///< nobody looked: the analyses have no regime, or the point is not there
} whirl_regime;

/// The longest period that is told.
enum { WHIRL_MAX_PERIOD = 128 };

/// How far a verdict can be trusted.
typedef enum whirl_confidence { WHIRL_LOW = 0, WHIRL_FAIR, WHIRL_HIGH } whirl_confidence;

/// What would make a verdict more certain.
typedef enum whirl_remedy {
    WHIRL_NO_REMEDY = 0,    ///< nothing is to be done
    WHIRL_LONGER_TRANSIENT, ///< the motion has not settled: a run of `factor` times as many revolutions
    WHIRL_LONGER_WATCH,     ///< more points of the section would tell: `factor` times as many revolutions watched
    WHIRL_TIGHTER,          ///< the tolerance decides: errors of a step smaller by `factor`
    WHIRL_MORE_STEPS,       ///< fixed steps are too long: `factor` times as many, or a method with a tolerance
    WHIRL_OTHER_START       ///< the motion stays on an unstable one: another start, beside it (no option of a run does)
} whirl_remedy;

/// Number of remedies.
enum { WHIRL_REMEDIES = WHIRL_OTHER_START + 1 };

/// What to do for a verdict that is more certain.
typedef struct whirl_advice {
    whirl_remedy remedy; ///< what is to be changed
    double factor;       ///< above 1 where there is a remedy but another start, else 1
} whirl_advice;

/// whirl_verdict.refuge of an equilibrium.
enum { WHIRL_REFUGE_AT_REST = -1 };

/// A verdict with the evidence it rests on.
typedef struct whirl_verdict {
    whirl_regime regime; ///< the kind of motion
    int period;          ///< k of P-k for a periodic motion, else 0
    int curves; ///< closed curves of a quasi-periodic motion's section, 0 where that may be a surface, and else
    /// Of a quasi-periodic motion: 2 for closed curves, and without curves where a phase forces it that fits no
    /// revolution; 3 where the section is a surface and a second exponent is zero
    /// as well, 0 where that cannot be told, and else.
    int frequencies;
    double diverged_at; ///< revolution, else 0
    double limit; ///< whirl_record.limit: what a diverging motion passed, 0 where another bound ended it, and else
    int limit_coordinate; ///< which coordinate did, from 0; 0 where there is no limit
    // trust
    whirl_confidence confidence; ///< after the second tolerance, if there was one; at most fair without it
    whirl_confidence agreement;  ///< what the evidence of this record would be worth, were no step ever wrong
    whirl_advice advice;         ///< what would settle it
    bool confirmed;              ///< whether it was compared with a verdict at another tolerance, namely
    whirl_regime other_regime;   ///< of the verdict at the other tolerance
    int other_period;            ///< k of P-k there, else 0
    double followed; ///< revolutions that copies of a chaotic motion were followed beyond its end, all together
    whirl_regime later_regime; ///< what they were then: the first of these that is not chaotic
    int later_period;          ///< k of P-k then, else 0
    // evidence
    whirl_estimate exponent; ///< largest, per revolution
    bool exponents_failed;   ///< all perturbations were followed, and the sum of their growth is wrong: none counts
    double recurrence;       ///< smallest over k of the largest return distance |z(n+k) - z(n)|, over the size of the
                             ///< motion
    int recurrence_period;   ///< the k that gives it (the smallest k below the tolerance, where there is one)
    int longest_period;      ///< that was looked for: 128 where three of them were watched, else fewer
    double recurrence_trend; ///< that distance in the last quarter of the watched revolutions over that in the first: <
                             ///< 1 settles
    double regularity; ///< decimal digits to which weighted Birkhoff averages over two halves agree: high on tori, low
                       ///< in chaos
    double chaos;      ///< K of the 0-1 test, near 1 in chaos, near 0 for regular motion; NaN for P-k
    int neighbours;  ///< of a quasi-periodic motion: median revolutions between visits of neighbours on a curve, else 0
    int unlocked;    ///< of a quasi-periodic motion: it is locked on no period up to this, else 0
    double rotation; ///< turns round its closed curve from one visit to the next, 0 to 1/2; NaN but for a
                     ///< quasi-periodic motion
    /// Of an undetermined motion that drifts evenly along a closed curve: revolutions once round it; NaN for others.
    double round;
    whirl_orbit_search orbit; ///< what became of the search for the orbit of a motion that returns, and of that orbit
    int orbit_period;         ///< revolutions after which that orbit closes
    double orbit_residual, orbit_distance, orbit_modulus; ///< as whirl_record_orbit has them; NaN where there is none
    double step_growth; ///< whirl_step_quality.growth; NaN for methods with a tolerance
    double step_error;  ///< whirl_step_quality.error
    double revolutions; ///< that were integrated
    double swelling;    ///< per revolution, at which the section grows from half to half of the watched revolutions
    bool sought;        ///< of a chaotic motion: whether it was looked for what else draws in where it goes, namely
    int refuge;         ///< k of a stable P-k, WHIRL_REFUGE_AT_REST of a stable equilibrium; 0: none was found
    double
        survived; ///< of a chaotic motion: revolutions, all together, for which copies went on (whirl_record_survival)
    int ended;    ///< how many of these copies ended all the same
    /// Rate per revolution of the slowest multiplier of the linear map that the section follows, below 0 where it
    /// settles on P-1, with its error; NaN where the section follows none.
    whirl_estimate settling;
    bool settles;      ///< of P-1: it has far to go, and is told by `settling`
    double line;       ///< main line of an undetermined or slowly watched quasi-periodic motion beside whole orders, in
                       ///< orders; NaN where none is clear
    double line_share; ///< its amplitude over the size of the motion
    double line_trend; ///< rate per revolution at which its amplitude grows
    bool rests;        ///< of P-1: it rests at a stable equilibrium; then the exponent is that of its slowest mode
    double rest_distance, rest_order; ///< as whirl_record_rest has them; NaN where it does not rest
} whirl_verdict;

/// Judges the motion. See docs/theory.md, "Verdicts".
whirl_verdict whirl_judge(const whirl_record *record);

/// Looks for what draws motions in where a chaotic motion goes: stable equilibria near its section, and stable orbits
/// that motions from 32 starts, near states of its section by a tenth of the size of its box, come to within 200
/// revolutions.
/// *refuge as whirl_verdict has it. WHIRL_BAD_INPUT where the system gives no Jacobian; WHIRL_NO_MEMORY.
whirl_status whirl_record_refuge(const whirl_system *system, const whirl_integrate_options *integrate,
                                 const whirl_record *record, int *refuge);

/// What became of copies of a chaotic motion.
typedef struct whirl_survival {
    double revolutions; ///< that they went on, all together, after they had gone ways of their own
    double cost;        ///< that were integrated
    int copies, ended;  ///< how many there were, and how many of them ended within these revolutions
} whirl_survival;

/// Follows copies of a chaotic motion side by side, from states of its section that are displaced by a millionth of its
/// size, beyond the revolutions in which they part by `exponent` (natural logarithm per revolution, above 0): for 200
/// revolutions, or as many as exclude mean lives below twice the revolutions that were watched.
/// One ends that is lost, comes to rest, or becomes regular. Without an end mean lives below a third of the
/// revolutions are excluded at 95 %. WHIRL_BAD_INPUT where the motion has too few sections, WHIRL_NO_MEMORY.
whirl_status whirl_record_survival(const whirl_system *system, const whirl_integrate_options *integrate,
                                   const whirl_record *record, double exponent, whirl_survival *survival);

/// Compares with the verdict on the same motion at another tolerance (whirl_integrate_tighter), which settles the
/// confidence: high needs the same regime (and period) from both, and of chaos that a refuge was looked for from there
/// and none was found, and that copies of it lived long; where they differ it is low.
void whirl_verdict_confirm(whirl_verdict *verdict, const whirl_verdict *other);

/// Sets beside a chaotic verdict what a copy of the motion was after `revolutions` more than the point's own `all`.
/// Chaos that has ended was a transient: the confidence is low then, and fair where the copy does not tell. The order
/// of copies changes nothing.
void whirl_verdict_follow(whirl_verdict *verdict, const whirl_verdict *copy, double revolutions, double all);

/// Options with errors of a step smaller by `factor` >= 1: tolerances divided by it, steps of a fixed-step method times
/// its fourth root (rounded up; 16 gives twice the steps). Tolerances are not taken below 1e-14.
whirl_integrate_options whirl_integrate_tighter(const whirl_integrate_options *options, double factor);

/// Changes options as the advice says (not at all where it is another start). The record keeps its length and the
/// samples of its waveform, so that the layout of a point's block stays.
void whirl_advice_apply(whirl_advice advice, whirl_integrate_options *integrate, whirl_record_options *record);

/// "periodic", "quasi-periodic", "chaotic", "diverged", "undetermined". Static text.
const char *whirl_regime_name(whirl_regime regime);

/// "low", "fair", "high". Static text.
const char *whirl_confidence_name(whirl_confidence confidence);

/// "P-2", "rests", "quasi-periodic (1 curve)", "chaotic", "diverged at revolution 17", "undetermined". Writes at most
/// `size` bytes.
void whirl_verdict_name(const whirl_verdict *verdict, char *text, size_t size);

/// Why, in one sentence from the evidence. Writes at most `size` bytes.
void whirl_verdict_reason(const whirl_verdict *verdict, char *text, size_t size);

/// What would settle it, in words: "let it run 3 times as long", or "" where nothing is advised. Writes at most `size`
/// bytes.
void whirl_verdict_advice(const whirl_verdict *verdict, char *text, size_t size);

/// The most lines that are told of a spectrum.
enum { WHIRL_MAX_LINES = 16 };

/// A line of a spectrum. Amplitudes are zero to peak.
typedef struct whirl_line {
    double order;             ///< frequency over the running speed, > 0
    double x, y;              ///< amplitudes of the two coordinates
    double forward, backward; ///< of the two circular motions that make it up (full spectrum of x + iy)
} whirl_line;

/// The synchronous (1X) part of a motion: of x, of y, and of the circular motions with the rotation (forward) and
/// against it (backward) of which both are made, in this order. The mark on the shaft, from which phases count, stands
/// on the x axis at tau = 0, 2 pi, ...: there an unbalance without an angle of its own points along x. x is
/// amplitude[0] cos(tau - lag[0]), y likewise; forward is the vector at the angle tau - lag[2], backward that at -(tau
/// - lag[3]).
typedef struct whirl_synchronous {
    double amplitude[4]; ///< zero to peak
    /// Degrees, 0 <= ... < 360, by which the peak, or the vector on its way through the x axis, comes after the mark;
    /// NaN where the amplitude is below 1e-12 of the largest displacement.
    double lag[4];
} whirl_synchronous;

/// Spectra of one probe over the record: Hann window over all samples, mean removed, resolution 1/record orders.
typedef struct whirl_spectrum {
    size_t count;                       ///< orders 0 .. highest
    double resolution;                  ///< orders between two bins
    double *x, *y, *forward, *backward; ///< [count] amplitudes, zero to peak; one block, freed by whirl_spectrum_free
    size_t line_count;                  ///< of lines
    whirl_line lines[WHIRL_MAX_LINES];  ///< interpolated peaks, largest first
    double line_share; ///< of the motion's mean square about its mean that the lines hold; NaN where nothing moves
    whirl_synchronous synchronous; ///< NaN where there are fewer than 3 samples per revolution
} whirl_spectrum;

/// Spectrum of probe `probe` up to `highest_order`; lines also above it, as far as 99 % of the motion reach.
/// WHIRL_BAD_INPUT when the record has no waveform.
whirl_status whirl_spectrum_new(const whirl_record *record, size_t probe, double highest_order,
                                whirl_spectrum **spectrum);

/// Frees a spectrum; NULL is none.
void whirl_spectrum_free(whirl_spectrum *spectrum);

// ---------------------------------------------------------------- peaks of responses

/// How an amplification factor was found.
typedef enum whirl_amplification_way {
    WHIRL_BY_HALF_POWER, ///< speed/(high - low)
    WHIRL_BY_ONE_SIDE,   ///< speed over twice the distance of the one point of half power that there is
    WHIRL_BY_PHASE_SLOPE ///< half of the speed times the slope of the lag: there is no such point
} whirl_amplification_way;

/// A peak of a response over the speed.
typedef struct whirl_response_peak {
    double speed, amplitude;     ///< of its top, by cubic interpolation
    double low, high;            ///< speeds at which the amplitude is 1/sqrt(2) of the top's; NaN where it rises before
    double amplification;        ///< factor
    whirl_amplification_way way; ///< it was found
    double points;               ///< of the response in the width speed/amplification: few tell it roughly
} whirl_response_peak;

/// The peaks of a response [count] at rising speeds, by rising speed, at most `most` of them; how many. lags: degrees
/// by which its phase is behind. Ends count as no peaks. (Amplification by half power: API 617, API 684; closed form of
/// a damped rotor: docs/theory.md.)
size_t whirl_response_peaks(size_t count, const double *speeds, const double *amplitudes, const double *lags,
                            size_t most, whirl_response_peak *peaks);

/// The largest of a response [count] at rising speeds from `low` to `high`: at points, at tops between them and at both
/// ends of that range, by cubic interpolation; NaN where points do not reach over it.
double whirl_response_largest(size_t count, const double *speeds, const double *amplitudes, double low, double high);

/// The critical speed ratio, of the speed over the first critical speed on rigid supports, above which a machine whose
/// gas has that average density (kg/m3) is in region B of the screening diagram of API 617: 2.5, falling from 16.53 to
/// 2.0 at 60 kg/m3, 0 beyond. Which edition counts is the user's to check.
double whirl_screening_ratio(double density);

/// The separation margin, in percent of the lowest (or, `above`, the highest) running speed, that a peak of that
/// amplification asks for: 17 (1 - 1/(A - 1.5)), and 10 more above; 0 below A = 2.5. After API 617; which edition
/// counts, and what it caps, is the user's to check.
double whirl_margin_required(double amplification, bool above);

// ---------------------------------------------------------------- analyses by name, and their fields

/// One named group of numbers in the block of a point: for every point, station (probe) or contact
/// an array [rows][columns] (1 x 1: a number), row-major. Missing values are NaN.
typedef struct whirl_field {
    char name[WHIRL_NAME_SIZE]; ///< "analysis/quantity", as "lyapunov/largest"
    const char *unit; ///< "length", "force", "1", "revolution", "1/revolution", "order"; "length" is the case's scale
    const char *meaning;  ///< one line; for columns their names, separated by ", "
    whirl_extent extent;  ///< what it stands once for
    size_t rows, columns; ///< of the array
    size_t repeat;        ///< 1, or the number of stations or contacts
    size_t offset;        ///< of the first number in the block; the next repetition follows after rows * columns
} whirl_field;

/// The most fields of a block, and the most columns that have names.
enum { WHIRL_MAX_FIELDS = 256, WHIRL_MAX_COLUMNS = 32 };

/// The fields of a point's block.
typedef struct whirl_layout {
    size_t field_count;                   ///< of fields
    whirl_field fields[WHIRL_MAX_FIELDS]; ///< in the order of the block
    size_t size;                          ///< doubles of the block
} whirl_layout;

/// A kind of points, with all that who handles batches and tables may ask of it: nobody asks which kind it is.
typedef struct whirl_kind {
    const char *name;   ///< "motion", "rest", "branch", "torus"
    const char *asked;  ///< how a case asks for its analyses, a sentence
    const char *method; ///< how its points are found, NULL: they are integrated, by the method of their options
    const char *begins; ///< what its points are followed from, NULL: values of the parameter
    const char *beside; ///< what is said behind the name of that method, "" nothing
    /// Its points are motions: from a start on, over a transient and a record, with a verdict, and so with several
    /// starts, confirmations and refinement.
    bool moves;
    bool settles; ///< motions are integrated at least until they have settled
    /// Its points are found as a run goes on: how many they are, at most record.trace.points, and at which values is
    /// known when they are there. Their options are those of whirl_trace_members, too.
    bool found;
    double cost; ///< of a point, about, in revolutions, 1 at rest; 0: those of its motion
    bool still;  ///< also of machines that stand still, of which no revolutions are counted
} whirl_kind;

// clang-format off
/// The studies of machines at rest: name, what it is of, source, and `STILL` where it is also of machines that stand
/// still, else `TURNING`. Each is an analysis, and a part of a study, of that name.
#define WHIRL_STUDIES_AT_REST(study)                                                                                   \
    study(modes, "frequencies, damping, whirl and shapes of small motions about where the machine rests",              \
          "Friswell, Penny, Garvey, Lees 2010; Floquet 1883 where coefficients turn with the shaft", STILL)            \
    study(unbalance, "synchronous response to unbalance about where the machine rests",                                \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(critical_speeds, "critical speeds without damping, all at once, forward and backward",                       \
          "Friswell, Penny, Garvey, Lees 2010", TURNING)                                                               \
    study(stability, "decrements over the cross coupling of stages, its limit, and what seals and impellers do",       \
          "Wachel, von Nimitz 1981; API 617", TURNING)                                                                 \
    study(statics, "sag, bending moments and loads of bearings by the weight, and elevations of bearings",             \
          "Przemieniecki 1968", STILL)
// clang-format on

/// An analysis as it describes itself.
typedef struct whirl_analysis {
    const char *name;       ///< as written in a case file: "poincare", "spectrum", ...
    const char *meaning;    ///< one line
    const char *source;     ///< author, year; "" where there is nothing to cite
    bool usual;             ///< computed where a case does not say which
    bool kept;              ///< of waveforms that are kept: computed exactly where some are (whirl_analysis_fit)
    const whirl_kind *kind; ///< of the points that it is of
} whirl_analysis;

/// All analyses; static, ended by an entry whose name is NULL.
const whirl_analysis *whirl_analyses(void);

/// A choice of analyses, one bit for the index in whirl_analyses().
typedef unsigned whirl_analysis_set;

/// Adds the analysis of that name; false when there is none.
bool whirl_analysis_add(whirl_analysis_set *set, const char *name);

/// Whether a choice has the analysis of that name.
bool whirl_analysis_has(whirl_analysis_set set, const char *name);

/// The kind of points that a choice is of, all of one; that of motions where nothing is chosen. Static.
const whirl_kind *whirl_analysis_kind(whirl_analysis_set set);

/// Those that are computed where a case does not say which.
whirl_analysis_set whirl_analysis_usual(void);

/// Name of the analysis whose fields hold the verdict.
const char *whirl_analysis_of_verdicts(void);

/// Name of the analysis of the ranges of laws, which every choice of motions or rests has.
const char *whirl_analysis_of_ranges(void);

/// The choice with all analyses of kept waveforms where some are kept, and without them where none are.
whirl_analysis_set whirl_analysis_fit(whirl_analysis_set set, const whirl_record_options *options);

/// Makes options record what the chosen analyses are made of: the waveform, the growth of perturbations. What is
/// recorded already stays.
void whirl_analysis_needs(whirl_analysis_set set, whirl_record_options *options);

/// The layout of a point's block for a system, options and choice. WHIRL_BAD_INPUT for contradicting options.
whirl_status whirl_layout_new(const whirl_system *system, const whirl_integrate_options *integrate,
                              const whirl_record_options *options, whirl_analysis_set set, whirl_layout *layout);

/// All fields that there are, as for a machine of one station and one contact, with more than one row where there can
/// be more.
whirl_status whirl_layout_known(whirl_layout *layout);

/// What is taken for granted of tables of branches and tori, for layouts and blocks that were read: all fields of these
/// analyses are there, with as many rows as the options and the dimension (that the first of them tells) ask for; and
/// revolutions and nodes are not more than there is room for. WHIRL_BAD_INPUT with what is wrong.
whirl_status whirl_layout_check(const whirl_layout *layout, whirl_analysis_set set,
                                const whirl_record_options *options);

/// The same of a block.
whirl_status whirl_block_check(const whirl_layout *layout, const double *block, const whirl_record_options *options);

/// Whether blocks hold a verdict.
bool whirl_layout_has_verdict(const whirl_layout *layout);

/// The field of that name, or NULL.
const whirl_field *whirl_layout_field(const whirl_layout *layout, const char *name);

/// The names of a field's columns, "x", "y"; false where they have none.
bool whirl_field_column_names(const whirl_field *field, char names[WHIRL_MAX_COLUMNS][WHIRL_NAME_SIZE]);

/// How a displacement is counted.
typedef enum whirl_counting {
    WHIRL_FROM_CENTRE = 0, ///< a place, an extent, the size of a part: there is one way
    WHIRL_ZERO_TO_PEAK,    ///< a distance from the centre: zero to peak whatever `units` says, as it is no sinusoid's
    WHIRL_AMPLITUDE        ///< of a sinusoid: held zero to peak, shown as `units` says
} whirl_counting;

/// The unit of a column, as whirl_field.unit; besides "length/radian", "rad/s" and "parameter" (SI), of columns whose
/// names tell so beside others. Static text, or the field's.
const char *whirl_column_unit(const whirl_field *field, size_t column);

/// How the lengths of a field are counted: its meaning says "0-p amplitude" of sinusoids, "0-p" of other distances.
whirl_counting whirl_field_counting(const whirl_field *field);

/// Whether the analyses have a field of that name whose numbers stand in rows: also where options leave one row of
/// them.
bool whirl_analysis_has_rows(const char *field);

/// Fills `block` [layout->size] with what the chosen analyses say of the record.
whirl_status whirl_analyze(const whirl_record *record, const whirl_record_options *options, whirl_analysis_set set,
                           const whirl_layout *layout, double *block);

/// What was located between two values of a parameter.
typedef enum whirl_critical_kind {
    WHIRL_CRITICAL_SPEED = 1, ///< a mode's damped frequency is the speed of the shaft
    WHIRL_ONSET,              ///< the machine loses its stability as the parameter grows
    WHIRL_RECOVERY            ///< ... regains it
} whirl_critical_kind;

/// A critical speed, or a threshold of stability.
typedef struct whirl_critical {
    whirl_critical_kind kind; ///< which of these
    double value;             ///< of the parameter, in SI
    double speed;             ///< of the shaft there, rad/s
    double frequency, ratio;  ///< of the mode, rad/s, and its damping ratio
    double direction;         ///< of its whirl
} whirl_critical;

/// A machine as it is studied, or otherwise.
typedef enum whirl_variant {
    WHIRL_AS_STUDIED,     ///< with springs for its bearings, where the study says so
    WHIRL_AS_GIVEN,       ///< with its own bearings
    WHIRL_BEARINGS_OF_IT, ///< these alone, on stations of 1 kg
    WHIRL_WITH_STAGES,    ///< with its own bearings and, `value` times, its stages, without seals and other impellers
    WHIRL_WITH_DRAG_AT,   ///< with its own bearings, and the seals and impellers at station `value`
    WHIRL_HELD,           ///< on springs of `value` N/m to the ground for its bearings, which hold their housings, too
    WHIRL_WITH_STATICS,   ///< as WHIRL_AS_GIVEN, with what its weight does to its shafts
} whirl_variant;

/// A machine at rest: what analyses of it are made of.
typedef struct whirl_resting {
    const whirl_system *system;     ///< of the machine
    const double *start;            ///< [dimension] where its equilibrium is looked for
    double clock, speed;            ///< rad/s: of the system's time, and of the shaft
    const whirl_modes *modes;       ///< of it, where they are asked for, else NULL
    size_t critical_count;          ///< of critical
    const whirl_critical *critical; ///< what lies between the point before and this one
    const size_t *before; ///< [modes->count] which mode of that point each was, from 1; 0: none; NULL: unknown
    /// Makes the same machine at another speed (rad/s; 0: its own), to be released; value: of the variant. Errors as
    /// those of machines.
    whirl_status (*at_speed)(const void *context, double speed, whirl_variant variant, double value,
                             whirl_machine *machine);
    /// Makes the same machine with its coefficients at a frequency of whirl, rad/s.
    whirl_status (*at_frequency)(const void *context, double frequency, whirl_variant variant, double value,
                                 whirl_machine *machine);
    const void *context;        ///< handed to at_speed and at_frequency
    size_t placed_count;        ///< of placed
    const whirl_placed *placed; ///< [placed_count] unbalances that it has in the place of its own
} whirl_resting;

/// kxx, kxy, ... of the bearings at a speed (rad/s) about where the machine rests, coefficients [probe_count][8] as
/// whirl_bearing_coefficients has them; 0 of a film that cavitates with the journal in its middle, where slopes differ
/// with the side. Errors as these.
whirl_status whirl_bearings_at(const whirl_resting *point, double speed, double *coefficients);

/// Fills `block` [layout->size] with what the chosen analyses, all of machines at rest, say of one. Errors as
/// whirl_forced_response.
whirl_status whirl_analyze_resting(const whirl_resting *point, const whirl_record_options *options,
                                   whirl_analysis_set set, const whirl_layout *layout, double *block);

/// Fills `block` [layout->size] of a machine that rests nowhere, as far as the search came: share is
/// whirl_equilibrium_share, 1 of one that rests while another that its analyses need does not. Numbers are missing, but
/// for ranges/rest.
void whirl_unfound_at_rest(const whirl_layout *layout, double share, double *block);

/// A point of a branch, as it stands among those of a study.
typedef struct whirl_trace {
    const whirl_system *system; ///< of its machine
    whirl_branch_point point;   ///< the orbit there and what happens at it
    size_t branch;              ///< which it is of, from 1 in the order in which they were found
    size_t parent;              ///< along which that one begins; 0: at a motion that settled, or at rest
    double end;                 ///< whirl_branch_end at its last point, else NaN
} whirl_trace;

/// Fills `block` [layout->size] of the analysis "trace" with a point. WHIRL_BAD_INPUT where an orbit has more
/// revolutions or segments than the options say.
whirl_status whirl_analyze_trace(const whirl_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// The point that a block holds, at a value, but for its bounds: *trace, whose orbit is freed by whirl_orbit_free and
/// whose system is not known. WHIRL_BAD_INPUT where it holds none, WHIRL_NO_MEMORY.
whirl_status whirl_block_trace(const whirl_layout *layout, const double *block, double value,
                               const whirl_record_options *options, whirl_trace *trace);

/// "fold", "period doubling", "Neimark-Sacker", ...; "" of a regular point. Static text.
const char *whirl_special_name(whirl_special special);

/// What begins or ends at a special point, in words, with the sense of its criticality where that is known. Writes at
/// most `size` bytes.
void whirl_special_text(const whirl_branch_point *point, char *text, size_t size);

/// "P-2", "limit cycle", "equilibrium". Writes at most `size` bytes.
void whirl_orbit_name(const whirl_orbit *orbit, char *text, size_t size);

/// Why a branch ends, in words. Static text.
const char *whirl_branch_end_text(whirl_branch_end end);

/// What whirl_torus_trace.end says besides whirl_torus_end: no torus was found at the point.
enum { WHIRL_TORUS_NONE = WHIRL_TORUS_STOPPED + 1 };

/// A torus as it stands among those of a study.
typedef struct whirl_torus_trace {
    const whirl_system *system;   ///< of its machine
    const whirl_torus *torus;     ///< NULL where none was found
    const whirl_torus_view *view; ///< of it
    size_t number;                ///< of its branch of tori, from 1 in the order of the points at which these begin
    size_t branch;                ///< of orbits, along which it begins
    size_t point;                 ///< of the table of branches: the Neimark-Sacker point, from 1
    double begins;                ///< value of the parameter there
    double end;                   ///< whirl_torus_end or WHIRL_TORUS_NONE at its last torus, else NaN
    double limit;                 ///< whirl_torus_branch.limit there, else NaN
} whirl_torus_trace;

/// Fills `block` [layout->size] of the analysis "torus". WHIRL_BAD_INPUT where a torus has more nodes or revolutions
/// than the options say.
whirl_status whirl_analyze_torus(const whirl_torus_trace *trace, const whirl_record_options *options,
                                 const whirl_layout *layout, double *block);

/// Why a branch of tori ends whose last one is near the resonance p/q (NaN: near none), in words: "it locks near 2/5".
/// Writes at most `size` bytes.
void whirl_torus_end_text(double end, double p, double q, char *text, size_t size);

/// The verdict that a block holds; regime WHIRL_NOT_JUDGED with NaN evidence when it holds none.
whirl_verdict whirl_block_verdict(const whirl_layout *layout, const double *block);

/// Looks for a refuge (whirl_record_refuge) of the motion whose block this is, where that calls it chaotic by clear
/// evidence, and notes it there. WHIRL_NO_MEMORY alone is an error.
whirl_status whirl_block_seek_refuge(const whirl_layout *layout, double *block, const whirl_system *system,
                                     const whirl_integrate_options *integrate, const whirl_record *record);

/// Follows copies (whirl_record_survival) of the motion whose block this is, where that calls it chaotic with high
/// agreement and no refuge was found, and notes there what became of them; their revolutions are added to those that
/// were integrated. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status whirl_block_survive(const whirl_layout *layout, double *block, const whirl_system *system,
                                 const whirl_integrate_options *integrate, const whirl_record *record);

/// Confirms (whirl_verdict_confirm) the verdict that a block holds with that at another tolerance.
void whirl_block_confirm(const whirl_layout *layout, double *block, const whirl_verdict *other);

/// Sets beside the verdict that a block holds what became of a copy of its motion (whirl_verdict_follow).
void whirl_block_follow(const whirl_layout *layout, double *block, const whirl_verdict *later, double revolutions);

/// Adds to the errors of the exponents that a block holds by how much they differ from those of the same motion at
/// another tolerance, in a block of another layout: that much is the method's own.
void whirl_block_compare_exponents(const whirl_layout *layout, double *block, const whirl_layout *other_layout,
                                   const double *other);

#ifdef __cplusplus
}
#endif
#endif
