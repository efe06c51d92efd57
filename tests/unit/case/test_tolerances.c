// Tolerances in a case: distributions as text and keys, classes of sizes, samples, and what is wrong with them.
#include "case_support.h"

#include <math.h>

#include "whirl/engine/study.h"

static const char rotor[] = "whirl: 1\n"
                            "parameters: {omega: 100 rad/s, d: 40 mm, k: 1 MN/m, n: 2, f: = 2*n}\n"
                            "rotor:\n"
                            "  speed: = omega\n"
                            "  length_scale: 1 mm\n"
                            "  stations:\n"
                            "    disc: {mass: 4 kg, damping: = 10*n, eccentricity: = d/1000}\n"
                            "  elements:\n"
                            "    - shaft: {between: [disc, ground], k1: = k}\n"
                            "study:\n"
                            "  unbalance: {parameter: omega, from: 90, to: 110, points: 3}\n"
                            "  tolerances:\n";

/// Parses the case with these lines below `tolerances:`; NULL, with the first problem, if they are wrong.
static whirl_case *parse_tolerances(const char *lines, char *problem, size_t size) {
    char text[4096];
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    snprintf(text, sizeof text, "%s%s", rotor, lines);
    const whirl_status status = whirl_case_parse(text, strlen(text), "t", &problems, &object);
    snprintf(problem, size, "%s", status.code == WHIRL_OK ? "" : status.message);
    whirl_problems_free(&problems);
    return object;
}

static void expect_wrong(const char *lines, const char *expected) {
    char problem[1024];
    whirl_case *object = parse_tolerances(lines, problem, sizeof problem);
    whirl_case_free(object);
    if (strcmp(problem, expected) != 0) print_error("%s\n", lines);
    assert_string_equal(problem, expected);
}

/// Reads the distribution of the parameter in "{NAME: ...}".
static whirl_tolerance distribution(const char *text) {
    char lines[1024], problem[1024];
    whirl_study study;
    snprintf(lines, sizeof lines, "    parameters: {%s}\n", text);
    whirl_case *object = parse_tolerances(lines, problem, sizeof problem);
    if (!object) print_error("%s\n", problem);
    assert_non_null(object);
    assert_int_equal(whirl_case_study(object, &study).code, WHIRL_OK);
    assert_int_equal(study.batch_count, 2);
    assert_int_equal(study.batches[1].count, 3 * 1024);
    const whirl_tolerance found = study.batches[1].tolerated[0];
    whirl_case_free(object);
    return found;
}

static void expect_bounds(const char *text, double low, double high) {
    const whirl_tolerance found = distribution(text);
    if (!(fabs(found.low - low) < 1e-12 * fabs(low)) || !(fabs(found.high - high) < 1e-12 * fabs(high)))
        fail_msg("%s: %.15g to %.15g", text, found.low, found.high);
    assert_true(found.deviation == 0.0);
}

static void bounds_are_text_or_keys(void **state) {
    (void)state;
    expect_bounds("d: 40 mm +- 5 %", 0.038, 0.042);
    expect_bounds("d: 40 mm +- 0.1 mm", 0.0399, 0.0401);
    expect_bounds("d: 40 mm \u00b1 100 um", 0.0399, 0.0401);
    expect_bounds("d: +- 1 %", 0.0396, 0.0404);
    expect_bounds("d: +/- 1 mm", 0.039, 0.041);
    expect_bounds("n: 3 +- 0.5", 2.5, 3.5);
    expect_bounds("k: {from: 0.9 MN/m, to: = 2*k}", 0.9e6, 2e6);
    expect_bounds("k: {within: 1 MN/m +- 10 %}", 0.9e6, 1.1e6);
}

static void normal_distributions(void **state) {
    (void)state;
    whirl_tolerance found = distribution("k: {distribution: normal, deviation: 0.1 MN/m}");
    assert_true(found.mean == 1e6 && found.deviation == 1e5 && isinf(found.low) && isinf(found.high));
    found = distribution("k: {distribution: normal, within: 2 MN/m +- 30 %}");
    assert_true(fabs(found.mean - 2e6) < 1e-6 && fabs(found.deviation - 2e5) < 1e-6 && fabs(found.low - 1.4e6) < 1e-6);
    found = distribution("n: {distribution: normal, mean: 3, deviation: 1, from: 1}");
    assert_true(found.mean == 3.0 && found.low == 1.0 && isinf(found.high));
}

