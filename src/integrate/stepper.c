// Steps: slopes, error, length, interpolant, and where a step must end.
#include "stepper.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bernstein.h"
#include "crossing.h"
#include "lanes.h"

static const double safety = 0.92, least_factor = 1.0 / 3.0, most_factor = 6.0;

static const double rk4_c[] = {0.0, 0.5, 0.5, 1.0, 1.0};
static const double rk4_a[][DOP853_SLOPES - 1] = {
    {0}, {0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}};

static double explicit_step(stepper *c, double h), longer(double error, double before), shorter(double error);
static void take_cubic(stepper *c), interpolate(stepper *c);

const formula dop853_formula = {.stages = DOP853_STAGES,
                                .c = dop853_c,
                                .a = dop853_a,
                                .adaptive = true,
                                .try_step = explicit_step,
                                .interpolate = interpolate,
                                .try_varied = stepper_try_varied,
                                .longer = longer,
                                .shorter = shorter};
const formula rk4_formula = {.stages = 4,
                             .c = rk4_c,
                             .a = rk4_a,
                             .try_step = explicit_step,
                             .interpolate = take_cubic,
                             .try_varied = stepper_try_varied};

/// |R(z)| of a formula, stage by stage on x' = z x from x = 1.
static double amplification(const formula *own, double real, double imaginary) {
    double re[DOP853_STAGES + 1], im[DOP853_STAGES + 1], x = 1.0, y = 0.0;
    for (int i = 0; i <= own->stages; i++) {
        x = 1.0;
        y = 0.0;
        for (int j = 0; j < i; j++) {
            x += own->a[i][j] * re[j];
            y += own->a[i][j] * im[j];
        }
        re[i] = real * x - imaginary * y;
        im[i] = real * y + imaginary * x;
    }
    return hypot(x, y);
}

double rk4_amplification(double real, double imaginary) {
    return amplification(&rk4_formula, real, imaginary);
}
double dop853_amplification(double real, double imaginary) {
    return amplification(&dop853_formula, real, imaginary);
}

stepper *stepper_new(const formula *own, size_t dimension, size_t switch_count,
                     const whirl_integrate_options *options) {
    const size_t rows = 5 + DOP853_SLOPES + DENSE + MAX_SLIDING + 3;
    const size_t own_room = own->room ? own->room(dimension) : 0;
    const size_t numbers = rows * dimension + (1 + SWITCH_ROWS) * switch_count + own_room;
    stepper *c = calloc(1, sizeof *c + numbers * sizeof(double) + switch_count * (sizeof(int) + sizeof(bool)));
    if (!c) return NULL;
    double *row = (double *)(c + 1);
    double **const parts[] = {&c->x, &c->start, &c->end, &c->stage, &c->scale};
    c->formula = own;
    c->dimension = dimension;
    c->rtol = options->rtol;
    c->atol = options->atol;
    c->limit = options->limit;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += dimension) *parts[i] = row;
    for (int i = 0; i < DOP853_SLOPES; i++, row += dimension) c->k[i] = row;
    for (int i = 0; i < DENSE; i++, row += dimension) c->dense[i] = row;
    c->work = row;
    c->sides = row + (MAX_SLIDING + 3) * dimension;
    c->at_switches = c->sides + switch_count;
    c->own = c->at_switches + SWITCH_ROWS * switch_count;
    c->held = (int *)(c->own + own_room);
    c->sliding = (bool *)(c->held + switch_count);
    return c;
}

// ---------------------------------------------------------------- one step

/// The weighted sum of the first `count` slopes; many weights are zero.
static void sum_slopes(const stepper *c, const double *weights, int count, double *restrict out) {
    memset(out, 0, c->dimension * sizeof *out);
    for (int j = 0; j < count; j++) {
        const double *restrict slope = c->k[j];
        const double weight = weights[j];
        if (weight == 0.0) continue;
        for (size_t d = 0; d < c->dimension; d++) out[d] += weight * slope[d];
    }
}

