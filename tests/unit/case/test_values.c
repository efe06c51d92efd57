// Meaning of a case: numbers, units, expressions, overrides, batches and starts.
#include "case_support.h"

#include <math.h>

#include "whirl/engine/integrate.h"

static double value_of(const whirl_case *object, const char *name) {
    double value = NAN;
    assert_int_equal(whirl_case_parameter(object, name, &value).code, WHIRL_OK);
    return value;
}

/// Returns the value of "p: TEXT" in SI.
static double parameter_value(const char *text) {
    char line[200];
    snprintf(line, sizeof line, "kappa: 10\n  p: %s", text);
    whirl_case *object = parse_edited("kappa: 10", line);
    const double value = value_of(object, "p");
    whirl_case_free(object);
    return value;
}

static void expect_parameter(const char *text, double expected) {
    const double found = parameter_value(text);
    if (!(fabs(found - expected) <= 1e-14 * fabs(expected))) print_error("%s gives %.17g\n", text, found);
    assert_true(fabs(found - expected) <= 1e-14 * fabs(expected));
}

static const double pi = 3.14159265358979323846;

/// A number in a decimal unit is the double nearest to the number with the unit's exponent, for every unit.
static void decimal_units_are_exact(void **state) {
    static const struct {
        const char *unit;
        int power;
    } units[] = {{"nm", -9}, {"um", -6},   {"mm", -3},    {"cm", -2},    {"km", 3},   {"g", -3},
                 {"mg", -6}, {"kN", 3},    {"MN/m", 6},   {"mPa.s", -3}, {"GPa", 9},  {"bar", 5},
                 {"ms", -3}, {"g mm", -6}, {"kN s/m", 3}, {"cm2", -4},   {"N/mm", 3}, {"mrad", -3}};
    static const char *const numbers[] = {"30", "0.07", "80.1", "1.1e-3", "123.456789", "9999", "-0.3", "1e20"};
    (void)state;
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
            char written[64], plain[64];
            const char *const mark = strchr(numbers[i], 'e');
            const int own = mark ? atoi(mark + 1) : 0, length = (int)strcspn(numbers[i], "e");
            snprintf(written, sizeof written, "%s %s", numbers[i], units[u].unit);
            snprintf(plain, sizeof plain, "%.*se%d", length, numbers[i], own + units[u].power);
            if (parameter_value(written) != strtod(plain, NULL)) print_error("%s is not %s\n", written, plain);
            assert_true(parameter_value(written) == strtod(plain, NULL));
        }
}

static void quantities_are_in_si(void **state) {
    (void)state;
    expect_parameter("12 mm", 0.012);
    expect_parameter("12   mm", 0.012);
    expect_parameter("-1.5e-2", -0.015);
    expect_parameter(".5", 0.5);
    expect_parameter("5.", 5.0);
    expect_parameter("+2", 2.0);
    expect_parameter("\"2\"", 2.0);
    expect_parameter("6207 rpm", 6207.0 * 2.0 * pi / 60.0);
    expect_parameter("18 mPa.s", 0.018);
    expect_parameter("18 cP", 0.018);
    expect_parameter("650 rad/s", 650.0);
    expect_parameter("30 deg", pi / 6.0);
    expect_parameter("1 kN/mm", 1e6);
    expect_parameter("200 g.mm", 2e-4);
    expect_parameter("5 %", 0.05);
    expect_parameter("50 Hz", 50.0);
    expect_parameter("16 \xC2\xB5m", 16e-6);
    expect_parameter("9.81 m/s2", 9.81);
    expect_parameter("9.81 m/s^2", 9.81);
    expect_parameter("1 inch", 0.0254);
    expect_parameter("2 kg m-1", 2.0);
}

/// Units of US practice, by their definitions: the pound is 0.45359237 kg, the inch 25.4 mm, the gallon 231 cubic
/// inches, and the ounce a sixteenth of a pound (not a fluid ounce).
static void units_of_us_practice(void **state) {
    const double pound = 0.45359237, inch = 0.0254, force = pound * 9.80665;
    (void)state;
    expect_parameter("3 lbm", 3.0 * pound);
    expect_parameter("1 oz", pound / 16.0);
    expect_parameter("8 ozm", pound / 2.0);
    expect_parameter("2 oz.in", pound / 8.0 * inch);
    expect_parameter("1 lbm.in2", pound * inch * inch);
    expect_parameter("1 blob", force / inch);
    expect_parameter("1 reyn", force / (inch * inch));
    expect_parameter("5 thou", 0.005 * inch);
    expect_parameter("12 gpm", 12.0 * 231.0 * inch * inch * inch / 60.0);
    expect_parameter("0.2 ips", 0.2 * inch);
    expect_parameter("3600 cpm", 60.0);
    expect_parameter("1 lbf.s/in", force / inch);
    expect_parameter("1 slug", force / (12.0 * inch));
    expect_parameter("3 slugs", 3.0 * force / (12.0 * inch));
    expect_parameter("4 ozf", force / 4.0);
    expect_parameter("2 hp", 2.0 * 550.0 * 12.0 * inch * force);
    expect_parameter("1 horsepower", 550.0 * 12.0 * inch * force);
    expect_parameter("1 kilohorsepower", 550.0e3 * 12.0 * inch * force);
    expect_parameter("1 poundal", pound * 12.0 * inch);
    expect_parameter("1 gallon", 231.0 * inch * inch * inch);
}

