/// An overhung rotor of 20 finite elements (84 coordinates) on two oil films, with a disc that may rub: reduced to the
/// displacements of its three stations and 16 modal coordinates, from rest by RK4 in 512 steps per revolution, which
/// resolve its highest mode. What whirl and its peers have in common.
///
/// Time is tau = speed t, displacements are in clearances. With q the 22 coordinates, ' = d/dtau:
///
///     q'' = -(OVERHUNG_SPEED/speed)^2 (K q + g) - G q' + u cos tau + w sin tau + P F/(speed^2 clearance)
///
/// F are the forces in newtons of films and rub on the first six coordinates: x and y of left, right and disc.
/// bench_overhung_matrices writes the matrices.
#ifndef BENCH_OVERHUNG_H
#define BENCH_OVERHUNG_H

enum {
    OVERHUNG_STEPS = 512,
    OVERHUNG_PORTS = 6,
    OVERHUNG_MODES = 16,
    OVERHUNG_DEGREES = OVERHUNG_PORTS + OVERHUNG_MODES,
    OVERHUNG_DIMENSION = 2 * OVERHUNG_DEGREES
};

#define OVERHUNG_CLEARANCE 80e-6   ///< m, the unit of length
#define OVERHUNG_ECCENTRICITY 8e-6 ///< m
#define OVERHUNG_VISCOSITY 0.02    ///< Pa s
#define OVERHUNG_GAP 150e-6        ///< m
#define OVERHUNG_STIFFNESS 20e6    ///< N/m
#define OVERHUNG_DAMPING 500.0     ///< N s/m
#define OVERHUNG_FRICTION 0.1
#define OVERHUNG_RTOL 1e-6 ///< relative tolerance of adaptive methods
#define OVERHUNG_ATOL 1e-9
#define OVERHUNG_SPEED 628.0 ///< rad/s, of single machines and of the first of many

static const double overhung_radius[2] = {0.02, 0.025}, overhung_length[2] = {0.025, 0.03}; ///< m, of the films

/// y of the stations at rest at the start, in clearances.
static const double overhung_start[OVERHUNG_PORTS / 2] = {-0.3, -0.6, -0.8};

/// Returns the speed of machine i of n side by side; only the end state of the first is compared.
static inline double overhung_speed(int i, int n) {
    return OVERHUNG_SPEED + 372.0 * i / (n > 1 ? n - 1 : 1);
}

/// Scales that follow from a speed, for forces per unit of inertia.
typedef struct overhung_scales {
    double stiffness, film[2], push, damping; ///< scales of K and g, of each film, of the rub's stiffness and damping
} overhung_scales;

static inline overhung_scales overhung_scales_at(double speed) {
    const double ratio = OVERHUNG_SPEED / speed;
    overhung_scales scales = {
        ratio * ratio, {0.0, 0.0}, OVERHUNG_STIFFNESS / (speed * speed), OVERHUNG_DAMPING / speed};
    for (int i = 0; i < 2; i++) {
        const double length = overhung_length[i], c = OVERHUNG_CLEARANCE;
        scales.film[i] = OVERHUNG_VISCOSITY * overhung_radius[i] * length * length * length / (4.0 * c * c * c * speed);
    }
    return scales;
}

/// Matrices in the order in which bench_overhung_matrices writes them.
typedef struct overhung_matrices {
    double K[OVERHUNG_DEGREES][OVERHUNG_DEGREES], G[OVERHUNG_DEGREES][OVERHUNG_DEGREES];
    double P[OVERHUNG_PORTS][OVERHUNG_DEGREES]; ///< a column each
    double g[OVERHUNG_DEGREES], u[OVERHUNG_DEGREES], w[OVERHUNG_DEGREES];
} overhung_matrices;

/// Reads the matrices from a file; a failure ends the program.
overhung_matrices overhung_read(const char *path);

#endif
