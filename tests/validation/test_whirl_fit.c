// Bearings with coefficients over the frequency of whirl in motions: rational functions with states of their own,
// compared with the machines that the tables come from, with linear studies of the tables, and with closed forms.
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
#include "whirl/engine/analyze.h"
#include "whirl/engine/case.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/result.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

enum { POINTS = 26, TEXT = POINTS * 26, COEFFICIENTS = 8, MAX_DIMENSION = 32, WHOLE = 16384 };

static const char *const names[COEFFICIENTS] = {"kxx", "kxy", "kyx", "kyy", "cxx", "cxy", "cyx", "cyy"};

static void relative(const char *what, double expected, double obtained, double share) {
    check_within("Whirl in time", what, expected, obtained, share * fabs(expected));
}

// ---------------------------------------------------------------- tables

/// A 2 x 2 matrix over s.
typedef struct matrix {
    double complex m[2][2];
} matrix;
typedef matrix over_s(double complex s);

/// Lists of a table: the frequencies, then all coefficients.
typedef struct table {
    char frequencies[TEXT], list[COEFFICIENTS][TEXT];
    double w[POINTS];
} table;

static void append(char *text, size_t i, double number) {
    const size_t used = strlen(text);
    snprintf(text + used, TEXT - used, "%s%.17g", i > 0 ? ", " : "", number);
}

/// Writes K + i w C at equal distances from 0 to `top`; C at 0 is taken at a small frequency.
static void tabulate(over_s *of, double top, table *out) {
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i < POINTS; i++) {
        const double w = out->w[i] = top * (double)i / (POINTS - 1), slow = w > 0.0 ? w : 1e-4 * top;
        const matrix here = of(I * w), near = of(I * slow);
        append(out->frequencies, i, w);
        for (size_t e = 0; e < 4; e++) {
            append(out->list[e], i, creal(here.m[e / 2][e % 2]));
            append(out->list[4 + e], i, cimag(near.m[e / 2][e % 2]) / slow);
        }
    }
}

typedef struct disc {
    double speed, mass, eccentricity, elevation;
} disc;

static whirl_status build(const disc *d, const table *of, bool in_time, whirl_rotor **rotor) {
    whirl_design *design;
    whirl_setting settings[COEFFICIENTS + 3] = {
        {"at", 0, "disc"}, {"frequencies", 0, of->frequencies}, {"elevation", d->elevation, NULL}};
    const whirl_setting station[] = {{"mass", d->mass, NULL}, {"eccentricity", d->eccentricity, NULL}};
    const whirl_setting weight[] = {{"acceleration", 9.81, NULL}};
    for (size_t i = 0; i < COEFFICIENTS; i++) settings[3 + i] = (whirl_setting){names[i], 0, of->list[i]};
    require_ok(whirl_design_new(d->speed, 1e-3, &design));
    require_ok(whirl_design_station(design, "disc", station, 2));
    require_ok(whirl_design_element(design, "bearing", settings, COEFFICIENTS + 3));
    if (d->elevation != 0.0) require_ok(whirl_design_element(design, "gravity", weight, 1));
    if (in_time) whirl_design_in_time(design);
    const whirl_status status = whirl_rotor_new(design, rotor);
    whirl_design_free(design);
    return status;
}

// ---------------------------------------------------------------- a pad that is condensed

/// Between disc and pad, and between pad and ground; with the pad's mass.
static const double film[COEFFICIENTS] = {2e6, 8e5, -9e5, 2.5e6, 3e3, 400.0, -300.0, 3.5e3};
static const double pivot[COEFFICIENTS] = {6e6, 2e5, -1e5, 9e6, 2e3, 100.0, 150.0, 1e3};
static const double pad_mass = 4.0;

static double complex stiffness(const double *of, int row, int column, double complex s) {
    return of[2 * row + column] + s * of[4 + 2 * row + column];
}