static void expressions_are_in_si(void **state) {
    (void)state;
    expect_parameter("= 50*(650/0.2)^2", 528125000.0);
    expect_parameter("= c", 0.0002);
    expect_parameter("= -2^2", -4.0);
    expect_parameter("= 2^3^2", 512.0);
    expect_parameter("= 2*pi", 2.0 * pi);
    expect_parameter("= later/2\n  later: = 3*omega", 150.0);
    expect_parameter("\"= omega > 99 ? 1e-3 : 2\"", 1e-3);
    expect_parameter("= ln(exp(2)) + log10(100) + log2(8)", 7.0);
    expect_parameter("= log(exp(2))", 2.0);
    expect_parameter("= max(1, 2, 3) + min(4, 5)", 7.0);
    expect_parameter("= sqrt(2)^2 + abs(-1)", 3.0);
    expect_parameter("= atan2(1, 1) + sin(pi/6)", pi / 4.0 + 0.5);
    expect_parameter("= rint(2.6) + sign(-3) + sum(1, 2) + avg(2, 4)", 8.0);
    expect_parameter("= cosh(0) + sinh(0) + tanh(0) + acosh(1) + asinh(0) + atanh(0)", 1.0);
    expect_parameter("= asin(1) + acos(1) + atan(0) + tan(0) + cos(0)", pi / 2.0 + 1.0);
}

static void rotors_follow_the_parameters(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_rotor *rotor;
    assert_int_equal(whirl_case_rotor(object, NULL, 0.0, &rotor).code, WHIRL_OK);
    assert_true(whirl_rotor_speed(rotor) == 100.0);
    assert_true(fabs(whirl_rotor_length_scale(rotor) - 2e-4) < 1e-18);
    const whirl_system *system = whirl_rotor_system(rotor);
    assert_int_equal(system->probe_count, 2);
    assert_int_equal(system->contact_count, 1);
    // At rest in (5, 0) length scales the rub force is k (5 - 1.2) c, with k = kappa 1e6.
    const double x[8] = {5.0};
    double force;
    system->contacts(system->model, x, &force);
    assert_true(fabs(force - 10e6 * 3.8 * 2e-4) < 1e-6);
    whirl_rotor_free(rotor);
    assert_int_equal(whirl_case_rotor(object, "kappa", 20.0, &rotor).code, WHIRL_OK);
    system = whirl_rotor_system(rotor);
    system->contacts(system->model, x, &force);
    assert_true(fabs(force - 20e6 * 3.8 * 2e-4) < 1e-6);
    whirl_rotor_free(rotor);
    assert_int_equal(whirl_case_rotor(object, "omega", -1.0, &rotor).code, WHIRL_BAD_INPUT);
    assert_null(rotor);
    assert_int_equal(whirl_case_rotor(object, "omegas", 1.0, &rotor).code, WHIRL_BAD_INPUT);
    whirl_case_free(object);
}

static void elements_stand_alone(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_rotor *rotor;
    double rates[8];
    const double x[8] = {1e-3, 0.0, 0.0, 0.0, 0.3, -0.2, 0.1, 0.0};
    // The stator pushes the disc back by k (x - gap), and nothing else acts on it or on the journal.
    assert_int_equal(whirl_case_element(object, "rub", &rotor).code, WHIRL_OK);
    assert_int_equal(whirl_rotor_rates(rotor, 0.1, x, rates).code, WHIRL_OK);
    assert_true(fabs(rates[4] + 10e6 * (1e-3 - 1.2 * 2e-4)) < 1e-6);
    for (size_t i = 0; i < 4; i++) assert_true(fabs(rates[i] - x[4 + i]) < 1e-16);
    assert_true(rates[6] == 0.0 && rates[7] == 0.0);
    whirl_rotor_free(rotor);
    static const char *const wrong[] = {"rubb", "rub[2]", "rub[0]", "rub[1", "rub[1]x", "rub[", ""};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(whirl_case_element(object, wrong[i], &rotor).code, WHIRL_BAD_INPUT);
        assert_null(rotor);
    }
    assert_int_equal(whirl_case_element(object, "rub[1]", &rotor).code, WHIRL_OK);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
}

static void parameters_are_set(void **state) {
    (void)state;
    // The ends of the sweep follow from kappa, so that setting it has a meaning.
    char *follows = edited(good_case, "from: 1, to: 20", "from: = kappa, to: = 2*kappa");
    char *text = edited(follows, "kappa: 10", "kappa: 10\n  twice: = 2*kappa");
    whirl_case *object = parse_good(text);
    free(follows);
    free(text);
    assert_int_equal(whirl_case_set(object, "kappa=0.5").code, WHIRL_OK);
    assert_true(value_of(object, "twice") == 1.0);
    assert_int_equal(whirl_case_set(object, "omega=6000 rpm").code, WHIRL_OK);
    assert_true(fabs(value_of(object, "omega") - 200.0 * pi) < 1e-11);
    assert_int_equal(whirl_case_set(object, "c== 2*0.1e-3").code, WHIRL_OK);
    assert_true(value_of(object, "c") == 2 * 0.1e-3);
    assert_true(value_of(object, "twice") == 1.0); // what was set before stays
    assert_int_equal(whirl_case_set(object, "kappa = 3 ").code, WHIRL_OK);
    assert_true(value_of(object, "kappa") == 3.0);
    whirl_case_free(object);
}

