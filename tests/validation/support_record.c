#include "support_record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support_check.h"
#include "support_flow.h"

whirl_record *record_motion(const whirl_system *system, const double *start, int steps_per_revolution, int transient,
                            int record) {
    whirl_integrate_options integrate = whirl_integrate_default();
    whirl_record_options options = whirl_record_default();
    whirl_record *recorded;
    integrate.steps_per_revolution = steps_per_revolution;
    options.transient = transient;
    options.record = record;
    options.watch = record;
    options.waveform = false;
    require_ok(whirl_record_motion(system, &integrate, &options, start, NULL, &recorded));
    return recorded;
}

void check_regime(const char *id, const char *what, const char *expected, const whirl_record *record) {
    const whirl_verdict verdict = whirl_judge(record);
    char name[64];
    whirl_verdict_name(&verdict, name, sizeof name);
    check_text(id, what, expected, name);
}

/// Finds the point of the orbit through `state` that is nearest to (x, y).
static void find_nearest(whirl_integrator *integrator, size_t n, const double *state, int period, double x, double y,
                         double nearest[2]) {
    double at[MAX_DIMENSION], best = INFINITY;
    memcpy(at, state, n * sizeof *at);
    for (int i = 0; i < period; i++) {
        const double distance = hypot(at[0] - x, at[1] - y);
        if (distance < best) {
            best = distance;
            memcpy(nearest, at, 2 * sizeof *nearest);
        }
        revolve(integrator, at, 1);
    }
}

void check_orbit(const char *id, const char *what, const whirl_record *record, whirl_integrator *integrator, int period,
                 const printed_point *points, size_t count, double *state) {
    memcpy(state, record->end, record->dimension * sizeof *state);
    find_fixed_point(integrator, record->dimension, state, period);
    for (size_t i = 0; i < count; i++) {
        double nearest[2] = {NAN, NAN};
        find_nearest(integrator, record->dimension, state, period, strtod(points[i].x, NULL), strtod(points[i].y, NULL),
                     nearest);
        check_digits(id, words("%s: x of point %zu", what, i + 1), points[i].x, nearest[0]);
        check_digits(id, words("%s: y of point %zu", what, i + 1), points[i].y, nearest[1]);
    }
}

void check_exponent(const char *id, const char *what, double expected, double tolerance, const whirl_record *record,
                    double unit_of_time) {
    const whirl_estimate exponent = whirl_lyapunov_largest(record);
    check_within(id, what, expected, exponent.value / unit_of_time, tolerance);
    check_within(id, words("%s: standard error", what), 0.0, exponent.error / unit_of_time, tolerance / 2.0);
}
