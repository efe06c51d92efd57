/// Laws of elements as plain C functions, one element at a time: the peers of whirl's kernels in lanes. All balls or
/// blades share one sine and cosine a turn, open contacts return at once, and no division is repeated. All numbers are
/// in the units of the machines in elements.c.
#ifndef BENCH_ELEMENT_LAWS_H
#define BENCH_ELEMENT_LAWS_H

enum { LAW_STATES = 8, LAW_BLADES = 12 };

/// Computes the forces along the axes at displacements d and velocities w, [2] or [4], and the slopes of the states s.
typedef void element_law(const void *law, const double *d, const double *w, const double *s, double *force,
                         double *slope);

/// strength: mu omega R L^3/(4 c^2); drag: rate of the ring's speed for a relative speed of 1, at e = 0.
typedef struct film_law {
    double clearance, strength, drag;
} film_law;

/// A journal in a ring in a housing; s: the ring's speed less `speed`, which is its speed while all are concentric.
typedef struct ring_law {
    film_law inner, outer;
    double speed;
} ring_law;

/// A film of finite length by the polynomials of film_ratio.h.
typedef struct finite_law {
    film_law film;
    double coefficients[200];
} finite_law;

typedef struct dent_law {
    double depth, width, start;
} dent_law;

/// s: the angles of the cage and, with dents, of inner race, outer race and ball.
typedef struct rolling_law {
    int count, line, oblique, dented; ///< line: 1 for rollers, 0 for balls
    double stiffness, gap, cage;
    double centres, radial, axial;
    dent_law dents[3];
    double rates[4], apart[64][2]; ///< apart: cosine and sine of the angle of each ball from the first
} rolling_law;

typedef struct seal_law {
    double clearance, stiffness, damping, mass, ratio, growth, slowing;
} seal_law;

enum { RUB_SMOOTH, RUB_STRIBECK, RUB_LUGRE };

/// s: the deflections of the bristles in LuGre's friction.
typedef struct contact_law {
    double gap, stiffness, power, loss, surface;
    double kinetic, excess, stribeck_speed, slip_speed, bristle, bristle_damping;
    int friction, slips;
} contact_law;

/// s: the angle of the first blade.
typedef struct blade_law {
    int count;
    double casing, length, stiffness, power, friction, apart[LAW_BLADES][2];
} blade_law;

/// s: for each axis the states of sensor, PID (2) and amplifier.
typedef struct magnet_law {
    double constant, gap, bias, most, cosine, sine;
    double sensor, amplifier, proportional, integral, derivative, filter; ///< corner frequencies; gains; filter: 1/T
} magnet_law;

element_law ring_force, finite_force, rolling_force, seal_force, contact_force, blade_force, magnet_force;

#endif