/// A plain number has the SI unit of the value that it replaces, and results show this unit.
static void set_numbers_keep_their_unit(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_result *result = calloc(1, sizeof *result);
    assert_non_null(result);
    assert_int_equal(whirl_case_set(object, "omega=2").code, WHIRL_OK);
    assert_int_equal(whirl_case_describe_result(object, result).code, WHIRL_OK);
    assert_string_equal(result->parameters[0].name, "omega");
    assert_string_equal(result->parameters[0].unit, "rad/s");
    assert_true(result->parameters[0].value == 2.0);
    assert_string_equal(result->parameters[1].unit, "1");
    whirl_result_free(result);
    whirl_case_free(object);
}

static void expect_refused(const char *assignment, const char *message) {
    whirl_case *object = parse_good(good_case);
    const whirl_status status = whirl_case_set(object, assignment);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, message);
    assert_true(value_of(object, "kappa") == 10.0);
    assert_true(value_of(object, "omega") == 100.0);
    assert_true(fabs(value_of(object, "c") - 2e-4) < 1e-18);
    whirl_case_free(object);
}

static void wrong_settings_leave_the_case_as_it_was(void **state) {
    (void)state;
    expect_refused("kapa=1", "no parameter is called kapa, did you mean kappa?");
    expect_refused("kappa", "'kappa' sets nothing, expected NAME=VALUE");
    expect_refused("=3", "'=3' sets nothing, expected NAME=VALUE");
    expect_refused("kappa=2x", "kappa: is 2x, expected a number, or a number and a unit, with a space before the unit");
    expect_refused("kappa=", "kappa: is empty, expected a number, a quantity or an expression");
    expect_refused("omega=3 kg", "omega: is in kg, expected a unit of rad/s");
    // Texts that UDUNITS silently takes for another unit.
    static const char *const slips[] = {"rad/s)",
                                        "rad/(s).2",
                                        "(rad)2.s",
                                        "rad\xC2\xB2"
                                        "2/s",
                                        "rad\xC2\xB7"
                                        "2/s",
                                        "rad/s since2"};
    for (size_t i = 0; i < sizeof slips / sizeof *slips; i++) {
        char assignment[80], sentence[200];
        snprintf(assignment, sizeof assignment, "omega=3 %s", slips[i]);
        snprintf(sentence, sizeof sentence, "omega: is 3 %s, expected a number in rad/s or rpm (no unit is called %s)",
                 slips[i], slips[i]);
        expect_refused(assignment, sentence);
    }
    expect_refused("omega=50 Hz", "omega: is in Hz, expected a unit of rad/s, such as rpm (1 Hz = 60 rpm)");
    expect_refused("omega=-5", "t.yaml:8:10: rotor.speed: = omega is -5 rad/s, expected a number above 0 rad/s, and "
                               "rotation: clockwise for a rotor that turns from y to x");
    // In the unit in which it was written.
    expect_refused("omega=-100 rpm", "t.yaml:8:10: rotor.speed: = omega is -100 rpm, expected a number above 0 rpm, "
                                     "and rotation: clockwise for a rotor that turns from y to x");
    expect_refused("omega=0 rpm", "t.yaml:8:10: rotor.speed: = omega is 0 rpm, expected a number above 0 rpm");
    expect_refused("omega== 0-2", "t.yaml:8:10: rotor.speed: = omega is -2 rad/s, expected a number above 0 rad/s, "
                                  "and rotation: clockwise for a rotor that turns from y to x");
    expect_refused("kappa=\xFF", "the value of kappa is not text in UTF-8");
    expect_refused("kappa=3",
                   "the study sweeps kappa from 1 to 20, so that setting it changes nothing; change sweep in "
                   "the case, or write response: {} in its place");
    expect_refused("kappa== kappa+1", "kappa: depends on itself: kappa -> kappa");
}

static void a_swept_parameter_can_be_assigned(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    assert_int_equal(whirl_case_assign(object, "kappa=3").code, WHIRL_OK);
    assert_true(value_of(object, "kappa") == 3.0);
    assert_int_equal(whirl_case_assign(object, "kapa=3").code, WHIRL_BAD_INPUT);
    whirl_case_free(object);
}

/// Checks that the rotor has the same numbers after a key was set as after the same edit by hand.
static void expect_key_set(const char *assignment, const char *old, const char *new) {
    whirl_case *set = parse_good(good_case), *edited_case = parse_edited(old, new);
    whirl_result *a = calloc(1, sizeof *a), *b = calloc(1, sizeof *b);
    assert_true(a && b);
    const whirl_status status = whirl_case_set(set, assignment);
    if (status.code != WHIRL_OK) print_error("%s: %s\n", assignment, status.message);
    assert_int_equal(status.code, WHIRL_OK);
    assert_int_equal(whirl_case_describe_result(set, a).code, WHIRL_OK);
    assert_int_equal(whirl_case_describe_result(edited_case, b).code, WHIRL_OK);
    assert_string_equal(a->case_text, b->case_text); // the text in a result is that of the computed case
    whirl_result_free(a);
    whirl_result_free(b);
    whirl_case_free(set);
    whirl_case_free(edited_case);
}

