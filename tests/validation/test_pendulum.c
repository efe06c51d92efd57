// Fractal basin boundary of the forced damped pendulum, theta'' + .1 theta' + sin theta = 2.1 cos t (Ott, Basin of
// attraction, Scholarpedia 1(8):1701, 2006): which way it turns in the end, and how slowly the share of starts that an
// error of the start makes uncertain falls with this error. The dimension of the boundary is that of the plane less the
// exponent of this share (Grebogi, McDonald, Ott & Yorke 1983).
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
#include "whirl/engine/study.h"

static const double pi = 3.14159265358979323846, damping = 0.1, force = 2.1;

enum { ERRORS = 3, SOME = 2000, MANY = 6000 };

static const double errors[ERRORS] = {1e-2, 1e-4, 1e-6};

/// A share of `count` starts, and its standard error.
typedef struct share {
    double value, error;
} share;

static share share_of(size_t found, size_t count) {
    const double value = (double)found / (double)count;
    return (share){value, sqrt(value * (1.0 - value) / (double)count)};
}

/// Returns the exponent by which uncertain shares fall from the first error to the last, as if the shares were
/// independent.
static share exponent_of(const share *uncertain) {
    const share first = uncertain[0], last = uncertain[ERRORS - 1];
    const double decades = log(errors[0] / errors[ERRORS - 1]);
    return (share){log(first.value / last.value) / decades,
                   hypot(first.error / first.value, last.error / last.value) / decades};
}

/// Start number i, in the unit square that such starts fill evenly (Roberts' sequence).
static void place(size_t i, double *a, double *b) {
    double whole;
    *a = modf(0.5 + 0.7548776662466927 * (double)i, &whole);
    *b = modf(0.5 + 0.5698402909980532 * (double)i, &whole);
}

static void place_pendulum(size_t i, double *angle, double *rate) {
    place(i, angle, rate);
    *angle = pi * (2.0 * *angle - 1.0);
    *rate = 6.0 * *rate - 2.0;
}

static size_t starts(void) {
    return getenv("WHIRL_SOAK") ? MANY : SOME;
}

// ---------------------------------------------------------------- a map with a known dimension

/// Returns true if the map of Grebogi, McDonald, Ott & Yorke (1983) comes to rest at theta = 0, and not at pi.
static bool rests_at_zero(double theta, double x) {
    for (size_t i = 0; i < 100000; i++) {
        const double next = theta + 1.32 * sin(2.0 * theta) - 0.9 * sin(4.0 * theta) - x * sin(theta);
        x = -0.3 * cos(theta);
        theta = next;
        if (fabs(sin(theta)) < 1e-3 && fabs(x + 0.3 * cos(theta)) < 1e-3) return cos(theta) > 0.0;
    }
    fail_msg("the map did not come to rest");
    return false;
}

/// The estimate of this test finds the published dimension of a map.
static void estimate_finds_a_known_dimension(void **state) {
    enum { STARTS = 20000 };
    share uncertain[ERRORS];
    (void)state;
    for (size_t e = 0; e < ERRORS; e++) {
        size_t differ = 0;
        for (size_t i = 0; i < STARTS; i++) {
            double theta, x;
            place(i, &theta, &x);
            differ += rests_at_zero(2.0 * pi * theta, x - 0.5) != rests_at_zero(2.0 * pi * theta, x - 0.5 + errors[e]);
        }
        uncertain[e] = share_of(differ, STARTS);
    }
    check_digits("pendulum", "map of Grebogi & al. (1983): dimension, published (this test's estimate)", "1.8",
                 2.0 - exponent_of(uncertain).value);
}

// ---------------------------------------------------------------- brute force

enum { STEPS = 100, PERIODS = 1000, WAYS = 3 };

/// A motion of the pendulum and a perturbation of it.
typedef struct motion {
    double angle, rate, d_angle, d_rate;
} motion;

static motion slope(motion at, double forcing) {
    return (motion){at.rate, forcing - damping * at.rate - sin(at.angle), at.d_rate,
                    -damping * at.d_rate - cos(at.angle) * at.d_angle};
}

static motion along(motion from, motion slope, double h) {
    return (motion){from.angle + h * slope.angle, from.rate + h * slope.rate, from.d_angle + h * slope.d_angle,
                    from.d_rate + h * slope.d_rate};
}

