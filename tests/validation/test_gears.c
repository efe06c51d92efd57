// Gears: rattle of a pair through its play, periodic orbits and multipliers, against digits of independent
// computations; pairs on supports; what must not change.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_study.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/result.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))
#define ADD(design, kind, ...)                                                                                         \
    require_ok(whirl_design_element(design, kind, (whirl_setting[]){__VA_ARGS__},                                      \
                                    COUNT_OF(((whirl_setting[]){__VA_ARGS__}))))
#define STATION(design, name, ...)                                                                                     \
    require_ok(whirl_design_station(design, name, (whirl_setting[]){__VA_ARGS__},                                      \
                                    COUNT_OF(((whirl_setting[]){__VA_ARGS__}))))

static whirl_rotor *rotor_of(whirl_design *design) {
    whirl_rotor *rotor = NULL;
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

// ---------------------------------------------------------------- rattle

/// x'' + 2 z x' + (1 + eps s(t)) f(x) = Fm + Fe W^2 cos W t, with half a play of 1; s = 1 in the first share d of 2
/// pi/W, then -1.
typedef struct rattle {
    double z, eps, steady, harmonic, speed, share;
    size_t revolutions;
    double start[2];         ///< x and x', near the orbit
    double place[2];         ///< of the orbit, at t = 0
    double multiplier[2][2]; ///< real and imaginary part
} rattle;

/// Makes one gear on a fixed rack, at a length scale. Radius and inertia have no effect if the inertia goes with the
/// square of the radius, and torques with the radius.
static whirl_rotor *rattle_rotor(const rattle *of, double length, double radius) {
    whirl_design *design = NULL;
    const double damping = 2.0 * of->z * radius * radius, torque = of->harmonic * of->speed * of->speed * radius;
    char radii[64];
    snprintf(radii, sizeof radii, "%.17g, %.17g", radius, radius);
    require_ok(whirl_design_new(of->speed, length, &design));
    STATION(design, "wheel", {"polar", radius * radius, NULL}, {"moves", 0.0, "twist"});
    ADD(design, "spring", {"between", 0.0, "wheel, ground"}, {"along", 0.0, "twist"}, {"damping", damping, NULL});
    ADD(design, "force", {"at", 0.0, "wheel"}, {"torque", torque, NULL}, {"steady_torque", of->steady * radius, NULL});
    if (of->eps > 0.0)
        ADD(design, "gear", {"between", 0.0, "wheel, ground"}, {"base_radii", 0.0, radii}, {"stiffness", 1.0, NULL},
            {"backlash", 2.0, NULL}, {"teeth", 1.0, NULL}, {"variation", of->eps, NULL},
            {"contact_share", of->share, NULL});
    else
        ADD(design, "gear", {"between", 0.0, "wheel, ground"}, {"base_radii", 0.0, radii}, {"stiffness", 1.0, NULL},
            {"backlash", 2.0, NULL});
    return rotor_of(design);
}

/// Kahraman, Singh 1990; digits by shooting with located switches, and by unknown switching times and exponentials in
/// 30 digits.
static const rattle rattles[] = {
    {.05,
     0,
     .1,
     .1,
     1.2,
     .5,
     1,
     {.88, .03},
     {.879500748114861, .0327583635912789},
     {{-.8655188718147, 0}, {-.6844274186031, 0}}},
    {.05,
     .2,
     .15,
     .02,
     .95,
     .6,
     1,
     {1.144, .246},
     {1.14393311735248, .246199093795523},
     {{.5407576372331, .4729858960821}, {.5407576372331, -.4729858960821}}},
    {.05,
     0,
     .1,
     1,
     .7,
     .5,
     1,
     {3.06, 1.306},
     {3.06138888291171, 1.30639679355977},
     {{.1005050405687, .630433335915}, {.1005050405687, -.630433335915}}},
    {.05,
     0,
     .1,
     .1,
     1.4,
     .5,
     1,
     {.9183, .0249},
     {.918296648660739, .0249070116320417},
     {{-1.346345517621, 0}, {-.4741683515195, 0}}},
    {.03,
     .3,
     .12,
     0,
     1.7,
     .5,
     1,
     {1.1165, .046},
     {1.1164924267259, .0459506214554316},
     {{-.8184316755646, .3623225289067}, {-.8184316755646, -.3623225289067}}},
    {.03,
     .3,
     .12,
     0,
     1.7,
     .5,
     2,
     {1.2745, .2288},
     {1.27449721065853, .228803148242056},
     {{-.5216686133139, .6079769087971}, {-.5216686133139, -.6079769087971}}},
};

static whirl_orbit *rattle_orbit(const rattle *of, const whirl_rotor *rotor, double length, double radius) {
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_orbit_options options = whirl_orbit_default();
    double state[3] = {of->start[0] / length / radius, of->start[1] / of->speed / length / radius, 0.0};
    whirl_orbit *orbit = NULL;
    require_ok(whirl_orbit_find(system, state, of->revolutions, &options, &orbit));
    return orbit;
}

static void rattles_through_the_play(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rattles); i++) {
        const rattle *of = &rattles[i];
        whirl_rotor *rotor = rattle_rotor(of, 1.0, 1.0);
        whirl_orbit *orbit = rattle_orbit(of, rotor, 1.0, 1.0);
        // All digits but the last ones, which are those of 30 digits: steps of double precision sum up to 1e-13.
        for (size_t k = 0; k < 2; k++) {
            check_within("Gear rattle", words("%zu: %s", i + 1, k ? "x'" : "x"), of->place[k],
                         (k ? of->speed : 1.0) * orbit->nodes[k], 2e-13);
            check_within("Gear rattle", words("%zu: multiplier %zu", i + 1, k + 1), of->multiplier[k][0],
                         orbit->multipliers[k].real, 2e-12);
            check_within("Gear rattle", words("%zu: its imaginary part", i + 1), of->multiplier[k][1],
                         orbit->multipliers[k].imaginary, 2e-12);
        }
        // Liouville: all damping is viscous and acts always.
        check_within("Gear rattle", words("%zu: product of multipliers", i + 1),
                     -2.0 * of->z * (double)of->revolutions * 6.283185307179586 / of->speed, orbit->volume, 1e-12);
        whirl_orbit_free(orbit);
        whirl_rotor_free(rotor);
    }
}

