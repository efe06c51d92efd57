// A run turn by turn: the first turn from standstill by time, from then on by the angle; machines whose torques depend
// on time, or whose stations twist, by time throughout. The run stops at the exact instants of events.
#include "run_motion.h"
#include "runup_state.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// A search for an instant ends when the interval has shrunk to this share of its first length.
static const double located = 1e-14;

static double runup_speed_of(const runner *r, const double *x) {
    return x[r->rotor] * r->unit;
}
static double runup_time_of(const runner *r, const double *x) {
    return x[r->rotor + 1] / r->unit;
}

/// Returns the angle, rad, and the speed, rad/s, of shaft k with a speed of its own.
static double runup_spool_angle(const runner *r, const double *x, size_t k) {
    return x[r->spool_state + 2 * k];
}
static double runup_spool_speed(const runner *r, const double *x, size_t k) {
    return x[r->spool_state + 2 * k + 1] * r->unit;
}

/// Returns the angle of the shaft in a state. With the angle as variable, returns that at the beginning of the turn.
static double runup_angle_of(const runner *r, const double *x) {
    return r->by_time ? x[r->rotor + 2] : r->angle0;
}

/// Sets how the shaft turns from now on, with the unbalances that have appeared.
static void runup_set_turning(runner *r, const whirl_turning *how) {
    r->machine->turn(r->machine, how);
    r->settings++;
}

/// Selects the machine `side` and the variable, time or angle.
static void runup_go_by(runner *r, size_t side, bool time) {
    r->settings++;
    r->side = side;
    r->machine = r->sides[side].machine;
    r->by_time = time;
    r->system = time ? r->machine->by_time : r->machine->by_angle;
    r->dimension = r->system->dimension;
}

/// Returns a state in the form with derivatives by the angle. If its derivatives are by time, the form is written to
/// workspace.
static const double *runup_placed(const runner *r, const double *x) {
    if (!r->by_time) return x;
    memcpy(r->placed, x, r->dimension * sizeof *x);
    r->machine->to_angle(r->machine, r->placed);
    return r->placed;
}

/// Returns the number of complete turns; 0 for a shaft that swings back at its beginning.
static double runup_whole_turns(const runner *r) {
    return fmax(floor(r->turns + 1e-9), 0.0);
}

static bool runup_stopped(const runner *r) {
    return whirl_stop_is_set(r->system->stop);
}

// ---------------------------------------------------------------- carrying

typedef struct sampler {
    runner *r;
    size_t next;
} sampler;

static void runup_keep_sample(void *context, double t, const double *x) {
    sampler *s = context;
    (void)t;
    memcpy(s->r->samples + s->next++ * s->r->dimension, x, s->r->dimension * sizeof *x);
}

/// Carries x over `length` of the variable; with the angle as variable, from the angle `from` on.
static whirl_motion runup_carry_part(runner *r, double from, double length, double *x) {
    if (length <= 0.0) return WHIRL_BOUNDED;
    r->machine->part(r->machine, from, length);
    return whirl_integrator_revolve(r->sides[r->side].part[r->by_time], x, NULL, NULL);
}

/// Carries `x` over a part of a turn like runup_carry_part, and keeps all samples.
static whirl_motion runup_carry_seen(runner *r, double from, double length, double *x) {
    sampler s = {r, 1};
    memcpy(r->samples, x, r->dimension * sizeof *x);
    r->machine->part(r->machine, from, length);
    return whirl_integrator_revolve(r->sides[r->side].seen[r->by_time], x, runup_keep_sample, &s);
}

/// Returns a quantity of a state. which: index of its station or switch, if the quantity belongs to one.
typedef double quantity(const runner *r, const double *x, size_t which);

/// Finds where a quantity reaches `target` on the way of `length` from `state`, which begins at the angle `from`. low,
/// high: values of the quantity at both ends, on different sides of the target. Uses regula falsi after Dowell and
/// Jarratt (1971, "Illinois"). Returns the length of the way up to the target; `there` receives the state.
static double runup_find_passage(runner *r, quantity *of, size_t which, double target, const double *state, double from,
                                 double length, double low, double high, double *there) {
    double a = 0.0, b = length, fa = low - target, fb = high - target, at = fa == 0.0 ? 0.0 : length;
    int side = 0;
    // Narrow the bracket: the secant's point, or the middle if that is outside.
    for (int i = 0; i < 80 && fa * fb < 0.0 && b - a > located * length; i++) {
        const double before = at;
        at = (a * fb - b * fa) / (fb - fa);
        if (!(at > a && at < b)) at = 0.5 * (a + b);
        // Carry the motion there, and see on which side of the target it is.
        memcpy(there, state, r->dimension * sizeof *there);
        if (runup_carry_part(r, from, at, there) != WHIRL_BOUNDED) break;
        const double f = of(r, there, which) - target;
        if (f == 0.0 || fabs(at - before) < located * length) return at;
        // Move the bracket's end; the value of an end that stays twice is halved.
        if ((f < 0.0) == (fb < 0.0)) {
            b = at, fb = f;
            if (side == -1) fa *= 0.5;
            side = -1;
        } else {
            a = at, fa = f;
            if (side == 1) fb *= 0.5;
            side = 1;
        }
    }
    // Give the state at the last place.
    memcpy(there, state, r->dimension * sizeof *there);
    runup_carry_part(r, from, at, there);
    return at;
}

// ---------------------------------------------------------------- what is seen of a part of a turn

/// Notes which coordinates the probes read, as whirl_probe_value does.
static void runup_find_probes(runner *r, const whirl_system *system) {
    for (size_t p = 0; p < r->watched; p++) {
        const whirl_probe *from = &system->probes[p];
        r->probe[p] = (runup_probe){.at = {from->x, from->y, from->vx, from->vy}};
        for (size_t nth = 0; nth < 4; nth++) {
            r->probe[p].unit[nth] = from->units ? from->units[nth] : 1.0;
            r->probe[p].sees[nth] = whirl_probe_sees(from, nth % 2);
        }
    }
}

/// Returns x, y, vx or vy (nth: 0 to 3) of a state at a station.
static inline double runup_value(const runner *r, const double *x, size_t probe, size_t nth) {
    const runup_probe *own = &r->probe[probe];
    return own->sees[nth] ? own->unit[nth] * x[own->at[nth]] : 0.0;
}

static double runup_radius_of(const runner *r, const double *x, size_t probe) {
    return hypot(runup_value(r, x, probe, 0), runup_value(r, x, probe, 1));
}

/// Returns the square of the radius, to rounding.
static double runup_radius_square(const runner *r, const double *x, size_t probe) {
    const double along_x = runup_value(r, x, probe, 0), along_y = runup_value(r, x, probe, 1);
    return along_x * along_x + along_y * along_y;
}

/// Returns half the slope of the squared radius by time.
static double runup_radial_slope(const runner *r, const double *x, size_t probe) {
    return runup_value(r, x, probe, 0) * runup_value(r, x, probe, 2) +
           runup_value(r, x, probe, 1) * runup_value(r, x, probe, 3);
}

/// Returns the size whose largest value is peak `which`: the radius of a station, or the displacement along or against
/// the axis, or the twist in either sense.
static double runup_peak_size(const runner *r, const double *x, size_t which) {
    if (which < r->probes) return runup_radius_of(r, x, which);
    const double along = runup_value(r, x, r->probes + (which - r->probes) / 2, 0);
    return (which - r->probes) % 2 == 0 ? -along : along;
}

/// Returns the slope of that size by time, or a positive multiple of the slope.
static double runup_peak_slope(const runner *r, const double *x, size_t which) {
    if (which < r->probes) return runup_radial_slope(r, x, which);
    const double along = runup_value(r, x, r->probes + (which - r->probes) / 2, 2);
    return (which - r->probes) % 2 == 0 ? -along : along;
}

static double runup_switch_of(const runner *r, const double *x, size_t which) {
    double values[WHIRL_MAX_SWITCHES];
    r->system->switches(r->system->model, 0.0, x, values);
    return values[which];
}

static const double *runup_sample(const runner *r, size_t k) {
    return r->samples + k * r->dimension;
}

/// Notes that sample k of a part has the largest size of a peak so far, with the samples around it.
static void runup_note_peak(runner *r, size_t which, double size, size_t k, size_t count, double from, double step) {
    const size_t before = k > 0 ? k - 1 : 0, after = k < count ? k + 1 : count;
    r->run->peaks[which] =
        (runup_peak){size, runup_time_of(r, runup_sample(r, k)), runup_speed_of(r, runup_sample(r, k))};
    memcpy(r->peak_state + which * r->most, runup_sample(r, before), r->dimension * sizeof *r->x);
    r->peak_where[which] = (runup_where){r->side, r->by_time, r->lost_count, r->how};
    r->peak_from[which] = from + (double)before * step;
    r->peak_length[which] = (double)(after - before) * step;
}

/// Notes the least and largest axial displacements and twists in a part, and the states around those that are the least
/// and largest so far.
static void runup_see_extras(runner *r, double from, double step, size_t count) {
    for (size_t which = r->probes; which < r->peaks; which++) {
        runup_station *own = &r->stations[r->probes + (which - r->probes) / 2];
        for (size_t k = 0; k <= count; k++) {
            const double size = runup_peak_size(r, runup_sample(r, k), which);
            if ((which - r->probes) % 2 == 0)
                own->least = fmin(own->least, -size);
            else
                own->largest = fmax(own->largest, size);
            if (size > r->run->peaks[which].radius) runup_note_peak(r, which, size, k, count, from, step);
        }
    }
}

