// Derivatives by parameters: of the equations of every element against complex steps through the same forces as the
// literature writes them, in newtons and metres, and of motions against closed forms and differences of motions.
#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_flow.h"
#include "whirl/engine.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

typedef long double complex number;

static const double two_pi = 6.283185307179586476925;

// ---------------------------------------------------------------- one element at a station

/// Input of a law, in SI: its parameters, the shaft's speed and angle, place and velocity, its own states, the
/// station's mass.
typedef struct given {
    const number *p;
    number speed, tau, d[2], w[2], s[2], mass;
} given;

/// Force in newtons, slopes a second, inertia that is added to the station's.
typedef struct answer {
    number force[2], slope[2], inertia;
} answer;

typedef answer law(const given *g);

enum { SPEED, SCALE, MASS, FIRST, MAX_KEYS = 9 };

/// An element, or keys of the station itself (kind ""), on a station that moves in x and y.
typedef struct sample {
    const char *name, *kind;
    whirl_setting words[4], numbers[MAX_KEYS];
    size_t states;
    law *law;
} sample;

static answer spring(const given *g) {
    answer a = {.inertia = 0.0L};
    for (int i = 0; i < 2; i++) {
        const long double side = creall(g->d[i]) > creall(g->p[2]) ? 1.0L : -1.0L;
        if (fabsl(creall(g->d[i])) > creall(g->p[2]))
            a.force[i] = -g->p[0] * (g->d[i] - side * g->p[2]) - g->p[1] * g->w[i];
    }
    return a;
}

/// Returns the force of stiffnesses k1 and k2 along axes at `angle` and across.
static answer turned(number k1, number k2, number angle, const number d[2]) {
    const number c = ccosl(angle), s = csinl(angle);
    const number along = k1 * (c * d[0] + s * d[1]), aside = k2 * (c * d[1] - s * d[0]);
    return (answer){.force = {-(c * along - s * aside), -(s * along + c * aside)}};
}

static answer shaft(const given *g) {
    return turned(g->p[0], g->p[1], g->tau, g->d);
}

static answer crack(const given *g) {
    const number open = 0.5L * (1.0L + ccosl(g->tau + g->p[3] - g->p[4]));
    return turned(g->p[0] * (1.0L - g->p[1] * open), g->p[0] * (1.0L - g->p[2] * open), g->tau + g->p[3], g->d);
}

/// Returns the force of Capone's film; numbers: c, mu, R, L.
static answer film(const given *g) {
    const number c = g->p[0], x = g->d[0] / c, y = g->d[1] / c;
    const number A = x - 2.0L * g->w[1] / (c * g->speed), B = y + 2.0L * g->w[0] / (c * g->speed);
    const number C = csqrtl(A * A + B * B), ca = -A / C, sa = -B / C, q = 1.0L - x * x - y * y, root = csqrtl(q);
    const number across = y * ca - x * sa, along = x * ca + y * sa;
    const number G = 2.0L / root * (acosl(-1.0L) / 2.0L + catanl(across / root));
    const number V = (2.0L + across * G) / q, S = along / (1.0L - along * along);
    const number load = g->p[1] * g->speed * g->p[2] * g->p[3] * g->p[3] * g->p[3] / (4.0L * c * c), K = -load * C / q;
    return (answer){
        .force = {K * (3.0L * x * V - sa * G - 2.0L * ca * S), K * (3.0L * y * V + ca * G - 2.0L * sa * S)}};
}

/// Returns the force of a short damper with half a film: the pressure -mu v.n L^3/h^3 where v.n > 0, added up by Gauss'
/// formula. Numbers: c, mu, R, L.
static answer squeeze(const given *g) {
    static const long double nodes[] = {0.1488743389816312L, 0.4333953941292472L, 0.6794095682990244L,
                                        0.8650633666889845L, 0.9739065285171717L};
    static const long double weights[] = {0.2955242247147529L, 0.2692667193099964L, 0.2190863625159820L,
                                          0.1494513491505806L, 0.0666713443086881L};
    enum { PANELS = 64 };
    const long double pi = acosl(-1.0L), towards = atan2l(creall(g->w[1]), creall(g->w[0])),
                      half = pi / (2.0L * PANELS);
    answer a = {.inertia = 0.0L};
    for (int i = 0; i < PANELS; i++)
        for (int k = 0; k < 10; k++) {
            const long double at = (k < 5 ? -1.0L : 1.0L) * nodes[k % 5];
            const long double phi = towards - 0.5L * pi + (2 * i + 1 + at) * half, n[2] = {cosl(phi), sinl(phi)};
            const number h = g->p[0] - g->d[0] * n[0] - g->d[1] * n[1];
            const number pressed =
                g->p[1] * g->p[2] * cpowl(g->p[3], 3.0L) * (g->w[0] * n[0] + g->w[1] * n[1]) / (h * h * h);
            for (int j = 0; j < 2; j++) a.force[j] -= half * weights[k % 5] * pressed * n[j];
        }
    return a;
}

/// Returns the force of a seal; numbers: c, K0, D0, m_f, lambda0, n, b.
static answer seal(const given *g) {
    const number *p = g->p, e = csqrtl(g->d[0] * g->d[0] + g->d[1] * g->d[1]) / p[0];
    const number turn = p[4] * g->speed * cpowl(1.0L - e, p[6]), grown = cpowl(1.0L - e * e, -p[5]);
    const number K = p[1] * grown, D = p[2] * grown, m = p[3];
    const number x = g->d[0], y = g->d[1], vx = g->w[0], vy = g->w[1];
    return (answer){.force = {-(m * (2.0L * turn * vy - turn * turn * x) + D * (vx + turn * y) + K * x),
                              -(m * (-2.0L * turn * vx - turn * turn * y) + D * (vy - turn * x) + K * y)},
                    .inertia = m};
}