/// Length scale and radius change no multiplier.
static void rattles_at_any_scale(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT_OF(rattles); i++) {
        whirl_rotor *one = rattle_rotor(&rattles[i], 1.0, 1.0), *other = rattle_rotor(&rattles[i], 2.7e-3, 0.08);
        whirl_orbit *a = rattle_orbit(&rattles[i], one, 1.0, 1.0), *b = rattle_orbit(&rattles[i], other, 2.7e-3, 0.08);
        for (size_t k = 0; k < 2; k++)
            check_within("Gear rattle", words("%zu: multiplier %zu at another scale", i + 1, k + 1),
                         a->multipliers[k].real, b->multipliers[k].real, 1e-10);
        check_within("Gear rattle", words("%zu: place at another scale", i + 1), a->nodes[0],
                     2.7e-3 * 0.08 * b->nodes[0], 1e-10);
        whirl_orbit_free(a);
        whirl_orbit_free(b);
        whirl_rotor_free(one);
        whirl_rotor_free(other);
    }
}

/// Computes the slope of (x, x') for the equation with a stiffness k(W t).
static void profile_slope(const double *values, size_t count, double z, double psi, const double *x, double *slope) {
    // The trigonometric polynomial through an odd number of values, by Dirichlet's kernel.
    double k = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double apart = 0.5 * (psi - 6.283185307179586476925 * (double)i / (double)count);
        k += values[i] * (fabs(sin(apart)) < 1e-9 ? 1.0 : sin((double)count * apart) / ((double)count * sin(apart)));
    }
    slope[0] = x[1];
    slope[1] = -2.0 * z * x[1] - k * x[0];
}

