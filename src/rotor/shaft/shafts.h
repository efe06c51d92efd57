/// Shafts of finite elements in a design: materials, shafts, and their segments.
#ifndef ROTOR_SHAFTS_H
#define ROTOR_SHAFTS_H

#include "element.h"

#include <stdbool.h>

// ---------------------------------------------------------------- timoshenko
// The finite element of a shaft: a piece that bends and shears, and carries mass and rotary inertia.
//
// In one plane the coordinates of a piece are displacement and slope of its left end, then of its right end; a slope
// is the derivative of the displacement along the shaft where nothing shears, so that both planes of a round shaft
// have the same matrices. The displacements between the ends are those of a piece without mass, exactly, for any taper
// (Friswell et al. 2010, sec. 5.4; Przemieniecki 1968): for a cylinder the element of Timoshenko beams with cubic
// displacements, phi = 12 E I/(kappa G A L^2).

/// Shear coefficient: Cowper 1966 and Hutchinson 2001, for hollow circles; none: Bernoulli, Euler, Rayleigh.
typedef enum shear_law { SHEAR_COWPER, SHEAR_HUTCHINSON, SHEAR_NONE } shear_law;

/// Pa, Pa, kg/m3.
typedef struct material {
    double modulus, shear_modulus, density;
} material;

/// m; N.
typedef struct shaft_piece {
    double length;
    double outer[2], inner[2]; ///< diameters at its ends
    double flats;              ///< distance of two flats across the shaft; 0: it is round
    material of;
    shear_law shear;
    bool rotary;     ///< with rotary inertia
    double axial[2]; ///< axial force at its ends, positive where it pulls; linear between them
} shaft_piece;

/// By displacement and slope of the left end, then of the right one.
typedef struct matrix4 {
    double at[4][4];
} matrix4;

/// SI.
typedef struct piece_matrices {
    /// In the plane of the larger and of the smaller stiffness, across flats and along their normal.
    matrix4 stiffness[2];
    matrix4 axial;    ///< stiffness by the axial force
    matrix4 mass;     ///< consistent, with the rotary inertia
    matrix4 polar;    ///< gyroscopic moments per rate of rotation
    double weight[4]; ///< force and moment of its weight on the ends, over gravity: kg, kg m
    double lumped_mass[2], lumped_diametral[2], lumped_polar[2]; ///< lumped at its ends: kg, kg m2
    /// Against twist: N m/rad between its ends, and inertia, kg m2, of the twists of left and left, left and right,
    /// right and right end; exact for any taper without mass, as bending is.
    double twist_stiffness, twist_inertia[3];
} piece_matrices;

void piece_fill(const shaft_piece *piece, piece_matrices *out);

/// Computes the displacement at a share `at` of its length from its left end, by one of each coordinate, in the plane
/// of the larger stiffness.
void piece_shape(const shaft_piece *piece, double at, double moved[4]);

/// Returns mass per metre, kg/m, and smaller bending stiffness, N m2, at a share `at` of its length from its left end.
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
    SHAFT_TWIST,
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

/// Keys of the element `gravity`, and the words of its `axis`.
enum { GRAVITY_ACCELERATION, GRAVITY_DIRECTION, GRAVITY_AXIS, GRAVITY_HELD_AT, GRAVITY_TOP, GRAVITY_KEYS };
enum { GRAVITY_HORIZONTAL, GRAVITY_VERTICAL };

extern const whirl_group material_group, shaft_group;

/// A shaft's own settings, in SI.
typedef struct shaft_settings {
    bool lumped, rotary, gyroscopic;
    shear_law shear;
    double ratio;               ///< its speed over the rotor's
    bool twists;                ///< its nodes twist
    double alpha, beta;         ///< proportional damping, 1/s and s
    double viscous, hysteretic; ///< internal damping, s and 1
    double mesh_to;             ///< Hz; 0: not said
    bool reduced;
    size_t modes;    ///< kept in a plane, at most
    double modes_to; ///< Hz, in place of their number; 0: not said
} shaft_settings;

/// Reads a material from its keys. WHIRL_BAD_INPUT if keys contradict each other.
whirl_status material_from(const key_value *values, material *out);
whirl_status shaft_settings_from(const key_value *values, shaft_settings *out);

/// Returns the settings of a segment: its shaft's, overridden by its own keys.
shaft_settings segment_settings_from(const key_value *values, const shaft_settings *shaft);

/// Default material of shafts.
extern const material shaft_steel;

#endif
