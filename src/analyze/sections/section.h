/// Points of a Poincare section, oldest first, and the properties that verdicts use.
#ifndef ANALYZE_SECTION_H
#define ANALYZE_SECTION_H

#include "whirl/engine/analyze.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct section {
    size_t count, dimension;
    const double *points; ///< [count][dimension]
} section;

/// The last `count` points.
section section_tail(const section *all, size_t count);

/// Euclidean distance of points a and b.
double section_distance(const section *all, size_t a, size_t b);

/// Size against which distances are judged: half the diagonal of the motion's bounds over the record. It is at least
/// 1e-6 of the largest coordinate and 1e-12, so that an equilibrium returns although rounding moves it.
double motion_size(const whirl_record *record);

/// Largest distance, over the size of the motion, that may be accumulated rounding.
double motion_rounding(const whirl_record *record);

// ---------------------------------------------------------------- recurrence.c

/// Returns to earlier points of the section.
typedef struct recurrence {
    size_t window; ///< last points of the section that were compared
    int longest; ///< longest period that was compared: 128, or a third of the points but not less than 64 if there are
                 ///< few
    /// The smallest k that returns within the tolerance, else the k up to 64 that returns best; 0: too few points.
    int period;
    double distance;   ///< largest |z(n+k) - z(n)| over the window, over the size of the motion
    double separation; ///< smallest such distance for a proper divisor of k, the distance between the k points;
                       ///< infinite for k = 1
    double trend;      ///< largest |z(n+k) - z(n)| in the last quarter of the section over that in the first
} recurrence;

/// Periods up to this are compared by all returns of a window, longer ones if three of them were recorded.
enum { SHORT_PERIOD = 64 };

/// A computed motion returns when it comes back within this share of its size.
static const double recurrence_tolerance = 1e-6;

recurrence recurrence_find(const section *all, size_t record_count, double size, double tolerance);

/// Rounds after which a drift shows its curve, and averages over both halves agree (halves of 5.5 rounds still differ).
static const double enough_rounds = 12.0;

/// Revolutions of one round along a closed curve, if the nearest returns show an even drift that has made too few
/// rounds; else NaN.
double drift_round(const section *all, const recurrence *returns, double size);

// ---------------------------------------------------------------- birkhoff.c

/// Agreement of weighted averages over the two halves of the section.
typedef struct regularity {
    double digits; ///< decimal digits to which the averages agree, at most 16
    double spread; ///< size of the second half over that of the first
} regularity;

/// Compares the halves. `size` is that of the motion; coordinates that move by less than 1e-9 of it count as constant.
regularity regularity_find(const section *all, double size);

// ---------------------------------------------------------------- curves.c

/// Closed curves on which the points lie and which they visit in turn.
typedef struct closed_curves {
    int count; ///< 0 without such curves
    /// Median of the revolutions between the visits of neighbours on a curve. A motion that settles on a lock of period
    /// q never passes the start of another of its q branches, so that neighbours are a return apart: q.
    int neighbours;
} closed_curves;

/// Finds the curves from the last 2000 points. None also without memory.
closed_curves curves_find(const section *all);

// ---------------------------------------------------------------- zero_one.c

/// Least number of points.
enum { ZERO_ONE_MIN = 100 };

/// Returns K of the 0-1 test for chaos over the last 4000 points: near 1 in chaos, near 0 for regular motion (possibly
/// negative). `size` is that of the motion. NaN for fewer points, or if nothing moves.
double zero_one_test(const section *all, double size);

// ---------------------------------------------------------------- correlation.c

/// Memory of the section: correlation over the last 1000 points.
typedef struct correlation {
    double late; ///< largest correlation (in modulus) of points between 1/8 and 1/4 of the points apart
    double time; ///< revolutions after which it stays below 0.2; NaN if it does not
} correlation;

/// Computes it. NaN for fewer than 64 points, and if the root mean square spread is not above `least`.
correlation correlation_find(const section *all, double least);

// ---------------------------------------------------------------- rotation.c

/// Points from which rotation numbers and locks are found, the last ones: slow rotations must go round several times.
enum { ROTATION_POINTS = 20000 };

/// Returns the turns round its closed curve from one visit to the next, 0 to 1/2 (without sense), of a section on
/// `curves` >= 1 closed curves that it visits in turn. NaN if it cannot be determined.
double rotation_number(const section *all, int curves);

// ---------------------------------------------------------------- locks.c

/// Returns the longest period that must be excluded before a motion on `curves` closed curves (0: unknown) certainly is
/// not locked: a third of the points, at least 96.
int longest_lock(const section *all, int curves);

