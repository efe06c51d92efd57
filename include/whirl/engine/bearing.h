/// Journal bearings of pads, fixed or tilting, by themselves: forces of their films of finite length, where the journal
/// rests under a load, stiffness and damping.
///
/// All is without dimensions: lengths in the pads' radial clearance c, velocities in c Omega, forces in
/// mu Omega R L (R/c)^2, so stiffness in mu Omega R L R^2/c^3 and damping in mu R L R^2/c^3. Angles go from x to y, the
/// way in which the journal turns. The films obey Reynolds' equation (1886), of constant viscosity: laminar, or with
/// the factors of turbulence; with the pressure of the surroundings at the ends of the pads and, unless their grooves
/// are under pressure, at the edges. A clearance of the bearing, by which its clearance circle is told, is (1 -
/// preload) c.
#ifndef WHIRL_BEARING_H
#define WHIRL_BEARING_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { WHIRL_MAX_PADS = 12 };

/// Whose factors of turbulence a film has.
typedef enum whirl_turbulence {
    WHIRL_LAMINAR,       ///< none
    WHIRL_NG_PAN,        ///< Ng, Pan 1965
    WHIRL_CONSTANTINESCU ///< Constantinescu 1962
} whirl_turbulence;

/// A pad.
typedef struct whirl_pad {
    double pivot;   ///< rad, where its pivot is, or that of a fixed pad's line of preload
    double arc;     ///< rad, its length
    double offset;  ///< share of the arc before the pivot; 0.5: in the middle
    double preload; ///< share of the clearance by which its centre of curvature lies beyond the bearing's
} whirl_pad;

/// A bearing.
typedef struct whirl_pads {
    size_t count;                   ///< of pads
    whirl_pad pads[WHIRL_MAX_PADS]; ///< [count]
    double ratio;                   ///< L/D, length over diameter
    bool tilting;                   ///< pads tilt about their pivots; else they are fixed
    /// The full film's pressures below 0 are left out (Guembel 1914); else pressure and its gradient vanish where the
    /// film breaks (Swift 1932, Stieber 1933).
    bool gumbel;
    int fineness;                ///< volumes around a full circle of the finest of the grids, a multiple of 16; 0: 960
    bool halved;                 ///< half as many volumes both ways: what that changes tells how good an answer is
    whirl_turbulence turbulence; ///< of the films, by the local Reynolds number, `reynolds` times the thickness
    double reynolds;             ///< density Omega R c/mu
    double supply;          ///< pressure in the grooves before and after every pad, over 6 mu Omega (R/c)^2; fixed pads
    double groove;          ///< share of the length over which it stands there; from there it falls evenly to the end
    double pivot_stiffness; ///< of a tilting pad's pivot along the radius; 0: rigid
    double pivot_damping;   ///< the same of its damping
    double pad_mass;        ///< m Omega c^3/(mu L R^3), of a pad on such a pivot
} whirl_pads;

/// What a bearing does with its journal at a place.
typedef struct whirl_pads_state {
    double at[2];                  ///< the journal's place from the centre of the bearing
    double force[2];               ///< on the journal
    double load[WHIRL_MAX_PADS];   ///< of every pad
    double tilt[WHIRL_MAX_PADS];   ///< R delta/c of every pad, above 0 with the rotation; 0 of fixed pads
    double yield[WHIRL_MAX_PADS];  ///< by which the load moves a pad outwards on its pivot
    double thrust[WHIRL_MAX_PADS]; ///< of its film on every pad, outwards along the radius of its pivot
    double moment[WHIRL_MAX_PADS]; ///< of every pad about its pivot over R: the force along it, 0 of those that tilt
    bool loaded[WHIRL_MAX_PADS];   ///< it has a film that holds it; of others the tilt is told as 0
    double thinnest;               ///< the least film thickness of loaded pads
    double highest;                ///< the highest pressure over 6 mu Omega (R/c)^2
    double leaving;                ///< oil that leaves at the ends a second, over Omega R c L
    double drag;       ///< torque on the journal over mu Omega R^3 L/c: streams in cavities, no oil between pads
    double grooves[2]; ///< of `force`, that of the oil in the grooves between pads
    /// Derivatives of -force by the place and by the velocity, pads held: [row][column].
    double stiffness[2][2], damping[2][2];
    /// The same of every pad by itself.
    double of_pads[WHIRL_MAX_PADS][2][2][2]; ///< [pad][0: stiffness, 1: damping][row][column]
} whirl_pads_state;

/// "elliptical", "three-lobe", ...: pads of a usual bearing by name, with that preload. False where no bearing is
/// called so. Angles are those of a load along -y: plain (one pad of 360 degrees, its groove opposite to the load),
/// two-groove (160 degrees each, grooves at the sides), elliptical (the same, preloaded), three-lobe (100 degrees
/// each), offset-half (160 degrees each, offset 1: preloaded sideways), tilting-4 (80 degrees each), tilting-5 (60
/// degrees each, the load between two pads).
bool whirl_pads_named(const char *name, double preload, whirl_pads *out);

/// Whether pads lie over one another, where no film is their own; pads `one` and `other`, from 0, are the first two.
bool whirl_pads_overlap(const whirl_pads *bearing, size_t *one, size_t *other);

/// The angle from the end of a pad to the beginning of the next, where a groove is.
double whirl_pads_gap(const whirl_pads *bearing, size_t pad);

/// Where the journal rests under a load (Newton's method, from the middle of the bearing on), with all that
/// whirl_pads_state has. WHIRL_BAD_INPUT where pads are impossible; WHIRL_NUMERICAL_FAILURE where no such place is
/// found; WHIRL_NO_MEMORY.
whirl_status whirl_pads_rest(const whirl_pads *bearing, const double load[2], whirl_pads_state *state);

/// What the bearing does with its journal at rest at a place, pads that tilt balanced, as on rigid pivots.
/// WHIRL_BAD_INPUT also where the journal touches a pad.
whirl_status whirl_pads_at(const whirl_pads *bearing, const double place[2], whirl_pads_state *state);

/// What pads that tilt make of stiffness and damping at a whirl ratio, frequency over speed: condensed
/// Z = K + i ratio C, of pads with a moment of inertia about their pivots over mu L R^5/(Omega c^3)... `inertia` is
/// I Omega c^3/(mu L R^5). Pads on pivots that yield move along the radius, too. Of fixed pads they are those of the
/// state.
void whirl_pads_reduced(const whirl_pads *bearing, const whirl_pads_state *state, double ratio, double inertia,
                        double stiffness[2][2], double damping[2][2]);

#ifdef __cplusplus
}
#endif

#endif
