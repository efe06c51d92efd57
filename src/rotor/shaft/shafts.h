/// Shafts of finite elements in a design: materials, shafts, and their segments.
#ifndef ROTOR_SHAFTS_H
#define ROTOR_SHAFTS_H

#include "element.h"

#include <stdbool.h>

// ---------------------------------------------------------------- timoshenko
// The finite element of a shaft: a piece that bends and shears, and carries mass and rotary inertia.
//
// In one plane the coordinates of a piece are displacement and slope of its left end, then of its right end. Without
// shear a slope is the derivative of the displacement along the shaft, so that both planes of a round shaft have the
// same matrices. Between the ends the displacements are exactly those of a piece without mass, for any taper (Friswell
// et al. 2010, sec. 5.4; Przemieniecki 1968). For a cylinder this is the element of Timoshenko beams with cubic
// displacements, phi = 12 E I/(kappa G A L^2).

/// Shear coefficient, by Cowper 1966 or Hutchinson 2001 for hollow circles. none: beams of Bernoulli, Euler and
/// Rayleigh.
typedef enum shear_law { SHEAR_COWPER, SHEAR_HUTCHINSON, SHEAR_NONE } shear_law;

/// A material: moduli in Pa, density in kg/m3.
typedef struct material {
    double modulus, shear_modulus, density;
} material;

/// A piece of a shaft, in m and N.
typedef struct shaft_piece {
    double length;
    double outer[2], inner[2]; ///< diameters at its ends
    double flats;              ///< distance of two flats across the shaft; 0: it is round
    material of;
    shear_law shear;
    bool rotary;     ///< the piece has rotary inertia
    double axial[2]; ///< axial force at its ends, positive where it pulls; linear between them
} shaft_piece;

/// A matrix for displacement and slope of the left end, then of the right end.
typedef struct matrix4 {
    double at[4][4];
} matrix4;

/// The matrices of a piece against twist or along its axis. The stiffness is exact for any taper, as that of bending
/// is.
typedef struct line_matrices {
    double stiffness;  ///< between its ends, N m/rad or N/m
    double inertia[3]; ///< entries left-left, left-right and right-right for the two ends, kg m2 or kg
} line_matrices;

/// The matrices of a piece, SI.
typedef struct piece_matrices {
    /// Stiffness in the plane of larger and in that of smaller stiffness: across the flats, and along their normal.
    matrix4 stiffness[2];
    matrix4 axial;    ///< stiffness by the axial force
    matrix4 mass;     ///< consistent, with the rotary inertia
    matrix4 polar;    ///< gyroscopic moments per rate of rotation
    double weight[4]; ///< force and moment of its weight on the ends, divided by gravity: kg, kg m
    double lumped_mass[2], lumped_diametral[2], lumped_polar[2]; ///< lumped at its ends: kg, kg m2
    line_matrices twist, stretch;
} piece_matrices;

/// Computes all matrices of a piece.
void piece_fill(const shaft_piece *piece, piece_matrices *out);

/// Computes the displacement at a share `at` of its length from its left end, by one unit of each coordinate, in the
/// plane of the larger stiffness.
void piece_shape(const shaft_piece *piece, double at, double moved[4]);

/// Returns, at a share `at` of its length from its left end, the mass per metre, kg/m, and the smaller bending
/// stiffness, N m2.
double piece_line_mass(const shaft_piece *piece, double at);
double piece_bending(const shaft_piece *piece, double at);

/// Keys of `materials`, `shafts` and the element `segment`, in the order of their tables.
enum { MATERIAL_MODULUS, MATERIAL_SHEAR_MODULUS, MATERIAL_POISSON, MATERIAL_DENSITY, MATERIAL_KEYS };
enum {
    SHAFT_MATERIAL,
    SHAFT_MASS,
    SHAFT_SHEAR,
    SHAFT_ROTARY,
    SHAFT_GYROSCOPIC,
    SHAFT_RATIO,
    SHAFT_SPEED,
    SHAFT_TWIST,
    SHAFT_AXIAL,
    SHAFT_MASS_DAMPING,
    SHAFT_STIFFNESS_DAMPING,
    SHAFT_VISCOUS,
    SHAFT_HYSTERETIC,
    SHAFT_MESH_TO,
    SHAFT_REDUCE,
    SHAFT_MODES,
    SHAFT_MODES_TO,
    SHAFT_KEYS
};
enum {
    SEGMENT_LENGTH,
    SEGMENT_OUTER,
    SEGMENT_INNER,
    SEGMENT_OUTER_END,
    SEGMENT_INNER_END,
    SEGMENT_FLATS,
    SEGMENT_FLATS_ANGLE,
    SEGMENT_SHAFT,
    SEGMENT_START,
    SEGMENT_FROM,
    SEGMENT_TO,
    SEGMENT_MATERIAL,
    SEGMENT_ELEMENTS,
    SEGMENT_AXIAL_FORCE,
    SEGMENT_SHEAR,
    SEGMENT_ROTARY,
    SEGMENT_GYROSCOPIC,
    SEGMENT_MASS_DAMPING,
    SEGMENT_STIFFNESS_DAMPING,
    SEGMENT_KEYS
};

/// Keys of the element `gravity`, and the choices of its key `axis`.
enum { GRAVITY_ACCELERATION, GRAVITY_DIRECTION, GRAVITY_AXIS, GRAVITY_HELD_AT, GRAVITY_TOP, GRAVITY_KEYS };
enum { GRAVITY_HORIZONTAL, GRAVITY_VERTICAL };

extern const whirl_group material_group, shaft_group;

/// The settings of a shaft, in SI.
typedef struct shaft_settings {
    bool lumped, rotary, gyroscopic;
    shear_law shear;
    double ratio;       ///< ratio of its speed to the rotor's
    size_t spool;       ///< number of its speed among those of their own, from 1; 0: the speed follows the rotor's
    bool meshed;        ///< it has segments; otherwise its stations are lumped
    bool twists, axial; ///< its nodes twist; they move along the shaft
    double alpha, beta; ///< proportional damping, 1/s and s
    double viscous, hysteretic; ///< internal damping, s and 1
    double mesh_to;             ///< highest frequency that the mesh resolves, Hz; 0: not given
    bool reduced;
    size_t modes;    ///< most modes that are kept in a plane
    double modes_to; ///< highest frequency of kept modes, in place of their number, Hz; 0: not given
} shaft_settings;

/// Read a material, and the settings of a shaft, from their keys. WHIRL_BAD_INPUT if keys contradict each other.
whirl_status material_from(const key_value *values, material *out);
whirl_status shaft_settings_from(const key_value *values, shaft_settings *out);

/// Returns the settings of a segment: those of its shaft, overridden by the keys of the segment.
shaft_settings segment_settings_from(const key_value *values, const shaft_settings *shaft);

/// Default material of shafts.
extern const material shaft_steel;

#endif
