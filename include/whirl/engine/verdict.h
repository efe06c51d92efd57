/// Verdicts: the regime of a recorded motion, its evidence, the trust in it, and advice for more.
///
/// The rules are in docs/theory.md, "Verdicts".
#ifndef WHIRL_VERDICT_H
#define WHIRL_VERDICT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/integrate.h"
#include "whirl/engine/lyapunov.h"
#include "whirl/engine/record.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/// whirl_verdict.coexisting of a coexisting stable equilibrium.
enum { WHIRL_COEXISTING_AT_REST = -1 };

/// A verdict with its evidence.
typedef struct whirl_verdict {
    whirl_regime regime; ///< the kind of motion
    int period;          ///< k of P-k for a periodic motion, else 0
    int curves; ///< closed curves in the section of a quasi-periodic motion; 0 if it may be a surface, and for others
    /// Number of independent frequencies of a quasi-periodic motion: 2 for closed curves, or if the motion is forced by
    /// a phase that does not repeat in whole revolutions; 3 if the section is a surface and a second exponent is zero.
    /// 0 if unknown, and for other motions.
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
    /// All perturbations were followed, but the sum of their growth is wrong: all exponents are invalid.
    bool exponents_failed;
    double recurrence; ///< smallest over k of the largest return distance |z(n+k) - z(n)|, over the size of the motion
    int recurrence_period; ///< the k of it (the smallest k below the tolerance, if there is one)
    int longest_period;    ///< longest period searched: 128 if three of them were watched, else fewer
    /// Return distance in the last quarter of the watched revolutions over that in the first: below 1 it settles.
    double recurrence_trend;
    /// Decimal digits to which weighted Birkhoff averages over two halves agree: high on tori, low in chaos.
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
    double swelling;    ///< growth rate of the section's size from the first to the second half of the watched
                        ///< revolutions, per revolution
    bool sought;        ///< chaotic motion: true if coexisting attractors were searched
    /// Coexisting attractor: k of a stable P-k, WHIRL_COEXISTING_AT_REST for a stable equilibrium; 0: none found.
    int coexisting;
    double survived; ///< chaotic motion: total revolutions of its perturbed copies (whirl_record_survival)
    int ended;       ///< number of these copies that ended
    /// Logarithm per revolution of the slowest multiplier of the linear map that the section follows, below 0 for a
    /// motion that settles on P-1, with its error; NaN if the section follows none.
    whirl_estimate settling;
    bool settles; ///< P-1: far from settled, recognized by `settling`
    /// Undetermined motion, or one judged quasi-periodic by its spectral lines: order of the largest line away from
    /// whole orders; NaN if none is clear.
    double line;
    double line_share; ///< amplitude of that line over the size of the motion
    double line_trend; ///< growth rate of that amplitude, per revolution
    /// Order of the largest line that is no combination of `line` and of whole orders; NaN without one.
    double second;
    double second_share, second_trend; ///< as for `line`
    bool rests;                        ///< P-1: at a stable equilibrium; the exponent is that of its slowest mode
    double rest_distance, rest_order;  ///< as in whirl_record_rest; NaN if it does not rest
} whirl_verdict;

/// Judges a motion. See docs/theory.md, "Verdicts".
whirl_verdict whirl_judge(const whirl_record *record);

/// Searches for coexisting attractors along a chaotic motion: stable equilibria near its section, and stable orbits
/// that motions reach within 200 revolutions. The 32 starts of these motions are states of the section, displaced by up
/// to a tenth of the motion's extent in every coordinate. *coexisting as in whirl_verdict. WHIRL_BAD_INPUT if the
/// system has no Jacobian or has turning phases, and for a motion that is not bounded; WHIRL_NO_MEMORY.
whirl_status whirl_record_coexisting(const whirl_system *system, const whirl_integrate_options *integrate,
                                     const whirl_record *record, int *coexisting);

/// Survival of perturbed copies of a chaotic motion.
typedef struct whirl_survival {
    double revolutions; ///< total revolutions of the copies after they had separated
    double cost;        ///< revolutions integrated
    int copies, ended;  ///< number of copies, and of those that ended within these revolutions
} whirl_survival;

/// Follows perturbed copies of a chaotic motion, from states of its section displaced by a millionth of its size.
/// Counting begins when they have separated at the rate `exponent` (natural logarithm per revolution, above 0). It goes
/// on for enough revolutions to exclude mean lives below 12,800 revolutions and below four times the watched
/// revolutions. A copy ends when it is lost, settles, or becomes regular. If none ends, mean lives below a third
/// of the revolutions are excluded at 95 %. WHIRL_BAD_INPUT if the motion has too few sections, WHIRL_NO_MEMORY.
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

#ifdef __cplusplus
}
#endif
#endif