/// Carries a motion over one period by RK4.
static motion period(motion at) {
    const double h = 2.0 * pi / STEPS;
    for (int i = 0; i < STEPS; i++) {
        const double t = h * i, middle = force * cos(t + 0.5 * h);
        const motion s1 = slope(at, force * cos(t)), s2 = slope(along(at, s1, 0.5 * h), middle),
                     s3 = slope(along(at, s2, 0.5 * h), middle), s4 = slope(along(at, s3, h), force * cos(t + h));
        at = along(along(along(along(at, s1, h / 6.0), s2, h / 3.0), s3, h / 3.0), s4, h / 6.0);
    }
    return at;
}

/// End of a motion: the way that it turns, the period in which that was clear, and the growth of a perturbation up to
/// every period.
typedef struct fate {
    int way, life;
    double growth[PERIODS];
} fate;

/// Follows a start until it has turned by once a period, to 1e-4, four times in a row.
static void follow(double angle, double rate, fate *end) {
    motion at = {angle, rate, 1.0, 0.3};
    double growth = 0.0;
    int again = 0;
    end->way = 0;
    for (end->life = 1; end->life < PERIODS; end->life++) {
        const double before = at.angle;
        at = period(at);
        const double turns = (at.angle - before) / (2.0 * pi), size = hypot(at.d_angle, at.d_rate);
        const int way = fabs(turns - 1.0) < 1e-4 ? 1 : fabs(turns + 1.0) < 1e-4 ? -1 : 0;
        at.d_angle /= size;
        at.d_rate /= size;
        end->growth[end->life] = growth += log(size);
        again = way != 0 && way == end->way ? again + 1 : 0;
        end->way = way;
        if (again == 3) return;
    }
    fail_msg("the pendulum did not settle from %g, %g", angle, rate);
}

/// Returns the exponent by how fast starts leave the motions between both ways, over how fast perturbations grow on
/// these (Kantz & Grassberger 1985): lives beyond 50 periods, which fall like a geometric series, and growth from
/// period 5 until 45 periods, most of them of settling, before the end of the lives beyond 75.
static share exponent_by_escape(size_t count) {
    fate end;
    double beyond = 0.0, rate = 0.0;
    size_t left = 0, long_lived = 0;
    for (size_t i = 0; i < count; i++) {
        double angle, speed;
        place_pendulum(i, &angle, &speed);
        follow(angle, speed, &end);
        if (end.life > 50) {
            left++;
            beyond += end.life - 51;
        }
        if (end.life > 75) {
            long_lived++;
            rate += (end.growth[end.life - 45] - end.growth[5]) / (end.life - 50);
        }
    }
    const double exponent = log1p((double)left / beyond) / (rate / (double)long_lived);
    return (share){exponent, exponent / sqrt((double)left)};
}

// ---------------------------------------------------------------- the library

/// The angle as a point of the unit circle, so that a pendulum that turns on and on returns; what the errors of steps
/// take away from the circle is brought back.
static void rhs(const void *model, double t, const double *forcing, const double *x, double *dx) {
    const double back = 1.0 - x[0] * x[0] - x[1] * x[1];
    (void)model;
    (void)forcing;
    dx[0] = back * x[0] - x[1] * x[2];
    dx[1] = back * x[1] + x[0] * x[2];
    dx[2] = force * cos(t) - damping * x[2] - x[1];
}

/// Its "x" is the rate, whose mean tells the way.
static const whirl_probe probe = {.name = "bob", .x = 2, .y = 0, .vx = 2, .vy = 0};

/// A pendulum with its start, and the system that it lends.
typedef struct pendulum {
    double start[3];
    whirl_system system;
} pendulum;

static whirl_status machine_at(const void *family, const whirl_batch *batch, double value, whirl_machine *machine) {
    pendulum *own = malloc(sizeof *own);
    (void)family;
    assert_non_null(own);
    *own = (pendulum){
        .start = {cos(value), sin(value), batch->second_value},
        .system = {.dimension = 3, .period = 2.0 * pi, .rhs = rhs, .probe_count = 1, .probes = &probe},
    };
    *machine = (whirl_machine){.system = &own->system, .start = own->start, .owner = own, .release = free};
    return whirl_ok();
}

/// Computes the basins of starts, in one row.
static whirl_result *run(const double *angles, const double *rates, size_t count) {
    static const char *const analyses[] = {"poincare", "orbit", "regime"};
    whirl_study study = {.batch_count = 1, .machine = machine_at};
    whirl_batch *batch = &study.batches[0];
    whirl_result *result;
    const whirl_run_options options = {.threads = 2};
    *batch = (whirl_batch){.name = "basin",
                           .role = WHIRL_ROLE_BASIN,
                           .parameter = "theta",
                           .second = "rate",
                           .count = count,
                           .row = count};
    batch->values = angles;
    batch->second_values = rates;
    batch->integrate = whirl_integrate_default();
    batch->integrate.steps_per_revolution = 128;
    batch->record = whirl_record_default();
    batch->record.transient = 400;
    batch->record.record = 20;
    batch->record.settle = true;
    for (size_t i = 0; i < 3; i++) assert_true(whirl_analysis_add(&batch->analyses, analyses[i]));
    whirl_analysis_needs(batch->analyses, &batch->record);
    require_ok(whirl_study_run(&study, &options, &result));
    return result;
}

