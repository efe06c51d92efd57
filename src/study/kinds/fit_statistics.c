#include "fit_statistics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "two_pi.h"

/// Parts of the record whose numbers are compared for the scatter.
enum { STATISTICS_PARTS = 8 };

/// Pieces of a revolution over which lines are summed up first.
enum { STATISTICS_PIECES = 16 };

/// A recorded motion: at every instant, for each number of the place, the quantity from which the number is computed.
typedef struct statistics_record {
    const fit_place *place;
    const whirl_system *system;
    double length;       ///< metres of a unit of displacement
    size_t first, count; ///< first number of the motion and how many there are, one after the other
    size_t taken, room;  ///< instants so far, and of the whole record
    double *series;      ///< [count][room] displacements in m; of the share of contact 1 or 0
    double *contacts;    ///< [contact_count] workspace
} statistics_record;

static void statistics_take(void *observer, double t, const double *x) {
    statistics_record *r = observer;
    const whirl_system *system = r->system;
    bool touches = false;
    (void)t;
    if (system->contact_count > 0) system->contacts(system->model, x, r->contacts);
    for (size_t i = 0; i < system->contact_count; i++) touches = touches || r->contacts[i] > 0.0;
    const size_t instants = r->place->motion->instants;
    const double turn = (double)((r->taken + 1) % instants) / (double)instants;
    for (size_t i = 0; i < r->count; i++) {
        const whirl_fit_number *number = &r->place->of->fit->numbers[r->first + i];
        const whirl_probe *probe = &system->probes[number->station];
        const double cosine = cos(number->angle), sine = sin(number->angle);
        r->series[i * r->room + r->taken] =
            number->quantity == WHIRL_FIT_SHARE
                ? touches
                : r->length * (cosine * (whirl_probe_value(probe, x, 0) + whirl_probe_runout(probe, 0, turn)) +
                               sine * (whirl_probe_value(probe, x, 1) + whirl_probe_runout(probe, 1, turn)));
    }
    r->taken++;
}

// ---------------------------------------------------------------- numbers of a series

static double statistics_mean(const double *f, size_t count) {
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) sum += f[i];
    return sum / (double)count;
}

/// Returns the largest (sign 1) or smallest (-1) value, by the parabola through the neighbouring instants.
static double statistics_extreme(const double *f, size_t count, double sign) {
    size_t at = 0;
    for (size_t i = 1; i < count; i++)
        if (sign * f[i] > sign * f[at]) at = i;
    if (at == 0 || at + 1 == count) return f[at];
    const double slope = 0.5 * (f[at + 1] - f[at - 1]), bend = f[at + 1] - 2.0 * f[at] + f[at - 1];
    return bend == 0.0 ? f[at] : f[at] - 0.5 * slope * slope / bend;
}

/// A part of a motion turned back by an order, with Hann's window, in sums over short pieces of a revolution.
typedef struct statistics_turned {
    size_t count;             ///< number of pieces
    double *real, *imaginary; ///< [count]
} statistics_turned;

/// Turns a series back by an order.
static void statistics_turn(const double *f, size_t count, size_t instants, double order, statistics_turned *out) {
    const size_t piece = instants / STATISTICS_PIECES;
    const double mean = statistics_mean(f, count), step = two_pi * order / (double)instants;
    out->count = count / piece;
    for (size_t k = 0; k < out->count; k++) {
        double real = 0.0, imaginary = 0.0;
        for (size_t i = k * piece; i < (k + 1) * piece; i++) {
            const double value = (1.0 - cos(two_pi * ((double)i + 0.5) / (double)count)) * (f[i] - mean);
            real += value * cos(step * (double)i);
            imaginary -= value * sin(step * (double)i);
        }
        out->real[k] = 2.0 / (double)count * real;
        out->imaginary[k] = 2.0 / (double)count * imaginary;
    }
}