/// Limits in um as handbooks print them.
static void classes_of_sizes(void **state) {
    static const struct {
        const char *size;
        double nominal, low, high;
    } printed[] = {
        {"40 mm H7", 40, 0, 25},      {"40 mm h6", 40, -16, 0},      {"40 mm g6", 40, -25, -9},
        {"25 mm f7", 25, -41, -20},   {"50 mm k6", 50, 2, 18},       {"30 mm js7", 30, -10.5, 10.5},
        {"60 mm p6", 60, 32, 51},     {"20 mm N7", 20, -28, -7},     {"50 mm K7", 50, -18, 7},
        {"40 mm M7", 40, -25, 0},     {"50 mm P7", 50, -42, -17},    {"100 mm s6", 100, 71, 93},
        {"70 mm r6", 70, 43, 62},     {"45 mm c11", 45, -290, -130}, {"300 mm M6", 300, -41, -9},
        {"10 mm H8", 10, 0, 22},      {"30 mm D9", 30, 65, 117},     {"50 mm S7", 50, -59, -34},
        {"2 mm N9", 2, -29, -4},      {"18 mm m6", 18, 7, 18},       {"6 mm E8", 6, 20, 38},
        {"180 mm JS9", 180, -50, 50}, {"400 mm h11", 400, -360, 0},  {"500 mm H6", 500, 0, 40},
    };
    (void)state;
    for (size_t i = 0; i < sizeof printed / sizeof *printed; i++) {
        char text[64];
        snprintf(text, sizeof text, "d: %s", printed[i].size);
        const whirl_tolerance found = distribution(text);
        const double low = 1e6 * (found.low - 1e-3 * printed[i].nominal);
        const double high = 1e6 * (found.high - 1e-3 * printed[i].nominal);
        if (fabs(low - printed[i].low) > 1e-6 || fabs(high - printed[i].high) > 1e-6)
            fail_msg("%s: %g to %g um", printed[i].size, low, high);
    }
}

static void problems_of_distributions(void **state) {
    (void)state;
    expect_wrong("    parameters: {q: 1}\n",
                 "t:13:18: study.tolerances.parameters.q: is no parameter, did you mean d?");
    expect_wrong("    parameters: {d: 40 mm}\n",
                 "t:13:21: study.tolerances.parameters.d: is 40 mm, expected bounds such as "
                 "0.2 mm +- 5 %, +- 0.01 mm or 40 mm H7");
    expect_wrong("    parameters: {k: 2 mm +- 1 %}\n",
                 "t:13:21: study.tolerances.parameters.k: is in mm, expected a unit of N/m");
    expect_wrong(
        "    parameters: {d: 40 mm +- 0.1}\n",
        "t:13:21: study.tolerances.parameters.d: has the distance 0.1 without a unit, expected one, or a part in %");
    expect_wrong("    parameters: {d: 40 mm +- -1 %}\n",
                 "t:13:21: study.tolerances.parameters.d: has the distance -1 %, expected one above 0");
    expect_wrong(
        "    parameters: {d: 40 mm Q7}\n",
        "t:13:21: study.tolerances.parameters.d: has the class Q7, expected one of the letters c to h, js, k, m, n, "
        "p, r and s of a shaft, or capitals of a hole, and a grade of 1 to 18: 40 mm H7");
    expect_wrong("    parameters: {d: 0.6 m H7}\n",
                 "t:13:21: study.tolerances.parameters.d: has a class at a size of 600 mm, "
                 "expected one above 0 and up to 500 mm");
    expect_wrong(
        "    parameters: {f: 1 +- 5 %}\n",
        "t:13:18: study.tolerances.parameters.f: is = 2*n in the case, expected a parameter with a number of its "
        "own, not an expression");
    expect_wrong("    parameters: {omega: +- 5 %}\n",
                 "t:13:18: study.tolerances.parameters.omega: is a parameter that the "
                 "study varies or sets itself, expected another one");
    expect_wrong(
        "    parameters: {k: {from: 2 MN/m, to: 1 MN/m}}\n",
        "t:13:40: study.tolerances.parameters.k.to: gives bounds 2000000 and 1000000 (in SI), expected the lower "
        "one first");
    expect_wrong("    parameters: {k: {from: 2 MN/m}}\n",
                 "t:13:18: study.tolerances.parameters.k.to: is missing, expected two "
                 "bounds, from and to, or within");
    expect_wrong("    parameters: {k: {from: 1, to: 2, mean: 1}}\n",
                 "t:13:38: study.tolerances.parameters.k.mean: has a meaning only with distribution: normal");
    expect_wrong("    parameters: {}\n",
                 "t:13:5: study.tolerances.parameters: is empty, expected 1 to 16 parameters with their tolerances");
    char lines[1024];
    size_t used = (size_t)snprintf(lines, sizeof lines, "    parameters: {");
    for (int i = 0; i < 17; i++)
        used += (size_t)snprintf(lines + used, sizeof lines - used, "p%d: 1%s", i, i < 16 ? ", " : "}\n");
    expect_wrong(lines,
                 "t:13:5: study.tolerances.parameters: has 17 parameters, expected 1 to 16 with their tolerances");
}

