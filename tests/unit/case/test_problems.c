// Everything that can be wrong with a case: one edit of a good case, one problem with its place.
#include "case_support.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "whirl/engine/analyze.h"

#define NAME_OF(name, ...) #name,

static void numbers(void **state) {
    (void)state;
    expect_problem(
        "kappa: 10", "kappa: 2x",
        "t:5:10: parameters.kappa: is 2x, expected a number, or a number and a unit, with a space before the unit");
    expect_problem("kappa: 10", "kappa: nan",
                   "t:5:10: parameters.kappa: is nan, expected a number, or a number and a unit");
    expect_problem("kappa: 10", "kappa: -inf",
                   "t:5:10: parameters.kappa: is -inf, expected a number, or a number and a unit");
    expect_problem("kappa: 10", "kappa: 1e999", "t:5:10: parameters.kappa: is 1e999, too large for a number");
    expect_problem(
        "kappa: 10", "kappa: 0x10",
        "t:5:10: parameters.kappa: is 0x10, expected a number, or a number and a unit, with a space before the unit");
    expect_problem("kappa: 10",
                   "kappa:", "t:5:3: parameters.kappa: is empty, expected a number, a quantity or an expression");
    expect_problem("kappa: 10", "kappa: [10]",
                   "t:5:3: parameters.kappa: is a list, expected a number, a quantity or an expression");
    expect_problem("mass: 4 kg", "mass: -3 kg",
                   "t:11:18: rotor.stations.disc.mass: is -3 kg, expected a number above 0 kg");
    expect_problem("mass: 4 kg", "mass: = -kappa",
                   "t:11:18: rotor.stations.disc.mass: = -kappa is -10 kg, expected a number above 0 kg");
    expect_problem("omega: 100 rad/s", "omega: 0 rad/s",
                   "t:8:10: rotor.speed: = omega is 0 rad/s, expected a number above 0 rad/s");
    expect_problem("points: 5", "points: 2.5",
                   "t:19:54: study.sweep.points: is 2.5, expected a whole number from 1 to 10000000");
    expect_problem("points: 5", "points: 0",
                   "t:19:54: study.sweep.points: is 0, expected a whole number from 1 to 10000000");
    expect_problem("points: 5", "points: 10000001",
                   "t:19:54: study.sweep.points: is 10000001, expected a whole number from 1 to 10000000");
}

static void sweeps(void **state) {
    static const char old[] = "from: 1, to: 20, points: 5";
    (void)state;
    expect_problem(old, "from: 1, to: 20",
                   "t:19:3: study.sweep.points: is missing, expected the number of values, or step");
    expect_problem("from: 1, to: 20, points: 5, start: state", "start: rest",
                   "t:19:3: study.sweep: has no values, expected from, to and points, or values: [...]");
    expect_problem(old, "from: 1, points: 5",
                   "t:19:3: study.sweep.to: is missing, expected last value of the parameter, or values: [...]");
    expect_problem(old, "from: 1, to: 20, pionts: 5",
                   "t:19:46: study.sweep.pionts: sweep has no key pionts, did you mean points?");
    expect_problem(old, "from: 1, to: 20, points: 5, step: 1",
                   "t:19:57: study.sweep.step: is given together with points, expected one of the two");
    expect_problem(old, "from: 1, to: 20, step: 0", "t:19:52: study.sweep.step: is 0, expected a distance above 0");
    expect_problem(old, "from: 1, to: 20, step: 1e-9",
                   "t:19:52: study.sweep.step: gives 1.9e+10 values, expected at most 10000000");
    expect_problem(old, "from: 1, to: 20, step: 1 mm", "t:19:52: study.sweep.step: is in mm, expected a plain number");
    expect_problem(old, "from: 1, to: 20, step: 1, scale: log",
                   "t:19:46: study.sweep.step: has no meaning with scale: log, expected points");
    expect_problem(old, "from: 0, to: 20, points: 3, scale: log",
                   "t:19:64: study.sweep.scale: is log from 0 to 20, expected two ends above 0 or two below");
    expect_problem(old, "values: []",
                   "t:19:29: study.sweep.values: is an empty list, expected a list of 1 to 10000000 values");
    expect_problem(old, "values: 3", "t:19:37: study.sweep.values: is 3, expected a list of 1 to 10000000 values");
    expect_problem(old, "values: [3, 4], points: 2",
                   "t:19:45: study.sweep.points: is given together with values, expected one of the two");
    expect_problem(old, "values: [3, 4, 2]",
                   "t:19:44: study.sweep.values[3]: is 2 after 4, expected values that rise or fall throughout");
    expect_problem(old, "values: [3, 3]",
                   "t:19:41: study.sweep.values[2]: is 3 after 3, expected values that rise or fall throughout");
    expect_problem(old, "values: [3, 4 mm]", "t:19:41: study.sweep.values[2]: is in mm, expected a plain number");
    expect_problem(old, "values: [-3, 3]",
                   "t:19:38: study.sweep.values[1]: gives no machine at kappa = -3: rub.stiffness is -3000000 N/m, "
                   "expected a number of at least 0 N/m");
}