/// Notes the largest radii in a part, and the states around the radii which are the largest so far.
static void runup_see_radii(runner *r, double from, double step, size_t count) {
    for (size_t p = 0; p < r->probes; p++)
        for (size_t k = 1; k <= count; k++) {
            const runup_peak *peak = &r->run->peaks[p];
            // A radius that is certainly not the largest of the turn needs no square root.
            const double known = fmin(r->stations[p].radius, peak->radius);
            if (runup_radius_square(r, runup_sample(r, k), p) < (1.0 - 1e-12) * known * known) continue;
            const double radius = runup_radius_of(r, runup_sample(r, k), p);
            r->stations[p].radius = fmax(r->stations[p].radius, radius);
            if (radius > peak->radius) runup_note_peak(r, p, radius, k, count, from, step);
        }
}

/// Returns when a contact closed or opened between two samples.
static double runup_find_change(runner *r, size_t contact, const double *state, double from, double length) {
    double *there = r->scratch;
    const size_t which = r->machine->contact_switch(r->machine, contact);
    memcpy(there, state, r->dimension * sizeof *there);
    const double low = runup_switch_of(r, there, which);
    if (runup_carry_part(r, from, length, there) != WHIRL_BOUNDED) return runup_time_of(r, state);
    const double high = runup_switch_of(r, there, which);
    // A damped contact lets go before its gap opens: then the instant is known only to the distance of samples.
    if (!(low * high < 0.0)) return runup_time_of(r, there);
    runup_find_passage(r, runup_switch_of, which, 0.0, state, from, length, low, high, there);
    return runup_time_of(r, there);
}

static void runup_see_contacts(runner *r, double from, double step, size_t count) {
    for (size_t k = 0; k <= count && r->contacts > 0; k++)
        r->machine->contacts(r->machine, runup_placed(r, runup_sample(r, k)), r->force + k * r->contacts);
    for (size_t c = 0; c < r->contacts; c++) {
        runup_contact *own = &r->run->contacts[c];
        for (size_t k = 0; k < count; k++) {
            const bool before = r->force[k * r->contacts + c] > 0.0, after = r->force[(k + 1) * r->contacts + c] > 0.0;
            const double begin = runup_time_of(r, runup_sample(r, k)), end = runup_time_of(r, runup_sample(r, k + 1));
            double closed = before && after ? end - begin : 0.0;
            r->largest[c] = fmax(r->largest[c], r->force[(k + 1) * r->contacts + c]);
            if (before != after) {
                const double at = runup_find_change(r, c, runup_sample(r, k), from + (double)k * step, step);
                closed = after ? end - at : at - begin;
                if (after) own->count += 1.0;
                if (after && isnan(own->first)) own->first = at;
                if (!after) own->last = at;
            }
            own->time += closed;
            r->share[c] += closed;
        }
    }
}

/// Returns the weight of sample k in an integral over equal steps, of the order 6 at both ends (Gregory).
static double runup_weight(size_t k, size_t count) {
    static const double ends[] = {95.0 / 288.0, 317.0 / 240.0, 23.0 / 30.0, 793.0 / 720.0, 157.0 / 160.0};
    const size_t from_end = k < count - k ? k : count - k;
    return from_end < sizeof ends / sizeof *ends ? ends[from_end] : 1.0;
}

// ---------------------------------------------------------------- a copy that began nearby

bool runup_wants_copy(const whirl_runup_options *o, size_t contacts) {
    return strcmp(o->sensitivity, "yes") == 0 || (contacts > 0 && strcmp(o->sensitivity, "contacts") == 0);
}

/// Returns the distance to be given to the copy: a hundred times the tolerance, so that the copy's own errors do not
/// count, and small against the motion.
static double runup_copy_distance(const runner *r) {
    return fmin(1e-3, 100.0 * r->plan->options->rtol) * fmax(r->size, 1e-6);
}

/// Measures the distance of the copy: places and velocities of all stations, with those along shafts, and the speed.
static double runup_measure_copy(const runner *r) {
    const double speed = r->size * (r->copy[r->rotor] - r->x[r->rotor]);
    double sum = speed * speed;
    for (size_t p = 0; p < r->watched; p++)
        for (size_t nth = 0; nth < 4; nth++) {
            const double apart = runup_value(r, r->copy, p, nth) - runup_value(r, r->x, p, nth);
            sum += apart * apart;
        }
    return sqrt(sum);
}

/// Places the copy again: multiplies its distance from the motion by a factor. With a factor of 0, displaces all
/// coordinates of the rotor anew.
static void runup_place_copy(runner *r, double factor) {
    const double apart = runup_copy_distance(r);
    for (size_t i = 0; i < r->dimension; i++)
        if (factor > 0.0)
            r->copy[i] = r->x[i] + factor * (r->copy[i] - r->x[i]);
        else
            r->copy[i] = r->x[i] + (i < r->rotor ? apart / (double)(1 + 7 * i % 5) : 0.0);
    if (!r->how.driven) r->copy[r->rotor] = r->x[r->rotor];
    for (size_t k = 0; k < r->spools; k++)
        if (r->how.spools[k].law != WHIRL_SPOOL_DRIVEN)
            memcpy(r->copy + r->spool_state + 2 * k, r->x + r->spool_state + 2 * k, 2 * sizeof *r->x);
    if (r->spools > 0) r->machine->follow(r->machine, r->copy);
    r->copy[r->rotor + 1] = r->x[r->rotor + 1];
}

/// Carries the copy over a part of a turn that the run has completed.
static void runup_carry_copy(runner *r, double from, double length) {
    if (r->copy && runup_carry_part(r, from, length, r->copy) != WHIRL_BOUNDED) r->copy = NULL;
}

/// Notes by how much the copy's distance, relative to the motion, has grown since the last call, and rescales the
/// distance.
static void runup_compare_copy(runner *r) {
    if (!r->copy) return;
    double *found = r->run->sensitivity;
    const double apart = runup_measure_copy(r), time = runup_time_of(r, r->x);
    for (size_t p = 0; p < r->probes; p++) r->size = fmax(r->size, r->stations[p].radius);
    const double wanted = runup_copy_distance(r);
    if (!isfinite(apart)) {
        r->copy = NULL;
        return;
    }
    r->growth += log(fmax(apart, 1e-9 * wanted) / wanted);
    if (r->growth < r->least) r->least = r->growth, r->least_at = time;
    if (r->growth - r->least > found[0]) {
        found[0] = r->growth - r->least, found[1] = r->least_at, found[2] = time;
        if (isnan(found[3]) && found[0] > log(1e-3 / r->plan->options->rtol)) found[3] = time;
    }
    runup_place_copy(r, apart > 0.0 ? wanted / apart : 0.0);
}

/// Fills in the weight of a sample in means, and its factors in orders, 2 exp(-i k angle). share: of the sample in a
/// turn.
static void runup_fill_weights(runup_weights *of, double share, double angle) {
    const double complex turn = cexp(-I * angle);
    double complex turned = 2.0;
    of->share = share;
    for (size_t order = 0; order < RUNUP_ORDERS; order++) {
        turned *= turn;
        of->turned[order] = turned;
    }
}

/// Finds the weights of the samples of a part. With the angle as variable the weights of a whole turn are always the
/// same.
static void runup_find_weights(runner *r, double passed, double step, size_t count) {
    if (!r->by_time && r->weights_passed == passed && r->weights_step == step) return;
    r->weights_passed = r->by_time ? (double)NAN : passed;
    r->weights_step = step;
    for (size_t k = 0; k <= count; k++) {
        const double *sample = runup_sample(r, k);
        const double length = step * (r->by_time ? sample[r->rotor] : 1.0);
        const double angle = passed + (r->by_time ? sample[r->rotor + 2] - r->samples[r->rotor + 2] : (double)k * step);
        runup_fill_weights(&r->weights[k], runup_weight(k, count) * length / two_pi, angle);
    }
}

/// Adds sample k of a part to the means and orders of station p.
static void runup_add_sample(const runner *r, size_t k, size_t p, const runup_weights *of, runup_station *to) {
    const double x = of->share * runup_value(r, runup_sample(r, k), p, 0);
    const double y = of->share * runup_value(r, runup_sample(r, k), p, 1);
    to->mean[0] += x;
    to->mean[1] += y;
    for (size_t order = 0; order < RUNUP_ORDERS; order++) {
        to->x[order] += of->turned[order] * x;
        to->y[order] += of->turned[order] * y;
    }
}

/// Adds a part of a turn, of samples that are `step` apart, to the means and orders; `passed`: the angle of its first
/// sample within the turn.
static void runup_add_orders(runner *r, double passed, double step, size_t count) {
    runup_find_weights(r, passed, step, count);
    for (size_t p = 0; p < r->watched; p++)
        for (size_t k = 0; k <= count; k++) runup_add_sample(r, k, p, &r->weights[k], &r->stations[p]);
}

/// Adds a part to the means and orders of the shafts with a speed of their own, over their angles.
static void runup_add_spool_orders(runner *r, double step, size_t count) {
    for (size_t spool = 0; spool < r->spools; spool++)
        for (size_t k = 0; k <= count; k++) {
            const double *sample = runup_sample(r, k);
            const double passed = step * runup_spool_speed(r, sample, spool) / r->unit;
            runup_weights of;
            runup_fill_weights(&of, runup_weight(k, count) * passed / two_pi, runup_spool_angle(r, sample, spool));
            for (size_t p = 0; p < r->probes; p++)
                runup_add_sample(r, k, p, &of, &r->spool_stations[spool * r->probes + p]);
        }
}

// ---------------------------------------------------------------- torques

/// Passes on the watched torques of a sample.
static void runup_watch(const runner *r, const double *x) {
    const double *placed = runup_placed(r, x);
    r->machine->watch(r->machine, placed, runup_angle_of(r, x), r->torque);
}