/// A stiffness from a table over the mesh angle, without play: trace and determinant of the monodromy matrix by
/// Runge-Kutta steps of the equation with the polynomial through the table by another formula.
static void stiffness_over_the_mesh(void **state) {
    enum { STEPS = 4000 };
    static const double tables[][7] = {
        {1.3, 0.85, 0.85}, {1.2, 1.1, 0.7, 0.9, 1.05}, {1.3, 1.2, 1.0, 0.8, 0.75, 0.9, 1.1}};
    static const size_t counts[] = {3, 5, 7};
    static const double z = 0.03, speed = 1.7;
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        double monodromy[2][2];
        for (size_t column = 0; column < 2; column++) {
            const double h = 6.283185307179586476925 / speed / STEPS;
            double x[2] = {column == 0, column == 1};
            for (int n = 0; n < STEPS; n++) {
                double a[2], b[2], c[2], d[2], at[2];
                const double psi = speed * h * n, half = 0.5 * speed * h;
                profile_slope(tables[i], counts[i], z, psi, x, a);
                for (int k = 0; k < 2; k++) at[k] = x[k] + 0.5 * h * a[k];
                profile_slope(tables[i], counts[i], z, psi + half, at, b);
                for (int k = 0; k < 2; k++) at[k] = x[k] + 0.5 * h * b[k];
                profile_slope(tables[i], counts[i], z, psi + half, at, c);
                for (int k = 0; k < 2; k++) at[k] = x[k] + h * c[k];
                profile_slope(tables[i], counts[i], z, psi + 2.0 * half, at, d);
                for (int k = 0; k < 2; k++) x[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
            }
            for (int k = 0; k < 2; k++) monodromy[k][column] = x[k];
        }
        char profile[128] = "";
        for (size_t k = 0; k < counts[i]; k++)
            snprintf(profile + strlen(profile), sizeof profile - strlen(profile), "%s%.17g", k ? ", " : "",
                     tables[i][k]);
        whirl_design *design = NULL;
        require_ok(whirl_design_new(speed, 1.0, &design));
        STATION(design, "wheel", {"polar", 1.0, NULL}, {"moves", 0.0, "twist"});
        ADD(design, "spring", {"between", 0.0, "wheel, ground"}, {"along", 0.0, "twist"}, {"damping", 2.0 * z, NULL});
        ADD(design, "gear", {"between", 0.0, "wheel, ground"}, {"base_radii", 0.0, "1, 1"}, {"stiffness", 1.0, NULL},
            {"teeth", 1.0, NULL}, {"profile", 0.0, profile});
        ADD(design, "force", {"at", 0.0, "wheel"}, {"steady_torque", 0.1, NULL});
        whirl_rotor *rotor = rotor_of(design);
        const double first[3] = {0.1, 0.0, 0.0};
        whirl_orbit_options options = whirl_orbit_default();
        whirl_orbit *orbit = NULL;
        require_ok(whirl_orbit_find(whirl_rotor_system(rotor), first, 1, &options, &orbit));
        check_within("Gear rattle", words("table of %zu: trace of the monodromy matrix", counts[i]),
                     monodromy[0][0] + monodromy[1][1], orbit->multipliers[0].real + orbit->multipliers[1].real, 1e-9);
        check_within("Gear rattle", words("table of %zu: determinant, logarithm", counts[i]),
                     log(monodromy[0][0] * monodromy[1][1] - monodromy[0][1] * monodromy[1][0]), orbit->volume, 1e-9);
        whirl_orbit_free(orbit);
        whirl_rotor_free(rotor);
    }
}

// ---------------------------------------------------------------- a pair on supports