static void problems_of_samples(void **state) {
    (void)state;
    expect_wrong("    parameters: {k: +- 5 %}\n    samples: 1000\n",
                 "t:14:14: study.tolerances.samples: is 1000, expected a power of two: 64, 128, 256, ...");
    expect_wrong("    parameters: {k: +- 5 %}\n    samples: 8\n",
                 "t:14:14: study.tolerances.samples: is 8, expected a whole number from 64 to 1048576");
    expect_wrong(
        "    parameters: {k: +- 5 %}\n    of: [{field: unbalance/axis}]\n",
        "t:14:10: study.tolerances.of[1]: asks for unbalance/axis, which is no field of the points of this study");
    expect_wrong("    parameters: {k: +- 5 %}\n    of: [{field: unbalance/axes, column: large, at: disc}]\n",
                 "t:14:10: study.tolerances.of[1]: has a column that the field does not have");
    expect_wrong("    parameters: {k: +- 5 %}\n    of: [{field: unbalance/axes, at: disk}]\n",
                 "t:14:10: study.tolerances.of[1]: has `at`, which names no station");
    expect_wrong("    parameters: {k: +- 5 %}\n    of: [{field: unbalance/axes, at: disc, below: 3 kg}]\n",
                 "t:14:10: study.tolerances.of[1]: has a limit in kg, expected the unit of unbalance/axes: m");
    expect_wrong("    parameters: {k: +- 5 %}\n    of: [{field: unbalance/axes, at: disc, above: 2 mm, below: 1 mm}]\n",
                 "t:14:64: study.tolerances.of[1].below: is not above the limit `above`, expected a larger number");
    char lines[2048];
    size_t used = (size_t)snprintf(lines, sizeof lines, "    parameters: {k: +- 5 %%}\n    of: [");
    for (int i = 0; i < 17; i++)
        used += (size_t)snprintf(lines + used, sizeof lines - used, "{field: unbalance/axes, at: disc}%s",
                                 i < 16 ? ", " : "]\n");
    expect_wrong(lines, "t:14:570: study.tolerances.of[17]: asks for one more number than the 16 that are possible");
    // Machines that cannot be are named before the run.
    static const char begins[] = "t:12:3: study.tolerances: gives no machine at omega = 90 rad/s and n = -0.";
    char problem[1024];
    assert_null(parse_tolerances("    parameters: {n: 0 +- 1}\n", problem, sizeof problem));
    problem[sizeof begins - 1] = '\0';
    assert_string_equal(problem, begins);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_are_text_or_keys), cmocka_unit_test(normal_distributions),
        cmocka_unit_test(classes_of_sizes),        cmocka_unit_test(problems_of_distributions),
        cmocka_unit_test(problems_of_samples),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