/// Notes a sample of torques: extremes, and the samples around them.
static void runup_note_torques(runner *r, double step, size_t k, size_t count) {
    const double time = runup_time_of(r, runup_sample(r, k));
    for (size_t t = 0; t < r->torques; t++)
        for (size_t side = 0; side < 2; side++) {
            runup_extreme *own = side == 0 ? &r->run->torques[t].largest : &r->run->torques[t].least;
            if (side == 0 ? !(r->torque[t] > own->value) : !(r->torque[t] < own->value)) continue;
            const size_t before = k > 0 ? k - 1 : 0, after = k < count ? k + 1 : count;
            *own = (runup_extreme){r->torque[t], time};
            memcpy(r->torque_state + (2 * t + side) * r->most, runup_sample(r, before), r->dimension * sizeof *r->x);
            r->torque_length[2 * t + side] = (double)(after - before) * step;
            r->torque_where[2 * t + side] = (runup_where){r->side, r->by_time, r->lost_count, r->how};
        }
}

static void runup_see_torques(runner *r, double step, size_t count) {
    if (r->torques == 0) return;
    for (size_t k = 0; k <= count; k++) {
        const double *sample = runup_sample(r, k);
        const double *placed = runup_placed(r, sample);
        r->machine->watch(r->machine, placed, runup_angle_of(r, sample), r->torque);
        r->machine->speeds(r->machine, placed, r->speed);
        runup_note_torques(r, step, k, count);
        if (r->plan->watch) r->plan->watch(r->plan->context, runup_time_of(r, sample), r->torque, r->speed);
    }
}

/// Returns the slope of a torque by time, from a difference along the motion.
static double runup_torque_slope(const runner *r, const double *x, size_t which) {
    double values[2], *slope = r->change, *next = r->change + r->most;
    const double apart = 1e-2 * r->torque_length[which];
    r->system->rhs(r->system->model, 0.0, NULL, x, slope);
    for (size_t side = 0; side < 2; side++) {
        for (size_t i = 0; i < r->dimension; i++) next[i] = x[i] + (side == 0 ? -apart : apart) * slope[i];
        runup_watch(r, next);
        values[side] = r->torque[which / 2];
    }
    return (values[1] - values[0]) / (2.0 * apart);
}

// ---------------------------------------------------------------- turns that are seen

/// Writes the torques on the shaft in a sample, at that angle of the shaft, then the watched ones, and those of all
/// shafts of a machine with several.
static void runup_fill_torques_at(const runner *r, const double *sample, double angle, double *out) {
    const double *placed = runup_placed(r, sample);
    const turn_samples *to = r->plan->samples;
    whirl_torques found;
    if (to->torques > 0) {
        r->machine->torques(r->machine, placed, angle, &found);
        runup_list_torques(&found, out);
        if (r->torques > 0) r->machine->watch(r->machine, placed, angle, out + RUNUP_SHAFT_TORQUES);
    }
    if (to->shafts == 0) return;
    whirl_shaft_torques shafts[WHIRL_MAX_RUN_SHAFTS];
    r->machine->shaft_torques(r->machine, placed, angle, shafts);
    for (size_t k = 0; k < to->shafts; k++) runup_list_shaft(&shafts[k], out + to->torques + RUNUP_SHAFT_NUMBERS * k);
}

/// Fills in an instant of a turn from a sample, at that angle of the shaft.
static void runup_fill_instant(const runner *r, const double *sample, const double *force, double angle,
                               turn_instant *out) {
    double *numbers = out->numbers, *slopes = out->slopes;
    // Velocities by time are derivatives by the angle times the speed.
    const double faster = r->by_time ? 1.0 : sample[r->rotor];
    out->speed = runup_speed_of(r, sample);
    *numbers++ = runup_time_of(r, sample);
    for (size_t p = 0; p < r->watched; p++)
        for (size_t axis = 0; axis < 2; axis++) {
            *numbers++ = runup_value(r, sample, p, axis);
            *slopes++ = r->unit * faster * runup_value(r, sample, p, axis + 2);
        }
    for (size_t c = 0; c < r->contacts; c++) {
        *numbers++ = force[c];
        *numbers++ = -runup_switch_of(r, sample, r->machine->contact_switch(r->machine, c));
    }
    if (r->plan->samples->torques + r->plan->samples->shafts > 0) runup_fill_torques_at(r, sample, angle, numbers);
}

/// Keeps the instants of a part at equal angles of the turn. from: angle of its beginning, with the angle as variable.
static void runup_keep_instants(runner *r, double from, double passed, double step, size_t count) {
    turn_samples *to = r->plan->samples;
    for (size_t k = 0; k <= count; k++) {
        const double *sample = runup_sample(r, k);
        turn_instant *own = &to->ends[k % 2];
        own->angle = passed + (r->by_time ? sample[r->rotor + 2] - r->samples[r->rotor + 2] : (double)k * step);
        runup_fill_instant(r, sample, r->force + k * r->contacts,
                           r->by_time ? sample[r->rotor + 2] : from + (double)k * step, own);
        if (k > 0) turn_samples_fill(to, &to->ends[(k - 1) % 2], own);
    }
}

/// Returns true if the part that was carried has instants of the motion of a record.
static bool runup_has_instants(const runner *r) {
    const whirl_run_motion *to = r->plan->motion;
    const double end = runup_time_of(r, runup_sample(r, (size_t)r->plan->options->samples));
    return to && run_motion_reaches(to, end);
}

/// Finds the slopes of all samples of a part, by the equations.
static void runup_find_slopes(runner *r, double from, double length) {
    const size_t count = (size_t)r->plan->options->samples;
    r->machine->part(r->machine, from, length);
    for (size_t k = 0; k <= count; k++)
        r->system->rhs(r->system->model, r->by_time ? 0.0 : (double)k * length / (double)count, NULL,
                       runup_sample(r, k), r->slopes + k * r->most);
}

/// Describes a sample of a part, which begins at the angle `passed` within the turn.
static motion_node runup_node(const runner *r, size_t k, double passed, double step) {
    const double *sample = runup_sample(r, k), *slope = r->slopes + k * r->most;
    const double angle = r->angle0 + two_pi * runup_whole_turns(r) + passed + (double)k * step;
    return (motion_node){.state = sample,
                         .slope = slope,
                         .time = runup_time_of(r, sample),
                         .angle = r->by_time ? sample[r->rotor + 2] : angle,
                         .speed = sample[r->rotor],
                         .rate = slope[r->rotor] * (r->by_time ? 1.0 : sample[r->rotor]),
                         .by_time = r->by_time};
}

/// Fills in the instants of the motion of a record up to the end of a part, whose slopes are known.
static void runup_fill_motion(runner *r, double passed, double step, size_t count) {
    for (size_t k = 0; k < count; k++) {
        const motion_node low = runup_node(r, k, passed, step), high = runup_node(r, k + 1, passed, step);
        run_motion_fill(r->plan->motion, r->system->probes, &low, &high, 1.0 / r->unit);
    }
}

/// Returns the interpolation error of a record's motion between the samples of a part by the angle, as a share of the
/// motion. Every second sample is compared with the interpolation between its neighbours, whose distance is twice that
/// of the samples: the error of the sixth order is divided by 64.
static double runup_motion_error(const runner *r, double step, size_t count) {
    enum { HALVED = 64 }; // two to the sixth power
    double largest = 0.0, size = 0.0;
    for (size_t k = 1; k < count; k += 2) {
        const motion_node low = runup_node(r, k - 1, 0.0, step), middle = runup_node(r, k, 0.0, step);
        const motion_node high = runup_node(r, k + 1, 0.0, step);
        const double error = run_motion_error(r->probes, r->system->probes, &low, &middle, &high, 1.0 / r->unit, &size);
        largest = fmax(largest, error);
    }
    return size > 0.0 ? largest / HALVED / size : 0.0;
}

/// Returns true if the samples of a part by the angle are too far apart for the motion of a record. The part must then
/// be carried again, divided into shorter parts.
static bool runup_is_coarse(runner *r) {
    enum { SHORTEST = 16 }; // of a turn
    const size_t count = (size_t)r->plan->options->samples;
    if (r->by_time || !runup_has_instants(r)) return false;
    runup_find_slopes(r, r->from, r->length);
    const double error = runup_motion_error(r, r->length / (double)count, count);
    const double allowed = fmax(10.0 * r->plan->options->rtol, 1e-10);
    const bool coarse = error > allowed && r->length > 1.01 * two_pi / SHORTEST;
    r->leg = coarse ? 0.5 * r->length : error > allowed / 64.0 ? r->length : 2.0 * r->length;
    return coarse;
}

/// Evaluates a part of a turn. from: angle of its beginning (0 with time as variable); passed: the angle of its
/// beginning within the turn.
static void runup_see_part(runner *r, double from, double passed, double length) {
    const size_t count = (size_t)r->plan->options->samples;
    const double step = length / (double)count;
    runup_see_radii(r, from, step, count);
    runup_see_extras(r, from, step, count);
    runup_see_contacts(r, from, step, count);
    runup_see_torques(r, step, count);
    runup_add_orders(r, passed, step, count);
    if (r->spools > 0) runup_add_spool_orders(r, step, count);
    if (r->plan->samples) runup_keep_instants(r, from, passed, step, count);
    if (!runup_has_instants(r)) return;
    if (r->by_time || length != r->length) runup_find_slopes(r, from, length);
    runup_fill_motion(r, passed, step, count);
}

static void runup_begin_turn(runner *r) {
    r->parted = false;
    for (size_t p = 0; p < r->probes; p++) r->stations[p] = (runup_station){.radius = 0.0};
    for (size_t p = r->probes; p < r->watched; p++)
        r->stations[p] = (runup_station){.least = (double)INFINITY, .largest = -(double)INFINITY};
    for (size_t c = 0; c < r->contacts; c++) r->largest[c] = r->share[c] = 0.0;
}