/// Makes two gears on springs, each on a shaft to a further inertia; the whole machine is turned by `turned`.
static whirl_rotor *pair_rotor(double turned, double stiffness) {
    whirl_design *design = NULL;
    require_ok(whirl_design_new(300.0, 1e-3, &design));
    STATION(design, "one", {"mass", 12.0, NULL}, {"polar", 0.05, NULL}, {"moves", 0.0, "all"});
    STATION(design, "two", {"mass", 30.0, NULL}, {"polar", 0.4, NULL}, {"moves", 0.0, "all"});
    STATION(design, "in", {"polar", 0.8, NULL}, {"moves", 0.0, "twist"});
    STATION(design, "out", {"polar", 3.0, NULL}, {"moves", 0.0, "twist"});
    ADD(design, "spring", {"between", 0.0, "one, ground"}, {"stiffness", 6e7, NULL});
    ADD(design, "spring", {"between", 0.0, "two, ground"}, {"stiffness", 9e7, NULL});
    ADD(design, "coupling", {"between", 0.0, "in, one"}, {"twist", 2e5, NULL});
    ADD(design, "coupling", {"between", 0.0, "two, out"}, {"twist", 4e5, NULL});
    if (stiffness > 0.0)
        ADD(design, "gear", {"between", 0.0, "one, two"}, {"base_radii", 0.0, "0.08, 0.2"},
            {"pressure_angle", 0.3490658503988659, NULL}, {"direction", turned, NULL}, {"stiffness", stiffness, NULL});
    else
        ADD(design, "gear", {"between", 0.0, "one, two"}, {"base_radii", 0.0, "0.08, 0.2"});
    return rotor_of(design);
}

