// Tori of studies, compared with closed forms and with motions of the same rotor by integration.
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
#include "support_study.h"
#include "support_torus.h"
#include "whirl/engine/case.h"

static const double pi = 3.14159265358979323846;

static double number(const whirl_table *table, size_t point, const char *field) {
    return table_number(table, point, field, 0);
}

// ---------------------------------------------------------------- a circle in closed form

/// z' = (p + i(w + b |z|^2) - |z|^2) z and x' = cos t - x, u = Re z, v = Im z: from p = 0 on the circle |z|^2 = p is
/// a torus of rotation number w + b p and exponents -4 pi p and -2 pi a revolution.
typedef struct circle {
    double growth, angular, bend;
    whirl_probe probe;
    whirl_system system;
    double start[3];
} circle;

static void slope(const void *model, double t, const double *f, const double *x, double *dxdt) {
    const circle *c = model;
    const double square = x[0] * x[0] + x[1] * x[1], radial = c->growth - square, turn = c->angular + c->bend * square;
    (void)t;
    dxdt[0] = radial * x[0] - turn * x[1];
    dxdt[1] = radial * x[1] + turn * x[0];
    dxdt[2] = f[0] - x[2];
}

static void tangent(const void *model, double t, const double *f, const double *x, const double *sides, size_t count,
                    const double *u, double *out) {
    const circle *c = model;
    const double square = x[0] * x[0] + x[1] * x[1], radial = c->growth - square, turn = c->angular + c->bend * square;
    (void)t, (void)f, (void)sides;
    for (size_t k = 0; k < count; k++, u += 3, out += 3) {
        const double change = 2.0 * (x[0] * u[0] + x[1] * u[1]);
        out[0] = radial * u[0] - turn * u[1] - change * (x[0] + c->bend * x[1]);
        out[1] = radial * u[1] + turn * u[0] - change * (x[1] - c->bend * x[0]);
        out[2] = -u[2];
    }
}

static double divergence(const void *model, double t, const double *f, const double *x, const double *sides) {
    const circle *c = model;
    (void)t, (void)f, (void)sides;
    return 2.0 * c->growth - 4.0 * (x[0] * x[0] + x[1] * x[1]) - 1.0;
}

static void cosine(const void *model, double t, double *forcing) {
    (void)model;
    *forcing = cos(t);
}

static void release(void *owner) {
    free(owner);
}

/// Makes the machine; `family` is the angular rate.
static whirl_status machine_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    circle *c = malloc(sizeof *c);
    const double *angular = family;
    (void)batch;
    assert_non_null(c);
    *c = (circle){.growth = value, .angular = *angular, .bend = 0.1, .probe = {.name = "z", .y = 1, .vx = 2, .vy = 2}};
    c->start[0] = 0.01;
    c->start[2] = 0.5;
    c->system = (whirl_system){.dimension = 3,
                               .period = 2.0 * pi,
                               .forcing_count = 1,
                               .forcing = cosine,
                               .rhs = slope,
                               .tangent = tangent,
                               .divergence = divergence,
                               .model = c,
                               .probe_count = 1,
                               .probes = &c->probe};
    *machine = (whirl_machine){.system = &c->system, .start = c->start, .owner = c, .release = release};
    return whirl_ok();
}

static void make_batch(const char *name, const char *analysis, const double *begins, whirl_batch *batch) {
    *batch = (whirl_batch){.parameter = "p",
                           .count = 1,
                           .values = begins,
                           .bounds = {-0.2, 0.5},
                           .integrate = whirl_integrate_default(),
                           .record = whirl_record_default()};
    snprintf(batch->name, sizeof batch->name, "%s", name);
    batch->role = strcmp(name, "branch") == 0 ? WHIRL_ROLE_BRANCHES : WHIRL_ROLE_TORI;
    strcpy(batch->integrate.method, "dop853");
    batch->record.transient = 20;
    batch->record.growth = WHIRL_GROWTH_NONE;
    batch->record.waveform = false;
    batch->record.trace.torus_accuracy = 1e-9;
    assert_true(whirl_analysis_add(&batch->analyses, analysis));
}