static void runup_show_turn(runner *r, bool whole) {
    const double end = runup_time_of(r, r->x), begin = runup_time_of(r, r->begin);
    runup_turn turn = {.time = 0.5 * (begin + end),
                       .speed = whole ? two_pi / (end - begin) : runup_speed_of(r, r->x),
                       .end = end,
                       .turns = r->turns,
                       .whole = whole,
                       .parted = r->parted,
                       .stations = r->stations,
                       .force = r->largest,
                       .share = r->share,
                       .samples = whole && r->plan->samples ? r->plan->samples->numbers : NULL};
    for (size_t c = 0; c < r->contacts; c++) r->share[c] = end > begin ? r->share[c] / (end - begin) : 0.0;
    r->machine->torques(r->machine, runup_placed(r, r->x), runup_angle_of(r, r->x), &turn.torques);
    if (r->plan->see) r->plan->see(r->plan->context, &turn);
}

// ---------------------------------------------------------------- events

/// Kinds of coming events.
enum {
    EVENT_NONE,
    EVENT_TURN,
    EVENT_END,
    EVENT_DWELL,
    EVENT_CORNER, ///< corner of the speed table
    EVENT_TORQUE,
    EVENT_SPOOL,                                        ///< a turn of the first shaft with a speed of its own ends
    EVENT_SPOOL_DWELL = EVENT_SPOOL + WHIRL_MAX_SPOOLS, ///< its rate ends
    EVENT_FIRST = EVENT_SPOOL_DWELL + WHIRL_MAX_SPOOLS  ///< the first of the run's own events; others follow
};

/// Maximum number of conditions that may come true: five of the run (end by time, end by speed, a corner, a turn, a
/// torque), two of every shaft with a speed of its own (a turn; a corner or the end of a rate), three of every event
/// (two besides its formula).
enum { MAX_COMING = 5 + 2 * WHIRL_MAX_SPOOLS + 3 * RUNUP_EVENTS };

/// Something that happens when a quantity passes a target, rising (1), falling (-1) or both (0).
typedef struct coming {
    int what; ///< an event
    quantity *of;
    double target;
    size_t which; ///< index of the quantity
    int passing;
} coming;

static double runup_time_quantity(const runner *r, const double *x, size_t which) {
    (void)which;
    return runup_time_of(r, x);
}
/// Returns the speed of the motor's station if it twists, otherwise of the shaft. which: from 1, a shaft with a speed
/// of its own.
static double runup_speed_quantity(const runner *r, const double *x, size_t which) {
    if (which > 0) return runup_spool_speed(r, x, which - 1);
    if (r->machine->driver >= r->probes) return runup_speed_of(r, x);
    r->machine->speeds(r->machine, runup_placed(r, x), r->speed);
    return r->speed[r->machine->driver];
}

static double runup_spool_angle_quantity(const runner *r, const double *x, size_t which) {
    return runup_spool_angle(r, x, which);
}

static double runup_angle_quantity(const runner *r, const double *x, size_t which) {
    (void)which;
    return x[r->rotor + 2];
}

/// Sets the variables of axial displacements and twists. rate: m/s of one unit of velocity.
static void runup_extra_variables(const runner *r, const double *x, double rate) {
    const whirl_run_course *course = r->plan->course;
    for (size_t i = 0; i < r->system->extra_count; i++) {
        const whirl_extra *extra = &r->system->extras[i];
        const whirl_probe *probe = &r->system->probes[r->probes + i];
        double *variable = course->variables + WHIRL_VARIABLE_STATIONS + WHIRL_OF_STATION * extra->station;
        if (extra->twists) {
            variable[WHIRL_OF_STATION_TWIST] = whirl_probe_value(probe, x, 0);
        } else {
            variable[WHIRL_OF_STATION_AXIAL] = course->length * whirl_probe_value(probe, x, 0);
            variable[WHIRL_OF_STATION_AXIAL_VELOCITY] = rate * whirl_probe_value(probe, x, 2);
        }
    }
}

/// Returns the value of the formula of an event of the course, or a value far from the target where it has none.
static double runup_formula_quantity(const runner *r, const double *x, size_t which) {
    const whirl_run_course *course = r->plan->course;
    // Velocities by time are derivatives by the angle times the speed.
    const double rate = course->length * r->unit * (r->by_time ? 1.0 : x[r->rotor]);
    double *variable = course->variables + WHIRL_VARIABLE_STATIONS;
    course->variables[WHIRL_VARIABLE_TIME] = runup_time_of(r, x);
    course->variables[WHIRL_VARIABLE_SPEED] = runup_speed_of(r, x);
    r->machine->speeds(r->machine, runup_placed(r, x), r->speed);
    for (size_t p = 0; p < r->probes; p++, variable += WHIRL_OF_STATION) {
        const whirl_probe *probe = &r->system->probes[p];
        variable[WHIRL_OF_STATION_X] = course->length * whirl_probe_value(probe, x, 0);
        variable[WHIRL_OF_STATION_Y] = course->length * whirl_probe_value(probe, x, 1);
        variable[WHIRL_OF_STATION_RADIUS] = course->length * runup_radius_of(r, x, p);
        variable[WHIRL_OF_STATION_VX] = rate * whirl_probe_value(probe, x, 2);
        variable[WHIRL_OF_STATION_VY] = rate * whirl_probe_value(probe, x, 3);
        variable[WHIRL_OF_STATION_SPEED] = r->speed[p];
        variable[WHIRL_OF_STATION_AXIAL] = variable[WHIRL_OF_STATION_AXIAL_VELOCITY] = 0.0;
        variable[WHIRL_OF_STATION_TWIST] = probe->twists ? variable[WHIRL_OF_STATION_X] : 0.0;
    }
    runup_extra_variables(r, x, rate);
    const double value = course->value(course->owner, WHIRL_FORMULA_EVENT + (whirl_run_formula)which);
    return isnan(value) ? -INFINITY : value;
}

/// Returns the angle at which the present turn ends.
static double runup_turn_end(const runner *r) {
    return r->angle0 + two_pi * (runup_whole_turns(r) + 1.0);
}

/// Returns the index of the first event of the course.
static size_t runup_first_of_course(const runner *r) {
    return r->run->event_count - (r->plan->course ? r->plan->course->event_count : 0);
}

/// Lists the conditions of event k, which has not happened yet.
static size_t runup_list_event(const runner *r, size_t k, coming *list) {
    const runup_happening *own = &r->run->events[k];
    const size_t first = runup_first_of_course(r);
    const int what = EVENT_FIRST + (int)k;
    double since = 0.0;
    size_t count = 0;
    const whirl_spool_turning *spool = own->is.spool > 0 ? &r->how.spools[own->is.spool - 1] : NULL;
    const bool tripped = spool ? spool->tripped || spool->law != WHIRL_SPOOL_DRIVEN : r->how.tripped || !r->how.driven;
    if (!isnan(own->time) || (own->is.trip && tripped)) return 0;
    if (own->is.after != WHIRL_NO_EVENT) since = r->run->events[first + own->is.after].time;
    if (isnan(since)) return 0;
    if (!isnan(own->is.time)) list[count++] = (coming){what, runup_time_quantity, since + own->is.time, 0, 1};
    if (!isnan(own->is.speed))
        list[count++] = (coming){what, runup_speed_quantity, own->is.speed, own->is.spool, own->is.passing};
    if (own->is.when) list[count++] = (coming){what, runup_formula_quantity, 0.0, k - first, 1};
    if (count == 0) list[count++] = (coming){what, runup_time_quantity, since, 0, 1};
    return count;
}

/// Returns the angle at which the present turn of a shaft with a speed of its own ends.
static double runup_spool_turn_end(const runner *r, size_t spool) {
    return two_pi * (r->spool_turns[spool] + 1.0);
}

/// Returns the time of the run, s, with a margin by which a corner of a table counts as reached.
static double runup_corner_time(const runner *r) {
    return runup_time_of(r, r->x) * (1.0 + 1e-12);
}

static size_t runup_spool_corner(const runner *r, size_t spool) {
    const whirl_spool_course *own = &r->plan->course->spools[spool];
    return whirl_run_row_after(own->count, own->at, runup_corner_time(r));
}

/// Lists what may happen to the shafts with a speed of their own.
static size_t runup_list_spools(const runner *r, coming *list) {
    size_t count = 0;
    for (size_t k = 0; k < r->spools; k++) {
        const whirl_spool_turning *how = &r->how.spools[k];
        const whirl_spool_course *own = r->plan->course ? &r->plan->course->spools[k] : NULL;
        list[count++] = (coming){EVENT_SPOOL + (int)k, runup_spool_angle_quantity, runup_spool_turn_end(r, k), k, 1};
        if (how->law == WHIRL_SPOOL_RATE && how->rate != 0.0 && own && own->to > 0.0)
            list[count++] = (coming){EVENT_SPOOL_DWELL + (int)k, runup_speed_quantity, own->to, 1 + k, 0};
        if (how->law == WHIRL_SPOOL_BY_TIME && runup_spool_corner(r, k) < own->count)
            list[count++] = (coming){EVENT_CORNER, runup_time_quantity, own->at[runup_spool_corner(r, k)], 0, 1};
    }
    return count;
}

size_t whirl_run_row_after(size_t count, const double *times, double time) {
    size_t k = 0;
    while (k < count && times[k] <= time) k++;
    return k;
}

static size_t runup_next_corner(const runner *r) {
    const whirl_run_course *course = r->plan->course;
    return whirl_run_row_after(course->speed_count, course->speed_times, runup_corner_time(r));
}

