#include "support_record.h"

#include <math.h>
#include <stdlib.h>

#include "support_check.h"

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

void check_section_point(const char *id, const char *what, const whirl_record *record, const char *x, const char *y) {
    const double at_x = strtod(x, NULL), at_y = strtod(y, NULL);
    const double *best = record->section;
    for (size_t i = 0; i < record->section_count; i++) {
        const double *point = record->section + i * record->dimension;
        if (hypot(point[0] - at_x, point[1] - at_y) <= hypot(best[0] - at_x, best[1] - at_y)) best = point;
    }
    check_digits(id, words("%s: x", what), x, best[0]);
    check_digits(id, words("%s: y", what), y, best[1]);
}

void check_exponent(const char *id, const char *what, double expected, double tolerance, const whirl_record *record,
                    double unit_of_time) {
    const whirl_estimate exponent = whirl_lyapunov_largest(record);
    check_within(id, what, expected, exponent.value / unit_of_time, tolerance);
    check_within(id, words("%s: standard error", what), 0.0, exponent.error / unit_of_time, tolerance / 3.0);
}