/// Returns the force of a bearing of nine balls; numbers: C, g0, cage, angle, damping.
static answer ball(const given *g) {
    answer a = {.force = {-g->p[4] * g->w[0], -g->p[4] * g->w[1]}, .slope = {g->p[2] * g->speed}};
    for (int j = 0; j < 9; j++) {
        const number theta = g->s[0] + g->p[3] + j * 2.0L * acosl(-1.0L) / 9.0L, c = ccosl(theta), s = csinl(theta);
        const number deep = g->d[0] * c + g->d[1] * s - g->p[1];
        if (creall(deep) <= 0.0L) continue;
        a.force[0] -= g->p[0] * deep * csqrtl(deep) * c;
        a.force[1] -= g->p[0] * deep * csqrtl(deep) * s;
    }
    return a;
}

/// Returns the force of a mount, whose states are lengths; numbers: k, k_m, c.
static answer mount(const given *g) {
    answer a = {.inertia = 0.0L};
    for (int i = 0; i < 2; i++) {
        a.force[i] = -g->p[0] * g->d[i] - g->p[1] * (g->d[i] - g->s[i]);
        a.slope[i] = g->p[1] / g->p[2] * (g->d[i] - g->s[i]);
    }
    return a;
}

/// Returns the force of a looseness along y; numbers: k1, c1, k2, c2, g, k3, c3.
static answer looseness(const given *g) {
    const number *p = g->p, d = g->d[1], w = g->w[1];
    const bool seated = creall(d)<0.0L, held = creall(d)> creall(p[4]);
    const number push = seated ? p[0] * d + p[1] * w
                        : held ? p[2] * p[4] + p[5] * (d - p[4]) + p[6] * w
                               : p[2] * d + p[3] * w;
    return (answer){.force = {0.0L, -push}};
}

/// Returns the force of a rub; numbers: gap, k, c, f, R, v0.
static answer rub(const given *g) {
    const number *p = g->p, x = g->d[0], y = g->d[1], r = csqrtl(x * x + y * y);
    const number normal = p[1] * (r - p[0]) + p[2] * (x * g->w[0] + y * g->w[1]) / r;
    const number slip = p[4] * g->speed + (x * g->w[1] - y * g->w[0]) / r,
                 f = p[3] * slip / csqrtl(slip * slip + p[5] * p[5]);
    if (creall(r) <= creall(p[0]) || creall(normal) <= 0.0L) return (answer){.inertia = 0.0L};
    return (answer){.force = {-normal / r * (x - f * y), -normal / r * (f * x + y)}};
}

/// Returns the force of a linear bearing; numbers: kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy.
static answer bearing(const given *g) {
    const number *p = g->p;
    return (answer){.force = {-p[0] * g->d[0] - p[1] * g->d[1] - p[4] * g->w[0] - p[5] * g->w[1],
                              -p[2] * g->d[0] - p[3] * g->d[1] - p[6] * g->w[0] - p[7] * g->w[1]}};
}

/// Returns a turning force; numbers: F, phi, delta, then the ratio or the frequency.
static answer turning_force(const given *g, number rate) {
    const number angle = g->p[1] + g->s[0] + g->p[2];
    return (answer){.force = {g->p[0] * ccosl(angle), g->p[0] * csinl(angle)}, .slope = {rate}};
}
static answer force_by_ratio(const given *g) {
    return turning_force(g, g->p[3] * g->speed);
}
static answer force_by_frequency(const given *g) {
    return turning_force(g, 2.0L * acosl(-1.0L) * g->p[3]);
}
static answer shaker(const given *g) {
    const number size = g->p[0] * ccosl(g->tau + g->p[2]);
    return (answer){.force = {size * ccosl(g->p[1]), size * csinl(g->p[1])}};
}

/// Returns the force of an unbalance; numbers: U, beta, the speed of its shaft.
static answer unbalance(const given *g) {
    const number size = g->p[0] * g->p[2] * g->p[2], angle = g->p[1] + g->s[0];
    return (answer){.force = {size * ccosl(angle), size * csinl(angle)}, .slope = {g->p[2]}};
}

static answer gravity(const given *g) {
    return (answer){.force = {g->mass * g->p[0] * ccosl(g->p[1]), g->mass * g->p[0] * csinl(g->p[1])}};
}

/// Returns the force of a station; numbers: c, e, beta.
static answer station(const given *g) {
    const number size = g->mass * g->p[1] * g->speed * g->speed, angle = g->tau + g->p[2];
    return (answer){.force = {size * ccosl(angle) - g->p[0] * g->w[0], size * csinl(angle) - g->p[0] * g->w[1]}};
}