/// Slope `i` of the step from `start` of length h.
static void take_slope(const stepper *c, int i, double h) {
    sum_slopes(c, c->formula->a[i], i < DOP853_SLOPES - 1 ? i : DOP853_SLOPES - 1, c->stage);
    for (size_t d = 0; d < c->dimension; d++) c->stage[d] = c->start[d] + h * c->stage[d];
    stepper_slope(c, c->begin + c->formula->c[i] * h, c->stage, c->k[i]);
}

/// Lets coordinates count as large as the largest of them.
static void level(double *scale, const size_t *parts, size_t count) {
    double size = 0.0;
    for (size_t k = 0; k < count; k++) size = fmax(size, scale[parts[k]]);
    for (size_t k = 0; k < count; k++) scale[parts[k]] = size;
}

/// What an error of every coordinate is compared with, between the states a and b. A coordinate that passes zero is not
/// small for that: those of one probe, or of one of a rotor's groups, count together.
void stepper_set_scales(stepper *c, const double *a, const double *b) {
    const whirl_lanes *lanes = c->system->lanes;
    for (size_t d = 0; d < c->dimension; d++) c->scale[d] = fmax(fabs(a[d]), fabs(b[d]));
    for (size_t i = 0; !lanes && i < c->system->probe_count; i++) {
        const whirl_probe *probe = &c->system->probes[i];
        level(c->scale, (const size_t[]){probe->x, probe->y, probe->vx, probe->vy}, 4);
    }
    for (size_t g = 0; lanes && g < lanes->group_count; g++) {
        const size_t x = lanes->groups[g], y = lanes->groups[g + 1] - 1, n = lanes->degrees;
        level(c->scale, (const size_t[]){x, y, n + x, n + y}, 4);
    }
    for (size_t d = 0; d < c->dimension; d++) c->scale[d] = c->atol + c->rtol * c->scale[d];
}

/// The norm of the estimated error over the tolerance, of both embedded formulas as DOP853 weighs them; not a number
/// where the step leaves the equations' domain.
static double estimated_error(const stepper *c, double h) {
    double square5 = 0.0, square3 = 0.0, *e5 = c->work, *e3 = c->work + c->dimension;
    sum_slopes(c, dop853_e5, DOP853_STAGES, e5);
    sum_slopes(c, dop853_e3, DOP853_STAGES, e3);
    for (size_t d = 0; d < c->dimension; d++) {
        square5 += (e5[d] / c->scale[d]) * (e5[d] / c->scale[d]);
        square3 += (e3[d] / c->scale[d]) * (e3[d] / c->scale[d]);
    }
    const double mixed = square5 + 0.01 * square3;
    return mixed > 0.0 ? h * square5 / sqrt(mixed * (double)c->dimension) : mixed;
}

static double explicit_step(stepper *c, double h) {
    const int stages = c->formula->stages;
    for (int i = 1; i <= stages; i++) take_slope(c, i, h); // the last one at the step's end
    memcpy(c->end, c->stage, c->dimension * sizeof *c->end);
    for (size_t d = 0; d < c->dimension; d++)
        if (!isfinite(c->k[stages][d])) return NAN;
    if (!c->formula->adaptive) return 0.0;
    stepper_set_scales(c, c->start, c->end);
    return estimated_error(c, h);
}

/// Tries a step of length h from `start`, whose first slope is known: end, slope at the end and error.
static double try_step(stepper *c, double h) {
    c->length = h;
    c->tried++;
    return c->formula->try_step(c, h);
}

/// The same for the disturbances that go along: they are as sure as the state. Where they have no error that is a
/// number the state decides.
static double try_all(stepper *c, double h) {
    const double error = try_step(c, h);
    if (!(error <= 1.0)) return error;
    const double varied = c->formula->try_varied(c);
    return isfinite(varied) ? fmax(error, varied) : error;
}