static void keys_are_set_in_the_text(void **state) {
    (void)state;
    expect_key_set("disc.mass=41 kg", "mass: 4 kg", "mass: 41 kg");
    expect_key_set("disc.mass = 41 kg ", "mass: 4 kg", "mass: 41 kg");
    expect_key_set("rotor.stations.disc.mass== kappa/2", "mass: 4 kg", "mass: = kappa/2");
    expect_key_set("film.clearance=0.3 mm", "clearance: = c", "clearance: 0.3 mm");
    expect_key_set("rub.gap== max(c, 1e-4)", "gap: = 1.2*c", "gap: '= max(c, 1e-4)'");
    expect_key_set("gravity.acceleration=1.62 m/s2", "gravity: 9.81 m/s2", "gravity: 1.62 m/s2");
    expect_key_set("integrate.transient=40", "transient: 20", "transient: 40");
    expect_key_set("sweep.points=7", "points: 5", "points: 7");
    expect_key_set("initial.disc.y=-20 um", "disc: {y: -0.5}", "disc: {y: -20 um}");
    expect_key_set("rotor.elements[1].shaft.k1=2 kN/mm", "k1: 1 kN/mm", "k1: 2 kN/mm");
    expect_key_set("parameters.omega=99", "A rotor", "A rotor"); // a parameter: outside the text, as before
    // A key that is absent is written before the others; what was set before stays.
    whirl_case *object = parse_good(good_case);
    assert_int_equal(whirl_case_set(object, "omega=99").code, WHIRL_OK);
    assert_int_equal(whirl_case_set(object, "journal.damping=3 N.s/m").code, WHIRL_OK);
    assert_int_equal(whirl_case_set(object, "disc.mass=5 kg").code, WHIRL_OK);
    assert_true(value_of(object, "omega") == 99.0);
    whirl_case_free(object);
}

static void wrong_keys_leave_the_case_as_it_was(void **state) {
    (void)state;
    expect_refused("disk.mass=4 kg", "the case has no disk whose mass could be set, did you mean disc?");
    expect_refused("flim.load=4 N", "the case has no flim whose load could be set, did you mean film?");
    expect_refused("disc.mas=4 kg", "rotor.stations.disc.mas: station has no key mas, did you mean mass?");
    expect_refused("disc.mass=-4 kg", "rotor.stations.disc.mass: is -4 kg, expected a number above 0 kg");
    expect_refused("disc.mass=4 m", "rotor.stations.disc.mass: is in m, expected a unit of kg");
    expect_refused("film[2].load=4 N", "film[2] is no element, the case has 1 of that kind");
    expect_refused("film[].load=4 N", "film[] is no element, the case has 1 of that kind");
    expect_refused("study.analyze=regime", "study.analyze is a list, expected a value");
    expect_refused(".mass=4 kg", ".mass is no key, expected a name as in disc.mass");
    expect_refused("disc.=4 kg", "disc. is no key, expected a name as in disc.mass");
    char *two = edited(good_case, "    - gravity",
                       "    - rub: {at: journal, gap: 2 m, stiffness: 1 N/m, friction: 0}\n    - gravity");
    whirl_case *object = parse_good(two);
    free(two);
    assert_non_null(strstr(whirl_case_set(object, "zzzzzz.mass=4 kg").message,
                           "could be set, expected one of disc, journal, gravity, shaft, film, rub, response"));
    assert_string_equal(whirl_case_set(object, "rub.gap=3 m").message,
                        "the case has 2 elements rub, expected rub[1].gap to rub[2].gap");
    assert_int_equal(whirl_case_set(object, "rub[2].gap=3 m").code, WHIRL_OK);
    whirl_case_free(object);
}

// ---------------------------------------------------------------- studies

static whirl_study study_of(const whirl_case *object) {
    whirl_study study;
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    return study;
}

static void sweeps_are_equally_spaced(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    const whirl_study study = study_of(object);
    assert_int_equal(study.batch_count, 1);
    const whirl_batch *batch = &study.batches[0];
    assert_string_equal(batch->name, "sweep");
    assert_string_equal(batch->parameter, "kappa");
    assert_int_equal(batch->count, 5);
    for (size_t i = 0; i < 5; i++) assert_true(fabs(batch->values[i] - (1.0 + 4.75 * (double)i)) < 1e-14);
    assert_true(batch->values[0] == 1.0 && batch->values[4] == 20.0);
    assert_int_equal(batch->carry, WHIRL_CARRY_NONE);
    assert_int_equal(batch->integrate.steps_per_revolution, 64);
    assert_int_equal(batch->record.transient, 20);
    assert_int_equal(batch->record.record, 10);
    assert_int_equal(batch->record.waveform_revolutions, 0);
    assert_true(batch->record.waveform && batch->record.growth && !batch->record.spectra);
    whirl_analysis_set expected = 0;
    whirl_analysis_add(&expected, "poincare");
    whirl_analysis_add(&expected, "regime");
    whirl_analysis_add(&expected, "spectrum");
    whirl_analysis_add(&expected, "ranges"); // whatever a case asks for
    assert_int_equal(batch->analyses, expected);
    whirl_case_free(object);
}