// clang-format off
static const sample samples[] = {
    {"spring with play", "spring", {{"between", 0, "disc, ground"}},
     {{"stiffness", 2e5, NULL}, {"damping", 90.0, NULL}, {"gap", 2e-5, NULL}}, 0, spring},
    {"shaft", "shaft", {{"between", 0, "disc, ground"}}, {{"k1", 2e5, NULL}, {"k2", 1.4e5, NULL}}, 0, shaft},
    {"crack", "crack", {{"between", 0, "disc, ground"}},
     {{"stiffness", 2e5, NULL}, {"loss", 0.4, NULL}, {"loss_across", 0.1, NULL}, {"angle", 0.7, NULL},
      {"opens", -1.3, NULL}}, 0, crack},
    {"film", "film", {{"at", 0, "disc"}},
     {{"clearance", 1.3e-4, NULL}, {"viscosity", 0.02, NULL}, {"radius", 0.02, NULL}, {"length", 0.015, NULL}},
      0, film},
    {"squeeze", "squeeze", {{"at", 0, "disc"}},
     {{"clearance", 1.3e-4, NULL}, {"viscosity", 0.02, NULL}, {"radius", 0.02, NULL}, {"length", 0.015, NULL}},
      0, squeeze},
    {"seal", "seal", {{"at", 0, "disc"}},
     {{"clearance", 1.3e-4, NULL}, {"stiffness", 1e5, NULL}, {"damping", 300.0, NULL}, {"mass", 0.4, NULL},
      {"ratio", 0.45, NULL},
      {"growth", 1.6, NULL}, {"slowing", 0.7, NULL}}, 0, seal},
    {"ball_bearing", "ball_bearing", {{"at", 0, "disc"}, {"balls", 9.0, NULL}},
     {{"stiffness", 2e9, NULL}, {"clearance", 3e-6, NULL}, {"cage", 0.41, NULL}, {"angle", 0.3, NULL},
      {"damping", 80.0, NULL}}, 1, ball},
    {"mount", "mount", {{"between", 0, "disc, ground"}},
     {{"stiffness", 1e5, NULL}, {"branch", 6e4, NULL}, {"damping", 200.0, NULL}}, 2, mount},
    {"looseness", "looseness", {{"between", 0, "disc, ground"}},
     {{"stiffness", 2e5, NULL}, {"damping", 50.0, NULL}, {"loose_stiffness", 4e4, NULL}, {"loose_damping", 20.0, NULL},
      {"gap", 4e-5, NULL}, {"held_stiffness", 3e5, NULL}, {"held_damping", 70.0, NULL}}, 0, looseness},
    {"rub", "rub", {{"at", 0, "disc"}, {"law", 0, "slip"}},
     {{"gap", 5e-5, NULL}, {"stiffness", 4e5, NULL}, {"damping", 60.0, NULL}, {"friction", 0.2, NULL},
      {"radius", 2e-4, NULL},
      {"slip_speed", 0.03, NULL}}, 0, rub},
    {"bearing", "bearing", {{"at", 0, "disc"}},
     {{"kxx", 2e5, NULL}, {"kxy", 3e4, NULL}, {"kyx", -4e4, NULL}, {"kyy", 1e5, NULL}, {"cxx", 80.0, NULL},
      {"cxy", 9.0, NULL},
      {"cyx", -7.0, NULL}, {"cyy", 60.0, NULL}}, 0, bearing},
    {"force, ratio", "force", {{"at", 0, "disc"}, {"law", 0, "forward"}},
     {{"amplitude", 20.0, NULL}, {"angle", 0.4, NULL}, {"phase", 0.9, NULL}, {"ratio", 1.3, NULL}}, 1, force_by_ratio},
    {"force, frequency", "force", {{"at", 0, "disc"}, {"law", 0, "forward"}},
     {{"amplitude", 20.0, NULL}, {"angle", 0.4, NULL}, {"phase", 0.9, NULL}, {"frequency", 31.0, NULL}},
      1, force_by_frequency},
    {"force, synchronous", "force", {{"at", 0, "disc"}},
     {{"amplitude", 20.0, NULL}, {"angle", 0.4, NULL}, {"phase", 0.9, NULL}}, 0, shaker},
    {"unbalance", "unbalance", {{"at", 0, "disc"}},
     {{"moment", 1e-4, NULL}, {"angle", 0.4, NULL}, {"speed", 410.0, NULL}}, 1, unbalance},
    {"gravity", "gravity", {{NULL, 0, NULL}}, {{"acceleration", 9.81, NULL}, {"direction", -1.2, NULL}}, 0, gravity},
    {"station", "", {{NULL, 0, NULL}},
     {{"damping", 70.0, NULL}, {"eccentricity", 2e-5, NULL}, {"eccentricity_angle", 0.6, NULL}}, 0, station},
};
// clang-format on

static size_t count_of(const whirl_setting *settings, size_t most) {
    size_t count = 0;
    while (count < most && settings[count].key) count++;
    return count;
}

/// One of the numbers of a sample varies.
typedef struct family {
    const sample *of;
    size_t which;
} family;

static const double common[FIRST] = {310.0, 1e-4, 2.0};

static double value_of(const sample *of, size_t which) {
    return which < FIRST ? common[which] : of->numbers[which - FIRST].number;
}

static void release_rotor(void *owner) {
    whirl_rotor_free(owner);
}