static whirl_result *run_circle(const double *angular) {
    static const double begins[] = {-0.2};
    const whirl_run_options options = {.threads = 2};
    whirl_study study = {.batch_count = 2, .machine = machine_at, .family = angular};
    whirl_result *result;
    make_batch("branch", "trace", begins, &study.batches[0]);
    make_batch("tori", "torus", begins, &study.batches[1]);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

static void a_circle_from_a_study(void **state) {
    const double angular = 0.31;
    double rotation = 0.0, exponent = 0.0, bounds = 0.0, lines = 0.0;
    (void)state;
    whirl_result *result = run_circle(&angular);
    const whirl_table *tori = whirl_result_table(result, "tori");
    const whirl_tori own = whirl_table_tori(tori, 0);
    assert_int_equal(tori->count - 1, own.last);
    assert_int_equal(tori->count, own.stable);
    check_within("tori", "study of a circle: p at which its tori begin", 0.0, number(tori, 0, "torus/begins"), 1e-9);
    for (size_t i = 0; i < tori->count; i++) {
        const double p = tori->values[i], radius = sqrt(p), turns = 0.31 + 0.1 * p;
        const char *const fields[] = {"torus/section_high", "torus/high", "torus/section_low", "torus/low"};
        rotation = fmax(rotation, fabs(number(tori, i, "torus/rotation") - turns));
        exponent = fmax(exponent, fabs(number(tori, i, "torus/exponent") - fmax(-4.0 * pi * p, -2.0 * pi)));
        lines = fmax(lines, fabs(number(tori, i, "torus/frequency") - turns));
        lines = fmax(lines, fabs(number(tori, i, "torus/amplitude") - radius));
        for (size_t f = 0; f < 4; f++)
            for (size_t c = 0; c < 2; c++)
                bounds = fmax(bounds, fabs(whirl_table_field(tori, i, fields[f], 0)[c] - (f < 2 ? radius : -radius)));
    }
    check_within("tori", words("%zu of them to p = 1/2: rotation numbers", tori->count), 0.0, rotation, 1e-9);
    check_within("tori", "their exponents", 0.0, exponent, 1e-6);
    check_within("tori", "bounds of their sections and motions", 0.0, bounds, 1e-6);
    check_within("tori", "frequency and amplitude of their lines", 0.0, lines, 1e-7);
    check_within("tori", "the last one is at the bound", 0.5, tori->values[own.last], 1e-12);
    assert_true(number(tori, own.last, "torus/end") == WHIRL_TORUS_END_OF_RANGE);
    whirl_result_free(result);
}

/// At a strong resonance the row of the table says that no torus is found.
static void no_torus_at_a_quarter_of_a_turn(void **state) {
    const double angular = 0.25;
    (void)state;
    whirl_result *result = run_circle(&angular);
    const whirl_table *tori = whirl_result_table(result, "tori");
    const whirl_tori own = whirl_table_tori(tori, 0);
    char text[WHIRL_MESSAGE_SIZE];
    assert_int_equal(1, tori->count);
    assert_true(own.found == 0 && own.last == 0);
    assert_true(number(tori, 0, "torus/end") == WHIRL_TORUS_NONE && isnan(number(tori, 0, "torus/rotation")));
    assert_true(fabs(tori->values[0]) < 1e-9 && tori->values[0] == number(tori, 0, "torus/begins"));
    whirl_torus_end_text(number(tori, 0, "torus/end"), NAN, NAN, text, sizeof text);
    assert_string_equal("none is found at the point", text);
    whirl_result_free(result);
}

// ---------------------------------------------------------------- a rotor and its own motions

static const char *const rotor =
    "whirl: 1\nparameters: {r_k: 0.6, omega: 650 rad/s, c: 0.2 mm, k2: = 50*(650/0.2)^2}\n"
    "rotor:\n  speed: = omega\n  length_scale: = c\n  stations:\n"
    "    disc:    {mass: 420 kg, damping: 4300 N.s/m, eccentricity: = 0.08*c}\n"
    "    journal: {mass: 100 kg, damping: 9300 N.s/m}\n  elements:\n"
    "    - shaft:   {between: [disc, journal], k1: = r_k*k2, k2: = k2, signs: paper}\n"
    "    - film:    {at: journal, count: 2, law: capone, clearance: = c, load: = 0.0045*50*c*omega^2}\n"
    "    - gravity: 9.8 m/s2\n"
    "study:\n  initial: {disc: {y: -0.9}, journal: {y: -0.8}}\n%s";

static whirl_result *run_rotor(const char *study) {
    char text[2048];
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study made;
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    snprintf(text, sizeof text, rotor, study);
    require_ok(whirl_case_parse(text, strlen(text), "t", &problems, &object));
    require_ok(whirl_case_study(object, &made));
    require_ok(whirl_study_run(&made, &options, &result));
    whirl_case_free(object);
    whirl_problems_free(&problems);
    return result;
}

/// Computes bounds of a coordinate over the recorded sections.
static void find_extent(const whirl_table *table, size_t point, size_t station, size_t axis, double extent[2]) {
    const double *section = whirl_table_field(table, point, "poincare/section", station);
    const size_t rows = whirl_layout_field(&table->layout, "poincare/section")->rows;
    extent[0] = INFINITY, extent[1] = -INFINITY;
    for (size_t n = 0; n < rows; n++) {
        extent[0] = fmin(extent[0], section[4 * n + axis]);
        extent[1] = fmax(extent[1], section[4 * n + axis]);
    }
}

/// Finds order and amplitude of the line of x that is nearest to an order.
static void find_line(const whirl_table *table, size_t point, double order, double line[2]) {
    const double *lines = whirl_table_field(table, point, "spectrum/lines", 0);
    const size_t rows = whirl_layout_field(&table->layout, "spectrum/lines")->rows;
    line[0] = line[1] = INFINITY;
    for (size_t n = 0; n < rows && !isnan(lines[5 * n]); n++)
        if (fabs(lines[5 * n] - order) < fabs(line[0] - order)) line[0] = lines[5 * n], line[1] = lines[5 * n + 1];
}

static void compare(const whirl_table *tori, size_t row, const whirl_table *runs, size_t point) {
    const double order = whirl_table_field(tori, row, "torus/frequency", 0)[0];
    double line[2], extent[2];
    const size_t sections = whirl_layout_field(&runs->layout, "poincare/section")->rows;
    // A mean of 1024 sections is good to some 1e-7 near fractions of small denominators.
    check_within("tori", words("rotor at r_k = %.6f: rotation number of its motion", runs->values[point]),
                 mean_turn(whirl_table_field(runs, point, "poincare/section", 0), 4, sections),
                 number(tori, row, "torus/rotation"), 1e-6);
    for (size_t station = 0; station < 2; station++)
        for (size_t axis = 0; axis < 2; axis++) {
            const double low = whirl_table_field(tori, row, "torus/section_low", station)[axis];
            const double high = whirl_table_field(tori, row, "torus/section_high", station)[axis];
            const char *what = words("section of %s, %c", station ? "journal" : "disc", "xy"[axis]);
            find_extent(runs, point, station, axis, extent);
            check_within("tori", words("%s: low", what), extent[0], low, 1e-5);
            check_within("tori", words("%s: high", what), extent[1], high, 1e-5);
        }
    find_line(runs, point, order, line);
    check_within("tori", "line of its spectrum, disc x: order", line[0], order, 1e-5);
    check_within("tori", "amplitude", line[1], whirl_table_field(tori, row, "torus/amplitude", 0)[0], 1e-4);
    check_within("tori", "second Lyapunov exponent", whirl_table_field(runs, point, "exponents/values", 0)[1],
                 number(tori, row, "torus/exponent"), 2e-3);
}

static size_t nearest_row(const whirl_table *table, double value) {
    size_t nearest = 0;
    for (size_t i = 1; i < table->count; i++)
        if (fabs(table->values[i] - value) < fabs(table->values[nearest] - value)) nearest = i;
    return nearest;
}

/// The torus begins at r_k = .46524 and ends at .39251, where the branch has its Neimark-Sacker points: it is followed
/// once. Three of its rows are compared with motions by integration.
static void a_rotor_and_its_motions(void **state) {
    char study[512];
    (void)state;
    whirl_result *result = run_rotor("  branch: {parameter: r_k, from: 0.6, to: 0.38, switches: 0, tori: yes}\n");
    const whirl_table *tori = whirl_result_table(result, "tori"), *branch = whirl_result_table(result, "branch");
    const whirl_tori own = whirl_table_tori(tori, 0);
    assert_int_equal(tori->count - 1, own.last);
    check_holds("tori", words("rotor: all %zu tori of the study are stable", tori->count), own.stable == tori->count);
    size_t other = branch->count;
    while (number(branch, --other, "trace/special") != WHIRL_NEIMARK_SACKER) assert_true(other > 0);
    assert_true(number(tori, own.last, "torus/end") == WHIRL_TORUS_SHRANK);
    check_within("tori", "r_k to which they shrink, and of the other Neimark-Sacker point", branch->values[other],
                 number(tori, own.last, "torus/limit"), 1e-4);
    const size_t rows[] = {nearest_row(tori, 0.45), nearest_row(tori, 0.43), nearest_row(tori, 0.41)};
    snprintf(study, sizeof study,
             "  sweep: {parameter: r_k, values: [%.17g, %.17g, %.17g], start: carry, direction: down}\n"
             "  integrate: {method: dop853, transient: 1500, record: 1024}\n"
             "  analyze: [poincare, spectrum, exponents]\n",
             tori->values[rows[0]], tori->values[rows[1]], tori->values[rows[2]]);
    whirl_result *motions = run_rotor(study);
    for (size_t i = 0; i < 3; i++) compare(tori, rows[i], whirl_result_table(motions, "sweep"), i);
    whirl_result_free(motions);
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_circle_from_a_study),
        cmocka_unit_test(no_torus_at_a_quarter_of_a_turn),
        cmocka_unit_test(a_rotor_and_its_motions),
    };
    return cmocka_run_group_tests_name("tori study", tests, NULL, NULL);
}