/// Returns the size of the line whose order is `more` above the order by which the series was turned back. Within a
/// piece this line still turns, by a small angle 2 a, which shortens its sum by the factor sin(a)/a.
static double statistics_size(const statistics_turned *t, double more) {
    const double step = two_pi * more / STATISTICS_PIECES, half = 0.5 * step;
    const double turn_cos = cos(step), turn_sin = sin(step);
    double c = 1.0, s = 0.0, real = 0.0, imaginary = 0.0;
    for (size_t k = 0; k < t->count; k++) {
        real += t->real[k] * c + t->imaginary[k] * s;
        imaginary += t->imaginary[k] * c - t->real[k] * s;
        const double next = c * turn_cos - s * turn_sin;
        s = s * turn_cos + c * turn_sin;
        c = next;
    }
    return hypot(real, imaginary) * (half != 0.0 ? half / sin(half) : 1.0);
}

/// Returns the size of a line: that of a whole order, else the largest within 0.05 of the order. `work` has room for
/// two numbers for each piece.
static double statistics_line(const double *f, size_t count, size_t instants, double order, double *work) {
    enum { ACROSS = 4, STEPS = 40 };
    static const double reach = 0.05, golden = 0.61803398874989485;
    statistics_turned turned = {.real = work, .imaginary = work + STATISTICS_PIECES * count / instants};
    statistics_turn(f, count, instants, order, &turned);
    if (order == round(order)) return statistics_size(&turned, 0.0);
    // Find the largest size on a grid, a quarter of the resolution apart.
    const double apart = (double)instants / (double)(ACROSS * count);
    double best = -INFINITY, at = 0.0;
    const size_t places = 1 + (size_t)floor(2.0 * reach / apart);
    for (size_t i = 0; i < places; i++) {
        const double more = (double)i * apart - reach;
        const double size = statistics_size(&turned, more);
        if (size > best) at = more;
        best = fmax(best, size);
    }
    // Find the largest size near it, by golden sections.
    double low = at - apart, high = at + apart;
    for (int i = 0; i < STEPS; i++) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        if (statistics_size(&turned, a) > statistics_size(&turned, b))
            high = b;
        else
            low = a;
    }
    return statistics_size(&turned, 0.5 * (low + high));
}

static double statistics_number(const whirl_fit_number *number, const double *f, size_t count, size_t instants,
                                double *work) {
    switch (number->quantity) {
    case WHIRL_FIT_HIGHEST:
        return statistics_extreme(f, count, 1.0);
    case WHIRL_FIT_LOWEST:
        return statistics_extreme(f, count, -1.0);
    case WHIRL_FIT_SHARE:
        return statistics_mean(f, count);
    default:
        return statistics_line(f, count, instants, number->at, work);
    }
}

/// Returns the scatter of a number: the standard error of its mean over parts of the record.
static double statistics_scatter(const whirl_fit_number *number, const double *f, size_t count, size_t instants,
                                 double *work) {
    const size_t part = count / instants / STATISTICS_PARTS * instants;
    double sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < STATISTICS_PARTS; i++) {
        const double own = statistics_number(number, f + i * part, part, instants, work);
        sum += own;
        squares += own * own;
    }
    const double mean = sum / STATISTICS_PARTS;
    const double variance = fmax(squares / STATISTICS_PARTS - mean * mean, 0.0);
    return sqrt(variance / (STATISTICS_PARTS - 1));
}

// ---------------------------------------------------------------- a motion

/// Records the motion of a machine from its start.
static whirl_status statistics_follow(statistics_record *r, const whirl_machine *machine) {
    const whirl_fit_options *fit = &r->place->of->batch->record.fit;
    const size_t n = machine->system->dimension;
    whirl_integrate_options options = r->place->options.integrate;
    options.steps_per_revolution = (int)r->place->motion->instants;
    options.rtol = fmax(options.rtol, 1e-10);
    whirl_integrator *integrator = NULL;
    double *x = malloc((n + 1) * sizeof *x);
    whirl_status status = x ? whirl_integrator_new(machine->system, &options, &integrator)
                            : whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion of a fit");
    if (status.code == WHIRL_OK) memcpy(x, machine->start, n * sizeof *x);
    for (int i = 0; i < fit->transient + fit->record && status.code == WHIRL_OK; i++)
        if (whirl_integrator_revolve(integrator, x, i < fit->transient ? NULL : statistics_take, r) != WHIRL_BOUNDED)
            status = whirl_fail(WHIRL_BAD_INPUT, "its motion leaves its bounds after %d revolutions", i);
    whirl_integrator_free(integrator);
    free(x);
    return status;
}