static void expect_sweep(const char *written, const double *expected, size_t count) {
    whirl_case *object = parse_edited("kappa, from: 1, to: 20, points: 5", written);
    const whirl_study study = study_of(object);
    assert_int_equal(study.batches[0].count, count);
    for (size_t i = 0; i < count; i++)
        assert_true(fabs(study.batches[0].values[i] - expected[i]) <= 1e-14 * fabs(expected[i]));
    assert_true(study.batches[0].values[0] == expected[0]);
    whirl_case_free(object);
}

static void sweeps_have_steps_ratios_or_lists(void **state) {
    (void)state;
    const double whole[] = {1, 3, 5, 7}, falling[] = {7, 5, 3, 1}, decades[] = {0.01, 0.1, 1, 10, 100};
    const double tenths[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}, list[] = {3, 3.5, 40};
    const double rpm[] = {10 * pi, 20 * pi, 30 * pi};
    expect_sweep("kappa, from: 1, to: 7, step: 2", whole, 4);
    expect_sweep("kappa, from: 1, to: 8.9, step: 2", whole, 4); // the last is not beyond `to`
    expect_sweep("kappa, from: 7, to: 1, step: 2", falling, 4);
    expect_sweep("kappa, from: 0.1, to: 0.7, step: 0.1", tenths, 7); // 0.7 is met, whatever 0.1 is in binary
    expect_sweep("kappa, from: 1, to: 1, step: 2", whole, 1);
    expect_sweep("kappa, from: 0.01, to: 100, points: 5, scale: log", decades, 5);
    expect_sweep("kappa, values: [3, 3.5, 40]", list, 3);
    expect_sweep("kappa, values: [7, 5, = 0.3*kappa, 1]", falling, 4);
    expect_sweep("omega, from: 300 rpm, to: 900 rpm, step: 300 rpm", rpm, 3);
    expect_sweep("omega, values: [300 rpm, = 0.2*pi*omega, 900 rpm]", rpm, 3);
    whirl_case *object =
        parse_edited("kappa, from: 1, to: 20, points: 5, start: state", "kappa, values: [5, 2, 1], start: carry");
    assert_int_equal(study_of(object).batches[0].carry, WHIRL_CARRY_REVERSE); // up, along the parameter
    whirl_case_free(object);
}

static void swept_values_have_the_parameter_s_unit(void **state) {
    (void)state;
    whirl_case *object = parse_edited("kappa, from: 1, to: 20", "omega, from: 600 rpm, to: = 2*omega");
    const whirl_study study = study_of(object);
    assert_true(fabs(study.batches[0].values[0] - 20.0 * pi) < 1e-12);
    assert_true(study.batches[0].values[4] == 200.0);
    whirl_case_free(object);
}

static whirl_carry carry_of(const char *from_to, const char *start) {
    char text[100];
    snprintf(text, sizeof text, "%s, points: 5, %s", from_to, start);
    whirl_case *object = parse_edited("from: 1, to: 20, points: 5, start: state", text);
    const whirl_carry carry = study_of(object).batches[0].carry;
    whirl_case_free(object);
    return carry;
}

static void carry_follows_the_parameter(void **state) {
    (void)state;
    assert_int_equal(carry_of("from: 1, to: 20", "start: carry, direction: up"), WHIRL_CARRY_FORWARD);
    assert_int_equal(carry_of("from: 1, to: 20", "start: carry, direction: down"), WHIRL_CARRY_REVERSE);
    assert_int_equal(carry_of("from: 20, to: 1", "start: carry, direction: up"), WHIRL_CARRY_REVERSE);
    assert_int_equal(carry_of("from: 20, to: 1", "start: carry, direction: down"), WHIRL_CARRY_FORWARD);
    assert_int_equal(carry_of("from: 1, to: 20", "start: carry, direction: both"), WHIRL_CARRY_BOTH);
    assert_int_equal(carry_of("from: 1, to: 20", "start: rest"), WHIRL_CARRY_NONE);
}

/// Computes the state from which the first point of batch `index` starts.
static void start_of(const whirl_case *object, size_t index, double state[8]) {
    const whirl_study study = study_of(object);
    const whirl_batch *batch = &study.batches[index];
    whirl_machine machine;
    const double value = batch->values ? batch->values[0] : NAN;
    assert_int_equal(study.machine(study.family, batch, value, &machine).code, WHIRL_OK);
    assert_int_equal(machine.system->dimension, 8);
    memcpy(state, machine.start, 8 * sizeof *state);
    machine.release(machine.owner);
}

