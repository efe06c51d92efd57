// Reference: how small machines move that hold one element each; a program of its own, which shares nothing with whirl.
//
// The equations are written in newtons, metres and seconds as the sources give them: films and squeeze films as
// integrals of Reynolds' pressure over their circumference, gyroscopic rotors and seals in complex numbers. The
// machines are those of motions/*.yaml. Each motion is carried by the classical Runge-Kutta method with fixed steps,
// its transient left out; its kind follows from its returns and from the growth of a small difference
// (Benettin et al. 1980). All is done twice, the second time with twice the steps: a motion that is not the same both
// times, or whose kind is not clear, is printed as "?" and is no reference.
//
//     element_motions [MACHINE [COUNT]]   prints the table element_motions.txt, or of a machine the first COUNT lines
#include <complex.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DIMENSION = 8, LONGEST = 96, SETTLING = 4000, SECTIONS = 2000, BLOCKS = 20 };

static const double pi = 3.14159265358979323846;

/// dx/dt of a machine with parameter p at time t.
typedef void slopes_function(double p, double t, const double *x, double *dx);

typedef struct machine {
    const char *name; ///< of its case in motions/
    slopes_function *slopes;
    double
        fixed_speed; ///< rad/s, of one under two forces, which make tori of motions that settle; 0: the parameter is it
    double start[2]; ///< displacements of the first station
    double closeness; ///< of returns that close, which fixed steps over a force that jumps spoil
    int dimension, steps;
    double parameters[16]; ///< up to a 0
} machine;

// ---------------------------------------------------------------- forces

static double above(double d) {
    return d > 0.0 ? d : 0.0;
}

/// Nodes of Gauss and Legendre on (-pi/2, pi/2) as directions, and their weights, by Newton's method on the polynomial.
enum { NODES = 40 };
static double along[NODES], across[NODES], weight[NODES];

static void make_nodes(void) {
    for (int i = 0; i < NODES; i++) {
        double z = cos(pi * (i + 0.75) / (NODES + 0.5)), slope = 0.0;
        for (int n = 0; n < 50; n++) {
            double p = 1.0, before = 0.0;
            for (int j = 0; j < NODES; j++) {
                const double last = before;
                before = p;
                p = ((2.0 * j + 1.0) * z * before - j * last) / (j + 1.0);
            }
            slope = NODES * (z * p - before) / (z * z - 1.0);
            z -= p / slope;
        }
        along[i] = cos(0.5 * pi * z);
        across[i] = sin(0.5 * pi * z);
        weight[i] = pi / ((1.0 - z * z) * slope * slope);
    }
}

/// Returns the force of a short film on a journal at r, in clearances: minus the integral of (g . n)/(1 - r . n)^3 n
/// over the half circle on which g . n > 0, times mu R L^3/c^2.
static double complex film_force(double complex r, double complex g) {
    const double size = cabs(g), x = creal(r), y = cimag(r);
    const double u = size > 0.0 ? creal(g) / size : 1.0, v = size > 0.0 ? cimag(g) / size : 0.0;
    double pull[2] = {0.0, 0.0};
    for (int i = 0; i < NODES; i++) {
        const double n[2] = {u * along[i] - v * across[i], u * across[i] + v * along[i]};
        const double h = 1.0 - x * n[0] - y * n[1], share = weight[i] * size * along[i] / (h * h * h);
        for (int a = 0; a < 2; a++) pull[a] -= share * n[a];
    }
    return pull[0] + I * pull[1];
}

/// Returns the force of a stator with this gap, with friction always against the rotation.
static double complex rub_force(double complex r, double gap, double stiffness, double friction) {
    const double depth = above(cabs(r) - gap);
    return depth > 0.0 ? -stiffness * depth * (1.0 + I * friction) * r / cabs(r) : 0.0;
}

static double complex unbalance_force(double moment, double speed, double t) {
    return moment * speed * speed * cexp(I * speed * t);
}

static double complex at(const double *x, int i) {
    return x[i] + I * x[i + 1];
}

static void put(double *x, int i, double complex z) {
    x[i] = creal(z);
    x[i + 1] = cimag(z);
}

// ---------------------------------------------------------------- machines

/// A mass between two stops, driven along y.
static void play(double p, double t, const double *x, double *dx) {
    const double f = above(x[0] - 0.5) - above(-x[0] - 0.5);
    dx[0] = x[1];
    dx[1] = 0.4 * p * p * sin(p * t) - 0.1 * x[1] - 0.2 * x[0] - 20.0 * f;
}

