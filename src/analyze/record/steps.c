#include "steps.h"

#include <math.h>
#include <stdio.h>

#include "section.h"

/// Error of a revolution, as a share of the size of the motion, from which on the computed motion is not the machine's
/// (wrong_error), or may not be (coarse_error).
static const double wrong_error = 0.1, coarse_error = 1e-2;

/// Error at which advised steps aim (good_error), and the tolerance with which the equations are integrated to measure
/// errors (seen_error).
static const double good_error = 1e-4, seen_error = 1e-5;

static bool are_unstable(double growth) {
    return whirl_step_is_unstable(&(whirl_step_check){.growth = growth});
}

// ---------------------------------------------------------------- looking

/// Adds the result of one revolution.
static void add_check(whirl_step_quality *all, const whirl_step_check *check, const whirl_integrate_options *integrate,
                      double size) {
    const double error = check->error / size;
    all->growth = fmax(all->growth, check->growth); // fmax ignores a NaN
    all->error = fmax(all->error, error);
    all->factor = fmax(all->factor, check->steps / integrate->steps_per_revolution);
    // The error is that of a method of order 4: a fourth root of the ratio gives the factor of the steps.
    if (error > coarse_error) all->factor = fmax(all->factor, sqrt(sqrt(fmin(error, 1e8) / good_error)));
}

static whirl_status look_at_bounded(const whirl_system *system, const whirl_integrate_options *integrate,
                                    whirl_record *record) {
    const size_t count = record->section_count, n = record->dimension;
    const double size = motion_size(record);
    const size_t starts[] = {count - 2, count / 2 - 1}; // the last revolution, and one in the middle
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sizeof starts / sizeof *starts && count >= 4 && status.code == WHIRL_OK; i++) {
        const double *start = record->section + starts[i] * n;
        whirl_step_check check;
        status = whirl_step_check_revolution(system, integrate, start, start + n, seen_error * size, &check);
        if (status.code == WHIRL_OK) add_check(&record->steps, &check, integrate, size);
    }
    return status;
}

/// Checks whether the exact equations leave the bounds, too, in the revolution in which the motion did.
static whirl_status look_at_diverged(const whirl_system *system, const whirl_integrate_options *integrate,
                                     whirl_record *record) {
    const double leaving = 0.1 * integrate->limit; // slow growth may be a revolution late
    whirl_step_check check;
    const whirl_status status = whirl_step_check_revolution(system, integrate, record->end, NULL, seen_error, &check);
    if (status.code != WHIRL_OK) return status;
    if (check.reach < leaving) check.error = INFINITY;
    add_check(&record->steps, &check, integrate, 1.0);
    return status;
}

/// Checks that a motion is large compared with the absolute tolerance, which bounds errors of single steps; those of a
/// revolution are several times as large. Measured with dop853 and rodas5p on a linear rotor: exponents err by 0.4 and
/// 4 % where the motion is 110 tolerances large; where it is one tolerance large, the computed motion is wrong.
static void look_at_tolerance(const whirl_integrate_options *integrate, whirl_record *record) {
    const double in_a_revolution = 10.0, size = motion_size(record);
    const double error = in_a_revolution * integrate->atol / size;
    if (record->motion != WHIRL_BOUNDED || record->rest.found || !(error > coarse_error)) return;
    record->steps.error = error;
    record->steps.factor = error / good_error;
}

whirl_status steps_look(const whirl_system *system, const whirl_integrate_options *integrate, whirl_record *record) {
    if (record->motion == WHIRL_STUCK) return whirl_ok();
    if (whirl_method_is_adaptive(integrate->method)) {
        look_at_tolerance(integrate, record);
        return whirl_ok();
    }
    return record->motion == WHIRL_BOUNDED ? look_at_bounded(system, integrate, record)
                                           : look_at_diverged(system, integrate, record);
}

// ---------------------------------------------------------------- weighing

void steps_weigh(whirl_verdict *verdict, const whirl_step_quality *steps) {
    const bool wrong = are_unstable(steps->growth) || steps->error > wrong_error;
    verdict->step_growth = steps->growth;
    verdict->step_error = steps->error;
    if (wrong) {
        verdict->regime = WHIRL_UNDETERMINED;
        verdict->period = verdict->curves = verdict->frequencies = 0;
        verdict->rests = verdict->settles = false;
        verdict->rotation = (double)NAN;
    }
    if (wrong || steps->error > coarse_error) {
        verdict->agreement = verdict->confidence = WHIRL_LOW;
        verdict->advice =
            (whirl_advice){isnan(steps->growth) ? WHIRL_TIGHTER : WHIRL_MORE_STEPS, fmax(steps->factor, 2.0)};
    }
}

bool steps_reason(const whirl_verdict *verdict, char *text, size_t size) {
    if (are_unstable(verdict->step_growth))
        snprintf(
            text, size,
            "the fixed step is unstable: it makes a perturbation %.3g times as large that the machine does not let "
            "grow; what it computed is no motion of the machine",
            verdict->step_growth);
    else if (verdict->step_error > wrong_error && isnan(verdict->step_growth))
        snprintf(text, size,
                 "the absolute tolerance (atol) is coarse for so small a motion: errors of a revolution may be %.2g of "
                 "its size",
                 verdict->step_error);
    else if (verdict->step_error > wrong_error)
        snprintf(text, size,
                 "the fixed steps are far too long: a revolution by them ends %.2g of the motion's size from where the "
                 "equations lead",
                 verdict->step_error);
    else
        return false;
    return true;
}