/// The cubic by the states and slopes at both ends.
static void take_cubic(stepper *c) {
    const double h = c->length;
    const double *first = c->k[0], *last = c->k[c->formula->stages];
    for (size_t d = 0; d < c->dimension; d++) {
        const double way = c->end[d] - c->start[d];
        c->dense[0][d] = way;
        c->dense[1][d] = h * first[d] - way;
        c->dense[2][d] = 2.0 * way - h * (first[d] + last[d]);
    }
}

/// The interpolant of the step: a cubic, and what DOP853 adds to it by three more slopes (Hairer, Norsett, Wanner 1993,
/// II.6).
static void interpolate(stepper *c) {
    take_cubic(c);
    for (int i = DOP853_STAGES + 1; i < DOP853_SLOPES; i++) take_slope(c, i, c->length);
    for (int i = 0; i < DOP853_DENSE; i++) {
        sum_slopes(c, dop853_d[i], DOP853_SLOPES, c->dense[3 + i]);
        for (size_t d = 0; d < c->dimension; d++) c->dense[3 + i][d] *= c->length;
    }
}

void stepper_between(const stepper *c, double theta, double *x) {
    for (size_t d = 0; d < c->dimension; d++) {
        double sum = 0.0;
        for (int i = DENSE - 1; i >= 0; i--) sum = (sum + c->dense[i][d]) * (i % 2 == 0 ? theta : 1.0 - theta);
        x[d] = c->start[d] + sum;
    }
}

/// Proportional and integral control (Gustafsson 1991), err^(-3/32) times the error before to the power 1/16, which
/// settles at 0.92^32 = 0.07 of the tolerance; roots alone, so that it is the same everywhere.
static double longer(double error, double before) {
    const double sixteenth = sqrt(sqrt(sqrt(sqrt(fmax(error, 1e-8)))));
    return safety * sqrt(sqrt(sqrt(sqrt(before)))) / (sixteenth * sqrt(sixteenth));
}

static double shorter(double error) {
    return safety / sqrt(sqrt(sqrt(error)));
}

// ---------------------------------------------------------------- the first step

static double norm(const stepper *c, const double *v, const double *other) {
    double sum = 0.0;
    for (size_t d = 0; d < c->dimension; d++) {
        const double value = (v[d] - (other ? other[d] : 0.0)) / c->scale[d];
        sum += value * value;
    }
    return sqrt(sum / (double)c->dimension);
}

/// A length for the first step (Hairer, Norsett, Wanner 1993, II.4), from the size of the state, of its slope and of
/// the slope's change.
static double first_length(stepper *c) {
    stepper_set_scales(c, c->x, c->x);
    const double size = norm(c, c->x, NULL), slope = norm(c, c->k[0], NULL), period = c->system->period;
    double h = size < 1e-5 || slope < 1e-5 ? 1e-6 * period : 0.01 * size / slope;
    h = fmin(h, period);
    for (size_t d = 0; d < c->dimension; d++) c->stage[d] = c->x[d] + h * c->k[0][d];
    stepper_slope(c, h, c->stage, c->k[1]);
    const double most = fmax(slope, norm(c, c->k[1], c->k[0]) / h);
    const double longer = most > 1e-15 ? sqrt(sqrt(sqrt(0.01 / most))) : fmax(1e-6 * period, 1e-3 * h);
    return isfinite(longer) ? fmin(100.0 * h, longer) : h;
}

void stepper_place(stepper *c, const whirl_system *system, double t) {
    c->system = system;
    c->t = t;
    c->error = 1.0;
    c->switchings = 0;
    c->crossed = true;
}

whirl_motion stepper_begin(stepper *c, const whirl_system *system, const double *x) {
    stepper_place(c, system, 0.0);
    memcpy(c->x, x, c->dimension * sizeof *x);
    for (size_t d = 0; d < c->dimension; d++)
        if (!(fabs(x[d]) <= c->limit)) return WHIRL_DIVERGED; // NaN too
    stepper_find_sides(c);
    if (!c->formula->adaptive) return WHIRL_BOUNDED;
    stepper_slope(c, 0.0, c->x, c->k[0]);
    c->h = first_length(c);
    return WHIRL_BOUNDED;
}