static void pair_of_gears(void **state) {
    static const char *const known[] = {"57.12096851491", "222.964106197",  "275.6644477109", "287.4975883324",
                                        "345.8352111437", "355.8812717086", "1505.45617792"};
    (void)state;
    for (size_t turned = 0; turned < 3; turned++) {
        whirl_rotor *rotor = pair_rotor((double)turned * 0.9, 2.5e8);
        const whirl_system *system = whirl_rotor_system(rotor);
        double start[16] = {0};
        whirl_modes *modes = NULL;
        require_ok(whirl_modes_new(system, start, &modes));
        assert_int_equal(modes->count, COUNT_OF(known));
        check_within("Gear pair", words("free motions, turned %zu times", turned), 1.0, (double)modes->free, 0.0);
        for (size_t i = 0; i < COUNT_OF(known); i++)
            check_digits("Gear pair", words("mode %zu, Hz, turned %zu times", i + 1, turned), known[i],
                         300.0 * modes->modes[i].imaginary / 6.283185307179586476925);
        // Two modes are the gears alone on their supports, across the line of action: no twist.
        check_within("Gear pair", "twist of a gear alone on its support", 0.0, modes->modes[2].torsion, 1e-12);
        check_within("Gear pair", "twist of the other", 0.0, modes->modes[5].torsion, 1e-12);
        check_holds("Gear pair", "the lowest mode is torsional", modes->modes[0].torsion > 0.9);
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
}

/// A pair of helical gears whose supports yield across the shafts, against tilts and twist and, with `axial`, along
/// them.
static whirl_rotor *helical_rotor(double turned, double helix, double length, bool axial) {
    whirl_design *design = NULL;
    require_ok(whirl_design_new(300.0, length, &design));
    STATION(design, "one", {"mass", 12.0, NULL}, {"polar", 0.05, NULL}, {"diametral", 0.03, NULL},
            {"moves", 0.0, "all"}, {"axial", 0.0, axial ? "yes" : "no"});
    STATION(design, "two", {"mass", 30.0, NULL}, {"polar", 0.4, NULL}, {"diametral", 0.25, NULL}, {"moves", 0.0, "all"},
            {"axial", 0.0, axial ? "yes" : "no"});
    ADD(design, "spring", {"between", 0.0, "one, ground"}, {"stiffness", 6e7, NULL});
    ADD(design, "spring", {"between", 0.0, "two, ground"}, {"stiffness", 9e7, NULL});
    ADD(design, "spring", {"between", 0.0, "one, ground"}, {"along", 0.0, "tilts"}, {"stiffness", 4e5, NULL});
    ADD(design, "spring", {"between", 0.0, "two, ground"}, {"along", 0.0, "tilts"}, {"stiffness", 7e5, NULL});
    ADD(design, "spring", {"between", 0.0, "one, ground"}, {"along", 0.0, "twist"}, {"stiffness", 2e5, NULL});
    ADD(design, "spring", {"between", 0.0, "two, ground"}, {"along", 0.0, "twist"}, {"stiffness", 4e5, NULL});
    if (axial) {
        ADD(design, "spring", {"between", 0.0, "one, ground"}, {"along", 0.0, "axial"}, {"stiffness", 5e7, NULL});
        ADD(design, "spring", {"between", 0.0, "two, ground"}, {"along", 0.0, "axial"}, {"stiffness", 8e7, NULL});
    }
    ADD(design, "gear", {"between", 0.0, "one, two"}, {"base_radii", 0.0, "0.08, 0.2"},
        {"pressure_angle", 0.3490658503988659, NULL}, {"direction", turned, NULL}, {"helix", helix, NULL},
        {"stiffness", 2.5e8, NULL});
    return rotor_of(design);
}

/// A force along the unit normal of the teeth at the pitch point, in space, gives the closing by rigid motions of both
/// gears, and so the stiffness k h h^T; eigenvalues with the gyroscopic moments of both discs, in 40 digits.
static void helical_gears(void **state) {
    static const char *const known[2][10] = {
        {"216.0862413692", "230.8452891039", "275.6644477109", "284.7806572320", "307.2396617880", "343.2884430513",
         "355.8812717086", "542.7234291663", "622.3009007122", "1505.417141379"},
        {"206.8614089487", "237.7349581144", "275.6644477109", "284.0150363700", "308.3567272702", "343.8027631737",
         "355.8812717086", "533.6758128760", "611.5511109186", "1532.161909804"}};
    static const char *const axially[2][12] = {
        {"216.0862413692", "230.8452891039", "259.8989337446", "275.6644477109", "284.780657232", "307.239661788",
         "324.8736671807", "343.2884430513", "355.8812717086", "542.7234291663", "622.3009007122", "1505.417141379"},
        {"205.2085036562", "236.8306348158", "261.019622132", "275.6644477109", "283.922322445", "308.3136702806",
         "324.3514107398", "344.5788534755", "355.8812717086", "534.1092162987", "611.9707450314", "1560.071070459"}};
    static const double helix[] = {0.0, 0.35, -0.35}, lengths[] = {1e-3, 1.0};
    (void)state;
    for (size_t i = 0; i < 2 * 4 * COUNT_OF(helix); i++) {
        const size_t k = i / 8, turned = i / 2 % 4;
        const bool axial = i % 2;
        whirl_rotor *rotor = helical_rotor((double)turned * 0.9, helix[k], lengths[turned % 2], axial);
        double start[24] = {0};
        whirl_modes *modes = NULL;
        require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
        assert_int_equal(modes->count, axial ? 12 : 10);
        for (size_t n = 0; n < modes->count; n++)
            check_digits("Gear pair",
                         words("helix %g, mode %zu%s, Hz, turned %zu times", helix[k], n + 1,
                               axial ? " with axial motion" : "", turned),
                         axial ? axially[k > 0][n] : known[k > 0][n],
                         300.0 * modes->modes[n].imaginary / 6.283185307179586476925);
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
}

/// Modes of two shafts of finite elements with helical gears, as they stand or turned end for end.
static whirl_result *helical_shafts(double helix, bool turned) {
    char text[4096];
    const double gears = turned ? 0.3 : 0.2;
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 100 rad/s\n  length_scale: 0.1 mm\n"
             "  shafts: {one: {twist: yes}, two: {twist: yes, ratio: -0.4}}\n"
             "  stations:\n"
             "    a: {shaft: one, position: 0 m}\n"
             "    g1: {shaft: one, position: %g m}\n"
             "    b: {shaft: one, position: 0.5 m}\n"
             "    c: {shaft: two, position: 0 m}\n"
             "    g2: {shaft: two, position: %g m}\n"
             "    d: {shaft: two, position: 0.5 m}\n"
             "  elements:\n"
             "    - segment: {shaft: one, length: 0.5 m, outer: 50 mm, elements: 10}\n"
             "    - segment: {shaft: two, length: 0.5 m, outer: 60 mm, elements: 10}\n"
             "    - disc: {at: g1, outer: 160 mm, inner: 50 mm, width: 60 mm, density: 7800 kg/m3}\n"
             "    - disc: {at: g2, outer: 400 mm, inner: 60 mm, width: 60 mm, density: 7800 kg/m3}\n"
             "    - spring: {between: [a, ground], stiffness: 1e8 N/m}\n"
             "    - spring: {between: [b, ground], stiffness: 1e8 N/m}\n"
             "    - spring: {between: [c, ground], stiffness: 1e8 N/m}\n"
             "    - spring: {between: [d, ground], stiffness: 1e8 N/m}\n"
             "    - spring: {between: [%s, ground], along: twist, stiffness: 1e5}\n"
             "    - gear: {between: [g1, g2], base_radii: [75 mm, 187.5 mm], stiffness: 4e8 N/m, helix: %g deg}\n"
             "study:\n  modes: {count: 12}\n",
             gears, gears, turned ? "b" : "a", helix);
    return result_of_text(text);
}

/// Shafts turned end for end with gears of the other hand are mirror images: they have the same frequencies. Turned end
/// for end with the same hand they have others.
static void helical_gears_in_a_mirror(void **state) {
    (void)state;
    whirl_result *all[] = {helical_shafts(15.0, false), helical_shafts(-15.0, true), helical_shafts(15.0, true)};
    const double *as[3];
    double apart = 0.0;
    for (size_t i = 0; i < 3; i++)
        as[i] = whirl_table_field(whirl_result_table(all[i], "modes"), 0, WHIRL_FIELD_MODES_FREQUENCY, 0);
    for (size_t i = 0; i < 12; i++) {
        check_within("Gear pair", words("helical, mode %zu in a mirror, rad/s", i + 1), as[0][i], as[1][i],
                     1e-9 * as[0][i]);
        apart = fmax(apart, fabs(as[2][i] / as[0][i] - 1.0));
    }
    check_holds("Gear pair", words("of the other hand they differ, by %.2g", apart), apart > 1e-3);
    for (size_t i = 0; i < 3; i++) whirl_result_free(all[i]);
}

/// A mesh that becomes stiffer has the torsional modes of a rigid ratio: the difference goes with one over the
/// stiffness of the mesh, with supports as stiff.
static void stiff_mesh_becomes_rigid(void **state) {
    double before = INFINITY, start[16] = {0};
    (void)state;
    whirl_rotor *rigid = pair_rotor(0.0, 0.0);
    whirl_modes *modes = NULL;
    require_ok(whirl_modes_new(whirl_rotor_system(rigid), start, &modes));
    double known = NAN;
    for (size_t i = modes->count; i-- > 0;)
        if (modes->modes[i].torsion > 0.5) known = modes->modes[i].imaginary;
    // Three inertias and two shafts, twists referred to the first gear: in, both gears, out.
    const double ratio = 0.08 / 0.2, both = 0.05 + 0.4 * ratio * ratio, out = 3.0 * ratio * ratio;
    const double k1 = 2e5, k2 = 4e5 * ratio * ratio, a = k1 / 0.8 + (k1 + k2) / both + k2 / out;
    const double b = k1 * k2 * (0.8 + both + out) / (0.8 * both * out);
    check_within("Gear pair", "lowest torsional mode of a rigid pair", sqrt(0.5 * (a - sqrt(a * a - 4.0 * b))) / 300.0,
                 known, 1e-12);
    whirl_modes_free(modes);
    whirl_rotor_free(rigid);
    double mesh = 1e9;
    for (int i = 0; i < 3; i++) {
        mesh *= 10.0;
        whirl_rotor *rotor = pair_rotor(0.0, mesh);
        require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
        // Supports give way, so that what is left does not vanish; it falls with the mesh.
        const double apart = fabs(modes->modes[0].imaginary / known - 1.0);
        check_holds("Gear pair", words("nearer to the rigid ratio at %g N/m", mesh), apart < before);
        before = apart;
        whirl_modes_free(modes);
        whirl_rotor_free(rotor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rattles_through_the_play),
                                       cmocka_unit_test(rattles_at_any_scale),
                                       cmocka_unit_test(stiffness_over_the_mesh),
                                       cmocka_unit_test(pair_of_gears),
                                       cmocka_unit_test(helical_gears),
                                       cmocka_unit_test(helical_gears_in_a_mirror),
                                       cmocka_unit_test(stiff_mesh_becomes_rigid)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