static void starts(void **state) {
    (void)state;
    expect_problem("journal: {x: 0.1, y: -0.5, vx: 0.25}", "journal: {x: 0.6, y: -0.8}",
                   "t:20:30: study.initial.journal: starts 1 clearances from the centre of its bearing, expected less "
                   "than 1");
    expect_problem("journal: {x: 0.1, y: -0.5, vx: 0.25}", "journal: {x: 0.3 mm}",
                   "t:20:30: study.initial.journal: starts 1.5 clearances from the centre of its bearing, expected "
                   "less than 1");
    expect_problem("disc: {y: -0.5}", "disc: {y: 0.1 kg}",
                   "t:20:23: study.initial.disc.y: is in kg, expected a unit of m");
    expect_problem("disc: {y: -0.5}", "disc: {vy: = omega}",
                   "t:20:24: study.initial.disc.vy: = omega is in rad/s, expected a unit of m/s");
    expect_problem("disc: {y: -0.5}", "disc: {y: = c + 1}",
                   "t:20:23: study.initial.disc.y: = c + 1 is neither in m nor a plain number");
    expect_problem("disc: {y: -0.5}", "disc: {vy: = 2*c}",
                   "t:20:24: study.initial.disc.vy: = 2*c is neither in m/s nor a plain number");
    expect_problem("journal: {x: 0.1, y: -0.5, vx: 0.25}", "journal: {x: = -1.5*c}",
                   "t:20:30: study.initial.journal: starts 1.5 clearances from the centre of its bearing, expected "
                   "less than 1");
    // If every point starts from the equilibrium the initial state has no effect, until a detail starts from it.
    char *text = edited(good_case, "start: state", "start: rest");
    char *more = edited(text, "x: 0.1, y: -0.5, vx", "x: 1.1, y: -0.5, vx");
    whirl_case_free(parse_good(more));
    free(text);
    text = edited(more, "  analyze:", "  detail: {at: [3, 4]}\n  analyze:");
    expect_bytes_problem(text, strlen(text),
                         "t:20:30: study.initial.journal: starts 1.208 clearances from the centre of its bearing, "
                         "expected less than 1");
    free(text);
    free(more);
}

static void units(void **state) {
    (void)state;
    expect_problem("damping: 20 N.s/m", "damping: 20 kg",
                   "t:11:33: rotor.stations.disc.damping: is in kg, expected a unit of N s/m");
    expect_problem("mass: 4 kg", "mass: 4 klg",
                   "t:11:18: rotor.stations.disc.mass: is 4 klg, expected a number in kg (no unit is called klg)");
    expect_problem("friction: 0.1", "friction: 0.1 mm",
                   "t:16:71: rotor.elements[3].rub.friction: is in mm, expected a plain number");
    expect_problem("speed: = omega", "speed: 50 Hz",
                   "t:8:10: rotor.speed: is in Hz, expected a unit of rad/s, such as rpm (1 Hz = 60 rpm)");
    expect_problem("omega: 100 rad/s", "omega: 50 Hz",
                   "t:8:10: rotor.speed: = omega is in 1/s, expected a unit of rad/s, such as rpm (1 Hz = 60 rpm)");
    expect_problem("length_scale: = c", "length_scale: = omega",
                   "t:9:17: rotor.length_scale: = omega is in rad/s, expected a unit of m");
    // Capitals and products as engineers write them.
    expect_problem(
        "omega: 100 rad/s", "omega: 6000 RPM",
        "t:4:10: parameters.omega: is 6000 RPM, expected a number, or a number and a unit (no unit is called "
        "RPM, did you mean rpm?)");
    expect_problem("damping: 20 N.s/m", "damping: 20 Ns/m",
                   "t:11:33: rotor.stations.disc.damping: is 20 Ns/m, expected a number in N s/m (no unit is called "
                   "Ns/m, did you mean N.s/m?)");
    // Reciprocals are no units of the same kind.
    expect_problem("damping: 20 N.s/m", "damping: 20 m/(N.s)",
                   "t:11:33: rotor.stations.disc.damping: is in m/(N.s), expected a unit of N s/m");
    expect_problem("kappa, from: 1,", "kappa, from: 1 mm,",
                   "t:19:35: study.sweep.from: is in mm, expected a plain number");
}

/// Returns the good case with these parameters, this gap of the rub, and a sweep of `wide` over these values.
static char *swept_case(const char *parameters, const char *gap, const char *values) {
    char sweep[128];
    snprintf(sweep, sizeof sweep, "parameter: wide, %s, points", values);
    char *one = edited(good_case, "  kappa: 10\n", parameters), *two = edited(one, "gap: = 1.2*c", gap);
    char *three = edited(two, "parameter: kappa, from: 1, to: 20, points", sweep);
    free(one);
    free(two);
    return three;
}