// ---------------------------------------------------------------- steps that end at switches

static void observe(void *context, double theta, double *values) {
    stepper *c = context;
    stepper_between(c, theta, c->stage);
    stepper_guarded(c, c->begin + theta * c->length, c->stage, values);
}

/// Takes the step anew so that it ends where function `which` is zero: at theta of its length by the interpolant, then
/// nearer by what is left. Shares bend, most of all near the end of a contact: their slope is the last two steps'.
static void land(stepper *c, double theta, size_t which) {
    const int tries = c->sliding[which] ? 12 : 4;
    const double whole = c->length, nudge = 1e-4;
    double *after = stepper_row(c, ROW_TO), *before = stepper_row(c, ROW_FROM);
    observe(c, theta + nudge, after);
    observe(c, theta - nudge, before);
    double rate = (after[which] - before[which]) / (2.0 * nudge * whole);
    double h = theta * whole, last_h = h, last = 0.0;
    for (int i = 0; i < tries; i++) {
        try_step(c, h);
        stepper_guarded(c, c->begin + h, c->end, after);
        const double secant = (after[which] - last) / (h - last_h);
        if (c->sliding[which] && i > 0 && secant < 0.0) rate = secant;
        if (fabs(after[which]) <= stepper_reach(c, which, c->begin + h, c->end) || !(rate < 0.0)) break;
        const double nearer = h - after[which] / rate;
        if (!(nearer > 0.0 && nearer <= whole) || i == tries - 1) break;
        last_h = h;
        last = after[which];
        h = nearer;
    }
}

/// Whether all switching functions keep their signs by far, by their values and derivatives at both ends of the step.
static bool is_clear(stepper *c) {
    const double end = c->begin + c->length, *last = c->k[c->formula->stages];
    double *from = stepper_row(c, ROW_FROM), *to = stepper_row(c, ROW_TO);
    if (!c->system->switch_gradient || c->sliding_count > 0) return false;
    stepper_guarded(c, c->begin, c->start, from);
    stepper_guarded(c, end, c->end, to);
    for (size_t i = 0; i < c->system->switch_count; i++) {
        if (c->held[i] > 0 || !(from[i] > 0.0) || !(to[i] > 0.0)) return false;
        const double third = c->sides[i] * c->length / 3.0;
        const double rise = third * stepper_rate(c, i, c->begin, c->start, c->k[0]);
        if (bernstein_clear(from[i], from[i] + rise, to[i] - third * stepper_rate(c, i, end, c->end, last), to[i]) <
            0.5)
            return false;
    }
    return true;
}

/// The beginning of a step, up to a share of it.
typedef struct beginning {
    stepper *c;
    double share;
} beginning;

static void observe_beginning(void *context, double theta, double *values) {
    const beginning *part = context;
    observe(part->c, part->share * theta, values);
}

/// Near the end of a contact the share of a friction that is slid along runs off between the places at which a whole
/// step is looked at: looks at what comes before a zero once more, until nothing nearer is found.
static void look_closer(stepper *c, double *theta, size_t *which) {
    enum { LOOKS = 8 };
    const double same = 1.0 - 1e-9;
    double nearer;
    size_t other;
    for (int i = 0; i < LOOKS; i++) {
        beginning part = {c, *theta};
        const crossing_search search = {observe_beginning, &part, c->system->switch_count, c->held,
                                        stepper_row(c, ROW_SEARCH)};
        if (!crossing_first(&search, &nearer, &other) || !(nearer < same)) return;
        *theta *= nearer;
        *which = other;
    }
}

