/// Journal bearings of fixed or tilting pads: forces of their films of finite length, equilibrium of the journal under
/// a load, stiffness and damping.
///
/// All quantities are dimensionless: lengths in the pads' radial clearance c, velocities in c Omega, forces in mu Omega
/// R L (R/c)^2, so stiffness in mu Omega R L R^2/c^3 and damping in mu R L R^2/c^3. Angles go from x to y, the
/// direction in which the journal turns. The films obey Reynolds' equation (1886) with constant viscosity, laminar or
/// with factors of turbulence. The pressure is ambient at the ends of the pads and, unless grooves are supplied under
/// pressure, at their edges. The clearance of the bearing, the radius of its clearance circle, is (1 - preload) c.
#ifndef WHIRL_BEARING_H
#define WHIRL_BEARING_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Maximum number of pads of a bearing.
enum { WHIRL_MAX_PADS = 12 };

/// Factors of turbulence of a film.
typedef enum whirl_turbulence {
    WHIRL_LAMINAR,       ///< none
    WHIRL_NG_PAN,        ///< Ng, Pan 1965
    WHIRL_CONSTANTINESCU ///< Constantinescu 1962
} whirl_turbulence;

/// A pad.
typedef struct whirl_pad {
    double pivot;   ///< rad, of its pivot, or of the line of preload of a fixed pad
    double arc;     ///< rad, its length
    double offset;  ///< share of the arc before the pivot; 0.5: centred
    double preload; ///< distance of its centre of curvature from the bearing's, as a share of the clearance
} whirl_pad;

/// A bearing.
typedef struct whirl_pads {
    size_t count;                   ///< number of pads
    whirl_pad pads[WHIRL_MAX_PADS]; ///< [count]
    double ratio;                   ///< L/D, length over diameter
    bool tilting;                   ///< pads tilt about their pivots; else they are fixed
    /// True: pressures of the full film below 0 are set to 0 (Guembel 1914); false: pressure and its gradient vanish
    /// where the film breaks (Swift 1932, Stieber 1933).
    bool gumbel;
    int fineness; ///< volumes of the finest grid around a full circle, a multiple of 16; 0: 960
    bool halved;  ///< half as many volumes in both directions, to estimate the error
    /// Turbulence of the films, by the local Reynolds number, `reynolds` times the thickness.
    whirl_turbulence turbulence;
    double reynolds; ///< density Omega R c/mu
    double supply;   ///< pressure in the grooves before and after every pad, over 6 mu Omega (R/c)^2; fixed pads only
    double groove;   ///< share of the length with that pressure; it falls linearly from there to the ends
    double pivot_stiffness; ///< stiffness of a tilting pad's pivot along the radius; 0: rigid
    double pivot_damping;   ///< damping of the pivot along the radius
    double pad_mass;        ///< m Omega c^3/(mu L R^3), of a pad on such a pivot
} whirl_pads;

/// Films, forces and coefficients of a bearing with its journal at a position.
typedef struct whirl_pads_state {
    double at[2];                  ///< position of the journal from the centre of the bearing
    double force[2];               ///< force on the journal
    double load[WHIRL_MAX_PADS];   ///< load of every pad
    double tilt[WHIRL_MAX_PADS];   ///< R delta/c of every pad, above 0 with the rotation; 0 for fixed pads
    double yield[WHIRL_MAX_PADS];  ///< outward displacement of every pad on its pivot under its load
    double thrust[WHIRL_MAX_PADS]; ///< force of the film on every pad, outwards along the radius of its pivot
    /// Moment on every pad about its pivot, over R: the force along the pad; 0 for tilting pads.
    double moment[WHIRL_MAX_PADS];
    bool loaded[WHIRL_MAX_PADS]; ///< true if a film carries the pad; otherwise its tilt is reported as 0
    double thinnest;             ///< least film thickness of loaded pads
    double highest;              ///< highest pressure over 6 mu Omega (R/c)^2
    double leaving;              ///< oil that leaves at the ends in a second, over Omega R c L
    double drag;       ///< torque on the journal over mu Omega R^3 L/c, with streamers in cavities and no oil between
                       ///< pads
    double grooves[2]; ///< part of `force` from the oil in the grooves between pads
    /// Derivatives of -force by position and velocity with fixed tilts: [row][column].
    double stiffness[2][2], damping[2][2];
    /// The same derivatives for every pad.
    double of_pads[WHIRL_MAX_PADS][2][2][2]; ///< [pad][0: stiffness, 1: damping][row][column]
} whirl_pads_state;

/// Fills the pads of a usual bearing by name ("elliptical", "three-lobe", ...) with that preload. False for an unknown
/// name. Angles are for a load along -y: plain (one pad of 360 degrees, its groove opposite to the load), two-groove
/// (160 degrees each, grooves at the sides), elliptical (the same, preloaded), three-lobe (100 degrees each),
/// four-lobe (70 degrees each), offset-half (160 degrees each, offset 1: preloaded sideways), tilting-4 (80 degrees
/// each), tilting-5 (60 degrees each, the load between two pads).
bool whirl_pads_named(const char *name, double preload, whirl_pads *out);

/// Returns true if pads overlap, which leaves their films undefined; pads `one` and `other`, from 0, are the first such
/// pair.
bool whirl_pads_overlap(const whirl_pads *bearing, size_t *one, size_t *other);

/// Returns the angle from the end of a pad to the beginning of the next, across the groove.
double whirl_pads_gap(const whirl_pads *bearing, size_t pad);

/// Finds the equilibrium of the journal under a load (Newton's method from the centre of the bearing), with its films
/// and coefficients. WHIRL_BAD_INPUT for impossible pads; WHIRL_NUMERICAL_FAILURE if no equilibrium is found;
/// WHIRL_NO_MEMORY.
whirl_status whirl_pads_rest(const whirl_pads *bearing, const double load[2], whirl_pads_state *state);

/// Computes the state of a bearing with its journal at rest at a position, and tilting pads balanced, on rigid pivots.
/// Errors as whirl_pads_rest; WHIRL_BAD_INPUT also if the journal touches a pad.
whirl_status whirl_pads_at(const whirl_pads *bearing, const double place[2], whirl_pads_state *state);

/// Reduces stiffness and damping of tilting pads at a whirl ratio, frequency over speed: condensed Z = K + i ratio C.
/// `inertia` is I Omega c^3/(mu L R^5), I the moment of inertia of a pad about its pivot. Pads on flexible pivots also
/// move along the radius. For fixed pads the results are those of the state.
void whirl_pads_reduced(const whirl_pads *bearing, const whirl_pads_state *state, double ratio, double inertia,
                        double stiffness[2][2], double damping[2][2]);

#ifdef __cplusplus
}
#endif

#endif
