// Evidence that analyses give, on rotors of which it is known. The sense of whirl of rubbing rotors (cases C2 and C3):
// with the shaft where the rub is synchronous, against it where dry friction drives the rotor, rolling round its
// stator. The largest multipliers of cases A7 and C4, by the way in which the motion comes to rest.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_rotor.h"
#include "whirl/engine/analyze.h"

enum { BLOCK = 8 };

/// Records the rotor, which is freed, and fills the fields of an analysis.
static void analyse(const char *analysis, whirl_rotor *rotor, const double *start, int steps, int transient,
                    whirl_layout *layout, double *block) {
    const whirl_system *system = whirl_rotor_system(rotor);
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_analysis_set set = 0;
    whirl_record *record;
    integrate.steps_per_revolution = steps;
    options.transient = transient;
    options.watch = options.record + transient; // the way to rest as well
    assert_true(whirl_analysis_add(&set, analysis));
    require_ok(whirl_layout_new(system, &integrate, &options, set, layout));
    assert_true(layout->size <= BLOCK);
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &record));
    require_ok(whirl_analyze(record, &options, set, layout, block));
    whirl_record_free(record);
    whirl_rotor_free(rotor);
}

static double value(const whirl_layout *layout, const double *block, const char *name) {
    return block[whirl_layout_field(layout, name)->offset];
}

static void synchronous_rub(void **state) {
    (void)state;
    const rub_case p = {.speed = 1.0, .zeta = 0.05, .kappa = 2.0, .eccentricity = 0.2, .friction = 0.1};
    const double start[4] = {0.2, -1.05, 1.05, 0.2};
    whirl_layout layout;
    double block[BLOCK];
    analyse("winding", make_rub_rotor(&p), start, 1024, 400, &layout, block);
    check_within("C2", "w = 1: turns round the mean position a revolution", 1.0,
                 value(&layout, block, "winding/winding"), 1e-6);
    check_within("C2", "w = 1: share of the time in contact", 1.0, value(&layout, block, "winding/contact"), 1e-9);
    check_within("C2", "w = 1: dry whip", 0.0, value(&layout, block, "winding/dry_whip"), 0.0);
}

/// Rolling without slip, R_d w = r w_b: -R_d/r turns per revolution.
static void rolling(void **state) {
    (void)state;
    static const struct {
        double zeta, kappa, surface_speed, whirl, rolling;
    } rows[] = {{0.05, 25.0, 30.0, 1.618033988750, 6.3838636}, {0.02, 4.0, 8.0, 1.219803902719, 4.0}};
    for (size_t i = 0; i < 2; i++) {
        const double speed = 3.0;
        const rub_case p = {.speed = speed,
                            .zeta = rows[i].zeta,
                            .kappa = rows[i].kappa,
                            .friction = 0.1,
                            .follows_slip = true,
                            .surface_radius = rows[i].surface_speed / speed,
                            .slip_speed = 0.01};
        const double start[4] = {1.5, 0.0, 0.0, -1.5 * rows[i].whirl / speed};
        whirl_layout layout;
        double block[BLOCK];
        analyse("winding", make_rub_rotor(&p), start, 2048, 400, &layout, block);
        check_within("C3", words("zeta = %g: turns round the stator a revolution, rolling", p.zeta),
                     -p.surface_radius / rows[i].rolling, value(&layout, block, "winding/winding"), 5e-3);
        check_within("C3", words("zeta = %g: direction of whirl", p.zeta), -1.0,
                     value(&layout, block, "winding/direction"), 0.0);
        check_within("C3", words("zeta = %g: dry whip", p.zeta), 1.0, value(&layout, block, "winding/dry_whip"), 0.0);
    }
}

/// Checks a multiplier to the printed digits and to the error of a fit to nonlinear returns of 1e-2 and less.
static void check_multiplier(const char *id, const char *what, const whirl_layout *layout, const double *block,
                             double real, double imaginary) {
    const double *found = block + whirl_layout_field(layout, "evidence/multiplier")->offset;
    check_within(id, words("%s: real part of the largest multiplier, from returns", what), real, found[0], 1e-4);
    check_within(id, words("%s: imaginary part", what), imaginary, found[1], 1e-4);
    check_within(id, words("%s: its modulus, by the exponent", what), hypot(real, imaginary),
                 value(layout, block, "evidence/modulus"), 1e-4);
}

/// All revolutions are watched, so that the way to rest is among them.
static void multipliers(void **state) {
    (void)state;
    const rub_case p = {.speed = 1.5, .zeta = 0.1, .kappa = 10.0, .eccentricity = 0.9, .friction = 0.05, .weight = 0.5};
    const double c4_start[4] = {0.1, -0.2, 0.0, 0.0};
    whirl_layout layout;
    double block[BLOCK];
    analyse("evidence", make_rub_rotor(&p), c4_start, 1024, 150, &layout, block);
    check_multiplier("C4", "w = 1.5", &layout, block, .54774858, .61278587);

    const double a7_start[4] = {0.28, 0.0, 0.0, 0.28};
    analyse("evidence", make_film_rotor(0.2, 0.0, .304206515539), a7_start, 1024, 100, &layout, block);
    const double *found = block + whirl_layout_field(&layout, "evidence/multiplier")->offset;
    check_within("A7", "e = 0.3: modulus of the largest multiplier, from returns", .57499, hypot(found[0], found[1]),
                 1e-4);
    check_within("A7", "e = 0.3: modulus by the exponent", .57499, value(&layout, block, "evidence/modulus"), 1e-4);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(synchronous_rub), cmocka_unit_test(rolling),
                                       cmocka_unit_test(multipliers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