/// Lists everything that may happen in the present state of the run.
static size_t runup_list_coming(const runner *r, coming list[MAX_COMING]) {
    const whirl_runup_options *o = r->plan->options;
    const whirl_run_course *course = r->plan->course;
    const double torque = r->machine->begins(r->machine, runup_time_of(r, r->x) * (1.0 + 1e-12));
    size_t count = 0;
    if (r->by_time) list[count++] = (coming){EVENT_TURN, runup_angle_quantity, runup_turn_end(r), 0, 0};
    if (isfinite(torque)) list[count++] = (coming){EVENT_TORQUE, runup_time_quantity, torque, 0, 1};
    if (o->duration > 0.0) list[count++] = (coming){EVENT_END, runup_time_quantity, o->duration, 0, 1};
    const bool steady = r->how.rate == 0.0 && !(course && course->has[WHIRL_FORMULA_RATE]);
    if (o->to > 0.0 && (r->how.driven || !steady))
        list[count++] = (coming){r->how.rate != 0.0 && o->duration > 0.0 ? EVENT_DWELL : EVENT_END,
                                 runup_speed_quantity, o->to, 0, 0};
    if (course && course->speed_count > 0) {
        const size_t corner = runup_next_corner(r);
        if (corner < course->speed_count)
            list[count++] = (coming){EVENT_CORNER, runup_time_quantity, course->speed_times[corner], 0, 1};
    }
    count += runup_list_spools(r, list + count);
    for (size_t k = 0; k < r->run->event_count; k++) count += runup_list_event(r, k, list + count);
    return count;
}

static bool runup_passes(const coming *what, double before, double after) {
    return (what->passing >= 0 && before < what->target && after >= what->target) ||
           (what->passing <= 0 && before > what->target && after <= what->target);
}

/// Returns the rate of a table of speeds before row `next`, the first one after the present time. At a corner the speed
/// x[at] becomes that of the table.
static double runup_follow_rows(runner *r, size_t count, const double *times, const double *speeds, size_t next,
                                size_t at) {
    const size_t last = next - 1; // a table begins at time 0
    const double time = runup_time_of(r, r->x);
    if (time - times[last] <= 2e-12 * time) r->x[at] = speeds[last] / r->unit;
    if (r->copy) r->copy[at] = r->x[at];
    return next == count ? 0.0 : (speeds[next] - speeds[last]) / (times[next] - times[last]);
}

/// Sets the rates of the shafts whose speeds follow tables over the time, from the present time on.
static void runup_follow_tables(runner *r) {
    const whirl_run_course *course = r->plan->course;
    for (size_t k = 0; k < r->spools; k++) {
        if (r->how.spools[k].law != WHIRL_SPOOL_BY_TIME) continue;
        const whirl_spool_course *own = &course->spools[k];
        r->how.spools[k].rate = runup_follow_rows(r, own->count, own->at, own->speeds, runup_spool_corner(r, k),
                                                  r->spool_state + 2 * k + 1);
    }
    if (!course || course->speed_count == 0) return;
    r->how.rate =
        runup_follow_rows(r, course->speed_count, course->speed_times, course->speeds, runup_next_corner(r), r->rotor);
}

/// Makes the integrators of a machine.
static whirl_status runup_add_integrators(const runner *r, runup_side *side) {
    whirl_integrate_options options = r->plan->integrate;
    whirl_status status = whirl_ok();
    for (size_t time = 0; time < 2 && status.code == WHIRL_OK; time++) {
        const whirl_system *system = time ? side->machine->by_time : side->machine->by_angle;
        options.steps_per_revolution = r->plan->options->samples;
        status = whirl_integrator_new(system, &options, &side->seen[time]);
        options.steps_per_revolution = 1;
        if (status.code == WHIRL_OK) status = whirl_integrator_new(system, &options, &side->part[time]);
    }
    return status;
}

/// Makes the machine after one more of the events in `happened`.
static void runup_add_side(runner *r) {
    const size_t next = r->side_count;
    r->status = r->plan->change(r->plan->change_context, next, r->happened, &r->sides[next].machine);
    if (r->status.code == WHIRL_OK) r->status = runup_add_integrators(r, &r->sides[next]);
    if (r->status.code == WHIRL_OK) r->side_count++;
}

/// Continues with the machine that the events of the course have made so far.
static void runup_change(runner *r, size_t of) {
    const size_t next = r->side_count;
    whirl_running *before = r->machine;
    r->happened[next - 1] = (unsigned char)of;
    runup_add_side(r);
    if (r->status.code != WHIRL_OK) return;
    runup_go_by(r, next, r->by_time);
    r->run->error = fmax(r->run->error, r->machine->error);
    r->machine->lose(r->machine, r->lost_count, r->lost);
    r->turns += r->machine->adopt(r->machine, before, r->by_time, r->x) / two_pi;
    if (r->copy) r->machine->adopt(r->machine, before, r->by_time, r->copy);
}

/// Applies event k of the run. Returns true if the run ends.
static bool runup_let_happen(runner *r, size_t k) {
    runup_happening *own = &r->run->events[k];
    own->time = runup_time_of(r, r->x);
    own->at = runup_speed_of(r, r->x);
    if (own->is.trip) *(own->is.spool > 0 ? &r->how.spools[own->is.spool - 1].tripped : &r->how.tripped) = true;
    if (own->is.lost.moment > 0.0) {
        r->lost[r->lost_count++] = own->is.lost;
        r->how.lost = true;
        r->machine->lose(r->machine, r->lost_count, r->lost);
    }
    if (own->is.changes) runup_change(r, k - runup_first_of_course(r));
    return own->is.end || r->status.code != WHIRL_OK;
}

/// Applies the event `what`. Returns true if the run ends.
static bool runup_happen(runner *r, int what) {
    bool ends = false;
    if (what == EVENT_NONE || what == EVENT_TURN || what == EVENT_TORQUE) return false;
    if (what >= EVENT_SPOOL && what < EVENT_SPOOL_DWELL) return false;
    r->parted = r->parted || what != EVENT_END;
    if (what == EVENT_DWELL) {
        r->how.rate = 0.0;
        r->x[r->rotor] = r->plan->options->to / r->unit;
        if (r->copy) r->copy[r->rotor] = r->x[r->rotor];
    } else if (what >= EVENT_SPOOL_DWELL && what < EVENT_FIRST) {
        const size_t k = (size_t)(what - EVENT_SPOOL_DWELL);
        r->how.spools[k].rate = 0.0;
        r->x[r->spool_state + 2 * k + 1] = r->plan->course->spools[k].to / r->unit;
        if (r->copy) r->copy[r->spool_state + 2 * k + 1] = r->x[r->spool_state + 2 * k + 1];
    } else if (what >= EVENT_FIRST) {
        ends = runup_let_happen(r, (size_t)(what - EVENT_FIRST));
    }
    runup_follow_tables(r);
    runup_set_turning(r, &r->how);
    return ends || what == EVENT_END;
}

/// Returns true if `what` happens in the present state.
static bool runup_is_here(const runner *r, const coming *what) {
    const double value = what->of(r, r->x, what->which);
    if (what->of == runup_formula_quantity) return value >= 0.0;
    if (what->of == runup_speed_quantity && what->passing != 0) {
        whirl_torques torques[1 + WHIRL_MAX_SPOOLS];
        r->machine->torques(r->machine, runup_placed(r, r->x), runup_angle_of(r, r->x), &torques[0]);
        if (what->which > 0)
            r->machine->spool_torques(r->machine, runup_placed(r, r->x), runup_angle_of(r, r->x), &torques[1]);
        if (!(torques[what->which].acceleration * what->passing > 0.0)) return false;
    }
    return fabs(value - what->target) <= 1e-12 * what->target;
}

/// Applies all that happens in the present state, and what follows from it. Returns true if the run ends.
static bool runup_happen_now(runner *r) {
    bool ends = false, more = true;
    while (more && r->status.code == WHIRL_OK) {
        coming list[MAX_COMING];
        const size_t count = runup_list_coming(r, list);
        int what = EVENT_NONE;
        for (size_t i = 0; i < count && what == EVENT_NONE; i++) {
            const bool once = list[i].what == EVENT_DWELL || list[i].what >= EVENT_SPOOL_DWELL;
            if (list[i].what == EVENT_END && runup_is_here(r, &list[i])) ends = true;
            if (once && runup_is_here(r, &list[i])) what = list[i].what;
        }
        more = what != EVENT_NONE;
        ends = runup_happen(r, what) || ends;
    }
    return ends;
}

/// Finds the first event in the part that was carried last with all samples, which has `length` and begins at the angle
/// `from`. Writes its place `at` and the state `there`. Returns the kind of event.
static int runup_find_event(runner *r, double from, double length, double *at, double *there) {
    coming list[MAX_COMING];
    const size_t events = runup_list_coming(r, list), count = (size_t)r->plan->options->samples;
    const double step = length / (double)count;
    int first = EVENT_NONE;
    *at = length;
    for (size_t i = 0; i < events; i++) {
        // A speed that pulsates may pass its target and return between the ends of a part.
        if (list[i].of == runup_time_quantity && list[i].target > runup_time_of(r, runup_sample(r, count))) continue;
        double before = list[i].of(r, runup_sample(r, 0), list[i].which);
        for (size_t k = 0; k < count && (double)k * step < *at; k++) {
            const double after = list[i].of(r, runup_sample(r, k + 1), list[i].which), begin = (double)k * step;
            if (runup_passes(&list[i], before, after)) {
                const double place =
                    begin + runup_find_passage(r, list[i].of, list[i].which, list[i].target, runup_sample(r, k),
                                               from + begin, step, before, after, r->scratch);
                if (first == EVENT_NONE || place < *at) {
                    first = list[i].what;
                    *at = place;
                    memcpy(there, r->scratch, r->dimension * sizeof *there);
                }
                break;
            }
            before = after;
        }
    }
    return first;
}

// ---------------------------------------------------------------- turns

/// Returns true if the shaft stands: it turned and came to rest, or turned back.
static bool runup_stands(const runner *r, const double *x) {
    const double speed = x[r->rotor];
    for (size_t k = 0; k < r->spools; k++)
        if (!(runup_spool_speed(r, x, k) >= -0.02 * r->unit)) return true;
    return isnan(speed) || speed < -0.02 || (speed < 1e-3 && r->turns >= 1.0);
}

