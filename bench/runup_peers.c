// The run-up of runup.yaml for peers, called by ctypes: its equations in plain C, and Newmark's method with steps of
// equal length.
//
// An unbalanced disc on a spring, and a motor whose torque T falls with the speed w:
//
//     x'' = (-c x' - k x)/m + e (w^2 cos + w' sin),  y'' = (-c y' - k y)/m + e (w^2 sin - w' cos),
//     J w' = T + m e (X sin - Y cos), where X and Y are the accelerations without w'.
#include <math.h>
#include <stdbool.h>

static const double mass = 10.0, damping = 40.0, stiffness = 1e5, eccentricity = 0.5e-3, inertia = 0.5, torque = 3.0,
                    no_load = 314.159265358979323846;

/// Computes the accelerations of x, y and the angle from z: x, y, angle, and their velocities.
static void accelerate(const double z[6], double a[3]) {
    const double c = cos(z[2]), s = sin(z[2]), w = z[5];
    const double free_x = (-damping * z[3] - stiffness * z[0]) / mass + eccentricity * w * w * c;
    const double free_y = (-damping * z[4] - stiffness * z[1]) / mass + eccentricity * w * w * s;
    a[2] = (torque * (1.0 - w / no_load) + mass * eccentricity * (free_x * s - free_y * c)) / inertia;
    a[0] = free_x + eccentricity * a[2] * s;
    a[1] = free_y - eccentricity * a[2] * c;
}

/// Computes the right-hand side [6] of z [6], as accelerate has it.
void bench_runup_slope(const double *z, double *slope);
void bench_runup_slope(const double *z, double *slope) {
    for (int i = 0; i < 3; i++) slope[i] = z[3 + i];
    accelerate(z, slope + 3);
}

/// Carries z [6] over `steps` steps of length h by Newmark's method of constant mean acceleration (1959). Each step is
/// repeated until its accelerations have settled.
void bench_runup_newmark(double *z, double h, long steps);
void bench_runup_newmark(double *z, double h, long steps) {
    enum { MAX_REPEATS = 50 };
    double a[3];
    accelerate(z, a);
    for (long n = 0; n < steps; n++) {
        double next[6], b[3] = {a[0], a[1], a[2]};
        bool settled = false;
        for (int repeat = 0; repeat < MAX_REPEATS && !settled; repeat++) {
            double found[3];
            for (int i = 0; i < 3; i++) {
                next[i] = z[i] + h * z[3 + i] + 0.25 * h * h * (a[i] + b[i]);
                next[3 + i] = z[3 + i] + 0.5 * h * (a[i] + b[i]);
            }
            accelerate(next, found);
            settled = true;
            for (int i = 0; i < 3; i++) {
                settled = settled && fabs(found[i] - b[i]) <= 1e-12 * (fabs(found[i]) + 1.0);
                b[i] = found[i];
            }
        }
        for (int i = 0; i < 6; i++) z[i] = next[i];
        for (int i = 0; i < 3; i++) a[i] = b[i];
    }
}