static void starts_are_states(void **state) {
    (void)state;
    const double initial[8] = {0.0, -0.5, 0.1, -0.5, 0.0, 0.0, 0.25, 0.0}, zero[8] = {0.0};
    double start[8];
    whirl_case *object = parse_good(good_case);
    start_of(object, 0, start);
    assert_memory_equal(start, initial, sizeof initial);
    whirl_case_free(object);
    object = parse_edited("start: state", "start: rest");
    start_of(object, 0, start);
    assert_memory_equal(start, zero, sizeof zero);
    whirl_case_free(object);
    object = parse_edited("start: state", "start: carry");
    start_of(object, 0, start);
    assert_memory_equal(start, initial, sizeof initial);
    whirl_case_free(object);
    object = parse_edited("disc: {y: -0.5}", "disc: {y: = -kappa/2}");
    start_of(object, 0, start);
    assert_true(start[1] == -0.5); // kappa is 1 there, not 10
    whirl_case_free(object);
}

/// c is 0.2 mm, omega 100 rad/s: a length scale per radian is 20 mm/s.
static void starts_may_have_units(void **state) {
    const double expected[8] = {0.0, -0.25, 0.1, -0.5, 0.0, 2.0, 0.5, 0.0};
    double start[8];
    (void)state;
    whirl_case *object = parse_edited("{disc: {y: -0.5}, journal: {x: 0.1, y: -0.5, vx: 0.25}}",
                                      "{disc: {y: -50 um, vy: 40 mm/s}, journal: {x: 0.1, y: -0.1 mm, vx: 0.5}}");
    start_of(object, 0, start);
    for (int i = 0; i < 8; i++) assert_true(fabs(start[i] - expected[i]) < 1e-15);
    whirl_case_free(object);
    // A parameter with a unit is one, too, and so are expressions of such parameters.
    char *text = edited(good_case, "c: 0.2 mm", "c: 0.2 mm\n  drop: -25 um");
    char *more = edited(text, "disc: {y: -0.5}", "disc: {x: = 2*0.25, y: = drop}");
    object = parse_good(more);
    start_of(object, 0, start);
    assert_true(start[0] == 0.5 && fabs(start[1] + 0.125) < 1e-15);
    whirl_case_free(object);
    free(more);
    more = edited(text, "disc: {y: -0.5}", "disc: {x: = 3*drop/2, y: = drop/c, vx: = omega*c/4, vy: = 2*0.25}");
    object = parse_good(more);
    start_of(object, 0, start);
    const double measured[4] = {-0.1875, -0.125, 0.25, 0.5};
    for (int i = 0; i < 2; i++) assert_true(fabs(start[i] - measured[i]) < 1e-15);
    for (int i = 2; i < 4; i++) assert_true(fabs(start[2 + i] - measured[i]) < 1e-15);
    whirl_case_free(object);
    free(text);
    free(more);
}

static void details_are_batches_of_their_own(void **state) {
    (void)state;
    const double initial[8] = {0.0, -0.5, 0.1, -0.5, 0.0, 0.0, 0.25, 0.0};
    double start[8];
    char *text = edited(good_case, "start: state", "start: rest");
    char *more = edited(text, "  analyze:", "  detail: {at: [3, = 2*kappa], transient: 40, record: 15}\n  analyze:");
    whirl_case *object = parse_good(more);
    const whirl_study study = study_of(object);
    assert_int_equal(study.batch_count, 2);
    const whirl_batch *detail = &study.batches[1];
    assert_string_equal(detail->name, "detail");
    assert_string_equal(detail->parameter, "kappa");
    assert_int_equal(detail->count, 2);
    assert_true(detail->values[0] == 3.0 && detail->values[1] == 20.0);
    assert_int_equal(detail->carry, WHIRL_CARRY_NONE);
    assert_int_equal(detail->record.transient, 40);
    assert_int_equal(detail->record.record, 15);
    assert_int_equal(detail->record.waveform_revolutions, 15); // 20 by default, but not more than the record
    assert_true(detail->record.spectra);
    whirl_analysis_set waveform = 0;
    whirl_analysis_add(&waveform, "waveform");
    assert_int_equal(detail->analyses, study.batches[0].analyses | waveform);
    start_of(object, 1, start);
    assert_memory_equal(start, initial, sizeof initial);
    whirl_case_free(object);
    free(text);
    free(more);
}

static void responses_are_single_points(void **state) {
    (void)state;
    whirl_case *object =
        parse_edited("sweep: {parameter: kappa, from: 1, to: 20, points: 5, start: state}", "response:");
    const whirl_study study = study_of(object);
    assert_int_equal(study.batch_count, 1);
    assert_string_equal(study.batches[0].name, "response");
    assert_string_equal(study.batches[0].parameter, "");
    assert_int_equal(study.batches[0].count, 1);
    assert_null(study.batches[0].values);
    assert_true(study.batches[0].record.spectra);
    whirl_case_free(object);
}

