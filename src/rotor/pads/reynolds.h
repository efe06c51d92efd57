/// The film of one pad, by finite volumes.
///
/// Lengths are in units of the pad's radial clearance c. Angles p are from the middle of the pad in the direction in
/// which the journal turns, and zeta = 2z/L. With H = 1 - x cos p - y sin p, where (x, y) is the journal's position
/// relative to the pad's centre of curvature, A = x - 2y', B = y + 2x' and ' = d/d(Omega t) the equation is
///
///     d/dp(H^3 dP/dp) + (D/L)^2 d/dzeta(H^3 dP/dzeta) = A sin p - B cos p                           (Reynolds 1886),
///
/// P = 0 at both ends. At the leading and the trailing edge P is that of the grooves there: 0, or `supply` up to zeta =
/// `groove` and from there on a straight line to 0 at the end. The pressure is 6 mu Omega (R/c)^2 P. The force on the
/// journal divided by mu Omega R L (R/c)^2 is 3 int int P (-cos p, -sin p) dp dzeta. In a turbulent film H^3 is divided
/// by the factors of the local Reynolds number, `reynolds` H (turbulence.h).
#ifndef ROTOR_REYNOLDS_H
#define ROTOR_REYNOLDS_H

#include <stdbool.h>

#include "whirl/internal/bearing.h"
#include "whirl/status.h"

/// Treatment of negative pressures.
typedef enum cavitation {
    CAVITATION_REYNOLDS, ///< P >= 0; where the film breaks, P and its gradient vanish (Swift 1932, Stieber 1933)
    CAVITATION_GUMBEL    ///< the pressures of the full film, of which negative ones are left out (Guembel 1914)
} cavitation;

/// A pad and its grid.
typedef struct pad_film {
    double arc;   ///< rad
    double ratio; ///< length over diameter, L/D
    cavitation law;
    int around, along; ///< volumes of the finest grid around the pad, and along half its length; both multiples of 2
    whirl_turbulence turbulence;
    double reynolds;       ///< density Omega R c/mu, for turbulent films
    double supply, groove; ///< P in grooves, and their share of the length
} pad_film;

/// Position of a journal in a pad, and its velocity as A and B.
typedef struct pad_place {
    double x, y, a, b; ///< a, b: A and B
} pad_place;

/// Results of the film.
typedef struct pad_answer {
    double force[2]; ///< force on the journal, along the middle of the pad and a right angle further on
    double leaving;  ///< volume of oil that leaves at both ends per second, divided by Omega R c L
    double drag;     ///< torque on the journal divided by mu Omega R^3 L/c
    double highest;  ///< P, the largest
    double thinnest; ///< H, the least on the pad
} pad_answer;

/// Workspace of solutions, for films with at most `around` by `along` volumes. WHIRL_NO_MEMORY.
typedef struct pad_workspace pad_workspace;
whirl_status pad_workspace_new(int around, int along, pad_workspace **out);
void pad_workspace_free(pad_workspace *work);

/// Solves the film on grids, each twice as fine as the previous one, and extrapolates from the last two.
/// WHIRL_BAD_INPUT if the journal touches the pad; WHIRL_NUMERICAL_FAILURE if the cavity does not converge.
whirl_status pad_solve(pad_workspace *work, const pad_film *film, const pad_place *place, pad_answer *answer);

#endif