static runup_end runup_end_of(const runner *r, whirl_motion motion) {
    if (runup_stopped(r)) return RUNUP_STOPPED;
    if (motion == WHIRL_DIVERGED) return RUNUP_DIVERGED;
    return r->x[r->rotor] < 1e-3 || isnan(r->x[r->rotor]) ? RUNUP_STALLED : RUNUP_STUCK;
}

/// Returns the largest number of steps of a part by time at which its samples still show every step.
static double runup_most_steps(const runner *r) {
    // With switches a step is at most an eighth of the machine's period, so a part of a period has at least 8 steps.
    enum { SAMPLES_OF_STEP = 4, MIN_STEPS = 16 };
    return fmax(MIN_STEPS, (double)r->plan->options->samples / SAMPLES_OF_STEP);
}

/// Carries `end` over the next part of a turn, at most *length long, and keeps all samples. Writes the part's length to
/// *length: with time as variable, a part has as many steps as its samples can show.
static whirl_motion runup_carry_next(runner *r, double from, double *length, double *end) {
    enum { TRIES = 6 };
    const whirl_integrator *by = r->sides[r->side].seen[r->by_time];
    const double most = runup_most_steps(r);
    for (int tries = 1;; tries++) {
        const size_t before = whirl_integrator_steps(by);
        memcpy(end, r->x, r->dimension * sizeof *end);
        const whirl_motion motion = runup_carry_seen(r, from, *length, end);
        const double used = (double)(whirl_integrator_steps(by) - before) / most;
        if (!r->by_time) return motion;
        r->leg = *length * fmin(2.0, fmax(0.1, 0.8 / used));
        if (tries == TRIES || runup_stopped(r) || (motion == WHIRL_BOUNDED && used <= 1.5)) return motion;
        *length = fmin(r->leg, 0.5 * *length);
    }
}

/// Returns the length of the next part by the angle: the rest of the turn, or less in two cases. If the speed would
/// fall below half of its value within the turn, the part ends before, since the law of the speed may have a corner
/// before the speed is 0. In the run of a record the samples may have to be closer.
static double runup_next_angle(const runner *r) {
    const double halving = 0.375, slow = 1e-3; // (1 - 1/4)/2
    const double speed = r->x[r->rotor], rate = r->how.rate / (r->unit * r->unit);
    double length = two_pi - r->passed;
    if (rate < 0.0 && speed > slow) length = fmin(length, halving * speed * speed / -rate);
    return r->plan->motion ? fmin(length, r->leg) : length;
}

/// Returns the length of the next part by time. In the run of a record the speed is given, and parts end with turns:
/// their ends need not be searched.
static double runup_next_leg(const runner *r) {
    const double before = 1.0 - 1e-13, speed = r->x[r->rotor], rate = r->how.rate / (r->unit * r->unit);
    if (!r->plan->motion) return r->leg;
    const double angle = runup_turn_end(r) - r->x[r->rotor + 2], root = speed * speed + 2.0 * rate * angle;
    return root > 0.0 ? fmin(r->leg, before * 2.0 * angle / (speed + sqrt(root))) : r->leg;
}

/// Returns true if a state ends the turn of the run of a record.
static bool runup_ends_turn(const runner *r, const double *x) {
    return r->plan->motion && fabs(x[r->rotor + 2] - runup_turn_end(r)) < 1e-10;
}

/// Begins a turn.
static void runup_begin_next_turn(runner *r) {
    memcpy(r->begin, r->x, r->dimension * sizeof *r->x);
    runup_begin_turn(r);
    r->passed = 0.0;
    r->phase = PHASE_PART;
}

/// Goes on by the angle after the first turn from standstill.
static void runup_go_by_angle(runner *r) {
    r->machine->to_angle(r->machine, r->x);
    if (r->copy) r->machine->to_angle(r->machine, r->copy);
    runup_go_by(r, r->side, false);
    r->leg = two_pi;
}

/// Lets the run be saved after a whole turn.
static void runup_offer(runner *r) {
    if (r->plan->turned) r->plan->turned(r->plan->context, r);
}

static void runup_end_at(runner *r, runup_end end) {
    r->run->end = end;
    r->phase = PHASE_OVER;
}

/// Ends a turn that is complete.
static void runup_end_turn(runner *r) {
    runup_compare_copy(r);
    runup_show_turn(r, true);
    r->phase = PHASE_TURN;
    if (!r->first)
        runup_offer(r);
    else if (!r->machine->in_time)
        runup_go_by_angle(r);
    r->first = false;
}

/// Begins the next turn of shaft k with a speed of its own.
static void runup_begin_spool_turn(runner *r, size_t k, bool whole) {
    for (size_t p = 0; p < r->probes; p++) r->spool_stations[k * r->probes + p] = (runup_station){.radius = 0.0};
    r->spool_begin[k] = whole ? runup_time_of(r, r->x) : (double)NAN;
}

/// Begins the turns of shafts with a speed of their own when the time of the run begins.
static void runup_begin_spools(runner *r) {
    for (size_t k = 0; k < r->spools; k++) {
        const double turns = runup_spool_angle(r, r->x, k) / two_pi;
        r->spool_before[k] = turns;
        r->spool_turns[k] = floor(turns + 1e-9);
        runup_begin_spool_turn(r, k, fabs(turns - r->spool_turns[k]) < 1e-9);
    }
}

/// Ends the turns of shafts with a speed of their own that end in the present state.
static void runup_end_spool_turns(runner *r) {
    whirl_torques torques[WHIRL_MAX_SPOOLS];
    bool found = false;
    for (size_t k = 0; k < r->spools; k++) {
        if (!(runup_spool_angle(r, r->x, k) > runup_spool_turn_end(r, k) - 1e-9)) continue;
        if (!found) r->machine->spool_torques(r->machine, runup_placed(r, r->x), runup_angle_of(r, r->x), torques);
        found = true;
        const double begin = r->spool_begin[k], end = runup_time_of(r, r->x);
        r->spool_turns[k] += 1.0;
        const runup_spool_turn turn = {.spool = k,
                                       .time = 0.5 * (begin + end),
                                       .speed = two_pi / (end - begin),
                                       .end = end,
                                       .turns = r->spool_turns[k] - r->spool_before[k],
                                       .stations = r->spool_stations + k * r->probes,
                                       .torques = torques[k]};
        if (!isnan(begin) && r->plan->see_spool) r->plan->see_spool(r->plan->context, &turn);
        runup_begin_spool_turn(r, k, true);
    }
}

/// Processes the part of a turn that was carried, with its samples, from x to `end`.
static void runup_take_part(runner *r, whirl_motion motion) {
    double *end = r->end, *there = r->scratch + 2 * r->most, at;
    if (motion != WHIRL_BOUNDED || (r->by_time ? runup_stands(r, end) : !(end[r->rotor] > 0.0))) {
        memcpy(r->x, end, r->dimension * sizeof *end);
        runup_end_at(r, runup_end_of(r, motion));
        return;
    }
    // Go to the first event in the part, or to its end.
    const bool rest = r->length == two_pi - r->passed;
    int what = runup_find_event(r, r->from, r->length, &at, there);
    if (what != EVENT_NONE) {
        memcpy(end, r->x, r->dimension * sizeof *end);
        if (at > 0.0) runup_carry_seen(r, r->from, at, end);
        memcpy(end, there, r->dimension * sizeof *end);
    }
    if (at > 0.0) runup_see_part(r, r->from, r->passed, at);
    if (r->copy && r->copy_carried && what == EVENT_NONE)
        memcpy(r->copy, r->copy_end, r->dimension * sizeof *end);
    else
        runup_carry_copy(r, r->from, at);
    const double passed = r->by_time ? end[r->rotor + 2] - r->x[r->rotor + 2] : at;
    memcpy(r->x, end, r->dimension * sizeof *end);
    if (what == EVENT_NONE && (r->by_time ? runup_ends_turn(r, r->x) : rest)) what = EVENT_TURN;
    if (r->spools > 0) {
        r->machine->follow(r->machine, r->x);
        runup_end_spool_turns(r);
        // Turns of two shafts may end together.
        const bool turned = what >= EVENT_SPOOL && what < EVENT_SPOOL_DWELL;
        if (turned && fabs(r->x[r->rotor + 2] - runup_turn_end(r)) < 1e-9) what = EVENT_TURN;
    }
    r->turns = what == EVENT_TURN ? runup_whole_turns(r) + 1.0 : r->turns + passed / two_pi;
    r->passed += passed;
    // Apply the event found, and all others whose conditions hold at its instant.
    bool ends = runup_happen(r, what);
    ends = runup_happen_now(r) || ends;
    if (r->status.code == WHIRL_OK && ends) {
        runup_show_turn(r, false);
        runup_end_at(r, r->by_time && r->turns < 1.0 && r->x[r->rotor] < 1e-3 ? RUNUP_STALLED : RUNUP_DONE);
    } else if (r->status.code != WHIRL_OK || runup_stopped(r)) {
        r->phase = PHASE_OVER;
    } else if (what == EVENT_TURN) {
        runup_end_turn(r);
    }
}

/// Returns true if a shaft that stands begins to turn.
static bool runup_begins_to_turn(const runner *r) {
    whirl_torques torques;
    r->machine->torques(r->machine, r->x, r->angle0, &torques);
    // Torques that depend on time may begin at 0, or below.
    const whirl_run_course *course = r->plan->course;
    const bool in_time = course && (course->has[WHIRL_FORMULA_MOTOR] || course->has[WHIRL_FORMULA_LOAD]);
    return r->machine->in_time || in_time || torques.acceleration > 0.0;
}