/// Sets the starts, and after them the same with every error.
static void place_all(double *angles, double *rates, size_t count) {
    for (size_t i = 0; i < count; i++) {
        place_pendulum(i, &angles[i], &rates[i]);
        for (size_t e = 0; e < ERRORS; e++) {
            angles[(e + 1) * count + i] = angles[i] + errors[e];
            rates[(e + 1) * count + i] = rates[i];
        }
    }
}

/// Checks that two motions turn once a period, one each way, to the error of RK4 of 128 steps: (2 pi/128)^4 = 6e-6.
static void check_motions(const whirl_table *table, const whirl_attractor *found, size_t count) {
    check_within("pendulum", "pendulum: attractors", 2.0, (double)count, 0.0);
    const double one = *whirl_table_field(table, found[0].first, "orbit/mean", 0),
                 other = *whirl_table_field(table, found[1].first, "orbit/mean", 0);
    check_within("pendulum", "... turns in a period, of the one", 1.0, fabs(one), 1e-5);
    check_within("pendulum", "... of both together", 0.0, one + other, 1e-5);
    for (size_t k = 0; k < 2; k++) {
        const whirl_verdict verdict = whirl_table_verdict(table, found[k].first);
        assert_int_equal(WHIRL_PERIODIC, verdict.regime);
        assert_int_equal(1, verdict.period);
    }
}

/// Checks that the shares of uncertain starts are those of brute force, to two standard errors: errors of the steps,
/// 1e-6 a period, decide where a start near the boundary goes.
static void check_shares(const size_t *labels, const int *ways, size_t count, share *uncertain) {
    for (size_t e = 0; e < ERRORS; e++) {
        const size_t *moved = labels + (e + 1) * count;
        const int *moved_ways = ways + (e + 1) * count;
        size_t differ = 0, differ_by_force = 0;
        for (size_t i = 0; i < count; i++) {
            differ += labels[i] != moved[i];
            differ_by_force += ways[i] != moved_ways[i];
        }
        uncertain[e] = share_of(differ, count);
        check_within("pendulum", words("share of starts that an error of %.0e makes uncertain, brute force", errors[e]),
                     share_of(differ_by_force, count).value, uncertain[e].value,
                     2.0 * hypot(uncertain[e].error, share_of(differ_by_force, count).error));
    }
}

/// Both ways are found, every start leads to one of them, and the boundary between their basins has the dimension that
/// follows from how motions leave it, which is not the published one.
static void boundary_has_its_dimension(void **state) {
    const size_t count = starts(), all = (ERRORS + 1) * count;
    double *angles = malloc(all * sizeof *angles), *rates = malloc(all * sizeof *rates);
    size_t *labels = malloc(all * sizeof *labels), attractors, lost = 0;
    int *ways = malloc(all * sizeof *ways);
    whirl_attractor found[4];
    share uncertain[ERRORS];
    fate end;
    (void)state;
    assert_true(angles && rates && labels && ways);
    place_all(angles, rates, count);
    whirl_result *result = run(angles, rates, all);
    require_ok(whirl_table_attractors(&result->tables[0], labels, found, 4, &attractors));
    check_motions(&result->tables[0], found, attractors);
    for (size_t i = 0; i < all; i++) {
        lost += labels[i] == 0;
        follow(angles[i], rates[i], &end);
        ways[i] = end.way;
    }
    check_within("pendulum", "starts that lead to neither", 0.0, (double)lost, 0.0);
    check_shares(labels, ways, count, uncertain);
    const share exponent = exponent_of(uncertain), escape = exponent_by_escape(count);
    check_within("pendulum", "dimension of the boundary, by rates of escape and growth", 2.0 - escape.value,
                 2.0 - exponent.value, 2.0 * hypot(exponent.error, escape.error));
    note_within("pendulum", "... published", 1.8, 2.0 - exponent.value, 0.05);
    whirl_result_free(result);
    free(angles);
    free(rates);
    free(labels);
    free(ways);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(estimate_finds_a_known_dimension),
                                       cmocka_unit_test(boundary_has_its_dimension)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