static void absent_parts_have_the_defaults_of_the_layers(void **state) {
    (void)state;
    char *text = edited(good_case, "  integrate: {steps_per_revolution: 64, transient: 20, record: 10}\n", "");
    char *less = edited(text, "  analyze: [poincare, regime, spectrum]\n", "");
    whirl_case *object = parse_good(less);
    const whirl_batch batch = study_of(object).batches[0];
    const whirl_integrate_options integrate = whirl_integrate_default();
    const whirl_record_options record = whirl_record_default();
    assert_string_equal(batch.integrate.method, "auto");
    assert_int_equal(batch.integrate.steps_per_revolution, integrate.steps_per_revolution);
    assert_true(batch.integrate.rtol == integrate.rtol);
    assert_true(batch.integrate.atol == integrate.atol);
    assert_true(batch.integrate.limit == integrate.limit);
    assert_int_equal(batch.record.transient, record.transient);
    assert_int_equal(batch.record.record, record.record);
    assert_int_equal(batch.record.watch, record.watch);
    assert_int_equal(batch.record.waveform_revolutions, record.waveform_revolutions);
    assert_int_equal(batch.record.samples_per_revolution, record.samples_per_revolution);
    assert_true(batch.record.highest_order == record.highest_order);
    whirl_analysis_set all = 0, asked_for = 0;
    for (const whirl_analysis *analysis = whirl_analyses(); analysis->name; analysis++)
        whirl_analysis_add(&all, analysis->name);
    whirl_analysis_add(&asked_for, "waveform");
    whirl_analysis_add(&asked_for, "exponents");
    whirl_analysis_add(&asked_for, "evidence");
    whirl_analysis_add(&asked_for, "floquet");
    for (const whirl_analysis *analysis = whirl_analyses(); analysis->name; analysis++)
        if (!analysis->kind->moves) whirl_analysis_add(&asked_for, analysis->name);
    assert_int_equal(batch.analyses, all & ~asked_for);
    whirl_case_free(object);
    free(text);
    free(less);
}

static void elements_have_short_forms(void **state) {
    (void)state;
    whirl_case_free(parse_edited("- gravity: 9.81 m/s2", "- gravity"));
    whirl_case_free(parse_edited("- gravity: 9.81 m/s2", "- gravity:"));
    whirl_case_free(parse_edited("- gravity: 9.81 m/s2", "- gravity: {acceleration: 9.81 m/s2}"));
    whirl_case_free(parse_edited("[disc, journal]", "\"disc,journal\""));
    whirl_case_free(parse_edited("[disc, journal]", "[disc, ground]"));
}

// ---------------------------------------------------------------- results

static void results_know_their_case(void **state) {
    (void)state;
    whirl_case *object = parse_edited("kappa: 10", "kappa: 10\n  k: = 2*kappa");
    assert_int_equal(whirl_case_set(object, "omega=6000 rpm").code, WHIRL_OK);
    whirl_result *result = calloc(1, sizeof *result);
    assert_non_null(result);
    assert_int_equal(whirl_case_describe_result(object, result).code, WHIRL_OK);
    assert_string_equal(result->title, "A rotor");
    assert_string_equal(result->case_name, "t.yaml");
    assert_non_null(strstr(result->case_text, "omega: 100 rad/s"));
    assert_true(fabs(result->speed - 200.0 * pi) < 1e-11);
    assert_int_equal(result->parameter_count, 4);
    assert_string_equal(result->parameters[0].name, "omega");
    assert_string_equal(result->parameters[0].unit, "rad/s");
    assert_string_equal(result->parameters[0].text, "6000 rpm");
    assert_true(result->parameters[0].value == result->speed);
    assert_string_equal(result->parameters[1].unit, "1");
    assert_string_equal(result->parameters[2].unit, "SI");
    assert_true(result->parameters[2].value == 20.0);
    assert_string_equal(result->parameters[3].unit, "m");
    assert_int_equal(result->station_count, 2);
    assert_string_equal(result->stations[1].name, "journal");
    assert_true(fabs(result->stations[1].clearance - 1.0) < 1e-14);
    assert_int_equal(result->contact_count, 1);
    assert_string_equal(result->contacts[0], "rub at disc");
    whirl_result_free(result);
    whirl_case_free(object);
}

static void a_case_runs(void **state) {
    (void)state;
    whirl_case *object = parse_good(good_case);
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    assert_int_equal(whirl_case_run(object, &options, &result).code, WHIRL_OK);
    const whirl_table *table = whirl_result_table(result, "sweep");
    assert_non_null(table);
    assert_int_equal(table->count, 5);
    assert_true(table->values[4] == 20.0);
    assert_string_equal(result->title, "A rotor");
    whirl_result_free(result);
    whirl_case_free(object);
}

/// A bearing with a table of coefficients has the numbers of the table, in the units that are written there.
static void lists_are_in_si(void **state) {
    static const char *const lines[] = {
        "- bearing: {at: disc, speeds: [600 rpm, 100 rad/s, 2000 rpm], kxx: [1 kN/m, 3 kN/m, 9 MN/m], cxx: 7 N s/m}",
        "- bearing: {at: disc, kxx: 3 kN/m, kyy: 3000, cxx: 7 N s/m}"};
    double slopes[2][8];
    (void)state;
    for (int i = 0; i < 2; i++) {
        static const double start[8] = {1.0, 2.0, 0.1, 0.2, 3.0, 4.0, 0.3, 0.4};
        double forcing[WHIRL_MAX_FORCING];
        whirl_case *object = parse_edited("- gravity: 9.81 m/s2", lines[i]);
        whirl_rotor *rotor;
        assert_int_equal(whirl_case_rotor(object, NULL, 0.0, &rotor).code, WHIRL_OK);
        const whirl_system *system = whirl_rotor_system(rotor);
        system->forcing(system->model, 0.5, forcing);
        system->rhs(system->model, 0.5, forcing, start, slopes[i]);
        whirl_rotor_free(rotor);
        whirl_case_free(object);
    }
    for (int i = 0; i < 8; i++) assert_true(fabs(slopes[0][i] - slopes[1][i]) <= 1e-13 * fabs(slopes[1][i]));
}