/// A pedestal that lifts from its seat, with unequal dampers and a stop above.
static void looseness(double p, double t, const double *x, double *dx) {
    const double d = x[0], v = x[1];
    const double f = d < 0.0 ? 10.0 * d + 0.6 * v : d < 1.0 ? 0.1 * d + 0.1 * v : 0.1 + 10.0 * (d - 1.0) + 0.6 * v;
    dx[0] = v;
    dx[1] = 0.3 * p * p * sin(p * t) - f - 0.5;
}

/// A breathing crack (Mayes and Davies 1984): stiffness 1 (1 - 0.5 f) towards it, 1 (1 - 0.1 f) across.
static void crack(double p, double t, const double *x, double *dx) {
    const double open = 0.5 * (1.0 + cos(p * t + 0.5 * pi));
    const double complex turn = cexp(I * p * t), r = at(x, 0) / turn;
    const double complex force = -(1.0 - 0.5 * open) * creal(r) - I * (1.0 - 0.1 * open) * cimag(r);
    put(dx, 0, at(x, 2));
    put(dx, 2, force * turn - 0.04 * at(x, 2) + unbalance_force(0.05, p, t) - 0.1 * I);
}

/// A disc on a spring in a squeeze film damper, under gravity.
static void squeeze(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2);
    put(dx, 0, v);
    put(dx, 2, 0.004 * film_force(r, v) - 0.05 * r - 0.02 * v + unbalance_force(0.3, p, t) - 0.1 * I);
}

/// A journal in a short film: h = 1 - r . n, with the wedge -i r p and the squeeze 2 v.
static void film(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2);
    put(dx, 0, v);
    put(dx, 2, 0.5 * 0.2 * film_force(r, 2.0 * v - I * p * r) + unbalance_force(0.25, p, t) - 1.0 * I);
}

/// A seal (Muszynska 1988) on a shaft.
static void seal(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2);
    const double e = cabs(r), growth = pow(1.0 - e * e, -2.0), lambda = 0.5 * p * pow(1.0 - e, 0.5);
    const double complex force =
        0.3 * growth * r + 0.3 * growth * (v - I * lambda * r) - 0.2 * (2.0 * I * lambda * v + lambda * lambda * r);
    put(dx, 0, v);
    put(dx, 2, (-force - r - 0.1 * v + unbalance_force(0.03, p, t) - 0.1 * I) / 1.2);
}

/// A ball bearing of eight balls (Fukata et al. 1985); x[4] is no state, the cage's angle follows from the time.
static void ball_bearing(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2);
    double complex force = 0.0;
    for (int j = 0; j < 8; j++) {
        const double complex n = cexp(I * (0.4 * p * t + 2.0 * pi * j / 8.0));
        force -= 30.0 * pow(above(creal(conj(n) * r) - 0.2), 1.5) * n;
    }
    put(dx, 0, v);
    put(dx, 2, force - 0.2 * v + unbalance_force(0.1, p, t) - 0.5 * I);
}

/// A disc on an elastomer (a standard linear solid, whose damper is s long) that rubs.
static void mount(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2), s = at(x, 4);
    put(dx, 0, v);
    put(dx, 2, -0.6 * r - 0.8 * (r - s) + rub_force(r, 1.0, 12.0, 0.05) + unbalance_force(0.9, p, t) - 0.5 * I);
    put(dx, 4, 0.8 * (r - s) / 1.0);
}

/// A rotor on a bearing with cross-coupled stiffness that rubs.
static void bearing(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), v = at(x, 2);
    put(dx, 0, v);
    put(dx, 2, -(1.0 - 0.05 * I) * r - 0.2 * v + rub_force(r, 1.0, 14.0, 0.05) + unbalance_force(0.9, p, t) - 0.5 * I);
}

/// A mass between two stops with a second force of p times the frequency of the first.
static void harmonic(double p, double t, const double *x, double *dx) {
    const double f = above(x[0] - 0.8) - above(-x[0] - 0.8);
    dx[0] = x[1];
    dx[1] = 0.3 * sin(t) + 0.2 * cos(p * t) - 0.2 * x[1] - 0.5 * x[0] - 4.0 * f;
}

/// An overhung disc that tilts, on a clamped massless beam of length 1 and bending stiffness 1/3, that rubs.
static void beam(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), tilt = at(x, 2), v = at(x, 4), w = at(x, 6);
    const double stiffness = 1.0 / 3.0, moment = 0.05, polar = 0.09;
    put(dx, 0, v);
    put(dx, 2, w);
    put(dx, 4,
        -stiffness * (12.0 * r - 6.0 * tilt) - 0.2 * v + rub_force(r, 1.0, 12.0, 0.05) + unbalance_force(0.9, p, t) -
            0.6 * I);
    put(dx, 6, (-stiffness * (4.0 * tilt - 6.0 * r) - 0.02 * w + I * polar * p * w) / moment);
}