static whirl_status make_sample(const void *context, const whirl_batch *batch, double value, whirl_machine *machine) {
    const family *own = context;
    const sample *of = own->of;
    double at[FIRST];
    whirl_setting settings[4 + MAX_KEYS], disc[1 + MAX_KEYS];
    const size_t words = count_of(of->words, 4), numbers = count_of(of->numbers, MAX_KEYS);
    whirl_design *design = NULL;
    whirl_rotor *rotor = NULL;
    (void)batch;
    memcpy(at, common, sizeof at);
    memcpy(settings, of->words, words * sizeof *settings);
    memcpy(settings + words, of->numbers, numbers * sizeof *settings);
    if (own->which < FIRST)
        at[own->which] = value;
    else
        settings[words + own->which - FIRST].number = value;
    disc[0] = (whirl_setting){"mass", at[MASS], NULL};
    memcpy(disc + 1, settings, (words + numbers) * sizeof *disc);
    whirl_status status = whirl_design_new(at[SPEED], at[SCALE], &design);
    if (status.code == WHIRL_OK) status = whirl_design_station(design, "disc", disc, *of->kind ? 1 : 1 + numbers);
    if (status.code == WHIRL_OK && *of->kind)
        status = whirl_design_element(design, of->kind, settings, words + numbers);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, &rotor);
    whirl_design_free(design);
    if (status.code == WHIRL_OK)
        *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release_rotor};
    return status;
}

/// Computes the scaled right-hand side with numbers p: speed, scale, mass, then those of the element.
static void reference(const sample *of, const number *p, double tau, const double *x, number *slope) {
    given g = {.p = p + FIRST, .speed = p[SPEED], .tau = tau, .mass = p[MASS]};
    const bool lengths = of->law == mount;
    for (int i = 0; i < 2; i++) {
        g.d[i] = x[i] * p[SCALE];
        g.w[i] = x[2 + i] * p[SCALE] * p[SPEED];
        g.s[i] = (size_t)i < of->states ? x[4 + i] * (lengths ? p[SCALE] : 1.0L) : 0.0L;
    }
    const answer a = of->law(&g);
    for (int i = 0; i < 2; i++) {
        slope[i] = x[2 + i];
        slope[2 + i] = a.force[i] / ((p[MASS] + a.inertia) * p[SPEED] * p[SPEED] * p[SCALE]);
        slope[4 + i] = a.slope[i] / p[SPEED] / (lengths ? p[SCALE] : 1.0L);
    }
}