/// Computes the slope of the case's rotor at one state, with a parameter at a value (NULL: the case's value).
static void slope_of(const whirl_case *object, const char *name, double value, double slope[8]) {
    const double x[8] = {1.2, -0.9, 0.2, -0.4, 0.01, 0.02, 0.03, 0.04}; // in contact
    double forcing[WHIRL_MAX_FORCING];
    whirl_rotor *rotor;
    assert_int_equal(whirl_case_rotor(object, name, value, &rotor).code, WHIRL_OK);
    const whirl_system *system = whirl_rotor_system(rotor);
    assert_int_equal(system->dimension, 8);
    system->forcing(system->model, 0.3, forcing);
    system->rhs(system->model, 0.3, forcing, x, slope);
    whirl_rotor_free(rotor);
}

/// Expressions that do not depend on a family's parameter are not evaluated again. Each machine is that of the case
/// with the parameter set, to the bit, for every chain of expressions.
static void machines_of_families_are_those_of_set_cases(void **state) {
    static const struct {
        const char *name, *setting;
        double value;
    } all[] = {{"omega", "omega=120 rad/s", 120.0},
               {"kappa", "kappa=7", 7.0},
               {"c", "c=0.3e-3 m", 0.3e-3},
               {"half", "half=0.4", 0.4},
               {"twice", "twice=3", 3.0}};
    (void)state;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        char *text = edited(good_case, "kappa: 10\n",
                            "half: = 0.5 + kappa/20\n  kappa: 10\n  twice: = 2\n  stiff: = kappa*twice / half*omega\n");
        char *whole = edited(text, "kappa*1e6", "stiff");
        whirl_case *family = parse_good(whole), *set = parse_good(whole);
        double one[8], other[8], before[8];
        slope_of(family, NULL, 0.0, before);
        slope_of(family, all[i].name, all[i].value, one);
        assert_int_equal(whirl_case_assign(set, all[i].setting).code, WHIRL_OK);
        slope_of(set, NULL, 0.0, other);
        assert_memory_equal(one, other, sizeof one);
        assert_memory_not_equal(one, before, sizeof one);
        slope_of(family, NULL, 0.0, other);
        assert_memory_equal(other, before, sizeof one);
        whirl_case_free(family);
        whirl_case_free(set);
        free(whole);
        free(text);
    }
}

/// Products and quotients of names need no parser; brackets do.
static void products_are_as_the_parser_has_them(void **state) {
    (void)state;
    expect_parameter("= omega * kappa / c", 100.0 * 10.0 / 0.2e-3);
    whirl_case *object =
        parse_edited("kappa: 10", "kappa: 10\n  p: = omega/kappa*c/omega\n  q: = (omega/kappa*c/omega)");
    assert_true(value_of(object, "p") == value_of(object, "q"));
    whirl_case_free(object);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimal_units_are_exact),
        cmocka_unit_test(quantities_are_in_si),
        cmocka_unit_test(units_of_us_practice),
        cmocka_unit_test(expressions_are_in_si),
        cmocka_unit_test(rotors_follow_the_parameters),
        cmocka_unit_test(elements_stand_alone),
        cmocka_unit_test(parameters_are_set),
        cmocka_unit_test(set_numbers_keep_their_unit),
        cmocka_unit_test(wrong_settings_leave_the_case_as_it_was),
        cmocka_unit_test(a_swept_parameter_can_be_assigned),
        cmocka_unit_test(keys_are_set_in_the_text),
        cmocka_unit_test(wrong_keys_leave_the_case_as_it_was),
        cmocka_unit_test(sweeps_are_equally_spaced),
        cmocka_unit_test(sweeps_have_steps_ratios_or_lists),
        cmocka_unit_test(swept_values_have_the_parameter_s_unit),
        cmocka_unit_test(carry_follows_the_parameter),
        cmocka_unit_test(starts_are_states),
        cmocka_unit_test(starts_may_have_units),
        cmocka_unit_test(details_are_batches_of_their_own),
        cmocka_unit_test(responses_are_single_points),
        cmocka_unit_test(absent_parts_have_the_defaults_of_the_layers),
        cmocka_unit_test(elements_have_short_forms),
        cmocka_unit_test(results_know_their_case),
        cmocka_unit_test(a_case_runs),
        cmocka_unit_test(lists_are_in_si),
        cmocka_unit_test(machines_of_families_are_those_of_set_cases),
        cmocka_unit_test(products_are_as_the_parser_has_them),
    };
    return cmocka_run_group_tests_name("values", tests, NULL, NULL);
}