/// A parameter that is an expression has the unit of the key that takes it, directly or by way of other parameters.
static void units_of_sweeps(void **state) {
    (void)state;
    static const struct {
        const char *parameters, *gap, *values, *problem; ///< NULL: none
    } rows[] = {
        {"  kappa: 10\n  wide: = 1.2*c\n", "gap: = wide", "from: 100 kg, to: 0.3 mm",
         "t:20:34: study.sweep.from: is in kg, expected a unit of m"},
        {"  kappa: 10\n  wide: = 1.2*c\n", "gap: = wide", "from: 0.2 mm, to: 200 kg",
         "t:20:46: study.sweep.to: is in kg, expected a unit of m"},
        {"  kappa: 10\n  gap: = wide\n  wide: = 1.2*c\n", "gap: = gap", "from: 0.2 mm, to: 200 kg",
         "t:21:46: study.sweep.to: is in kg, expected a unit of m"},
        {"  kappa: 10\n  wide: = 1.2*c\n", "gap: = 1*wide", "from: 0.2 mm, to: 200 kg", // its unit is not known, but
         "t:20:46: study.sweep.to: is in kg, expected a unit of m"},                    // it is one unit
        {"  kappa: 10\n  wide: = 1.2*c\n", "gap: = wide", "from: 0.2 mm, to: 3e-4", NULL},
        {"  kappa: 10\n  wide: = 1.2*c\n", "gap: = 1*wide", "from: 2e-4, to: 0.3 mm", NULL},
        {"  kappa: 10\n  gap: = wide\n  wide: = 1.2*c\n", "gap: = gap", "from: = c, to: = 2*c", NULL},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *text = swept_case(rows[i].parameters, rows[i].gap, rows[i].values);
        if (rows[i].problem)
            expect_bytes_problem(text, strlen(text), rows[i].problem);
        else
            whirl_case_free(parse_good(text));
        free(text);
    }
}

/// The record has everything that the chosen analyses need.
static void single_analyses(void **state) {
    (void)state;
    for (const whirl_analysis *a = whirl_analyses(); a->name; a++) {
        char list[64];
        if (strcmp(a->name, "waveform") == 0) continue; // at least one revolution must be recorded
        if (!a->kind->moves) continue;                  // a study, or a part of it, of its own
        snprintf(list, sizeof list, "analyze: [%s]", a->name);
        whirl_case_free(parse_edited("analyze: [poincare, regime, spectrum]", list));
    }
}

static void angles(void **state) {
    (void)state;
    static const char advice[] = "without a unit, which is in radians, expected at most a full turn (2 pi); write "
                                 "degrees as";
    char expected[400];
    snprintf(expected, sizeof expected, "t:17:28: rotor.elements[4].gravity.direction: is 270 %s '270 degree'", advice);
    expect_problem("gravity: 9.81 m/s2", "gravity: {direction: 270}", expected);
    snprintf(expected, sizeof expected,
             "t:12:47: rotor.stations.journal.eccentricity_angle: = -3*kappa is -30 %s '-30 degree'", advice);
    expect_problem("{mass: 2 kg}", "{mass: 2 kg, eccentricity_angle: = -3*kappa}", expected);
    static const char *const good[] = {"270 degree", "-450 deg", "4.71", "-6.2831853071795865", "9 rad", "= 6*pi/4"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        char gravity[80];
        snprintf(gravity, sizeof gravity, "gravity: {direction: %s}", good[i]);
        whirl_case_free(parse_edited("gravity: 9.81 m/s2", gravity));
    }
}