/// Begins to turn at the first speed until the motion has settled, before time begins.
static void runup_begin_settling(runner *r) {
    whirl_turning still = r->how;
    still.driven = still.lost = false;
    still.rate = 0.0;
    for (size_t k = 0; k < r->spools; k++) still.spools[k] = (whirl_spool_turning){.law = WHIRL_SPOOL_RATE};
    runup_set_turning(r, &still);
    r->phase = PHASE_SETTLE;
}

/// Processes a turn of settling that was carried to `end`.
static void runup_take_settling(runner *r, whirl_motion motion) {
    memcpy(r->x, r->end, r->dimension * sizeof *r->x);
    if (motion != WHIRL_BOUNDED || runup_stopped(r)) {
        runup_end_at(r, runup_end_of(r, motion));
        return;
    }
    r->settled++;
    runup_offer(r);
}

/// Returns the speed at which shaft k with a speed of its own begins, rad/s.
static double runup_spool_start(const runup_plan *plan, const whirl_running *running, size_t k) {
    return plan->course ? plan->course->spools[k].from : running->by_time->spools[k].speed;
}

static void runup_end_settling(runner *r) {
    r->x[r->rotor] = r->plan->options->from / r->unit;
    r->x[r->rotor + 1] = 0.0;
    if (r->by_time) r->x[r->rotor + 2] = r->angle0;
    for (size_t k = 0; k < r->spools; k++)
        r->x[r->spool_state + 2 * k + 1] = runup_spool_start(r->plan, r->machine, k) / r->unit;
    runup_set_turning(r, &r->how);
    r->phase = PHASE_START;
}

/// Begins the time of the run. A shaft that stands makes its first turn with time as variable.
static void runup_start(runner *r) {
    r->begun = true;
    if (r->plan->motion) run_motion_begin(r->plan->motion, r->system->probes, r->x, runup_angle_of(r, r->x));
    runup_begin_spools(r);
    const bool ends = runup_happen_now(r) || r->status.code != WHIRL_OK;
    if (r->copy) runup_place_copy(r, 0.0);
    r->phase = ends ? PHASE_OVER : PHASE_TURN;
    if (ends || r->plan->options->from > 0.0) return;
    r->first = true;
    if (runup_begins_to_turn(r))
        runup_begin_next_turn(r);
    else
        runup_end_at(r, RUNUP_STALLED);
}

bool runup_next(runner *r) {
    for (;;) {
        switch (r->phase) {
        case PHASE_BEGIN:
            if (strcmp(r->plan->options->begin, "steady") == 0)
                runup_begin_settling(r);
            else
                r->phase = PHASE_START;
            break;
        case PHASE_SETTLE:
            if (r->settled >= (size_t)r->plan->options->settle) {
                runup_end_settling(r);
                break;
            }
            r->from = r->angle0;
            r->length = r->by_time ? two_pi * r->unit / r->plan->options->from : two_pi;
            memcpy(r->end, r->x, r->dimension * sizeof *r->x);
            return true;
        case PHASE_START:
            runup_start(r);
            break;
        case PHASE_TURN:
            if (runup_stopped(r))
                r->phase = PHASE_OVER;
            else
                runup_begin_next_turn(r);
            break;
        case PHASE_PART:
            r->from = r->by_time ? 0.0 : r->angle0 + r->passed;
            r->length = r->by_time ? runup_next_leg(r) : runup_next_angle(r);
            r->copy_carried = false;
            memcpy(r->end, r->x, r->dimension * sizeof *r->x);
            return true;
        default:
            return false;
        }
    }
}

void runup_take(runner *r, whirl_motion motion) {
    if (r->phase == PHASE_SETTLE)
        runup_take_settling(r, motion);
    else if (motion != WHIRL_BOUNDED || !runup_is_coarse(r))
        runup_take_part(r, motion);
}

whirl_motion runup_carry_alone(runner *r) {
    if (r->phase == PHASE_SETTLE) return runup_carry_part(r, r->from, r->length, r->end);
    return runup_carry_next(r, r->from, &r->length, r->end);
}

// ---------------------------------------------------------------- saving

/// Archives (saves or restores) how the shaft turns; laws and formulas stay those of the plan.
static void runup_archive_turning(const runner *r, whirl_turning *how, archive *a) {
    archive_part(a, how, sizeof *how);
    how->course = r->plan->course;
}

static void runup_archive_where(const runner *r, runup_where *where, archive *a) {
    archive_part(a, where, sizeof *where);
    where->how.course = r->plan->course;
    if (where->side >= r->side_count || where->lost > r->lost_count) a->sound = false;
}

/// Archives (saves or restores) the changes of the machine, the lost unbalances, and the variable.
static void runup_archive_setting(runner *r, archive *a) {
    size_t changes = r->side_count - 1, side = r->side, by_time = r->by_time;
    archive_count(a, &changes, WHIRL_MAX_EVENTS);
    archive_part(a, r->happened, changes * sizeof *r->happened);
    archive_count(a, &r->lost_count, RUNUP_EVENTS);
    archive_part(a, r->lost, r->lost_count * sizeof *r->lost);
    runup_archive_turning(r, &r->how, a);
    archive_count(a, &side, changes);
    archive_count(a, &by_time, 1);
    if (a->way != ARCHIVE_READ || !a->sound) return;
    for (size_t i = 0; i < changes && r->status.code == WHIRL_OK; i++) runup_add_side(r);
    if (r->status.code != WHIRL_OK) return;
    runup_go_by(r, side, by_time == 1);
    r->machine->lose(r->machine, r->lost_count, r->lost);
    runup_set_turning(r, &r->how);
}

/// Archives (saves or restores) the results so far.
static void runup_archive_found(runup_run *run, const runner *r, archive *a) {
    archive_part(a, &run->error, sizeof run->error);
    archive_part(a, run->sensitivity, sizeof run->sensitivity);
    for (size_t k = 0; k < run->event_count; k++) {
        archive_part(a, &run->events[k].time, sizeof run->events[k].time);
        archive_part(a, &run->events[k].at, sizeof run->events[k].at);
    }
    archive_part(a, run->peaks, r->peaks * sizeof *run->peaks);
    archive_part(a, run->contacts, r->contacts * sizeof *run->contacts);
    archive_part(a, run->torques, r->torques * sizeof *run->torques);
}

void runup_archive(runup_state *r, archive *a) {
    archive_same(a, (double)r->most);
    archive_same(a, (double)r->plan->options->samples);
    runup_archive_setting(r, a);
    // Archive the state, and the copy that follows it.
    size_t copied = r->copy != NULL;
    archive_count(a, &copied, r->copy != NULL);
    if (copied == 0) r->copy = NULL;
    archive_part(a, r->x, r->most * sizeof *r->x);
    if (r->copy) archive_part(a, r->copy, r->most * sizeof *r->copy);
    archive_part(a, &r->size, sizeof r->size);
    archive_part(a, &r->growth, sizeof r->growth);
    archive_part(a, &r->least, sizeof r->least);
    archive_part(a, &r->least_at, sizeof r->least_at);
    archive_part(a, &r->leg, sizeof r->leg);
    archive_part(a, &r->turns, sizeof r->turns);
    archive_count(a, &r->settled, (size_t)r->plan->options->settle);
    archive_part(a, &r->begun, sizeof r->begun);
    archive_part(a, r->spool_stations, r->spools * r->probes * sizeof *r->spool_stations);
    archive_part(a, r->spool_begin, r->spools * sizeof *r->spool_begin);
    archive_part(a, r->spool_turns, r->spools * sizeof *r->spool_turns);
    archive_part(a, r->spool_before, r->spools * sizeof *r->spool_before);
    // Archive the samples around the largest values so far.
    archive_part(a, r->peak_state, r->peaks * r->most * sizeof *r->peak_state);
    archive_part(a, r->peak_from, r->peaks * sizeof *r->peak_from);
    archive_part(a, r->peak_length, r->peaks * sizeof *r->peak_length);
    archive_part(a, r->torque_state, 2 * r->torques * r->most * sizeof *r->torque_state);
    archive_part(a, r->torque_length, 2 * r->torques * sizeof *r->torque_length);
    for (size_t p = 0; p < r->peaks; p++) runup_archive_where(r, &r->peak_where[p], a);
    for (size_t k = 0; k < 2 * r->torques; k++) runup_archive_where(r, &r->torque_where[k], a);
    runup_archive_found(r->run, r, a);
}

double runup_turns_of(const runup_state *r) {
    return (double)r->settled + r->turns;
}

// ---------------------------------------------------------------- all

/// Restores the machine, the variable, the unbalances and the turning of the shaft with which a state was computed.
static void runup_go_back(runner *r, const runup_where *to) {
    runup_go_by(r, to->side, to->by_time);
    r->machine->lose(r->machine, to->lost, r->lost);
    r->machine->turn(r->machine, &to->how);
}

/// Locates the peaks of radii, of axial displacements and of twists between samples.
static void runup_locate_peaks(runner *r) {
    for (size_t p = 0; p < r->peaks; p++) {
        const double *state = r->peak_state + p * r->most;
        double *there = r->scratch + r->most;
        if (!(r->peak_length[p] > 0.0)) continue;
        runup_go_back(r, &r->peak_where[p]);
        memcpy(there, state, r->dimension * sizeof *there);
        if (runup_carry_part(r, r->peak_from[p], r->peak_length[p], there) != WHIRL_BOUNDED) continue;
        const double low = runup_peak_slope(r, state, p), high = runup_peak_slope(r, there, p);
        if (!(low > 0.0 && high < 0.0)) continue;
        runup_find_passage(r, runup_peak_slope, p, 0.0, state, r->peak_from[p], r->peak_length[p], low, high, there);
        const double radius = runup_peak_size(r, there, p);
        if (radius >= r->run->peaks[p].radius)
            r->run->peaks[p] = (runup_peak){radius, runup_time_of(r, there), runup_speed_of(r, there)};
    }
}