/// Two rotors joined by a coupling; the first rubs.
static void coupling(double p, double t, const double *x, double *dx) {
    const double complex r = at(x, 0), q = at(x, 2), v = at(x, 4), w = at(x, 6);
    const double complex between = 0.8 * (r - q) + 0.05 * (v - w);
    put(dx, 0, v);
    put(dx, 2, w);
    put(dx, 4, -between - 0.8 * r - 0.1 * v + rub_force(r, 1.0, 12.0, 0.05) + unbalance_force(0.9, p, t) - 0.6 * I);
    put(dx, 6, (between - 1.5 * q - 0.15 * w) / 0.7 - 0.6 * I);
}

static const machine machines[] = {
    {"play",
     play,
     0.0,
     {0.0, 0.0},
     1e-5,
     2,
     2000,
     {0.8, 1.1, 1.4, 1.7, 2.0, 2.3, 2.6, 2.9, 3.2, 3.5, 3.8, 4.1, 4.5, 5.0, 6.0}},
    {"looseness",
     looseness,
     0.0,
     {-0.05, 0.0},
     2e-3,
     2,
     500,
     {0.6, 1.0, 1.3, 1.6, 1.9, 2.2, 2.5, 2.8, 3.1, 3.4, 3.7, 4.0, 4.5, 5.0, 6.0}},
    {"crack",
     crack,
     0.0,
     {0.1, 0.0},
     1e-5,
     4,
     500,
     {0.3, 0.45, 0.5, 0.6, 0.7, 0.8, 0.85, 0.95, 1.1, 1.3, 1.5, 1.7, 1.75, 1.8, 2.0}},
    {"squeeze", squeeze, 0.0, {0.0, -0.2}, 1e-5, 4, 300, {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.3, 2.6}},
    {"film", film, 0.0, {0.1, -0.4}, 1e-5, 4, 300, {0.6, 1.0, 1.4, 1.8, 2.2, 2.6, 3.0, 3.4, 3.8, 4.2}},
    {"seal", seal, 0.0, {0.0, -0.1}, 1e-5, 4, 300, {0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.5, 4.0}},
    {"ball_bearing",
     ball_bearing,
     0.0,
     {0.0, -0.2},
     1e-5,
     4,
     500,
     {0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.5, 4.0, 5.0, 6.0}},
    {"mount",
     mount,
     0.0,
     {0.0, -0.2},
     1e-5,
     6,
     4000,
     {0.4, 0.6, 0.8, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0, 2.2}},
    {"bearing",
     bearing,
     0.0,
     {0.0, -0.2},
     1e-5,
     4,
     2000,
     {0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9, 2.1, 2.4, 2.7, 3.0, 3.5, 4.0, 4.3, 4.6}},
    {"harmonic",
     harmonic,
     1.0,
     {0.0, 0.0},
     1e-5,
     2,
     2000,
     {0.5, 0.6180339887, 0.75, 1.25, 1.4142135624, 1.5, 1.6180339887, 1.6666666666666667, 1.75, 1.8, 2.2360679775, 2.5,
      2.6180339887, 2.7182818285, 3.0}},
    {"beam", beam, 0.0, {0.0, -0.2}, 1e-5, 8, 2000, {0.3, 0.6, 0.9, 1.1, 1.3, 1.5, 1.7, 2.0, 2.3, 2.6, 3.0, 3.5, 4.0}},
    {"coupling",
     coupling,
     0.0,
     {0.0, -0.2},
     1e-5,
     8,
     2000,
     {0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.3, 2.6, 3.0, 3.5, 4.0, 4.2, 4.5}},
};
enum { MACHINES = sizeof machines / sizeof *machines };

// ---------------------------------------------------------------- motions

/// Carries x over revolution number n.
static void revolve(const machine *m, double p, int steps, int n, double *x) {
    const double speed = m->fixed_speed > 0.0 ? m->fixed_speed : p, h = 2.0 * pi / speed / steps;
    double k[4][MAX_DIMENSION], y[MAX_DIMENSION];
    for (int i = 0; i < steps; i++) {
        const double t = (i + (double)steps * n) * h;
        m->slopes(p, t, x, k[0]);
        for (int d = 0; d < m->dimension; d++) y[d] = x[d] + 0.5 * h * k[0][d];
        m->slopes(p, t + 0.5 * h, y, k[1]);
        for (int d = 0; d < m->dimension; d++) y[d] = x[d] + 0.5 * h * k[1][d];
        m->slopes(p, t + 0.5 * h, y, k[2]);
        for (int d = 0; d < m->dimension; d++) y[d] = x[d] + h * k[2][d];
        m->slopes(p, t + h, y, k[3]);
        for (int d = 0; d < m->dimension; d++) x[d] += h / 6.0 * (k[0][d] + 2.0 * k[1][d] + 2.0 * k[2][d] + k[3][d]);
    }
}

