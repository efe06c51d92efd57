/// A run of points of a Poincare section, oldest first, and what is found in it.
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

/// The size against which distances are judged: half the diagonal of the motion's bounds over the record. It is not
/// taken below 1e-6 of the largest coordinate nor below 1e-12, where only rounding is left: an equilibrium returns.
double motion_size(const whirl_record *record);

/// Distances up to this, over the size of the motion, may be rounding that built up over many steps.
double motion_rounding(const whirl_record *record);

// ---------------------------------------------------------------- recurrence.c

/// Returns to earlier points of the section.
typedef struct recurrence {
    size_t window; ///< last points of the section that were compared
    int longest; ///< period that was looked for: 128, or a third of the points but not less than 64 where these are few
    /// The smallest k that returns within the tolerance, else the k up to 64 that returns best; 0: too few points.
    int period;
    double distance;   ///< largest |z(n+k) - z(n)| over the window, over the size of the motion
    double separation; ///< smallest such distance for a proper divisor of k: how far the k points are apart; infinite
                       ///< for k = 1
    double trend;      ///< largest |z(n+k) - z(n)| in the last quarter of the section over that in the first
} recurrence;

/// Periods up to this are compared by all returns of a window, longer ones where three of them were watched.
enum { SHORT_PERIOD = 64 };

/// A computed motion returns when it comes back within this share of its size.
static const double recurrence_tolerance = 1e-6;

recurrence recurrence_find(const section *all, size_t record_count, double size, double tolerance);

/// A drift shows its curve, and averages over both halves agree, once it has gone round so often (halves of 5.5 rounds
/// still differ).
static const double enough_rounds = 12.0;

/// Revolutions in which a motion goes once round its closed curve, where its nearest returns say that it drifts along
/// it evenly and has not gone round often enough; else NaN.
double drift_round(const section *all, const recurrence *returns, double size);

// ---------------------------------------------------------------- birkhoff.c

/// What weighted averages over the two halves of the section say.
typedef struct regularity {
    double digits; ///< decimal digits to which the averages agree, at most 16
    double spread; ///< size of the second half over that of the first
} regularity;

/// `size` is that of the motion; coordinates that move by less than 1e-9 of it in the section only round.
regularity regularity_find(const section *all, double size);

// ---------------------------------------------------------------- curves.c

/// Closed curves on which the points lie and which they visit in turn.
typedef struct closed_curves {
    int count; ///< 0 where they do not
    /// Median of the revolutions between the visits of neighbours on a curve. A motion that is locked on a period q and
    /// still on its way never passes where another of its q branches began, so that neighbours are a return apart: q.
    int neighbours;
} closed_curves;

/// The last 2000 points are looked at. None also when memory is short.
closed_curves curves_find(const section *all);

// ---------------------------------------------------------------- zero_one.c

/// Points that it takes at least.
enum { ZERO_ONE_MIN = 100 };

/// K of the 0-1 test for chaos over the last 4000 points: near 1 in chaos, near 0 for regular motion (below 0 too).
/// `size` is that of the motion. NaN for fewer points, or where nothing moves.
double zero_one_test(const section *all, double size);

// ---------------------------------------------------------------- correlation.c

/// How long the section remembers. The last 1000 points are looked at.
typedef struct correlation {
    double late; ///< largest correlation (in modulus) of points between 1/8 and 1/4 of the points apart
    double time; ///< revolutions after which it stays below 0.2; NaN where it does not
} correlation;

/// NaN for fewer than 64 points, and where the root mean square spread is not above `least`.
correlation correlation_find(const section *all, double least);

// ---------------------------------------------------------------- rotation.c

/// Points that rotation numbers and locks are told from, the last ones: slow rotations must go round several times.
enum { ROTATION_POINTS = 20000 };

/// Turns round its closed curve from one visit to the next, 0 to 1/2 (the sense is not told), of a section on
/// `curves` >= 1 closed curves that it visits in turn. NaN where it cannot be told.
double rotation_number(const section *all, int curves);

// ---------------------------------------------------------------- locks.c

/// Periods up to this must be excluded before a motion on `curves` closed curves (0: not known) counts as not locked
/// for certain: a third of the points, 96 at least.
int longest_lock(const section *all, int curves);

/// The section, on `curves`->count >= 1 closed curves that it visits in turn with the rotation number `rotation` (NaN
/// where it is not told), is locked on no period up to this; longest_lock at most.
int locks_excluded(const section *all, const closed_curves *curves, double rotation);

