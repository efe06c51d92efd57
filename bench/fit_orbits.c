// Orbits of the rotor of fit.yaml for the peer SciPy, called by ctypes: whirl's orbits without derivatives by
// parameters, and the right-hand side in plain C.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine.h"

enum { PARAMETERS = 5, STATES = 4, SAMPLES = 64 };

/// Opens the case; NULL if it is bad. Never freed.
const whirl_study *bench_fit_open(const char *path);

/// Moves x [4] over some revolutions of the motion at values e, g, k_r, mu and c; finds the orbit from there, and
/// writes its state to x and its samples of x and y [64][2]. Returns false where there is none.
bool bench_fit_orbit(const whirl_study *study, const double values[PARAMETERS], double omega, int revolutions,
                     double rtol, double *x, double *samples);

/// Computes the right-hand side by time.
void bench_fit_slope(const double values[PARAMETERS], double omega, double t, const double *x, double *slope);

const whirl_study *bench_fit_open(const char *path) {
    static whirl_study study;
    whirl_case *object;
    if (whirl_case_load(path, NULL, &object).code != WHIRL_OK) return NULL;
    return whirl_case_study(object, &study).code == WHIRL_OK ? &study : NULL;
}

typedef struct sampled {
    double *samples;
    size_t count;
} sampled;

static void sample(void *observer, double t, const double *x) {
    sampled *s = observer;
    (void)t;
    if (s->count < SAMPLES) memcpy(s->samples + 2 * s->count++, x, 2 * sizeof *x);
}

bool bench_fit_orbit(const whirl_study *study, const double values[PARAMETERS], double omega, int revolutions,
                     double rtol, double *x, double *samples) {
    static const char *const names[] = {"e", "g", "k_r", "mu", "c", "omega"};
    whirl_given given[PARAMETERS + 1];
    whirl_batch batch = study->batches[0];
    whirl_machine machine;
    for (size_t i = 0; i <= PARAMETERS; i++) given[i] = (whirl_given){names[i], i < PARAMETERS ? values[i] : omega};
    batch.given = given;
    batch.given_count = PARAMETERS + 1;
    if (study->machine(study->family, &batch, NAN, &machine).code != WHIRL_OK) return false;
    // Follow the transient, then find the orbit.
    whirl_orbit_options options = whirl_orbit_default();
    options.integrate.atol *= rtol / options.integrate.rtol;
    options.integrate.rtol = rtol;
    options.tolerance = fmax(options.tolerance, 10.0 * rtol);
    whirl_integrate_options integrate = options.integrate;
    integrate.steps_per_revolution = SAMPLES;
    whirl_integrator *integrator = NULL;
    whirl_orbit *orbit = NULL;
    bool good = whirl_integrator_new(machine.system, &integrate, &integrator).code == WHIRL_OK;
    for (int i = 0; i < revolutions && good; i++)
        good = whirl_integrator_revolve(integrator, x, NULL, NULL) == WHIRL_BOUNDED;
    good = good && whirl_orbit_find(machine.system, x, 1, &options, &orbit).code == WHIRL_OK;
    if (good) {
        double end[STATES];
        sampled s = {samples, 0};
        memcpy(x, orbit->nodes, STATES * sizeof *x);
        memcpy(end, x, sizeof end);
        sample(&s, 0.0, x);
        good = whirl_integrator_revolve(integrator, end, sample, &s) == WHIRL_BOUNDED;
    }
    whirl_orbit_free(orbit);
    whirl_integrator_free(integrator);
    machine.release(machine.owner);
    return good;
}

void bench_fit_slope(const double values[PARAMETERS], double omega, double t, const double *x, double *slope) {
    const double e = values[0], g = values[1], k_r = values[2], mu = values[3], c = values[4];
    const double r = hypot(x[0], x[1]), push = r > g ? k_r * (r - g) / r : 0.0, force = e * omega * omega;
    slope[0] = x[2];
    slope[1] = x[3];
    slope[2] = force * cos(omega * t) - c * x[2] - x[0] - push * (x[0] - mu * x[1]);
    slope[3] = force * sin(omega * t) - c * x[3] - x[1] - push * (x[1] + mu * x[0]) - 0.5;
}