static void names(void **state) {
    (void)state;
    expect_problem("damping:", "dampnig:",
                   "t:11:24: rotor.stations.disc.dampnig: station has no key dampnig, did you mean damping?");
    expect_problem("mass: 4 kg, ", "",
                   "t:7:1: rotor: station 'disc' has no mass, expected its key mass or an element that brings one");
    expect_problem(
        "- shaft:", "- shatf:", "t:14:7: rotor.elements[1].shatf: no element is called shatf, did you mean shaft?");
    expect_problem("at: disc", "at: dusc",
                   "t:16:17: rotor.elements[3].rub.at: is dusc, which is no station, did you mean disc?");
    expect_problem("at: disc", "at: ground",
                   "t:16:17: rotor.elements[3].rub.at: is ground, which is no station, expected one of disc, journal");
    expect_problem(
        "[disc, journal]", "[disc, jornal]",
        "t:14:31: rotor.elements[1].shaft.between[2]: is jornal, which is no station, did you mean journal?");
    expect_problem("[disc, journal]", "\"disc, jornal\"",
                   "t:14:24: rotor.elements[1].shaft.between: is jornal, which is no station, did you mean journal?");
    expect_problem("[disc, journal]", "[disc]",
                   "t:14:15: rotor.elements[1].shaft.between: is a list, expected two stations: [one, other]");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, speeds: [5 rpm, 9 kg], kxx: [1 N/m, 2 N/m]}",
                   "t:17:43: rotor.elements[4].bearing.speeds[2]: is in kg, expected a unit of rad/s");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, speeds: [5, 900], kxx: [1 N/m, = kapa]}",
                   "t:17:58: rotor.elements[4].bearing.kxx[2]: is = kapa, but no parameter is called kapa, did you "
                   "mean kappa?");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, speeds: [5, 90], kxx: [1 N/m, 2 N/m]}",
                   "t:17:7: rotor.elements[4].bearing: bearing is known from 5 to 90 rad/s (47.7465 to 859.437 rpm), "
                   "and the rotor turns at 100 rad/s (954.93 rpm)");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, kxx: []}",
                   "t:17:27: rotor.elements[4].bearing.kxx: has 0 numbers, expected 1 to 32");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, frequencies: [5, 90], kxx: [[1, 2], [3]]}",
                   "t:17:63: rotor.elements[4].bearing.kxx[2]: has 1 numbers, expected 2 as the first list has");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, frequencies: [5, 90], kxx: [[1, 2], 3]}",
                   "t:17:63: rotor.elements[4].bearing.kxx[2]: is 3, expected a list as the one before");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, frequencies: [5, 90], kxx: [1 N/m, 2 N/m]}",
                   "t:19:3: study.sweep: bearing is known at frequencies of whirl from 5 to 90 rad/s, and the rotor "
                   "turns at 100 rad/s, which is the frequency of synchronous motions");
    expect_problem(
        "- gravity: 9.81 m/s2", "- bearing: {at: disc, frequencies: [5, 500], kxx: [1 N/m, 2 N/m]}",
        "t:19:3: study.sweep: bearing differs from its table by 40 % at 500 rad/s with the rational function of 0 "
        "poles that replaces the table in motions, expected at most fit_error, 2 %: more poles, closer "
        "frequencies or a larger fit_error");
    expect_problem("- gravity: 9.81 m/s2", "- bearing: {at: disc, kxx: 1 N/m, poles: 3}",
                   "t:17:7: rotor.elements[4].bearing: bearing has 3 poles, expected an even number");
    expect_problem("load: 200 N", "load: [200 N]",
                   "t:15:43: rotor.elements[2].film.load: is a list, expected a number");
    expect_problem("parameter: kappa", "parameter: kapa",
                   "t:19:22: study.sweep.parameter: is kapa, which is no parameter, did you mean kappa?");
    expect_problem(
        "initial: {disc:", "initial: {disk:", "t:20:13: study.initial.disk: is no station, did you mean disc?");
    expect_problem("start: state", "start: stat", "t:19:64: study.sweep.start: is stat, did you mean state?");
    expect_problem("regime", "regimes",
                   "t:22:23: study.analyze[2]: is regimes, which is no analysis, did you mean regime?");
    expect_problem(
        "kappa: 10", "kap-pa: 10\n  kappa: 10",
        "t:5:3: parameters.kap-pa: is no name for a parameter, expected a letter, then letters, digits and '_'");
    expect_problem("kappa: 10", "sqrt: 2\n  kappa: 10",
                   "t:5:3: parameters.sqrt: sqrt is a function or constant of expressions, expected another name");
    expect_problem("journal: {mass: 2 kg}", "journal: {mass: 2 kg}\n    ground: {mass: 1}",
                   "t:13:5: rotor.stations.ground: is the name of the ground, expected another name");
}

static void expressions(void **state) {
    (void)state;
    expect_problem("= kappa*1e6", "= kapa*1e6",
                   "t:16:48: rotor.elements[3].rub.stiffness: is = kapa*1e6, but no parameter is called kapa, did you "
                   "mean kappa?");
    expect_problem("kappa: 10", "kappa: = 2*b\n  b: = omega + kappa",
                   "t:5:10: parameters.kappa: depends on itself: kappa -> b -> kappa");
    expect_problem("kappa: 10", "kappa: = kappa", "t:5:10: parameters.kappa: depends on itself: kappa -> kappa");
    expect_problem("kappa: 10", "kappa: = 1/0",
                   "t:5:10: parameters.kappa: = 1/0 is infinite, expected a finite number");
    expect_problem("kappa: 10", "kappa: = sqrt(-1)",
                   "t:5:10: parameters.kappa: = sqrt(-1) is not a number, expected a finite number");
    expect_problem("kappa: 10", "kappa: = 2*(omega", "t:5:10: parameters.kappa: is no expression: a ')' is missing");
    expect_problem("kappa: 10", "kappa: = omega)",
                   "t:5:10: parameters.kappa: is no expression at ')', expected as many '(' as ')'");
    expect_problem("kappa: 10", "kappa: = 2x", "t:5:10: parameters.kappa: is no expression at '2x', expected a number");
    expect_problem("kappa: 10", "kappa: = 1 +",
                   "t:5:10: parameters.kappa: is no expression: it ends too early, or an argument is missing");
    expect_problem("kappa: 10", "kappa: = 1,5",
                   "t:5:10: parameters.kappa: is no expression at ',5', expected one number (decimals have a point)");
    expect_problem("kappa: 10", "kappa: = (1,5)",
                   "t:5:10: parameters.kappa: is no expression at ',5)', expected one number (decimals have a point)");
    expect_problem("kappa: 10", "kappa: = omega = 3",
                   "t:5:10: parameters.kappa: is no expression at '= 3', expected no assignment (== compares)");
    expect_problem("kappa: 10", "kappa: = 'a'", "t:5:10: parameters.kappa: is no expression at ''a''");
    expect_problem("kappa: 10", "kappa: = \"a\"", "t:5:10: parameters.kappa: is no expression at '\"a\"'");
    expect_problem("kappa: 10",
                   "kappa: =", "t:5:10: parameters.kappa: is an empty expression, expected '= ' and a formula");
    expect_problem("kappa: 10", "kappa: = 10 N",
                   "t:5:10: parameters.kappa: is = 10 N, but no parameter is called N (expressions are in SI and hold "
                   "no units)");
    expect_problem("kappa: 10", "kappa: = sin(omega, 2)",
                   "t:5:10: parameters.kappa: is = sin(omega, 2), where a function has too many arguments");
    expect_problem("kappa: 10", "kappa: = atan2(2)",
                   "t:5:10: parameters.kappa: is = atan2(2), where a function has too few arguments");
    expect_problem("kappa: 10", "kappa: = omega omega", "t:5:10: parameters.kappa: is no expression at 'omega'");
    char deep[200] = "kappa: = ", message[200], longer[700] = "kappa: = 1";
    for (int i = 0; i < 51; i++) strcat(deep, "(");
    expect_problem("kappa: 10", deep, "t:5:10: parameters.kappa: is nested deeper than 50 parentheses");
    for (int i = 0; i < 250; i++) strcat(longer, "+1");
    snprintf(message, sizeof message,
             "t:5:10: parameters.kappa: is an expression of %d characters, expected at most 500", 501);
    expect_problem("kappa: 10", longer, message);
}