static double distance(const machine *m, const double *a, const double *b) {
    double sum = 0.0;
    for (int d = 0; d < m->dimension; d++) sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sqrt(sum);
}

/// Kind of a motion: the number of revolutions after which it closes, or one of these.
enum { DIVERGED = -1, QUASI_PERIODIC = -2, CHAOTIC = -3, UNCLEAR = -4 };

typedef struct finding {
    int motion;
    double exponent, error; ///< growth of a small difference a revolution; three standard errors of its mean
} finding;

static double sections[SECTIONS][MAX_DIMENSION];

/// Returns the least number of revolutions after which every one of the last sections returns, or 0.
static int closes_after(const machine *m) {
    for (int n = 1; n <= LONGEST; n++) {
        double farthest = 0.0;
        for (int i = SECTIONS - 3 * LONGEST; i + n < SECTIONS; i++)
            farthest = fmax(farthest, distance(m, sections[i], sections[i + n]));
        if (farthest < m->closeness) return n;
    }
    return 0;
}

/// Returns the smallest distance of a later section from the first.
static double nearest_return(const machine *m) {
    double nearest = INFINITY;
    for (int i = 1; i < SECTIONS; i++) nearest = fmin(nearest, distance(m, sections[0], sections[i]));
    return nearest;
}

static finding find(const machine *m, double p, int steps) {
    double x[MAX_DIMENSION] = {m->start[0], m->start[1]}, beside[MAX_DIMENSION], growth[BLOCKS] = {0};
    const double apart = 1e-8;
    finding found = {UNCLEAR, 0.0, 0.0};
    for (int n = 0; n < SETTLING; n++) {
        revolve(m, p, steps, n, x);
        for (int d = 0; d < m->dimension; d++)
            if (!(fabs(x[d]) < 1e6)) return found.motion = DIVERGED, found;
    }
    for (int d = 0; d < m->dimension; d++) beside[d] = x[d] + apart / sqrt(m->dimension);
    for (int n = 0; n < SECTIONS; n++) {
        memcpy(sections[n], x, sizeof x);
        revolve(m, p, steps, SETTLING + n, x);
        revolve(m, p, steps, SETTLING + n, beside);
        const double now = distance(m, x, beside);
        growth[n * BLOCKS / SECTIONS] += log(now / apart);
        for (int d = 0; d < m->dimension; d++) beside[d] = x[d] + (beside[d] - x[d]) * apart / now;
    }
    double square = 0.0;
    for (int b = 1; b < BLOCKS; b++) found.exponent += growth[b] * BLOCKS / SECTIONS / (BLOCKS - 1);
    for (int b = 1; b < BLOCKS; b++) square += pow(growth[b] * BLOCKS / SECTIONS - found.exponent, 2.0);
    found.error = 3.0 * sqrt(square / (BLOCKS - 1) / (BLOCKS - 2));
    const int period = closes_after(m);
    if (period > 0 && found.exponent < -2e-3)
        found.motion = period;
    else if (found.exponent > 0.01 && found.exponent > 2.0 * found.error)
        found.motion = CHAOTIC;
    else if (found.exponent < 2e-3 && (found.exponent > -2e-3 || m->fixed_speed > 0.0) && nearest_return(m) < 0.1)
        found.motion = QUASI_PERIODIC;
    return found;
}

static void print(const machine *m, double p, finding a, finding b) {
    char name[32] = "?";
    if (a.motion == b.motion) {
        if (a.motion > 0) snprintf(name, sizeof name, "P-%d", a.motion);
        if (a.motion == DIVERGED) snprintf(name, sizeof name, "diverged");
        if (a.motion == QUASI_PERIODIC) snprintf(name, sizeof name, "quasi-periodic");
        if (a.motion == CHAOTIC) snprintf(name, sizeof name, "chaotic");
    }
    printf("%s\t%.15g\t%g\t%g\t%s\t%.5f\t%.5f\n", m->name, p, m->start[0], m->start[1], name, a.exponent, b.exponent);
    fflush(stdout);
}

int main(int count, char **arguments) {
    const int most = count > 2 ? atoi(arguments[2]) : 16;
    make_nodes();
    printf(
        "# machine, parameter, start, motion, growth of a small difference a revolution, and with twice the steps\n");
    for (int i = 0; i < MACHINES; i++) {
        const machine *m = &machines[i];
        if (count > 1 && strcmp(arguments[1], m->name) != 0) continue;
        for (int k = 0; k < most && m->parameters[k] > 0.0; k++)
            print(m, m->parameters[k], find(m, m->parameters[k], m->steps), find(m, m->parameters[k], 2 * m->steps));
    }
    return 0;
}