/// Locates the peaks and valleys of torques between samples.
static void runup_locate_torques(runner *r) {
    double *there = r->scratch + r->most;
    for (size_t which = 0; which < 2 * r->torques; which++) {
        runup_torque *torque = &r->run->torques[which / 2];
        runup_extreme *own = which % 2 == 0 ? &torque->largest : &torque->least;
        const double *state = r->torque_state + which * r->most, length = r->torque_length[which];
        if (!(length > 0.0)) continue;
        runup_go_back(r, &r->torque_where[which]);
        memcpy(there, state, r->dimension * sizeof *there);
        if (runup_carry_part(r, 0.0, length, there) != WHIRL_BOUNDED) continue;
        const double low = runup_torque_slope(r, state, which), high = runup_torque_slope(r, there, which);
        if (!(low * high < 0.0)) continue;
        runup_find_passage(r, runup_torque_slope, which, 0.0, state, 0.0, length, low, high, there);
        runup_watch(r, there);
        const double value = r->torque[which / 2];
        if (which % 2 == 0 ? value >= own->value : value <= own->value)
            *own = (runup_extreme){value, runup_time_of(r, there)};
    }
}

void runup_finish(runner *r) {
    if (runup_stopped(r)) r->run->end = RUNUP_STOPPED;
    r->run->time = runup_time_of(r, r->x);
    r->run->speed = runup_speed_of(r, r->x);
    r->run->turns = r->turns;
    for (size_t k = 0; k < r->spools; k++) {
        r->run->spool_speed[k] = runup_spool_speed(r, r->x, k);
        r->run->spool_turns[k] = runup_spool_angle(r, r->x, k) / two_pi - r->spool_before[k];
    }
    memcpy(r->run->last, runup_placed(r, r->x), (r->rotor + 2) * sizeof *r->x);
    if (r->run->end == RUNUP_DONE || r->run->end == RUNUP_STALLED) {
        runup_locate_peaks(r);
        if (r->torques > 0) runup_locate_torques(r);
    }
}

static whirl_status runup_make_room(runner *r) {
    // Make memory for all arrays at once.
    const size_t d = r->most, samples = (size_t)r->plan->options->samples;
    const size_t slopes = r->plan->motion ? samples + 1 : 0;
    const size_t numbers = d * (2 + samples + 1 + slopes + 3 + 1 + 2 + 2 + r->peaks + 2 * r->torques) +
                           r->contacts * (samples + 3) + 2 * r->peaks + r->probes + 3 * r->torques;
    r->x = calloc(numbers + 1, sizeof *r->x);
    r->stations = calloc(r->watched + 1, sizeof *r->stations);
    r->spool_stations = calloc(r->spools * r->probes + 1, sizeof *r->spool_stations);
    r->peak_where = calloc(r->peaks + 1, sizeof *r->peak_where);
    r->torque_where = calloc(2 * r->torques + 1, sizeof *r->torque_where);
    r->weights = calloc(samples + 1, sizeof *r->weights);
    r->weights_passed = (double)NAN;
    r->probe = calloc(r->watched + 1, sizeof *r->probe);
    if (!r->spool_stations || !r->probe || !r->weights || !r->x || !r->stations || !r->peak_where || !r->torque_where)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a run");
    runup_find_probes(r, r->sides[0].machine->by_angle);
    // Divide the block into arrays.
    double *next = r->x + d;
    r->begin = next, next += d;
    r->samples = next, next += (samples + 1) * d;
    if (r->plan->motion) r->slopes = next;
    next += slopes * d;
    r->scratch = next, next += 3 * d;
    r->placed = next, next += d;
    r->end = r->scratch + d;
    r->change = next, next += 2 * d;
    r->copy_end = next, next += d;
    if (runup_wants_copy(r->plan->options, r->contacts)) r->copy = next;
    next += d;
    r->peak_state = next, next += r->peaks * d;
    r->torque_state = next, next += 2 * r->torques * d;
    r->force = next, next += (samples + 1) * r->contacts;
    r->largest = next, next += r->contacts;
    r->share = next, next += r->contacts;
    r->peak_from = next, next += r->peaks;
    r->peak_length = next, next += r->peaks;
    r->speed = next, next += r->probes;
    r->torque = next, next += r->torques;
    r->torque_length = next;
    // Make the integrators of the first machine.
    return runup_add_integrators(r, &r->sides[0]);
}

void runup_close(runner *r) {
    for (size_t i = 0; i < sizeof r->sides / sizeof *r->sides; i++) {
        runup_side *side = &r->sides[i];
        for (size_t time = 0; time < 2; time++) {
            whirl_integrator_free(side->seen[time]);
            whirl_integrator_free(side->part[time]);
        }
        if (i > 0 && side->machine) side->machine->release(side->machine); // the first is the caller's
    }
    free(r->x);
    free(r->stations);
    free(r->spool_stations);
    free(r->weights);
    free(r->probe);
    free(r->peak_where);
    free(r->torque_where);
}

size_t runup_events_of(const whirl_runup_options *o, const whirl_system *system, runup_happening *out) {
    const whirl_run_event none = {.time = NAN, .speed = NAN, .after = WHIRL_NO_EVENT};
    size_t count = 0;
    if (o->trip_time > 0.0 || o->trip_speed > 0.0) {
        runup_happening *own = &out[count++];
        *own = (runup_happening){none, NAN, NAN};
        own->is.trip = true;
        *(o->trip_time > 0.0 ? &own->is.time : &own->is.speed) = o->trip_time > 0.0 ? o->trip_time : o->trip_speed;
    }
    if (*o->loss_at) {
        runup_happening *own = &out[count++];
        size_t station = 0;
        while (station + 1 < system->probe_count && strcmp(system->probes[station].name, o->loss_at) != 0) station++;
        *own = (runup_happening){none, NAN, NAN};
        own->is.lost = (whirl_placed){station, o->loss_moment, o->loss_angle};
        *(o->loss_speed > 0.0 ? &own->is.speed : &own->is.time) = o->loss_speed > 0.0 ? o->loss_speed : o->loss_time;
    }
    return count;
}

void runup_open(runner *r, whirl_running *running, const runup_plan *plan, runup_run *run) {
    const whirl_runup_options *o = plan->options;
    // Describe the machine and the run.
    *r =
        (runner){.machine = running,
                 .sides = {{.machine = running}},
                 .side_count = 1,
                 .status = whirl_ok(),
                 .plan = plan,
                 .rotor = running->by_angle->dimension - 2,
                 .most = running->by_time->dimension,
                 .probes = running->by_angle->probe_count,
                 .watched = whirl_watched_probes(running->by_angle),
                 .peaks = running->by_angle->probe_count + 2 * running->by_angle->extra_count,
                 .contacts = running->contact_count,
                 .torques = running->in_time ? running->watched_count : 0,
                 .spools = running->spool_count,
                 .spool_state = running->spool_state,
                 .leg = 0.05 * two_pi,
                 .unit = running->unit,
                 .angle0 = running->in_time || plan->motion ? plan->angle
                                                            : fmod(plan->angle, two_pi), // meshes depend on whole turns
                 .run = run};
    r->how = (whirl_turning){.driven = whirl_runup_driven(o),
                             .rate = o->to > 0.0 && o->to < o->from ? -o->rate : o->rate,
                             .dragless = !o->drag,
                             .course = plan->course};
    for (size_t k = 0; k < r->spools && plan->course; k++) {
        const whirl_spool_course *own = &plan->course->spools[k];
        const double rate = own->to > 0.0 && own->to < own->from ? -own->rate : own->rate;
        r->how.spools[k] = (whirl_spool_turning){.law = own->law, .rate = own->law == WHIRL_SPOOL_RATE ? rate : 0.0};
    }
    // Begin with the machine's own error, the events that may happen, and no extremes.
    run->error = running->error;
    for (size_t i = 0; i < 4; i++) run->sensitivity[i] = i == 0 ? 0.0 : (double)NAN;
    run->event_count = runup_events_of(o, running->by_angle, run->events);
    for (size_t i = 0; plan->course && i < plan->course->event_count; i++)
        run->events[run->event_count++] = (runup_happening){plan->course->events[i], NAN, NAN};
    for (size_t p = 0; p < r->peaks; p++)
        run->peaks[p] = (runup_peak){p < r->probes ? 0.0 : -(double)INFINITY, NAN, NAN};
    for (size_t t = 0; t < r->torques; t++)
        run->torques[t] = (runup_torque){{-(double)INFINITY, NAN}, {(double)INFINITY, NAN}};
    for (size_t c = 0; c < r->contacts; c++) run->contacts[c] = (runup_contact){NAN, NAN, 0.0, 0.0};
    // Start: by time where the shaft stands, else by its angle.
    r->status = runup_make_room(r);
    if (r->status.code != WHIRL_OK) return;
    runup_go_by(r, 0, running->in_time || o->from == 0.0);
    if (!r->by_time) r->leg = two_pi;
    memcpy(r->x, plan->start, plan->start_count * sizeof *r->x);
    r->x[r->rotor] = o->from / r->unit;
    for (size_t k = 0; k < r->spools; k++)
        r->x[r->spool_state + 2 * k + 1] = runup_spool_start(plan, running, k) / r->unit;
    if (r->by_time)
        r->x[r->rotor + 2] = r->angle0;
    else
        running->to_angle(running, r->x);
    runup_follow_tables(r);
    runup_set_turning(r, &r->how);
    if (r->spools > 0) r->machine->follow(r->machine, r->x);
    // Continue from a saved state.
    if (plan->resume && !plan->resume(plan->context, r) && r->status.code == WHIRL_OK)
        r->status = whirl_fail(WHIRL_BAD_INPUT, "the saved state of a run does not fit");
    r->phase = r->begun ? PHASE_TURN : PHASE_BEGIN;
}