static void structure(void **state) {
    (void)state;
    expect_problem("kappa: 10", "kappa: 10\n  kappa: 11",
                   "t:6:3: parameters.kappa: is a second key of that name, the first is in line 5");
    expect_problem("whirl: 1", "whirl: 2",
                   "t:1:8: whirl: is 2, expected 1, the version of the format that this whirl reads");
    expect_problem("whirl: 1\n", "", "t:1:1: whirl: is missing, expected version of the format, 1");
    expect_problem("title: A rotor", "title: [a]", "t:2:1: title: is a list, expected a text");
    expect_problem("{mass: 2 kg}", "[2 kg]",
                   "t:12:5: rotor.stations.journal: is a list, expected a mapping with the keys of station");
    expect_problem("analyze: [poincare, regime, spectrum]", "analyze: poincare",
                   "t:22:12: study.analyze: is poincare, expected a list of analyses: [poincare, regime]");
    expect_problem("start: state", "direction: up",
                   "t:19:57: study.sweep.direction: has a meaning only with start: carry");
    expect_problem("analyze: [poincare, regime, spectrum]", "analyze: [modes]",
                   "t:22:13: study.analyze[1]: is modes, which is a study of its own, expected modes: {...} in place "
                   "of response or sweep, or in addition");
    expect_problem("  sweep: {", "  modes: [{}, {}]\n  sweep: {",
                   "t:19:15: study.modes[2]: is another modes of the same name, expected a name of its own: {name: "
                   "..., ...}");
    expect_problem("  sweep: {", "  modes: []\n  sweep: {",
                   "t:19:3: study.modes: is an empty list, expected one study or a list of some");
    expect_problem("  sweep: {", "  modes: {name: a-b}\n  sweep: {",
                   "t:19:17: study.modes.name: is a-b, expected at most 21 letters, digits and '_'");
    expect_problem("  sweep: {", "  conditions: {a: {}}\n  sweep: {",
                   "t:19:3: study.conditions: needs a study of machines at rest or motions, which is done at each");
    expect_problem("  sweep: {", "  motions: {unbalance: first}\n  sweep: {",
                   "t:19:24: study.motions.unbalance: is first, which is no study of unbalance here, expected one "
                   "in the same study");
    expect_problem("  sweep: {", "  unbalance: {name: fast}\n  motions: {unbalance: fest}\n  sweep: {",
                   "t:20:24: study.motions.unbalance: is fest, which is no study of unbalance here, did you mean "
                   "fast?");
    expect_problem("  sweep: {", "  unbalance: {}\n  motions: {unbalance: unbalance}\n  sweep: {",
                   "t:20:24: study.motions.unbalance: is unbalance, which has no unbalances by rule, expected one "
                   "with antinodes_of or at");
    expect_problem("  sweep: {", "  motions: {factor: 6}\n  sweep: {",
                   "t:19:13: study.motions.factor: needs unbalance, the study whose unbalances it multiplies");
    expect_problem("  sweep: {", "  modes: {}\n  conditions: {a: {kapa: 2}}\n  sweep: {",
                   "t:20:20: study.conditions.a.kapa: is no parameter, did you mean kappa?");
    expect_problem("  sweep: {",
                   "  modes: {parameter: kappa, values: [1, 2]}\n  conditions: {a: {kappa: 2}}\n  sweep: {",
                   "t:20:20: study.conditions.a.kappa: is the varied parameter of modes, expected another one");
    expect_problem("  sweep: {", "  modes: {}\n  conditions: [a]\n  sweep: {",
                   "t:20:3: study.conditions: is a list, expected 1 to 8 names of conditions with values of "
                   "parameters");
    expect_problem("  sweep: {", "  response: {}\n  sweep: {",
                   "t:19:3: study.response: is given together with sweep, expected one of the two");
    // All studies at rest are named, the last one after "and".
    static const char *const at_rest[] = {WHIRL_STUDIES_AT_REST(NAME_OF)};
    enum { AT_REST = sizeof at_rest / sizeof *at_rest };
    char none[512] = "t:18:1: study: has none of response, sweep, map, basin, dataset, branch";
    for (size_t i = 0; i < AT_REST; i++)
        snprintf(none + strlen(none), sizeof none - strlen(none), "%s%s", i + 1 < AT_REST ? ", " : " and ", at_rest[i]);
    snprintf(none + strlen(none), sizeof none - strlen(none), ", expected one of them");
    expect_problem("  sweep: {parameter: kappa, from: 1, to: 20, points: 5, start: state}\n", "", none);
    expect_problem("  sweep: {parameter: kappa, from: 1, to: 20, points: 5, start: state}\n",
                   "  response:\n  detail: {at: [1]}\n",
                   "t:20:3: study.detail: needs a sweep, whose parameter it gives values to");
    expect_problem("- gravity: 9.81 m/s2", "- shaft: 3",
                   "t:17:14: rotor.elements[4].shaft: is 3, expected a mapping with the keys of shaft");
    expect_problem(
        "load: 200 N", "load: 200 N, radius: 3 mm",
        "t:15:7: rotor.elements[2].film: film has both load and viscosity, radius or length, expected one way");
    expect_problem("spectrum]", "spectrum, waveform]",
                   "t:22:41: study.analyze[4]: is waveform, but no waveform is kept, expected keep: {waveform: ...}");
    expect_problem("record: 10}", "record: 10, watch: 31}",
                   "t:21:75: study.integrate.watch: is 31, expected 0, or record (10) to transient + record (30)");
    expect_problem("  analyze:", "  keep: {waveform: 11}\n  analyze:",
                   "t:22:20: study.keep.waveform: is 11, expected at most the revolutions of the record (10)");
    expect_problem("  analyze:", "  keep: {samples: 16, highest_order: 8.5}\n  analyze:",
                   "t:22:38: study.keep.highest_order: is 8.5, expected at most 8, half the samples per revolution "
                   "(keep.samples)");
    whirl_case_free(parse_edited("  analyze:", "  keep: {samples: 16, highest_order: 8}\n  analyze:"));
    expect_problem("friction: 0.1", "slip_speed: 1, law: paper",
                   "t:16:7: rotor.elements[3].rub: rub has a slip_speed, which only law slip uses, expected law: slip, "
                   "or no slip_speed");
    expect_problem("  analyze:", "  keep: {samples: 65}\n  analyze:",
                   "t:22:19: study.keep.samples: is 65, expected at most steps_per_revolution (64)");
}

