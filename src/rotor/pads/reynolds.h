/// The film of one pad, by finite volumes.
///
/// Lengths are in the pad's radial clearance c, angles p from the middle of the pad in the direction in which the
/// journal turns, zeta = 2z/L. H = 1 - x cos p - y sin p, (x, y) the journal from the pad's centre of curvature,
/// A = x - 2y', B = y + 2x', ' = d/d(Omega t):
///
///     d/dp(H^3 dP/dp) + (D/L)^2 d/dzeta(H^3 dP/dzeta) = A sin p - B cos p                           (Reynolds 1886),
///
/// P = 0 at both ends; at the edges before and after the pad it is that of the grooves there, 0 or `supply` to zeta =
/// `groove` and from there to the end on a straight line to 0. The pressure is 6 mu Omega (R/c)^2 P. The force on the
/// journal over mu Omega R L (R/c)^2 is 3 int int P (-cos p, -sin p) dp dzeta. In a turbulent film H^3 is divided by
/// the factors of the local Reynolds number, `reynolds` H (pad_tables.h).
#ifndef ROTOR_REYNOLDS_H
#define ROTOR_REYNOLDS_H

#include <stdbool.h>

#include "whirl/engine/bearing.h"
#include "whirl/status.h"

/// Treatment of negative pressures.
typedef enum cavitation {
    CAVITATION_REYNOLDS, ///< P >= 0 where the film is, and its gradient vanishes with it (Swift 1932, Stieber 1933)
    CAVITATION_GUMBEL    ///< the full film's pressures above 0 count (Guembel 1914)
} cavitation;

/// A pad and its grid.
typedef struct pad_film {
    double arc;   ///< rad
    double ratio; ///< length over diameter, L/D
    cavitation law;
    int around, along; ///< volumes of the finest grid, along half the length; both multiples of 2
    whirl_turbulence turbulence;
    double reynolds;       ///< density Omega R c/mu, for turbulent films
    double supply, groove; ///< P in grooves, and their share of the length
} pad_film;

/// Place and velocity of a journal in it.
typedef struct pad_place {
    double x, y, a, b; ///< a, b: A and B
} pad_place;

/// Results of the film.
typedef struct pad_answer {
    double force[2]; ///< on the journal, along the middle of the pad and a right angle further on
    double leaving;  ///< volume of oil that leaves at both ends a second, over Omega R c L
    double drag;     ///< torque on the journal over mu Omega R^3 L/c
    double highest;  ///< P, the largest
    double thinnest; ///< H, the least on the pad
} pad_answer;

/// Workspace of solutions, for films of any size up to the one for which it was made.
typedef struct pad_workspace pad_workspace;
whirl_status pad_workspace_new(int around, int along, pad_workspace **out);
void pad_workspace_free(pad_workspace *work);

/// Solves it on grids, each twice as fine as the one before, and extrapolates the last two. WHIRL_BAD_INPUT if the
/// journal touches the pad; WHIRL_NO_CONVERGENCE if the cavity does not converge.
whirl_status pad_solve(pad_workspace *work, const pad_film *film, const pad_place *place, pad_answer *answer);

#endif