/// Returns Z_qq - Z_qs Z_ss^-1 Z_sq.
static matrix condensed(double complex s) {
    double complex a[2][2], z[2][2];
    matrix out;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            z[i][j] = stiffness(film, i, j, s);
            a[i][j] = z[i][j] + stiffness(pivot, i, j, s) + (i == j ? pad_mass * s * s : 0.0);
        }
    const double complex det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    const double complex inverse[2][2] = {{a[1][1] / det, -a[0][1] / det}, {-a[1][0] / det, a[0][0] / det}};
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            out.m[i][j] = z[i][j];
            for (int k = 0; k < 2; k++)
                for (int l = 0; l < 2; l++) out.m[i][j] -= z[i][k] * inverse[k][l] * z[l][j];
        }
    return out;
}

static whirl_rotor *with_pad(const disc *d) {
    whirl_design *design;
    whirl_rotor *rotor;
    const whirl_setting station[] = {{"mass", d->mass, NULL}, {"eccentricity", d->eccentricity, NULL}};
    const whirl_setting pad[] = {{"mass", pad_mass, NULL}};
    whirl_setting inner[COEFFICIENTS + 2] = {{"at", 0, "disc"}, {"from", 0, "pad"}};
    whirl_setting outer[COEFFICIENTS + 1] = {{"at", 0, "pad"}};
    for (size_t i = 0; i < COEFFICIENTS; i++) {
        inner[2 + i] = (whirl_setting){names[i], film[i], NULL};
        outer[1 + i] = (whirl_setting){names[i], pivot[i], NULL};
    }
    require_ok(whirl_design_new(d->speed, 1e-3, &design));
    require_ok(whirl_design_station(design, "disc", station, 2));
    require_ok(whirl_design_station(design, "pad", pad, 1));
    require_ok(whirl_design_element(design, "bearing", inner, COEFFICIENTS + 2));
    require_ok(whirl_design_element(design, "bearing", outer, COEFFICIENTS + 1));
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Writes all eigenvalues with an imaginary part of 0 or more, over the clock, [MAX_DIMENSION]; returns their number.
static size_t eigenvalues(const whirl_rotor *rotor, double complex *out) {
    const double start[MAX_DIMENSION] = {0.0};
    whirl_modes *modes;
    size_t count = 0;
    assert_true(whirl_rotor_system(rotor)->dimension <= MAX_DIMENSION);
    require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
    for (size_t i = 0; i < modes->count; i++) out[count++] = modes->modes[i].real + modes->modes[i].imaginary * I;
    for (size_t i = 0; i < modes->real_count; i++) out[count++] = modes->reals[i];
    whirl_modes_free(modes);
    return count;
}

/// Returns the largest distance of any of `of` from the nearest of the others, over the largest one.
static double farthest(const double complex *of, size_t count, const double complex *among, size_t most) {
    double worst = 0.0;
    for (size_t i = 0; i < count; i++) {
        double nearest = INFINITY;
        for (size_t k = 0; k < most; k++) nearest = fmin(nearest, cabs(of[i] - among[k]));
        worst = fmax(worst, nearest / cabs(of[i]));
    }
    return worst;
}

static void respond(const whirl_rotor *rotor, double complex out[2]) {
    const double start[MAX_DIMENSION] = {0.0};
    double rest[MAX_DIMENSION], response[2 * MAX_DIMENSION];
    require_ok(whirl_forced_response(whirl_rotor_system(rotor), start, rest, response));
    for (int a = 0; a < 2; a++) out[a] = response[2 * a] + response[2 * a + 1] * I;
}

static double apart(const double complex a[2], const double complex b[2]) {
    return hypot(cabs(a[0] - b[0]), cabs(a[1] - b[1])) / hypot(cabs(b[0]), cabs(b[1]));
}

/// Carries x [MAX_DIMENSION] over `revolutions`.
static void carry(const whirl_rotor *rotor, int revolutions, double *x) {
    whirl_integrate_options options = whirl_integrate_default();
    whirl_integrator *integrator;
    snprintf(options.method, sizeof options.method, "dop853");
    options.rtol = 1e-13;
    options.atol = 1e-15;
    require_ok(whirl_integrator_new(whirl_rotor_system(rotor), &options, &integrator));
    for (int n = 0; n < revolutions; n++)
        assert_int_equal(whirl_integrator_revolve(integrator, x, NULL, NULL), WHIRL_BOUNDED);
    whirl_integrator_free(integrator);
}

static void pad(void **state) {
    static table of;
    const disc d = {300.0, 10.0, 2e-5, 0.0};
    whirl_rotor *fitted, *whole = with_pad(&d), *linear;
    double complex among[MAX_DIMENSION], known[MAX_DIMENSION], response[3][2];
    char note[WHIRL_MESSAGE_SIZE];
    (void)state;
    tabulate(condensed, 1500.0, &of);
    require_ok(build(&d, &of, true, &fitted));
    require_ok(build(&d, &of, false, &linear));
    assert_true(whirl_rotor_note(fitted, 0, note));
    assert_non_null(strstr(note, "bearing at disc: in time 4 poles, off its table by"));
    check_holds("Whirl in time", "the table's machine has the states of its disc alone, that in time 8 more",
                whirl_rotor_system(linear)->dimension == 4 && whirl_rotor_system(fitted)->dimension == 12);
    const size_t most = eigenvalues(fitted, among), count = eigenvalues(whole, known);
    check_within("Whirl in time", "a pad condensed: part by which any eigenvalue of the whole differs", 0.0,
                 farthest(known, count, among, most), 1e-11);
    respond(fitted, response[0]);
    respond(whole, response[1]);
    respond(linear, response[2]);
    check_within("Whirl in time", "a pad condensed: part by which the response in time differs from the whole's", 0.0,
                 apart(response[0], response[1]), 1e-12);
    check_within("Whirl in time", "a pad condensed: part by which the linear study of the table does", 0.0,
                 apart(response[2], response[1]), 1e-12);
    // A blow on the disc: all states begin at 0.
    double x[MAX_DIMENSION] = {0.0, 0.0, 0.5, -0.3}, y[MAX_DIMENSION] = {0.0, 0.0, 0.0, 0.0, 0.5, -0.3}, worst = 0.0;
    for (int n = 0; n < 6; n++) {
        carry(fitted, 1, x);
        carry(whole, 1, y);
        worst = fmax(worst, hypot(hypot(x[0] - y[0], x[1] - y[1]), hypot(x[2] - y[4], x[3] - y[5])));
    }
    check_within("Whirl in time", "a pad condensed: motions after a blow, 0.5 mm/rad, over six revolutions, mm", 0.0,
                 worst, 1e-12);
    whirl_rotor_free(linear);
    whirl_rotor_free(fitted);
    whirl_rotor_free(whole);
}

/// Motions in time under an unbalance settle at the response of the linear study of the table.
static void response_at_speeds(void **state) {
    static table of;
    (void)state;
    tabulate(condensed, 1500.0, &of);
    for (int k = 3; k <= 18; k += 5) {
        const disc d = {of.w[k], 10.0, 2e-5, 0.0};
        whirl_rotor *fitted, *linear;
        double complex expected[2];
        double x[MAX_DIMENSION] = {0.0};
        require_ok(build(&d, &of, true, &fitted));
        require_ok(build(&d, &of, false, &linear));
        respond(linear, expected);
        carry(fitted, 150, x);
        const double complex found[2] = {x[0], x[1]}, real[2] = {creal(expected[0]), creal(expected[1])};
        check_within("Whirl in time", words("%.0f rad/s: part by which a motion of 150 revolutions differs", d.speed),
                     0.0, apart(found, real), 1e-11);
        whirl_rotor_free(linear);
        whirl_rotor_free(fitted);
    }
}

// ---------------------------------------------------------------- a solid: closed forms

static const double k0 = 1e6, k1 = 4e5, relaxation = 2e-3;

static matrix solid(double complex s) {
    const double complex z = k0 + k1 * relaxation * s / (1.0 + relaxation * s);
    return (matrix){{{z, 0.0}, {0.0, z}}};
}

/// Returns a root of m s^2 + Z(s) = 0 by Newton's method.
static double complex pole_of(double mass) {
    double complex p = -50.0 + I * sqrt((k0 + 0.5 * k1) / mass);
    for (int step = 0; step < 50; step++) {
        const double complex d = 1.0 + relaxation * p, value = mass * p * p + solid(p).m[0][0];
        p -= value / (2.0 * mass * p + k1 * relaxation / (d * d));
    }
    return p;
}

/// Four displacements, a revolution apart, determine the two roots of a decay along x.
static void free_decay(void **state) {
    static table of;
    const disc d = {250.0, 10.0, 0.0, 0.0};
    const double complex p = pole_of(d.mass), turned = cexp(p * 6.283185307179586476925 / d.speed);
    whirl_rotor *fitted;
    double x[MAX_DIMENSION] = {0.0, 0.0, 1.0, 0.0}, places[4];
    (void)state;
    tabulate(solid, 1000.0, &of);
    require_ok(build(&d, &of, true, &fitted));
    double complex found[MAX_DIMENSION];
    const size_t count = eigenvalues(fitted, found);
    const double complex known[] = {p / d.speed};
    check_within("Whirl in time", "solid: part by which an eigenvalue differs from the closed form", 0.0,
                 farthest(known, 1, found, count), 1e-12);
    carry(fitted, 4, x); // what has no frequency is gone
    for (int n = 0; n < 4; n++) {
        places[n] = x[0];
        carry(fitted, 1, x);
    }
    // x_2 = a x_1 + b x_0, x_3 = a x_2 + b x_1.
    const double det = places[1] * places[1] - places[0] * places[2];
    const double b = (places[2] * places[2] - places[1] * places[3]) / -det;
    relative("solid: remainder after a revolution of free decay, squared", creal(turned * conj(turned)), -b, 1e-10);
    whirl_rotor_free(fitted);
}

/// Z(0) carries the weight, from the elevation of the bearing.
static void at_rest(void **state) {
    static table of;
    const disc d = {250.0, 10.0, 0.0, 3e-4};
    whirl_rotor *fitted;
    double x[MAX_DIMENSION] = {0.0};
    (void)state;
    tabulate(solid, 1000.0, &of);
    require_ok(build(&d, &of, true, &fitted));
    require_ok(whirl_equilibrium(whirl_rotor_system(fitted), x));
    relative("solid: where a disc rests on a raised bearing, m", d.elevation - d.mass * 9.81 / k0, 1e-3 * x[1], 1e-12);
    whirl_rotor_free(fitted);
}

/// For linear equations the exact derivative is a difference.
static void tangent(void **state) {
    static table of;
    const disc d = {250.0, 10.0, 1e-5, 0.0};
    whirl_rotor *fitted;
    double x[MAX_DIMENSION], dx[MAX_DIMENSION], moved[MAX_DIMENSION], slope[MAX_DIMENSION], other[MAX_DIMENSION],
        change[MAX_DIMENSION], trace = 0.0, worst = 0.0;
    (void)state;
    tabulate(condensed, 1500.0, &of);
    require_ok(build(&d, &of, true, &fitted));
    const whirl_system *system = whirl_rotor_system(fitted);
    const size_t n = system->dimension;
    const double forcing[WHIRL_MAX_FORCING] = {1.0};
    for (size_t i = 0; i < n; i++) {
        x[i] = cos(1.0 + (double)i);
        dx[i] = sin(2.0 + 3.0 * (double)i);
        moved[i] = x[i] + dx[i];
    }
    system->rhs(system->model, 0.0, forcing, x, slope);
    system->rhs(system->model, 0.0, forcing, moved, other);
    system->tangent(system->model, 0.0, forcing, x, NULL, 1, dx, change);
    for (size_t i = 0; i < n; i++) worst = fmax(worst, fabs(other[i] - slope[i] - change[i]) / (1.0 + fabs(other[i])));
    check_within("Whirl in time", "derivative along a direction against the difference", 0.0, worst, 1e-13);
    for (size_t i = 0; i < n; i++) {
        double unit[MAX_DIMENSION] = {0.0};
        unit[i] = 1.0;
        system->tangent(system->model, 0.0, forcing, x, NULL, 1, unit, change);
        trace += change[i];
    }
    relative("its trace, expected by the divergence", trace, system->divergence(system->model, 0.0, forcing, x, NULL),
             1e-12);
    whirl_rotor_free(fitted);
}

// ---------------------------------------------------------------- over the speed as well

enum { SPEEDS = 5 };

/// Returns the stiffness of a fluid whose poles, and whose drive along the whirl, are in proportion to the speed.
static matrix turning(double complex s, double speed) {
    const double p = 0.8 * speed, drive = 2e3 * speed;
    const double complex slow = p / (s + p), place = 6e6 + 3e3 * speed - 2e6 * slow + 3e3 * s;
    return (matrix){{{place, drive * slow}, {-0.9 * drive * slow, place + 5e5 * slow}}};
}

/// Makes the disc at a speed, for motions in time or for linear studies.
static whirl_rotor *at_speed(double speed, bool in_time) {
    static char lists[COEFFICIENTS][SPEEDS * TEXT], speeds[TEXT], frequencies[TEXT];
    static bool written;
    whirl_design *design;
    whirl_rotor *rotor;
    for (size_t r = 0; r < SPEEDS && !written; r++) {
        const double own = 300.0 + 100.0 * (double)r;
        append(speeds, r, own);
        for (size_t i = 0; i < POINTS; i++) {
            const double w = 1200.0 * (double)i / (POINTS - 1), slow = w > 0.0 ? w : 0.1;
            const matrix here = turning(I * w, own), near = turning(I * slow, own);
            if (r == 0) append(frequencies, i, w);
            for (size_t k = 0; k < COEFFICIENTS; k++) {
                const size_t e = k % 4, used = strlen(lists[k]);
                const double number = k < 4 ? creal(here.m[e / 2][e % 2]) : cimag(near.m[e / 2][e % 2]) / slow;
                snprintf(lists[k] + used, sizeof lists[k] - used, "%s%.17g", i > 0 ? ", " : r > 0 ? "; " : "", number);
            }
        }
    }
    written = true;
    const whirl_setting station[] = {{"mass", 10.0, NULL}, {"eccentricity", 2e-5, NULL}};
    whirl_setting settings[COEFFICIENTS + 3] = {
        {"at", 0, "disc"}, {"speeds", 0, speeds}, {"frequencies", 0, frequencies}};
    for (size_t k = 0; k < COEFFICIENTS; k++) settings[3 + k] = (whirl_setting){names[k], 0, lists[k]};
    require_ok(whirl_design_new(speed, 1e-3, &design));
    require_ok(whirl_design_station(design, "disc", station, 2));
    require_ok(whirl_design_element(design, "bearing", settings, COEFFICIENTS + 3));
    if (in_time) whirl_design_in_time(design);
    require_ok(whirl_rotor_new(design, &rotor));
    whirl_design_free(design);
    return rotor;
}

/// Machines of a sweep have the same poles, and numbers that vary smoothly with the speed.
static void over_speeds(void **state) {
    const double forcing[WHIRL_MAX_FORCING] = {1.0};
    double worst = 0.0, jump = 0.0, x[MAX_DIMENSION], slopes[2][MAX_DIMENSION];
    (void)state;
    for (size_t i = 0; i < MAX_DIMENSION; i++) x[i] = cos((double)i);
    for (int k = 0; k <= 40; k++) {
        const double speed = 300.0 + 9.99 * k;
        double complex responses[2][2] = {{0.0}};
        whirl_rotor *linear = at_speed(speed, false);
        respond(linear, responses[1]);
        for (int i = 0; i < 2; i++) {
            whirl_rotor *fitted = at_speed(speed + 1e-5 * i, true);
            const whirl_system *system = whirl_rotor_system(fitted);
            system->rhs(system->model, 0.0, forcing, x, slopes[i]);
            if (i == 0) respond(fitted, responses[0]);
            whirl_rotor_free(fitted);
        }
        worst = fmax(worst, apart(responses[0], responses[1]));
        for (size_t i = 0; i < 12; i++)
            jump = fmax(jump, fabs(slopes[1][i] - slopes[0][i]) / (1.0 + fabs(slopes[0][i])));
        whirl_rotor_free(linear);
    }
    check_within("Whirl in time",
                 "poles in proportion to the speed: part by which 41 responses differ from the linear study's", 0.0,
                 worst, 3e-3);
    check_within("Whirl in time", "the same: part by which the right-hand side changes between speeds 1e-5 rad/s apart",
                 0.0, jump, 1e-6);
}

/// An inertia that is a list of one number is that number.
static void inertia(void **state) {
    static table of;
    char list[TEXT] = "";
    double complex response[2][2];
    (void)state;
    tabulate(solid, 1000.0, &of);
    for (size_t i = 0; i < POINTS; i++) append(list, i, 2.5);
    for (int listed = 0; listed < 2; listed++) {
        whirl_design *design;
        whirl_rotor *rotor;
        const whirl_setting station[] = {{"mass", 10.0, NULL}, {"eccentricity", 2e-5, NULL}};
        const whirl_setting settings[] = {{"at", 0, "disc"},
                                          {"frequencies", 0, of.frequencies},
                                          {"kxx", 0, of.list[0]},
                                          {"cxx", 0, of.list[4]},
                                          {"mxx", listed ? 0 : 2.5, listed ? list : NULL}};
        require_ok(whirl_design_new(250.0, 1e-3, &design));
        require_ok(whirl_design_station(design, "disc", station, 2));
        require_ok(whirl_design_element(design, "bearing", settings, 5));
        whirl_design_in_time(design);
        require_ok(whirl_rotor_new(design, &rotor));
        whirl_design_free(design);
        respond(rotor, response[listed]);
        whirl_rotor_free(rotor);
    }
    const double w = 250.0, impedance = cabs(solid(I * w).m[0][0] - 12.5 * w * w);
    check_within("Whirl in time", "inertia in a list: part by which the response differs from that of a number", 0.0,
                 apart(response[1], response[0]), 1e-12);
    relative("inertia of 2.5 kg in addition to 10 kg: response along x, m", 10.0 * 2e-5 * w * w / impedance,
             1e-3 * cabs(response[0][0]), 1e-12);
}

// ---------------------------------------------------------------- five tilting pads

/// Returns the largest real part of the eigenvalues of the case's machine in time.
static double growth_at(const whirl_case *object, double q) {
    const double start[2 * MAX_DIMENSION] = {0.0};
    whirl_rotor *rotor;
    whirl_modes *modes;
    require_ok(whirl_case_rotor(object, "q", q, &rotor));
    assert_true(whirl_rotor_system(rotor)->frequency_count == 0 &&
                whirl_rotor_system(rotor)->dimension <= 2 * MAX_DIMENSION);
    require_ok(whirl_modes_new(whirl_rotor_system(rotor), start, &modes));
    const double growth = modes->growth;
    whirl_modes_free(modes);
    whirl_rotor_free(rotor);
    return growth;
}

/// For a mode that neither grows nor decays, the coefficients at its frequency are the impedance itself.
static void tilting_pads(void **state) {
    whirl_problems problems = {0};
    whirl_case *object;
    whirl_study study;
    whirl_result *result;
    double threshold = NAN, low = 0.0, high = 2e7;
    (void)state;
    require_ok(whirl_case_load(WHIRL_CASES "/tilting-pad-table.yaml", &problems, &object));
    require_ok(whirl_case_study(object, &study));
    study.batches[0] = study.batches[1]; // its modes
    study.batch_count = 1;
    require_ok(whirl_study_run(&study, &(whirl_run_options){.threads = 1}, &result));
    const whirl_table *critical = &result->tables[0];
    const whirl_field *field = whirl_layout_field(&critical->layout, WHIRL_FIELD_MODES_CRITICAL);
    for (size_t point = 0; point < critical->count; point++) {
        const double *row = whirl_table_field(critical, point, WHIRL_FIELD_MODES_CRITICAL, 0);
        for (size_t i = 0; i < field->rows; i++, row += field->columns)
            if (row[0] == WHIRL_ONSET) threshold = row[1];
    }
    for (int step = 0; step < 40; step++) {
        const double middle = 0.5 * (low + high);
        *(growth_at(object, middle) < 0.0 ? &low : &high) = middle;
    }
    relative("five tilting pads: cross coupling at which the machine in time loses its stability, by tables and by "
             "functions of four poles, N/m",
             threshold, low, 1e-4);
    whirl_result_free(result);
    whirl_case_free(object);
    whirl_problems_free(&problems);
}

// ---------------------------------------------------------------- no frequency in it

/// A table without dependence on frequency has the bits of one over the speed alone, and no states.
static void without_frequency(void **state) {
    whirl_rotor *rotor[2];
    double x[] = {0.3, -0.2, 0.7, 0.1}, slope[2][4];
    const double forcing[WHIRL_MAX_FORCING] = {1.0};
    (void)state;
    for (int whirls = 0; whirls < 2; whirls++) {
        whirl_design *design;
        const whirl_setting mass = {"mass", 10.0, NULL};
        const whirl_setting settings[] = {{"at", 0, "disc"},
                                          {"speeds", 0, "100, 400, 900"},
                                          {"kxx", 0, whirls ? "1e6, 1e6; 2e6, 2e6; 3e6, 3e6" : "1e6, 2e6, 3e6"},
                                          {"kxy", 0, whirls ? "7e5, 7e5; 5e5, 5e5; 4e5, 4e5" : "7e5, 5e5, 4e5"},
                                          {"cxx", 0, whirls ? "900, 900; 800, 800; 300, 300" : "900, 800, 300"},
                                          {"frequencies", 0, "50, 1000"}};
        require_ok(whirl_design_new(555.0, 1e-3, &design));
        require_ok(whirl_design_station(design, "disc", &mass, 1));
        require_ok(whirl_design_element(design, "bearing", settings, whirls ? 6 : 5));
        whirl_design_in_time(design);
        require_ok(whirl_rotor_new(design, &rotor[whirls]));
        whirl_design_free(design);
        const whirl_system *system = whirl_rotor_system(rotor[whirls]);
        assert_true(system->dimension == 4);
        system->rhs(system->model, 0.0, forcing, x, slope[whirls]);
    }
    check_holds("Whirl in time", "the same at all frequencies: the bits of a table over the speed alone",
                memcmp(slope[0], slope[1], sizeof slope[0]) == 0);
    whirl_rotor_free(rotor[0]);
    whirl_rotor_free(rotor[1]);
}

// ---------------------------------------------------------------- what is refused, and what is warned of

static void refused(void **state) {
    static table of;
    const disc fast = {1200.0, 10.0, 0.0, 0.0}, d = {300.0, 10.0, 0.0, 0.0};
    whirl_rotor *rotor;
    (void)state;
    tabulate(solid, 1000.0, &of);
    check_text(
        "Whirl in time", "a speed beyond the frequencies",
        "bearing is known at frequencies of whirl from 0 to 1000 rad/s, and the rotor turns at 1200 rad/s, which "
        "is the frequency of synchronous motions",
        build(&fast, &of, true, &rotor).message);
    snprintf(of.frequencies, sizeof of.frequencies, "0, 500, 1000");
    for (size_t i = 0; i < COEFFICIENTS; i++) snprintf(of.list[i], sizeof of.list[i], "0, 0, 0");
    snprintf(of.list[0], sizeof of.list[0], "1e6, 2e6, 1e6");
    const whirl_status status = build(&d, &of, true, &rotor);
    check_holds("Whirl in time", "a table that no function of so few points comes near",
                status.code == WHIRL_BAD_INPUT && strstr(status.message, "bearing differs from its table by ") &&
                    strstr(status.message,
                           " with the rational function of 0 poles that replaces the table in motions, "
                           "expected at most fit_error, 2 %: more poles, closer frequencies or a larger fit_error"));
}

/// Returns the result of a case with this bearing.
static whirl_result *result_with_bearing(const char *bearing) {
    static char text[WHOLE], problems[WHOLE];
    whirl_case *object = NULL;
    whirl_result *result = calloc(1, sizeof *result);
    snprintf(text, sizeof text,
             "whirl: 1\nrotor:\n  speed: 150 rad/s\n  length_scale: 1 mm\n  stations:\n    disc: {mass: 10 kg}\n"
             "  elements:\n    - bearing: {at: disc, %s}\nstudy:\n  response: {}\n",
             bearing);
    if (whirl_case_check(text, strlen(text), "case.yaml", problems, sizeof problems, &object).code != WHIRL_OK)
        fail_msg("%s", problems);
    assert_non_null(result);
    require_ok(whirl_case_describe_result(object, result));
    whirl_case_free(object);
    return result;
}

static void warned_of(void **state) {
    whirl_result *result =
        result_with_bearing("frequencies: [0, 50, 100, 150, 200, 250], kxx: [1e6, 1.01e6, 1.02e6, 1.03e6, "
                            "1.04e6, 1.05e6], kxy: 8e4, kyx: -8e4, cxx: 100");
    (void)state;
    check_holds("Whirl in time", "warned of: an instability beyond the table, where it has no numbers",
                strncmp(whirl_result_warning(result, 0),
                        "study.response: with the rational functions that replace "
                        "its bearings' tables in motions the machine is unstable, by ",
                        100) == 0 &&
                    strstr(whirl_result_warning(result, 0), "beyond the tables (0 Hz to 39.79 Hz)"));
    check_holds("Whirl in time", "reported: the fit and its error",
                strncmp(whirl_result_fit(result, 0), "bearing at disc: in time 4 poles, off its table by ", 50) == 0);
    whirl_result_free(result);
    result = result_with_bearing(
        "frequencies: [0, 200, 300, 390, 400, 410, 500, 1000], kxx: 1.6e6, cxx: [200, 200, 200, -50, -50, "
        "-50, 200, 200], poles: 0, fit_error: 50 %");
    check_holds("Whirl in time", "warned of: a mode that is stable by the function and unstable by the table",
                strstr(whirl_result_warning(result, 0), "one is stable, the other is not"));
    whirl_result_free(result);
    result = result_with_bearing(
        "frequencies: [0, 200, 400, 600, 800, 1000], kxx: 1.6e6, cxx: [200, 195, 190, 185, 180, 175]");
    check_holds("Whirl in time", "nothing to warn of", !*whirl_result_warning(result, 0));
    whirl_result_free(result);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(pad),
                                       cmocka_unit_test(response_at_speeds),
                                       cmocka_unit_test(free_decay),
                                       cmocka_unit_test(at_rest),
                                       cmocka_unit_test(tangent),
                                       cmocka_unit_test(over_speeds),
                                       cmocka_unit_test(inertia),
                                       cmocka_unit_test(tilting_pads),
                                       cmocka_unit_test(without_frequency),
                                       cmocka_unit_test(refused),
                                       cmocka_unit_test(warned_of)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