/// Returns the longest period up to which locks are excluded, at most longest_lock, for a section on `curves`->count >=
/// 1 closed curves that it visits in turn with the rotation number `rotation` (NaN if unknown).
int locks_excluded(const section *all, const closed_curves *curves, double rotation);

// ---------------------------------------------------------------- multiplier.c

/// The largest Floquet multiplier of a periodic motion; of a complex pair the one with positive imaginary part.
typedef struct multiplier {
    double real, imaginary;
} multiplier;

/// Finds it by least squares on the returns z(n + period) - z(n), while they shrink between a hundredth of the motion's
/// size and its rounding. NaN if there are too few of these, or if they do not follow one multiplier or a pair.
multiplier multiplier_find(const section *all, int period, double size, double rounding);

// ---------------------------------------------------------------- settling_map.c

/// The linear map from each step of the section to the next.
typedef struct settling_map {
    whirl_estimate rate; ///< rate of its largest multiplier, natural logarithm per revolution; NaN without such a map
    double bend;         ///< change of the rate from half to half, over the rate's square and the time between them
    double bend_error;
} settling_map;

/// Finds the map. `size` and `rounding` are those of the motion.
settling_map settling_map_find(const section *all, double size, double rounding);

/// Returns true if the map leads to an orbit of one revolution: it certainly shrinks all steps, and its rate is that of
/// a linear map, unlike the approach of a small torus or the passage of a ghost of a vanished orbit.
bool settling_map_leads_to_rest(const settling_map *map);

// ---------------------------------------------------------------- main_line.c

/// The largest line of the record off whole orders, at the station where it is the largest part of the motion.
typedef struct main_line {
    double order; ///< NaN without one
    double share; ///< amplitude over half the diagonal of the station's box
    double trend; ///< rate of its amplitude per revolution, from two halves of the record; NaN unless in both
    double drift; ///< change of its order in the second half
    bool two; ///< all significant lines are combinations of this frequency and the shaft's, and the lines are the whole
              ///< motion
} main_line;

main_line main_line_find(const whirl_record *record);

/// Returns true if the line belongs to a motion of two frequencies that neither grows nor decays.
bool main_line_stays(const main_line *line, const whirl_record *record);

// ---------------------------------------------------------------- evidence
// Evidence for verdicts.

typedef struct evidence {
    section points;
    double size;         ///< size of the motion
    double rounding;     ///< distances over the size that are insignificant
    size_t growth_count; ///< after the first tenth, in which the perturbation aligns
    const double *growth;
    recurrence returns;
    regularity averages;
    whirl_estimate exponent;
    whirl_estimate second; ///< sharp, for regular motions; NaN unless all perturbations were followed
    bool forced;           ///< by a phase that fits no revolution: then a stable motion does not return
    bool exponents_failed; ///< the growth is invalid
} evidence;

/// Gathers the inexpensive evidence.
evidence evidence_gather(const whirl_record *record);

/// Returns the evidence of the later half of the recorded revolutions, for a motion that settled late.
evidence evidence_later_half(const evidence *all);

/// Returns the growth rate of returns, natural logarithm per revolution, negative while the motion settles: from those
/// in the first and in the last quarter of the recorded revolutions, which are three quarters apart.
double settling_rate(const evidence *e);

// ---------------------------------------------------------------- confidence
// Confidence of a verdict, and what would improve it.

/// Fills agreement, confidence and advice of a verdict on a bounded motion, from the evidence that it rests on.
void weigh_verdict(whirl_verdict *verdict, const evidence *e, const whirl_record *record);

/// Returns the mean life below which values are excluded, at 95 %, for chaos that no copy was seen to end.
double verdict_least_life(const whirl_verdict *verdict);

/// Returns true if the section of a motion grows at the rate of perturbations: it leaves an unstable motion, as a
/// linear machine does.
bool weigh_swelling(const whirl_verdict *verdict);

// ---------------------------------------------------------------- metric
// Norm in which a linear map shrinks every vector.

/// For a map m [n][n] whose eigenvalues are all within the unit circle: p = sum over j of (m^j)' m^j, so that |v|^2 =
/// v' p v shrinks by v' v with every step, whatever directions grow for a while (Lyapunov 1892; the sum by doubling).
/// *shrinks is the least share by which a step shortens a vector. `room` has 3 n^2 numbers. False if m does not shrink,
/// or too slowly for the sum to converge, and without memory.
bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *room);

/// Returns the length of v [n] in that norm.
double metric_length(size_t n, const double *p, const double *v);

#endif