static double uniform(uint64_t *seed, double low, double high) {
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

/// Differentiates by one number p of a sample at states on all sides. Finds the largest error as part of the derivative
/// or of f/p, and how far errors exceed their reported bound.
static void compare(const sample *of, size_t which, double *worst, double *beyond) {
    const family own = {of, which};
    const whirl_study study = {.machine = make_sample, .family = &own};
    const whirl_batch batch = {.count = 1};
    const size_t n = 4 + of->states, numbers = FIRST + count_of(of->numbers, MAX_KEYS);
    whirl_sensitivity *sensitivity;
    uint64_t seed = 11;
    require_ok(whirl_sensitivity_new(&study, &batch, value_of(of, which), 0.0, &sensitivity));
    assert_int_equal(whirl_sensitivity_machine(sensitivity)->dimension, n);
    for (int trial = 0; trial < 60; trial++) {
        double x[6], ours[6], error[6], size = 0.0, expected[6];
        number p[FIRST + MAX_KEYS], slope[6];
        const long double step = 1e-24L * value_of(of, which);
        const double tau = uniform(&seed, 0.0, two_pi), radius = uniform(&seed, 0.05, 0.9);
        const double angle = uniform(&seed, 0.0, two_pi);
        for (size_t i = 0; i < 6; i++) x[i] = uniform(&seed, -0.8, 0.8);
        x[0] = radius * cos(angle);
        x[1] = radius * sin(angle);
        for (size_t i = 0; i < numbers; i++) p[i] = value_of(of, i);
        p[which] += step * I;
        reference(of, p, tau, x, slope);
        whirl_sensitivity_slope(sensitivity, tau, x, NULL, ours, error);
        for (size_t i = 0; i < n; i++) {
            expected[i] = (double)(cimagl(slope[i]) / step);
            size = fmax(size, fmax(fabs(expected[i]), cabs((double complex)slope[i]) / fabs(value_of(of, which))));
        }
        for (size_t i = 0; i < n; i++) {
            const double off = fabs(ours[i] - expected[i]);
            *worst = fmax(*worst, off / size);
            *beyond = fmax(*beyond, off / (error[i] + 1e-15 * size));
        }
    }
    whirl_sensitivity_free(sensitivity);
}

static void every_element(void **unused) {
    (void)unused;
    for (size_t i = 0; i < COUNT_OF(samples); i++) {
        const size_t numbers = FIRST + count_of(samples[i].numbers, MAX_KEYS);
        double worst = 0.0, beyond = 0.0;
        for (size_t which = 0; which < numbers; which++) compare(&samples[i], which, &worst, &beyond);
        check_within("Sensitivity", words("%s: by %zu numbers, part of the derivative", samples[i].name, numbers), 0.0,
                     worst, 1e-10);
        check_within("Sensitivity", words("%s: errors over the reported ones", samples[i].name), 0.0, beyond, 3.0);
    }
}

// ---------------------------------------------------------------- tilts, a table of the speed, whatever a case says

/// A disc on a cantilever under a moment and its skew, by a case whose parameter enters by expressions, and its
/// derivative by the formulas.
static const char *const cantilever = "whirl: 1\n"
                                      "parameters: {d: 20 mm, omega: 2000 rpm}\n"
                                      "rotor:\n"
                                      "  speed: = omega*(1 + d)\n"
                                      "  length_scale: 0.1 mm\n"
                                      "  stations:\n"
                                      "    disc: {skew: 0.2 deg, mass: 1 kg, damping: = 900*d*d*1e3}\n"
                                      "  elements:\n"
                                      "    - disc: {at: disc, outer: = 12*d, width: = d, eccentricity: 10 um}\n"
                                      "    - beam: {between: [ground, disc], length: 0.4 m, diameter: = d}\n"
                                      "    - force: {at: disc, amplitude: 30 N, ratio: 0.37, keyphasor: yes}\n"
                                      "study:\n"
                                      "  response: {}\n";

/// Computes the slopes at (x, y, tilts, velocities, phase of the force, phase of the shaft) for the diameter d; the
/// length scale is 1e-4, tilts are in length scales over the radius of gyration of the mass at the station.
static void cantilever_slopes(number d, const double *q, number *slope) {
    const long double pi = acosl(-1.0L), L = 1e-4L, length = 0.4L, E = 2.11e11L;
    const number speed = 2000.0L * pi / 30.0L * (1.0L + d), clock = 0.37L * speed, outer = 12.0L * d;
    const number disc = 7850.0L * d * pi / 4.0L * outer * outer, mass = 1.0L + disc;
    const number polar = disc * outer * outer / 8.0L, diametral = 0.5L * polar + disc * d * d / 12.0L;
    const number gyration = csqrtl(diametral / mass), unit = L / gyration;
    const number bending = E * pi / 64.0L * d * d * d * d / (length * length * length);
    const number turn = cexpl(I * (long double)q[9]), skew = 0.2L * pi / 180.0L;
    number force[4], place[4], rate[4];
    for (int i = 0; i < 4; i++) {
        place[i] = q[i] * (i < 2 ? L : unit);
        rate[i] = q[4 + i] * (i < 2 ? L : unit) * clock;
    }
    for (int i = 0; i < 2; i++) {
        // cosine along x, sine along y: not analytic in the phase, which is real
        const long double part = i == 0 ? creall(turn) : cimagl(turn);
        force[i] = -bending * (12.0L * place[i] - 6.0L * length * place[2 + i]) - 900.0L * d * d * 1e3L * rate[i] +
                   disc * 1e-5L * speed * speed * part + (i == 0 ? 30.0L * cosl(q[8]) : 0.0L);
        force[2 + i] = -bending * (-6.0L * length * place[i] + 4.0L * length * length * place[2 + i]) +
                       (i == 0 ? -1.0L : 1.0L) * polar * speed * rate[3 - i] +
                       (diametral - polar) * speed * speed * skew * part;
    }
    for (int i = 0; i < 4; i++) {
        slope[i] = q[4 + i];
        slope[4 + i] = force[i] / (i < 2 ? mass * L : diametral * unit) / (clock * clock);
    }
    slope[8] = 1.0L;
    slope[9] = 1.0L / 0.37L;
}

static void expressions_of_a_case(void **unused) {
    (void)unused;
    whirl_case *object;
    whirl_study study;
    whirl_sensitivity *sensitivity;
    uint64_t seed = 4;
    double worst = 0.0;
    require_ok(whirl_case_parse(cantilever, strlen(cantilever), "cantilever", NULL, &object));
    require_ok(whirl_case_study(object, &study));
    whirl_batch batch = study.batches[0];
    strcpy(batch.parameter, "d");
    require_ok(whirl_sensitivity_new(&study, &batch, 0.02, 0.0, &sensitivity));
    assert_int_equal(whirl_sensitivity_machine(sensitivity)->dimension, 10);
    for (int trial = 0; trial < 100; trial++) {
        const long double step = 1e-26L;
        double x[10], ours[10], value[10], size = 0.0;
        number slope[10];
        for (int i = 0; i < 10; i++) x[i] = uniform(&seed, -1.0, 1.0);
        cantilever_slopes(0.02 + step * I, x, slope);
        evaluate_rhs(whirl_sensitivity_machine(sensitivity), 0.0, x, value);
        whirl_sensitivity_slope(sensitivity, 0.0, x, NULL, ours, NULL);
        for (int i = 0; i < 10; i++) size = fmax(size, fabs((double)(cimagl(slope[i]) / step)));
        for (int i = 0; i < 10; i++) {
            assert_true(fabs(value[i] - (double)creall(slope[i])) < 1e-11 * (1.0 + fabs(value[i])));
            worst = fmax(worst, fabs(ours[i] - (double)(cimagl(slope[i]) / step)) / size);
        }
    }
    check_within("Sensitivity", "disc on a beam, by expressions of a case, part of the derivative", 0.0, worst, 1e-10);
    whirl_sensitivity_free(sensitivity);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- motions

/// Carries a state x and its derivative by the one parameter, s, in the unit of the extended machine.
static void carry_parameter(const whirl_extended *extended, const char *method, int steps, int revolutions, double *x,
                            double *s) {
    whirl_integrator *integrator = make_integrator(whirl_extended_system(extended), method, steps);
    whirl_perturbations set = {.count = 1, .vectors = s};
    require_ok(whirl_integrator_follow(integrator, 1));
    for (int i = 0; i < revolutions; i++)
        assert_int_equal(whirl_integrator_carry(integrator, x, &set, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
}

/// A disc on a spring and a damper, free: m w^2 z'' + c w z' + k z = 0, z = a e^(r tau), dz/dk = a tau dr/dk e^(r tau).
static void free_motion(void **unused) {
    (void)unused;
    static const char *const methods[] = {"rk4", "dop853", "rodas5p"};
    static const sample disc = {
        "disc", "spring", {{"between", 0, "disc, ground"}, {"damping", 120.0, NULL}}, {{"stiffness", 2.2e5, NULL}},
        0,      NULL};
    const double mass = common[MASS], speed = common[SPEED], stiffness = 2.2e5;
    const family own = {&disc, FIRST};
    const whirl_study study = {.machine = make_sample, .family = &own};
    const whirl_batch batch = {.count = 1};
    whirl_sensitivity *sensitivity;
    whirl_extended *extended;
    require_ok(whirl_sensitivity_new(&study, &batch, stiffness, 0.0, &sensitivity));
    require_ok(whirl_extended_new(1, &sensitivity, &extended));
    assert_int_equal(whirl_extended_system(extended)->dimension, 5);
    const double unit = whirl_extended_unit(extended, 0);
    for (size_t m = 0; m < COUNT_OF(methods); m++) {
        const double complex root = csqrt(120.0 * 120.0 - 4.0 * mass * stiffness);
        const double complex r = (-120.0 + root) / (2.0 * mass * speed);
        const double complex by_stiffness = -1.0 / (root * speed);
        const double complex a = 0.3 + 0.2 * I, rate = unit * a * by_stiffness;
        double x[5] = {creal(a), cimag(a), creal(a * r), cimag(a * r)};
        double s[5] = {0.0, 0.0, creal(rate), cimag(rate), 1.0};
        carry_parameter(extended, methods[m], 2048, 3, x, s);
        const double tau = 3.0 * two_pi;
        const double complex z = a * cexp(r * tau), dz = z * tau * by_stiffness;
        check_within("Sensitivity", words("motion that dies out after 3 revolutions, %s", methods[m]), 0.0,
                     cabs(x[0] + I * x[1] - z) / cabs(a), 1e-9);
        check_within("Sensitivity", words("its derivative by the stiffness, %s", methods[m]), 0.0,
                     cabs((s[0] + I * s[1]) / unit - dz) / cabs(a * tau * by_stiffness), 1e-9);
    }
    whirl_extended_free(extended);
    whirl_sensitivity_free(sensitivity);
}

/// Makes case C4, a disc that rubs, at a friction.
static whirl_status make_rub(const void *context, const whirl_batch *batch, double value, whirl_machine *machine) {
    const double *damping = context;
    const whirl_setting disc[] = {{"mass", 1.0, NULL}, {"damping", 0.2, NULL}, {"eccentricity", 0.9, NULL}};
    const whirl_setting shaft[] = {{"between", 0, "disc, ground"}, {"k1", 1.0, NULL}};
    const whirl_setting rub[] = {{"at", 0, "disc"},
                                 {"gap", value, NULL},
                                 {"stiffness", 10.0, NULL},
                                 {"friction", 0.05, NULL},
                                 {"damping", damping ? *damping : 0.0, NULL}};
    const whirl_setting weight[] = {{"acceleration", 0.5, NULL}};
    whirl_design *design;
    whirl_rotor *rotor = NULL;
    (void)batch;
    require_ok(whirl_design_new(1.5, 1.0, &design));
    require_ok(whirl_design_station(design, "disc", disc, 3));
    require_ok(whirl_design_element(design, "shaft", shaft, 2));
    require_ok(whirl_design_element(design, "gravity", weight, 1));
    whirl_status status = whirl_design_element(design, "rub", rub, damping ? 5 : 4);
    if (status.code == WHIRL_OK) status = whirl_rotor_new(design, &rotor);
    whirl_design_free(design);
    if (status.code == WHIRL_OK)
        *machine = (whirl_machine){.system = whirl_rotor_system(rotor), .owner = rotor, .release = release_rotor};
    return status;
}

static void revolve_rub(const double *damping, double gap, double *x, int revolutions) {
    whirl_machine machine;
    require_ok(make_rub(damping, NULL, gap, &machine));
    whirl_integrator *integrator = make_integrator(machine.system, "dop853", 64);
    revolve(integrator, x, revolutions);
    whirl_integrator_free(integrator);
    machine.release(machine.owner);
}

/// A motion in and out of contact: its derivative by the gap against differences of motions. A damped contact jumps
/// where it touches.
static void through_contacts(void **unused) {
    (void)unused;
    enum { REVOLUTIONS = 3 };
    static const double damped = 0.4, start[4] = {0.1, -0.2}, step = 1e-3;
    static const double weights[] = {-1.0 / 12.0, 2.0 / 3.0, -2.0 / 3.0, 1.0 / 12.0}, places[] = {2.0, 1.0, -1.0, -2.0};
    const double *dampings[] = {NULL, &damped};
    for (int which = 0; which < 2; which++) {
        const whirl_study study = {.machine = make_rub, .family = dampings[which]};
        const whirl_batch batch = {.count = 1};
        double x[5] = {0.0}, s[5] = {[4] = 1.0}, difference[4] = {0.0}, worst = 0.0, size = 0.0;
        whirl_sensitivity *sensitivity;
        whirl_extended *extended;
        require_ok(whirl_sensitivity_new(&study, &batch, 1.0, 0.0, &sensitivity));
        require_ok(whirl_extended_new(1, &sensitivity, &extended));
        memcpy(x, start, sizeof start);
        carry_parameter(extended, "dop853", 64, REVOLUTIONS, x, s);
        for (int k = 0; k < 4; k++) {
            double end[4];
            memcpy(end, start, sizeof end);
            revolve_rub(dampings[which], 1.0 + places[k] * step, end, REVOLUTIONS);
            for (int i = 0; i < 4; i++) difference[i] += weights[k] * end[i] / step;
        }
        for (int i = 0; i < 4; i++) {
            size = fmax(size, fabs(difference[i]));
            worst = fmax(worst, fabs(s[i] / whirl_extended_unit(extended, 0) - difference[i]));
        }
        check_within("Sensitivity",
                     words("motion through %scontacts by the gap, part of the derivative", which ? "damped " : ""), 0.0,
                     worst / size, 1e-8);
        whirl_extended_free(extended);
        whirl_sensitivity_free(sensitivity);
    }
}

static void refused(void **unused) {
    (void)unused;
    const double damping = 0.1;
    const whirl_study study = {.machine = make_rub, .family = &damping};
    const whirl_batch batch = {.count = 1};
    whirl_extended *extended;
    whirl_sensitivity *sensitivity;
    assert_int_equal(whirl_sensitivity_new(&study, &batch, 0.0, 0.0, &sensitivity).code, WHIRL_BAD_INPUT);
    assert_null(sensitivity);
    assert_int_equal(whirl_sensitivity_new(&study, &batch, -1.0, 0.0, &sensitivity).code, WHIRL_BAD_INPUT);
    // A reach of half the gap or more could leave no gap: it is halved until all machines can be built.
    require_ok(whirl_sensitivity_new(&study, &batch, 1.0, 4.0, &sensitivity));
    assert_int_equal(whirl_extended_new(WHIRL_MAX_SENSITIVITIES + 1, &sensitivity, &extended).code, WHIRL_BAD_INPUT);
    assert_null(extended);
    whirl_sensitivity_free(sensitivity);
}

// ---------------------------------------------------------------- orbits

/// The rotor of jeffcott-rub.yaml with a gap that varies, and a damped contact.
static const char *const rubbing = "whirl: 1\n"
                                   "parameters: {omega: 1 rad/s, e: 0.9, g: 1 m, k_r: 10 N/m, mu: 0.05,\n"
                                   "             c: 0.2 N s/m, c_c: %g N s/m}\n"
                                   "rotor:\n"
                                   "  speed: = omega\n"
                                   "  length_scale: 1 m\n"
                                   "  stations: {disc: {mass: 1 kg, damping: = c, eccentricity: = e}}\n"
                                   "  elements:\n"
                                   "    - shaft: {between: [disc, ground], k1: 1 N/m}\n"
                                   "    - rub: {at: disc, gap: = g, stiffness: = k_r, friction: = mu, damping: = c_c}\n"
                                   "    - gravity: 0.5\n"
                                   "study:\n"
                                   "  sweep: {parameter: omega, from: 0.8, to: 1.2, points: 3}\n";

/// Makes derivatives of the orbit at a speed by parameters, sampled at `instants`.
static void derive_orbit(double damping, double omega, size_t count, const char *const *names,
                         const whirl_orbit_options *options, size_t instants, double *multipliers,
                         whirl_orbit_sensitivity **out) {
    static const double start[4] = {0.7, 0.0, 0.0, 0.7};
    char text[1024];
    whirl_case *object;
    whirl_study study;
    whirl_machine machine;
    whirl_orbit *orbit;
    whirl_sensitivity *by[8];
    whirl_extended *extended;
    // Read the case, and settle to its orbit.
    const int length = snprintf(text, sizeof text, rubbing, damping);
    require_ok(whirl_case_parse(text, (size_t)length, "rubbing", NULL, &object));
    require_ok(whirl_case_study(object, &study));
    whirl_batch batch = study.batches[0];
    require_ok(study.machine(study.family, &batch, omega, &machine));
    double x[4];
    memcpy(x, start, sizeof x);
    whirl_integrator *integrator = make_integrator(machine.system, "dop853", 64);
    revolve(integrator, x, 60);
    whirl_integrator_free(integrator);
    require_ok(whirl_orbit_find(machine.system, x, 1, options, &orbit));
    for (size_t i = 0; i < 4; i++) {
        multipliers[2 * i] = orbit->multipliers[i].real;
        multipliers[2 * i + 1] = orbit->multipliers[i].imaginary;
    }
    // Derive it by all parameters at once.
    const whirl_given speed = {"omega", omega};
    batch.given_count = 1;
    batch.given = &speed;
    for (size_t p = 0; p < count; p++) {
        double value;
        snprintf(batch.parameter, sizeof batch.parameter, "%s", names[p]);
        require_ok(whirl_case_parameter(object, names[p], &value));
        require_ok(whirl_sensitivity_new(&study, &batch, value, 0.0, &by[p]));
    }
    require_ok(whirl_extended_new(count, by, &extended));
    require_ok(whirl_orbit_sensitivity_new(extended, orbit, options, instants, out));
    whirl_extended_free(extended);
    for (size_t p = 0; p < count; p++) whirl_sensitivity_free(by[p]);
    whirl_orbit_free(orbit);
    machine.release(machine.owner);
    whirl_case_free(object);
}

/// Digits by two methods (exact tangents by an independent program; Richardson differences of extended orbits): x, vx,
/// y, vy at the beginning, and their derivatives.
static void orbits(void **unused) {
    (void)unused;
    static const char *const plain[] = {"e", "g", "k_r", "mu", "c"}, *const damped[] = {"g", "k_r", "mu", "c_c", "e"};
    static const double at_one[4] = {1.0656288887827, 0.4205497609761, -0.1201842858761, 0.8307397392019};
    static const double by_plain[4][5] = {
        {0.9149625338, 0.85140170751, 0.05302969984, 0.46459080153, -0.97320410963},
        {-1.54695250874, 0.49252677866, -0.07299928229, 1.56363032889, 0.68083923243},
        {0.49979393065, -0.47533199073, 0.00129752106, -1.66389297321, -1.24995470462},
        {-0.1821677677, 1.2194779335, -0.05948382157, -1.45833940417, 0.52617270093}};
    static const double at_damped[4] = {0.8663115188159, 0.2188811001760, -0.2621935556059, 0.5050475272372};
    static const double by_damped[4][5] = {
        {0.67045869347, 0.00241988908, -1.25784208475, 0.509566534, 0.66383841692},
        {-0.01886040779, 0.01755357171, -0.0078521765, 0.34705228127, 0.53229905624},
        {-0.51811106553, 0.0093675537, -0.70495751138, -0.16267058181, 0.56770455722},
        {1.27530306952, -0.03397371348, 0.63227300053, -0.4653543606, -0.77527509466}};
    static const size_t place[4] = {0, 2, 1, 3};
    const whirl_orbit_options options = whirl_orbit_default();
    for (int which = 0; which < 2; which++) {
        const double damping = which ? 0.4 : 0.0, omega = which ? 0.85 : 1.0;
        const double *at = which ? at_damped : at_one, (*by)[5] = which ? by_damped : by_plain;
        const char *name = which ? "damped contact" : "contact";
        double multipliers[8], off = 0.0, slopes_off = 0.0;
        whirl_orbit_sensitivity *orbit;
        derive_orbit(damping, omega, 5, which ? damped : plain, &options, 64, multipliers, &orbit);
        for (size_t i = 0; i < 4; i++) {
            const double rate = i % 2 ? omega : 1.0; // the digits are by time, the state by tau
            off = fmax(off, fabs(rate * orbit->states[place[i]] - at[i]));
            for (size_t p = 0; p < 5; p++)
                slopes_off = fmax(slopes_off, fabs(rate * orbit->slopes[p * 4 + place[i]] - by[i][p]));
        }
        check_within("Sensitivity", words("orbit with a %s at %g", name, omega), 0.0, off, 1e-11);
        check_within("Sensitivity", words("its derivatives by five parameters, %s", name), 0.0, slopes_off, 2e-10);
        if (which) {
            check_within("Sensitivity", "multipliers of the orbit with a damped contact", 0.0,
                         fmax(fmax(fabs(multipliers[0] + 0.40116826), fabs(multipliers[1] - 0.05522983)),
                              fmax(fabs(multipliers[4] - 0.26150249), fabs(multipliers[5] - 0.2542311))),
                         1e-8);
        }
        whirl_orbit_sensitivity_free(orbit);
    }
}

/// Three independent methods find the same orbit and derivatives at every instant.
static void by_other_methods(void **unused) {
    (void)unused;
    enum { INSTANTS = 64 };
    static const char *const names[] = {"e", "g", "k_r", "mu", "c"};
    static const struct {
        const char *method;
        double rtol, tolerance;
        int steps;
    } others[] = {{"rodas5p", 1e-11, 1e-9, 512}, {"rk4", 1e-13, 1e-9, 4096}};
    for (int which = 0; which < 2; which++) {
        double multipliers[8];
        whirl_orbit_sensitivity *of, *other;
        const whirl_orbit_options exact = whirl_orbit_default();
        derive_orbit(which ? 0.4 : 0.0, 0.85, 5, names, &exact, INSTANTS, multipliers, &of);
        for (size_t m = 0; m < COUNT_OF(others); m++) {
            whirl_orbit_options options = exact;
            snprintf(options.integrate.method, sizeof options.integrate.method, "%s", others[m].method);
            options.integrate.rtol = others[m].rtol;
            options.integrate.atol = 1e-2 * others[m].rtol;
            options.integrate.steps_per_revolution = others[m].steps;
            options.integrate.located = true;
            options.tolerance = 1e-10;
            derive_orbit(which ? 0.4 : 0.0, 0.85, 5, names, &options, INSTANTS, multipliers, &other);
            double off = 0.0, size = 0.0;
            for (size_t i = 0; i < (size_t)INSTANTS * 5 * 4; i++) {
                off = fmax(off, fabs(of->slopes[i] - other->slopes[i]));
                size = fmax(size, fabs(of->slopes[i]));
            }
            check_within("Sensitivity",
                         words("derivatives of an orbit with a %s at all instants: dop853 and %s, over the largest",
                               which ? "damped contact" : "contact", others[m].method),
                         0.0, off / size, others[m].tolerance);
            whirl_orbit_sensitivity_free(other);
        }
        whirl_orbit_sensitivity_free(of);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_element),   cmocka_unit_test(expressions_of_a_case),
                                       cmocka_unit_test(free_motion),     cmocka_unit_test(through_contacts),
                                       cmocka_unit_test(refused),         cmocka_unit_test(orbits),
                                       cmocka_unit_test(by_other_methods)};
    return cmocka_run_group_tests_name("sensitivity", tests, NULL, NULL);
}
