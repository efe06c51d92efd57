/// Returns of a section to earlier points, and the rounds of a slow drift.
#ifndef ANALYZE_RECURRENCE_H
#define ANALYZE_RECURRENCE_H

#include <stddef.h>

#include "section.h"

/// Returns to earlier points of the section.
typedef struct recurrence {
    size_t window; ///< last points of the section that were compared
    int longest; ///< longest period that was compared: 128, or a third of the points but not less than 64 if there are
                 ///< few
    /// The smallest k that returns within the tolerance, else the k up to 64 that returns best; 0: too few points.
    int period;
    double distance;   ///< largest |z(n+k) - z(n)| over the window, over the size of the motion
    double separation; ///< smallest such distance for a proper divisor of k: the k points of P-k are this far apart;
                       ///< infinite for k = 1
    double trend;      ///< largest |z(n+k) - z(n)| in the last quarter of the section over that in the first
} recurrence;

/// Periods up to this are compared by all returns of a window, longer ones only if the section has three of them.
enum { SHORT_PERIOD = 64 };

/// A computed motion returns when it comes back within this share of its size.
static const double recurrence_tolerance = 1e-6;

/// Compares the points of the last `record_count` revolutions, or at least of 128, with later ones. `size` is that of
/// the motion, `tolerance` the largest distance of a return over this size.
recurrence recurrence_find(const section *all, size_t record_count, double size, double tolerance);

/// Rounds after which a drift shows its curve, and the averages over both halves agree. (Halves of 5.5 rounds still
/// differ.)
static const double enough_rounds = 12.0;

/// Returns the number of revolutions of one round along a closed curve, if the nearest returns show an even drift that
/// has made too few rounds; otherwise NaN.
double drift_round(const section *all, const recurrence *returns, double size);

#endif