static void ends_of_sweeps(void **state) {
    (void)state;
    expect_problem("to: 20", "to: -1",
                   "t:19:42: study.sweep.to: gives no machine at kappa = -1: rub.stiffness is -1000000 N/m, expected a "
                   "number of at least 0 N/m");
    expect_problem(
        "  analyze:", "  detail: {at: [3, -2]}\n  analyze:",
        "t:22:20: study.detail.at[2]: gives no machine at kappa = -2: rub.stiffness is -2000000 N/m, expected "
        "a number of at least 0 N/m");
}

static void no_yaml(void **state) {
    (void)state;
    static const char nothing[] = "", comment[] = "# nothing\n", word[] = "word", list[] = "- 1\n",
                      two[] = "whirl: 2\n---\na: 1\n", alias[] = "a: *b\n", anchor[] = "a: &b 1\n",
                      tag[] = "a: !!int 1\n", tab[] = "a:\n\tb: 1\n", open[] = "a: [1, 2\n",
                      latin[] = "title: caf\xE9\n", nul[] = "a: \0b\n", escape[] = "a: \"\\0\"\n",
                      utf16[] = "\xFF\xFEw\0h\0", surrogate[] = "a: \xED\xA0\x80\n", complex[] = "? [a]\n: b\n";
    expect_bytes_problem(nothing, 0, "t:1:1: is empty, expected a mapping of keys");
    expect_bytes_problem(comment, sizeof comment - 1, "t:1:1: is empty, expected a mapping of keys");
    expect_bytes_problem(word, sizeof word - 1, "t:1:1: is word, expected a mapping that begins with whirl: 1");
    expect_bytes_problem(list, sizeof list - 1, "t:1:1: is a list, expected a mapping that begins with whirl: 1");
    expect_bytes_problem(alias, sizeof alias - 1,
                         "t:1:4: has an alias (*), expected a case without anchors and aliases");
    expect_bytes_problem(anchor, sizeof anchor - 1,
                         "t:1:4: has an anchor (&), expected a case without anchors and aliases");
    expect_bytes_problem(tag, sizeof tag - 1, "t:1:4: has a tag (!), expected a case without tags");
    expect_bytes_problem(tab, sizeof tab - 1, "t:2:1: is indented with a tab, expected spaces");
    expect_bytes_problem(open, sizeof open - 1,
                         "t:2:1: is not YAML: did not find expected ',' or ']' (while parsing a flow sequence)");
    expect_bytes_problem(latin, sizeof latin - 1, "t:1:11: has the byte 0xE9, expected text in UTF-8");
    expect_bytes_problem(surrogate, sizeof surrogate - 1, "t:1:4: has the byte 0xED, expected text in UTF-8");
    expect_bytes_problem(utf16, sizeof utf16 - 1, "t:1:1: has the byte 0xFF, expected text in UTF-8");
    expect_bytes_problem(nul, sizeof nul - 1,
                         "t:1:4: has the byte 0x00, expected text in UTF-8 without control characters");
    expect_bytes_problem(escape, sizeof escape - 1, "t:1:4: has a control character, expected text");
    // An editor shows these lines in another order than they are read, and a terminal takes U+009B for an escape
    // sequence.
    const char override[] = "a: 1\nb: x\xE2\x80\xAE\n", isolate[] = "# \xE2\x81\xA6\na: 1\n",
               c1[] = "a: \xC2\x9B"
                      "2J\n",
               written[] = "a: \"\\u202E\"\n", key[] = "\"\\u2066\": 1\n", line_end[] = "a: \xE2\x80\xA8\n",
               ordinary[] = "d\xC3\xA9j\xC3\xA0: *b\n";
    const char expected[] = "expected text without characters that end a line or turn its direction";
    char sentence[200];
    snprintf(sentence, sizeof sentence, "t:2:5: has the character U+202E, %s", expected);
    expect_bytes_problem(override, sizeof override - 1, sentence);
    snprintf(sentence, sizeof sentence, "t:1:3: has the character U+2066, %s", expected);
    expect_bytes_problem(isolate, sizeof isolate - 1, sentence);
    snprintf(sentence, sizeof sentence, "t:1:4: has the character U+2028, %s", expected);
    expect_bytes_problem(line_end, sizeof line_end - 1, sentence);
    expect_bytes_problem(c1, sizeof c1 - 1,
                         "t:1:4: has the character U+009B, expected text without control characters");
    expect_bytes_problem(written, sizeof written - 1, "t:1:4: has a control character, expected text");
    expect_bytes_problem(key, sizeof key - 1, "t:1:1: has a control character, expected text");
    expect_bytes_problem(ordinary, sizeof ordinary - 1,
                         "t:1:7: has an alias (*), expected a case without anchors and aliases");
    expect_bytes_problem(complex, sizeof complex - 1, "t:1:3: has a list or a mapping for a key, expected a name");
    whirl_problems problems = {0};
    whirl_case *object;
    assert_int_equal(whirl_case_parse(two, sizeof two - 1, "t", &problems, &object).code, WHIRL_BAD_INPUT);
    bool said = false;
    for (size_t i = 0; i < problems.count; i++)
        said = said || (problems.items[i].line == 2 && strstr(problems.items[i].message, "begins a second document"));
    assert_true(said);
    whirl_problems_free(&problems);
}