// ---------------------------------------------------------------- multiplier.c

/// The largest Floquet multiplier of a periodic motion, of a pair that with the imaginary part above 0.
typedef struct multiplier {
    double real, imaginary;
} multiplier;

/// By least squares on the returns z(n + period) - z(n), where they shrink between a hundredth of the motion's size and
/// its rounding. NaN where they never are there long enough, or do not follow one multiplier or a pair.
multiplier multiplier_find(const section *all, int period, double size, double rounding);

// ---------------------------------------------------------------- settling_map.c

/// The linear map from each step of the section to the next.
typedef struct settling_map {
    whirl_estimate
        rate;    ///< of its largest multiplier, natural logarithm per revolution; NaN where there is no such map
    double bend; ///< change of the rate from half to half, over the rate's square and the time between them
    double bend_error;
} settling_map;

/// `size` and `rounding` are those of the motion.
settling_map settling_map_find(const section *all, double size, double rounding);

/// Whether the motion comes to rest on an orbit of one revolution, as far as the map goes: it shrinks all steps for
/// certain, and its rate is that of a linear map, neither of a way to a small torus nor past an orbit that is not
/// there.
bool settling_map_leads_to_rest(const settling_map *map);

// ---------------------------------------------------------------- main_line.c

/// The largest line of the record beside whole orders, at the station where it is the largest part of the motion.
typedef struct main_line {
    double order; ///< NaN where there is none
    double share; ///< amplitude over half the diagonal of the station's box
    double trend; ///< rate of its amplitude per revolution, from two halves of the record; NaN where not in both
    double drift; ///< by how much its order is another one in the second half
    bool two;     ///< all lines that matter are of that frequency and the shaft's, and the lines are the motion
} main_line;

main_line main_line_find(const whirl_record *record);

/// Whether the line is that of a motion of two frequencies that neither grows nor dies out.
bool main_line_stays(const main_line *line, const whirl_record *record);

// ---------------------------------------------------------------- evidence
// What verdicts are judged from.

typedef struct evidence {
    section points;
    double size;         ///< of the motion
    double rounding;     ///< distances over the size that say nothing
    size_t growth_count; ///< after the first tenth, in which the perturbation turns
    const double *growth;
    recurrence returns;
    regularity averages;
    whirl_estimate exponent;
    whirl_estimate second; ///< sharp, of regular motions; NaN where not all perturbations were followed
    bool forced;           ///< by a phase that fits no revolution: then a stable motion does not return
    bool exponents_failed; ///< then there is no growth that says anything
} evidence;

/// All that costs little.
evidence evidence_gather(const whirl_record *record);

/// The evidence of the later half of the watched revolutions, for a motion that took long to come to its attractor.
evidence evidence_later_half(const evidence *all);

/// Rate at which returns grow, natural logarithm per revolution, below 0 while the motion settles: from those in the
/// first and in the last quarter of the watched revolutions, which are three quarters apart.
double settling_rate(const evidence *e);

// ---------------------------------------------------------------- confidence
// How far a verdict can be trusted, and what would settle it.

/// Fills agreement, confidence and advice of a verdict on a bounded motion, from the evidence that it rests on.
void weigh_verdict(whirl_verdict *verdict, const evidence *e, const whirl_record *record);

/// Mean lives below so many revolutions are excluded, at 95 %, of chaos that no copy was seen to end.
double verdict_least_life(const whirl_verdict *verdict);

/// Whether the section of a motion grows as perturbations do: it leaves an unstable one, as a linear machine does.
bool weigh_swelling(const whirl_verdict *verdict);

// ---------------------------------------------------------------- metric
// Lengths in which a linear map shrinks every vector.

/// For a map m [n][n] whose eigenvalues are all within the unit circle: p = sum over j of (m^j)' m^j, so that
/// |v|^2 = v' p v shrinks by v' v with every step, whatever directions grow for a while (Lyapunov 1892; the sum by
/// doubling). *shrinks is the least share by which a step shortens a vector. `room` has 3 n^2 numbers. False where m
/// does not shrink, or so slowly that the sum is not found, and without memory.
bool metric_make(size_t n, const double *m, double *p, double *shrinks, double *room);

/// The length of v [n].
double metric_length(size_t n, const double *p, const double *v);

#endif