/// Computes the numbers of the place, and unless NULL their scatter, at values of the unknowns.
static whirl_status statistics_at(const fit_place *p, const double *values, size_t first, size_t count, double *numbers,
                                  double *scatter, double *speed) {
    fit_place here;
    whirl_machine machine = {.system = NULL};
    fit_place_make(&here, p->of, (size_t)(p->motion - p->of->fit->motions), values);
    whirl_status status = fit_place_machine(&here, &machine);
    if (status.code != WHIRL_OK) return status;
    statistics_record r = {.place = &here,
                           .system = machine.system,
                           .length = machine.length,
                           .first = first,
                           .count = count,
                           .room = (size_t)p->of->batch->record.fit.record * p->motion->instants};
    const size_t pieces = STATISTICS_PIECES * (size_t)p->of->batch->record.fit.record;
    r.series = calloc(count * r.room + 2 * pieces + machine.system->contact_count + 1, sizeof *r.series);
    double *work = r.series + count * r.room;
    r.contacts = work + 2 * pieces;
    status =
        r.series ? statistics_follow(&r, &machine) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion of a fit");
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        const whirl_fit_number *number = &p->of->fit->numbers[first + i];
        const double *series = r.series + i * r.room;
        numbers[i] = statistics_number(number, series, r.room, p->motion->instants, work);
        if (scatter) scatter[i] = statistics_scatter(number, series, r.room, p->motion->instants, work);
    }
    if (speed) *speed = machine.speed;
    free(r.series);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Derives the numbers by one unknown: by a difference within its bounds.
static whirl_status statistics_derive(const fit_place *p, size_t unknown, size_t first, size_t count, double *work,
                                      double *slopes) {
    const whirl_fit *fit = p->of->fit;
    const whirl_fit_unknown *own = &fit->unknowns[unknown];
    const double range = own->high - own->low, part = p->of->batch->record.fit.difference;
    double values[2][WHIRL_MAX_UNKNOWNS], size = fabs(p->values[unknown]);
    if (isfinite(range)) size = fmax(size, 0.1 * range);
    if (size == 0.0) size = 1.0;
    for (size_t side = 0; side < 2; side++) {
        memcpy(values[side], p->values, fit->unknown_count * sizeof *p->values);
        const double to = p->values[unknown] + (side ? part : 0.0 - part) * size;
        values[side][unknown] = fmin(fmax(to, own->low), own->high);
        const whirl_status status = statistics_at(p, values[side], first, count, work + side * count, NULL, NULL);
        if (status.code != WHIRL_OK) return status;
    }
    for (size_t i = 0; i < count; i++)
        slopes[i * fit->unknown_count + unknown] =
            (work[count + i] - work[i]) / (values[1][unknown] - values[0][unknown]);
    return whirl_ok();
}

whirl_status fit_statistics(const fit_place *p, size_t first, fit_orbit *tried, double *model, double *slopes) {
    // Find the numbers of the motion.
    const whirl_fit *fit = p->of->fit;
    const size_t motion = (size_t)(p->motion - fit->motions);
    size_t count = 0;
    while (first + count < fit->number_count && fit->numbers[first + count].motion == motion) count++;
    // Compute them here and at neighbouring values.
    double *work = calloc(3 * count + 1, sizeof *work), speed = NAN, largest = 0.0;
    whirl_status status = work ? statistics_at(p, p->values, first, count, model + first, work, &speed)
                               : whirl_fail(WHIRL_NO_MEMORY, "no memory for a motion of a fit");
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++)
        largest = fmax(largest, work[i] / fit->numbers[first + i].noise);
    for (size_t u = 0; u < fit->unknown_count && status.code == WHIRL_OK; u++)
        status = statistics_derive(p, u, first, count, work + count, slopes + first * fit->unknown_count);
    free(work);
    // Nothing is followed: the next motion begins at its machine's start, too.
    if (status.code == WHIRL_OK) status = fit_place_note(p, 0, NULL, NULL, tried);
    if (status.code != WHIRL_OK) return status;
    tried->speed = speed;
    tried->scatter = largest;
    return status;
}