static void too_much(void **state) {
    (void)state;
    const size_t size = 2 << 20;
    char *text = malloc(size);
    assert_non_null(text);
    memset(text, '[', size);
    expect_bytes_problem(text, 1000, "t:1:33: is nested deeper than 32 levels, expected a case");
    expect_bytes_problem(text, size, "t: is larger than 1 MiB, expected a case of at most 1048576 bytes");
    for (size_t i = 0; i + 1 < size; i += 2) memcpy(text + i, ",a", 2);
    text[0] = '[';
    expect_bytes_problem(text, 300000, "t:1:199996: has more than 100000 values, expected a case");
    free(text);
}

/// Returns the first problem of the good case with one more key in its study.
static void problem_of_key(const char *key, char message[sizeof(whirl_problem)]) {
    char line[256];
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    snprintf(line, sizeof line, "study:\n  %s: 1", key);
    char *text = edited(good_case, "study:", line);
    whirl_case_parse(text, strlen(text), "t", &problems, &object);
    snprintf(message, sizeof(whirl_problem), "%s", problems.count > 0 ? problems.items[0].message : "");
    whirl_problems_free(&problems);
    whirl_case_free(object);
    free(text);
}

/// A list of keys that does not fit into a message ends with a whole key and "...", wherever it is cut.
static void long_lists(void **state) {
    (void)state;
    char key[64] = "", message[sizeof(whirl_problem)], other[sizeof(whirl_problem)], expected[128];
    for (size_t length = 4; length < sizeof key - 4; length++) {
        memset(key, 'z', length);
        problem_of_key(key, message);
        char *names = strstr(message, ", expected one of ");
        assert_non_null(names);
        names += strlen(", expected one of ");
        const size_t used = strlen(names);
        assert_true(used > 5);
        assert_string_equal(names + used - 5, ", ...");
        names[used - 5] = '\0';
        // Every name of the list is a key of the study.
        for (char *name = names; name;) {
            char *const end = strstr(name, ", ");
            if (end) *end = '\0';
            snprintf(expected, sizeof expected, "has no key %s,", name);
            problem_of_key(name, other);
            assert_null(strstr(other, expected));
            name = end ? end + 2 : NULL;
        }
    }
}

static void too_many(void **state) {
    (void)state;
    char *text = malloc(1 << 20);
    assert_non_null(text);
    char *end = text + sprintf(text, "c: 0.2 mm\n");
    for (int i = 0; i < 254; i++) end += sprintf(end, "  p%d: 1\n", i);
    expect_problem("c: 0.2 mm", text, "t:3:1: parameters: has 257 parameters, expected at most 256");
    end = text + sprintf(text, "journal: {mass: 2 kg}\n");
    for (int i = 0; i < 255; i++) end += sprintf(end, "    s%d: {mass: 1}\n", i);
    expect_problem("journal: {mass: 2 kg}\n", text, "t:10:3: rotor.stations: has 257 stations, expected at most 256");
    end = text + sprintf(text, "elements:\n");
    for (int i = 0; i < 1021; i++) end += sprintf(end, "    - gravity\n");
    expect_problem("elements:\n", text, "t:13:3: rotor.elements: has 1025 elements, expected at most 1024");
    end = text + sprintf(text, "detail: {at: [1");
    for (int i = 0; i < 1000; i++) end += sprintf(end, ",1");
    sprintf(end, "]}\n  analyze:");
    expect_problem("analyze:", text, "t:22:12: study.detail.at: is a longer list, expected a list of 1 to 1000 values");
    // 139 expressions of 471 characters are within 65536, 140 are not.
    end = text + sprintf(text, "kappa: 10\n");
    for (int i = 0; i < 140; i++) {
        end += sprintf(end, "  p%d: = 1", i);
        for (int k = 0; k < 235; k++) end += sprintf(end, "+1");
        end += sprintf(end, "\n");
    }
    expect_problem("kappa: 10", text,
                   "t:145:9: parameters.p139: is too much: all expressions together have more than 65536 characters");
    free(text);
}