/// Where the step just tried must end; at its beginning where theta is 0.
static bool meets_switch(stepper *c, double *theta, size_t *which) {
    if (c->system->switch_count == 0 || is_clear(c)) {
        if (c->observed) c->formula->interpolate(c);
        return false;
    }
    const crossing_search search = {observe, c, c->system->switch_count, c->held, stepper_row(c, ROW_SEARCH)};
    c->formula->interpolate(c);
    if (!crossing_first(&search, theta, which)) return false;
    if (c->sliding_count > 0 && *theta > 0.0) look_closer(c, theta, which);
    return true;
}

/// Lets the motion go on at the end of the step.
static void go_on(stepper *c, double t) {
    c->t = t;
    memcpy(c->x, c->end, c->dimension * sizeof *c->x);
    memset(c->held, 0, c->system->switch_count * sizeof *c->held);
    if (c->sliding_count > 0) stepper_project(c, c->x);
}

/// A length for the step from t: no sliver is left before `until`.
static double next_length(const stepper *c, double until) {
    const double left = until - c->t;
    if (!c->formula->adaptive) return left;
    const double most = c->system->switch_count > 0 ? fmin(c->h, c->system->period / 8.0) : c->h;
    if (left <= most * 1.01) return left;
    return left < 2.0 * most ? 0.5 * left : most;
}

static whirl_motion judge(const stepper *c) {
    for (size_t d = 0; d < c->dimension; d++)
        if (!(fabs(c->x[d]) <= c->limit)) return WHIRL_DIVERGED; // NaN too
    return WHIRL_BOUNDED;
}

/// Tries steps, shorter and shorter, until one keeps the tolerance.
static whirl_motion accept(stepper *c, double until) {
    bool rejected = false;
    for (;;) {
        const double h = next_length(c, until);
        const double error = try_all(c, h);
        if (error <= 1.0) {
            if (!c->formula->adaptive) return WHIRL_BOUNDED;
            const double factor = fmin(most_factor, fmax(least_factor, c->formula->longer(error, c->error)));
            // A step cut short by `until` or by a rejection says little of how long the next may be.
            c->h = fmax(h < c->h && !rejected ? c->h : 0.0, h * (rejected ? fmin(factor, 1.0) : factor));
            c->error = fmax(error, 1e-4);
            return WHIRL_BOUNDED;
        }
        if (!c->formula->adaptive) return WHIRL_DIVERGED;
        const bool finite = isfinite(error);
        c->h = h * (finite ? fmax(least_factor, c->formula->shorter(error)) : 0.1);
        rejected = true;
        if (c->h < 16.0 * DBL_EPSILON * c->system->period) return finite ? WHIRL_STUCK : WHIRL_DIVERGED;
    }
}

whirl_motion stepper_step(stepper *c, double until) {
    for (;;) {
        double theta = 1.0;
        size_t which = 0;
        c->begin = c->t;
        memcpy(c->start, c->x, c->dimension * sizeof *c->x);
        if (c->crossed || c->sliding_count > 0) {
            stepper_slope(c, c->t, c->x, c->k[0]);
        } else {
            memcpy(c->k[0], c->k[c->formula->stages], c->dimension * sizeof *c->x);
        }
        for (size_t d = 0; d < c->dimension; d++)
            if (!isfinite(c->k[0][d])) return WHIRL_DIVERGED;
        const whirl_motion motion = accept(c, until);
        if (motion != WHIRL_BOUNDED) return motion;
        c->crossed = meets_switch(c, &theta, &which);
        if (!c->crossed) {
            stepper_vary(c);
            go_on(c, c->length < until - c->begin ? c->begin + c->length : until);
            return judge(c);
        }
        if (++c->switchings > MAX_SWITCHINGS) return WHIRL_STUCK;
        if (theta > 0.0) {
            land(c, theta, which);
            if (c->observed) c->formula->interpolate(c);
            c->formula->try_varied(c);
            stepper_vary(c);
            go_on(c, c->begin + c->length);
        }
        stepper_cross_varied(c, which);
        if (theta > 0.0) return judge(c);
    }
}