static void many_problems_at_once(void **state) {
    (void)state;
    char *one = edited(good_case, "mass: 4 kg", "mass: -3 kg");
    char *two = edited(one, "points: 5", "points: 2x");
    char *three = edited(two, "kappa: 10", "kappa: nan");
    whirl_problems problems = {0};
    whirl_case *object;
    assert_int_equal(whirl_case_parse(three, strlen(three), "t", &problems, &object).code, WHIRL_BAD_INPUT);
    assert_int_equal(problems.count, 3);
    assert_string_equal(problems.items[0].key, "parameters.kappa");
    assert_string_equal(problems.items[1].key, "rotor.stations.disc.mass");
    assert_string_equal(problems.items[2].key, "study.sweep.points");
    whirl_problems_free(&problems);
    // A contradiction in an element is reported together with mistakes elsewhere, but not with a mistake in the same
    // element.
    char *film = edited(three, "load: 200 N", "load: = kappa, radius: 3 mm");
    char *rub = edited(film, "friction: 0.1", "radius: 3 mm, frictoin: 1");
    assert_int_equal(whirl_case_parse(rub, strlen(rub), "t", &problems, &object).code, WHIRL_BAD_INPUT);
    assert_int_equal(problems.count, 5);
    assert_string_equal(problems.items[2].key, "rotor.elements[2].film");
    assert_non_null(strstr(problems.items[2].message, "both load and viscosity"));
    assert_string_equal(problems.items[3].key, "rotor.elements[3].rub.frictoin");
    whirl_problems_free(&problems);
    free(film);
    free(rub);
    // A text that cannot name a station is not proposed as a name.
    char *nameless = edited(good_case, "    disc: {mass", "    di sc: {mass");
    assert_int_equal(whirl_case_parse(nameless, strlen(nameless), "t", &problems, &object).code, WHIRL_BAD_INPUT);
    for (size_t i = 1; i < problems.count; i++) assert_null(strstr(problems.items[i].message, "di sc"));
    assert_true(problems.count == 2);
    whirl_problems_free(&problems);
    free(nameless);
    char *text = calloc(1, 20000);
    assert_non_null(text);
    strcpy(text, "whirl: 1\n");
    for (int i = 0; i < 300; i++) sprintf(text + strlen(text), "key_that_is_not_there_%d: 1\n", i);
    assert_int_equal(whirl_case_parse(text, strlen(text), "t", &problems, &object).code, WHIRL_BAD_INPUT);
    assert_int_equal(problems.count, 100);
    whirl_problems_free(&problems);
    free(text);
    free(one);
    free(two);
    free(three);
}

static void files(void **state) {
    (void)state;
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_status status = whirl_case_load("/nowhere/at/all.yaml", &problems, &object);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "/nowhere/at/all.yaml cannot be read: No such file or directory");
    status = whirl_case_load("/", &problems, &object);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "/ cannot be read: it is a folder");
    assert_int_equal(problems.count, 0);
    status = whirl_case_load("/dev/zero", &problems, &object);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_string_equal(status.message, "/dev/zero cannot be read: it is a device, expected an ordinary file");
    whirl_problems_free(&problems);
    char name[] = "/tmp/whirl-case-XXXXXX";
    const int file = mkstemp(name);
    assert_true(file >= 0);
    assert_int_equal(ftruncate(file, 1 << 30), 0);
    assert_int_equal(close(file), 0);
    status = whirl_case_load(name, NULL, &object);
    assert_int_equal(unlink(name), 0);
    assert_int_equal(status.code, WHIRL_BAD_INPUT);
    assert_non_null(strstr(status.message, "is larger than 1 MiB"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers),    cmocka_unit_test(sweeps),          cmocka_unit_test(starts),
        cmocka_unit_test(units),      cmocka_unit_test(units_of_sweeps), cmocka_unit_test(single_analyses),
        cmocka_unit_test(angles),     cmocka_unit_test(names),           cmocka_unit_test(expressions),
        cmocka_unit_test(structure),  cmocka_unit_test(ends_of_sweeps),  cmocka_unit_test(no_yaml),
        cmocka_unit_test(too_much),   cmocka_unit_test(too_many),        cmocka_unit_test(many_problems_at_once),
        cmocka_unit_test(long_lists), cmocka_unit_test(files),
    };
    return cmocka_run_group_tests_name("problems", tests, NULL, NULL);
}
