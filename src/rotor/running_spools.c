// Machines with shafts whose speed is their own: how numbers depend on two speeds, levers of the unbalances on these
// shafts, and the equation of all shafts.
//
// The numbers are those of the rotor's angle as variable, so that the rotor's speed w divides each of them by a power
// of itself whatever else it depends on. Nearly all depend on one more speed W (unbalances, gyroscopic moments, films),
// or are sums of such numbers; those of parts between two shafts depend on the sum of both speeds or on their
// difference.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "elimination.h"
#include "running_rotor.h"

/// Speeds W at which a shaft is sampled beside that of the base; samples at other speeds of both shafts; index of the
/// rotor's speed for the former.
enum { SPOOL_SPEEDS = POWER_SPEEDS, CROSSINGS = 5, AT_SPEED = 2 };

/// Lowest and highest power of the rotor's speed in a number.
enum { LOWEST_LIFT = -2, HIGHEST_LIFT = 2 };

/// Relative differences of samples: below the first a number counts as constant, below the second as explained.
static const double same = 4e-15, explained = 2e-12;

/// Speed of the base, divided by the highest: samples of a shaft that turns against the rotor seldom have the same size
/// of speed.
static const double base_share = 0.9613;

/// Indices of the rotor's speed and of W at the crossings.
static const size_t crossing[CROSSINGS][2] = {{4, 2}, {6, 5}, {9, 8}, {1, 9}, {10, 4}};

/// Samples of all numbers for one shaft: at w[AT_SPEED] and the speeds W, then at the crossings.
typedef struct spool_samples {
    double speed[SPOOL_SPEEDS];
    double *at;    ///< [SPOOL_SPEEDS][numbers]
    double *cross; ///< [CROSSINGS][numbers]
} spool_samples;

/// Everything that is known about the numbers.
typedef struct spool_fit {
    running_rotor *r;
    size_t numbers;
    const double *w, *y;
    spool_samples of[WHIRL_MAX_SPOOLS];
} spool_fit;

static bool spool_equal(double a, double b, double size, double within) {
    return fabs(a - b) <= within * size;
}

/// Returns the largest size of a number in the samples of a shaft.
static double spool_size(const spool_fit *f, size_t k, size_t n) {
    double largest = fabs(f->y[AT_SPEED * f->numbers + n]);
    for (size_t j = 0; j < SPOOL_SPEEDS; j++) largest = fmax(largest, fabs(f->of[k].at[j * f->numbers + n]));
    return largest;
}

/// Returns true if a number depends on the speed of shaft k.
static bool spool_varies(const spool_fit *f, size_t k, size_t n) {
    const double size = spool_size(f, k, n), base = f->y[AT_SPEED * f->numbers + n];
    for (size_t j = 0; j < SPOOL_SPEEDS; j++)
        if (!spool_equal(f->of[k].at[j * f->numbers + n], base, size, same)) return true;
    return false;
}

/// Returns true if a number has a form, with a power of the rotor's speed, at all crossings of shaft k.
static bool spool_holds(const spool_fit *f, size_t k, size_t n, spool_form form, int lift) {
    const double base = f->y[AT_SPEED * f->numbers + n], size = spool_size(f, k, n);
    for (size_t i = 0; i < CROSSINGS; i++) {
        const double z = f->of[k].at[crossing[i][1] * f->numbers + n];
        const double grown = pow(f->w[crossing[i][0]] / f->w[AT_SPEED], lift),
                     own = f->y[crossing[i][0] * f->numbers + n];
        const double found = form == SPOOL_PRODUCT ? grown * z : own + grown * (z - base);
        const double most = fmax(grown * size, form == SPOOL_SUM ? fabs(own) : 0.0);
        if (!spool_equal(f->of[k].cross[i * f->numbers + n], found, most, explained)) return false;
    }
    return true;
}

/// Points of a function of one relative speed.
typedef struct relative_points {
    size_t count;
    double s[2 * POWER_SPEEDS + CROSSINGS], value[2 * POWER_SPEEDS + CROSSINGS];
} relative_points;

/// Adds a point with the number over the power of the rotor's speed. Points of slow relative motion add nothing.
static void relative_add(relative_points *to, double s, double number, double w, int lift, bool odd) {
    if (fabs(s) < 0.05) return;
    to->s[to->count] = fabs(s);
    to->value[to->count++] = number / pow(w, lift) * (odd && s < 0.0 ? -1.0 : 1.0);
}

/// Finds the function of a relative speed that a number is. Returns false if it is none.
static bool spool_relative(const spool_fit *f, size_t n, const size_t of[2], spool_number *out) {
    const running_rotor *r = f->r;
    const size_t k = of[1] - 1, other = of[0];
    const double base = r->spools[k].highest, sense = r->spools[k].sense;
    for (int lift = LOWEST_LIFT - 2; lift <= HIGHEST_LIFT; lift++)
        for (int form = 0; form < 4; form++) {
            const double sign = form < 2 ? sense : -sense;
            const bool odd = form % 2 == 1;
            relative_points p = {.count = 0};
            if (other == 0) {
                for (size_t i = 0; i < POWER_SPEEDS; i++)
                    relative_add(&p, f->w[i] + sign * base, f->y[i * f->numbers + n], f->w[i], lift, odd);
                for (size_t j = 0; j < SPOOL_SPEEDS; j++)
                    relative_add(&p, f->w[AT_SPEED] + sign * f->of[k].speed[j], f->of[k].at[j * f->numbers + n],
                                 f->w[AT_SPEED], lift, odd);
                for (size_t i = 0; i < CROSSINGS; i++)
                    relative_add(&p, f->w[crossing[i][0]] + sign * f->of[k].speed[crossing[i][1]],
                                 f->of[k].cross[i * f->numbers + n], f->w[crossing[i][0]], lift, odd);
            } else {
                const size_t l = other - 1;
                const double here = r->spools[l].highest * r->spools[l].sense;
                for (size_t j = 0; j < SPOOL_SPEEDS; j++) {
                    relative_add(&p, here + sign * f->of[k].speed[j], f->of[k].at[j * f->numbers + n], f->w[AT_SPEED],
                                 lift, odd);
                    relative_add(&p, r->spools[l].sense * f->of[l].speed[j] + sign * base,
                                 f->of[l].at[j * f->numbers + n], f->w[AT_SPEED], lift, odd);
                }
                for (size_t i = 0; i < CROSSINGS; i++)
                    relative_add(&p, here + sign * f->of[k].speed[crossing[i][1]], f->of[k].cross[i * f->numbers + n],
                                 f->w[crossing[i][0]], lift, odd);
            }
            if (!running_find_powers(p.count, p.s, p.value, out->by.power)) continue;
            out->form = SPOOL_RELATIVE;
            out->lift = lift;
            out->sign = sign;
            out->odd = odd;
            return true;
        }
    return false;
}

/// Returns an error that names the part with a number.
static whirl_status spool_refuse(const running_rotor *r, size_t number) {
    const whirl_rotor *rotor = r->rotor;
    const char *part = "a number of it", *at = "";
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        if (number >= own->first_number && number < own->first_number + own->type->number_count) {
            part = own->type->group.name;
            at = rotor->probes[own->station].name;
        }
    }
    return whirl_fail(
        WHIRL_BAD_INPUT,
        "%s%s%s depends on the speeds of two shafts in a way that is no sum or product, and no function of "
        "their sum or difference alone, expected a part of one shaft, or without turbulence",
        part, *at ? " at " : "", at);
}

/// Finds the form of a number. Those of one speed W that are no sums of powers get splines later.
static whirl_status spool_find(const spool_fit *f, size_t n, spool_number *out) {
    const running_rotor *r = f->r;
    size_t of[2] = {0, 0}, count = 0;
    for (size_t k = 0; k < r->spool_count; k++) {
        if (!spool_varies(f, k, n)) continue;
        of[0] = of[1];
        of[1] = k + 1;
        count++;
    }
    *out = (spool_number){.index = n, .of = {of[0], of[1]}, .by = {.index = n}};
    if (count == 0) return whirl_ok();
    const size_t k = of[1] - 1;
    for (int form = SPOOL_PRODUCT; form <= SPOOL_SUM && count == 1; form++)
        for (int lift = LOWEST_LIFT; lift <= HIGHEST_LIFT; lift++) {
            if (!spool_holds(f, k, n, (spool_form)form, lift)) continue;
            double values[SPOOL_SPEEDS];
            for (size_t j = 0; j < SPOOL_SPEEDS; j++)
                values[j] = f->of[k].at[j * f->numbers + n] / pow(f->w[AT_SPEED], lift);
            out->form = (spool_form)form;
            out->lift = lift;
            out->highest = f->y[AT_SPEED * f->numbers + n] / pow(f->w[AT_SPEED], lift);
            out->constant = f->y[n];
            if (running_find_powers(SPOOL_SPEEDS, f->of[k].speed, values, out->by.power)) return whirl_ok();
            // The sense of a relative motion may change with one of both speeds alone in the samples.
            for (size_t other = 0; other <= r->spool_count; other++) {
                const size_t both[2] = {other, k + 1};
                if (other == k + 1 || !spool_relative(f, n, both, out)) continue;
                out->of[0] = other;
                return whirl_ok();
            }
            out->by.value = r->numbers; // not NULL: spool_add_splines replaces it
            return whirl_ok();
        }
    return count <= 2 && spool_relative(f, n, of, out) ? whirl_ok() : spool_refuse(r, n);
}

// ---------------------------------------------------------------- samples

/// Makes the machine at the samples of shaft k, memory [SPOOL_SPEEDS + CROSSINGS][numbers].
static whirl_status spool_sample(spool_fit *f, whirl_machine_at *make, const void *context, size_t k, double *memory) {
    running_rotor *r = f->r;
    double w[SPOOL_SPEEDS + CROSSINGS], spools[(SPOOL_SPEEDS + CROSSINGS) * WHIRL_MAX_SPOOLS];
    spool_samples *own = &f->of[k];
    own->at = memory;
    own->cross = memory + SPOOL_SPEEDS * f->numbers;
    running_sample_speeds(r->spools[k].lowest_node, r->spools[k].top, own->speed);
    for (size_t i = 0; i < SPOOL_SPEEDS + CROSSINGS; i++) {
        const bool crosses = i >= SPOOL_SPEEDS;
        w[i] = f->w[crosses ? crossing[i - SPOOL_SPEEDS][0] : AT_SPEED];
        for (size_t l = 0; l < r->spool_count; l++) spools[i * r->spool_count + l] = r->spools[l].highest;
        spools[i * r->spool_count + k] = own->speed[crosses ? crossing[i - SPOOL_SPEEDS][1] : i];
    }
    return running_sample(r, make, context, SPOOL_SPEEDS + CROSSINGS, w, spools, memory);
}

/// Fits splines over the speed of shaft k, from `next` on, which moves behind them.
static whirl_status spool_add_splines(running_rotor *r, whirl_machine_at *make, const void *context, size_t k, double w,
                                      double **next) {
    const size_t numbers = r->rotor->lanes.number_count;
    running_spool *own = &r->spools[k];
    double rotors[SPLINE_SPEEDS], at[SPLINE_SPEEDS], spools[SPLINE_SPEEDS * WHIRL_MAX_SPOOLS];
    double *y = malloc(SPLINE_SPEEDS * numbers * sizeof *y);
    if (!y) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speeds");
    own->node_distance = (own->top - own->lowest_node) / (SPLINE_NODES - 1);
    for (size_t i = 0; i < SPLINE_SPEEDS; i++) {
        at[i] = own->lowest_node + 0.5 * (double)i * own->node_distance;
        rotors[i] = w;
        for (size_t l = 0; l < r->spool_count; l++) spools[i * r->spool_count + l] = r->spools[l].highest;
        spools[i * r->spool_count + k] = at[i];
    }
    const whirl_status status = running_sample(r, make, context, SPLINE_SPEEDS, rotors, spools, y);
    for (size_t v = 0; v < r->spooled_count && status.code == WHIRL_OK; v++) {
        spool_number *number = &r->spooled[v];
        number_of_speed *by = &number->by;
        if (!by->value || number->of[1] != k + 1) continue;
        const double error =
            running_fit_spline(by, own->lowest_node, own->node_distance, at, y, numbers, pow(w, number->lift), next);
        r->shown.error = fmax(r->shown.error, error);
        number->highest = running_number_at(by, own->lowest_node, own->node_distance, own->highest);
    }
    free(y);
    return status;
}

/// Leaves out of r->varying what is no sum with a function of the rotor's speed, and connects the sums with the rest.
static void spool_connect(running_rotor *r, size_t *splines) {
    size_t kept = 0;
    for (size_t i = 0, v = 0; i < r->varying_count; i++) {
        while (v < r->spooled_count && r->spooled[v].index < r->varying[i].index) v++;
        const bool known = v < r->spooled_count && r->spooled[v].index == r->varying[i].index;
        if (known && r->spooled[v].form != SPOOL_SUM) {
            *splines -= r->varying[i].value != NULL;
            continue;
        }
        r->varying[kept] = r->varying[i];
        if (known) r->spooled[v].own = &r->varying[kept];
        kept++;
    }
    r->varying_count = kept;
}

whirl_status running_find_spooled(running_rotor *r, whirl_machine_at *make, const void *context, const double *w,
                                  const double *y, size_t *rotor_splines) {
    const size_t numbers = r->rotor->lanes.number_count, all = (size_t)(SPOOL_SPEEDS + CROSSINGS) * numbers;
    spool_fit f = {.r = r, .numbers = numbers, .w = w, .y = y};
    size_t splines = 0;
    double *memory = malloc((r->spool_count * all + 1) * sizeof *memory);
    r->spooled = calloc(numbers + 1, sizeof *r->spooled);
    whirl_status status =
        memory && r->spooled ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speeds");
    // Sample all shafts, and find the forms of the numbers.
    for (size_t k = 0; k < r->spool_count && status.code == WHIRL_OK; k++)
        status = spool_sample(&f, make, context, k, memory + k * all);
    for (size_t n = 0; n < numbers && status.code == WHIRL_OK; n++) {
        spool_number own;
        status = spool_find(&f, n, &own);
        if (status.code != WHIRL_OK || own.of[1] == 0) continue;
        splines += own.by.value != NULL;
        r->spooled[r->spooled_count++] = own;
    }
    free(memory);
    spool_connect(r, rotor_splines);
    if (status.code != WHIRL_OK || splines == 0) return status;
    // Fit splines to those that are no sums of powers.
    double *next = r->spool_splines = malloc(SPLINE_NUMBERS * splines * sizeof *next);
    if (!next) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine over its speeds");
    for (size_t k = 0; k < r->spool_count && status.code == WHIRL_OK; k++)
        status = spool_add_splines(r, make, context, k, w[AT_SPEED], &next);
    return status;
}

/// Returns a whole power of the rotor's speed.
static double spool_lift(double w, int lift) {
    double power = 1.0;
    for (int i = 0; i < abs(lift); i++) power *= w;
    return lift < 0 ? 1.0 / power : power;
}

void running_put_spooled(const running_rotor *r, double w, const double *spools) {
    for (size_t v = 0; v < r->spooled_count; v++) {
        const spool_number *own = &r->spooled[v];
        const running_spool *shaft = &r->spools[own->of[1] - 1];
        const double speed = spools[own->of[1] - 1], grown = spool_lift(w, own->lift);
        double *number = &r->numbers[own->index];
        if (own->form == SPOOL_RELATIVE) {
            const size_t other = own->of[0];
            const double s = (other == 0 ? w : r->spools[other - 1].sense * spools[other - 1]) + own->sign * speed;
            *number = grown * running_number_at(&own->by, 0.0, 1.0, fmax(fabs(s), slowest));
            if (own->odd && s < 0.0) *number = -*number;
            continue;
        }
        const double by = running_number_at(&own->by, shaft->lowest_node, shaft->node_distance, speed);
        if (own->form == SPOOL_PRODUCT)
            *number = grown * by;
        else
            *number = (own->own ? running_number_at(own->own, r->lowest_node, r->node_distance, w) : own->constant) +
                      grown * (by - own->highest);
    }
    memcpy(r->spool_at, spools, r->spool_count * sizeof *spools);
}

// ---------------------------------------------------------------- unbalances

/// Computes the lever of an unbalance by its shaft's theta'' at a phase, N by 1 rad/s2. Returns its moment, kg m; 0 if
/// the element is no unbalance of a shaft with its own speed. The numbers are those of the base, where no speed is 0.
static double spool_lever(const running_rotor *r, size_t index, const double *states, double lever[2]) {
    element own = r->rotor->elements[index];
    if (own.spool == 0 || !own.type->lever || own.states == 0) return 0.0;
    own.number = r->rotor->numbers + own.first_number;
    // The lever of the type is by theta'' of the rotor, which is that of the shaft over the ratio of their speeds.
    const double ratio = r->spools[own.spool - 1].highest;
    const double moment = fabs(own.type->lever(&own, r->unit, states, lever)) / ratio;
    lever[0] /= ratio;
    lever[1] /= ratio;
    return moment;
}

running_spool running_spool_of(double highest, double sense) {
    return (running_spool){
        .highest = base_share * highest, .top = highest, .sense = sense, .lowest_node = highest / 256.0};
}

whirl_status running_add_spools(running_rotor *r) {
    const size_t n = r->rotor->lanes.degrees;
    for (size_t k = 0; k < r->spool_count; k++) {
        r->spools[k].lever_force = calloc(2 * n + 1, sizeof(double));
        if (!r->spools[k].lever_force)
            return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine whose speed changes");
        r->spools[k].lever_acceleration = r->spools[k].lever_force + n;
        r->spools[k].inertia = r->rotor->spool_drives[k].inertia;
    }
    return whirl_ok();
}

double running_spool_unbalance_inertia(const running_rotor *r, size_t k) {
    enum { PHASES = 2 };
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    running_spool *own = &r->spools[k];
    double *const sums[PHASES] = {own->lever_force, own->lever_acceleration};
    double inertia = 0.0;
    // Sum the levers of all unbalances of a place, at two phases a quarter turn apart.
    for (size_t phase = 0; phase < PHASES; phase++) {
        const double quarter = 1.57079632679489661923 * (double)phase;
        memset(sums[phase], 0, n * sizeof(double));
        for (size_t i = 0; i < rotor->element_count; i++) {
            const double at[MAX_ELEMENT_STATES] = {quarter};
            double lever[2] = {0.0, 0.0};
            if (rotor->elements[i].spool != k + 1 || spool_lever(r, i, at, lever) == 0.0) continue;
            for (size_t p = 0; p < 2; p++)
                if (rotor->elements[i].port[p] != NO_COORDINATE) sums[phase][rotor->elements[i].port[p]] += lever[p];
        }
        for (size_t i = 0; i < r->lost_spool_count; i++) {
            const whirl_placed *placed = &r->lost_spools[i];
            const whirl_probe *probe = &rotor->probes[placed->station];
            const double sense = rotor->way * own->sense, angle = placed->angle + quarter;
            if (rotor->spool_of[placed->station] != k + 1) continue;
            if (running_probe_moves(probe, 0)) sums[phase][probe->x] += sense * placed->moment * sin(angle);
            if (running_probe_moves(probe, 1)) sums[phase][probe->y] -= sense * placed->moment * cos(angle);
        }
    }
    for (size_t i = 0; i < n; i++)
        inertia += r->alone[i] * (sums[0][i] * sums[0][i] + sums[1][i] * sums[1][i]) / rotor->inertia[i];
    return inertia;
}

void running_find_spool_levers(const running_rotor *r, const double *x) {
    const whirl_rotor *rotor = r->rotor;
    const size_t n = rotor->lanes.degrees;
    for (size_t k = 0; k < r->spool_count; k++) {
        memset(r->spools[k].lever_force, 0, n * sizeof(double));
        r->spools[k].guided_lever[0] = r->spools[k].guided_lever[1] = 0.0;
    }
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        double lever[2] = {0.0, 0.0};
        if (spool_lever(r, i, x + n + own->state, lever) == 0.0) continue;
        running_spool *to = &r->spools[own->spool - 1];
        for (size_t p = 0; p < 2; p++)
            if (own->port[p] != NO_COORDINATE)
                to->lever_force[own->port[p]] += own->share[p] * lever[p];
            else
                to->guided_lever[p] += lever[p];
    }
    for (size_t k = 0; k < r->spool_count; k++)
        rotor_accelerate(rotor, r->spools[k].lever_force, r->spools[k].lever_acceleration);
}

// ---------------------------------------------------------------- the equation of all shafts

void running_solve_shafts(const running_rotor *r, double w, const double *a, const double pull[3], size_t count,
                          shaft_row *rows) {
    enum { SHAFTS = 1 + WHIRL_MAX_SPOOLS };
    const whirl_rotor *rotor = r->rotor;
    const double square = r->unit * r->unit;
    double matrix[SHAFTS * SHAFTS] = {0.0}, right[SHAFTS] = {0.0}, coupled[SHAFTS][SHAFTS] = {{0.0}};
    size_t unknown[SHAFTS] = {0}, unknowns = 0;
    // Sum what the unbalances of each shaft do to it: at rest of all theta'', and by each of them.
    for (size_t i = 0; i < count; i++) {
        shaft_row *own = &rows[i];
        own->reaction = 0.0;
        for (size_t way = 0; way < 2; way++) own->reaction -= own->guided[way] * pull[way] / square;
        for (size_t j = 0; j < count; j++) coupled[i][j] = i == j ? own->inertia : 0.0;
        for (size_t d = 0; d < rotor->lanes.degrees; d++) {
            const double u = own->force[d];
            if (u == 0.0) continue;
            own->reaction += u * (rotor->unit[d] * w * w * a[d] - pull[r->along[d]] / square);
            for (size_t j = 0; j < count; j++) coupled[i][j] -= u * rotor->unit[d] * rows[j].acceleration[d];
        }
        if (own->driven) unknown[unknowns++] = i;
    }
    // Shafts whose theta'' is given go to the right side, but for their part by that of the first shaft.
    for (size_t m = 0; m < unknowns; m++) {
        const size_t i = unknown[m];
        right[m] = rows[i].torque / square + rows[i].reaction;
        for (size_t j = 0; j < count; j++)
            if (!rows[j].driven) right[m] -= coupled[i][j] * rows[j].all;
        for (size_t l = 0; l < unknowns; l++) {
            double *number = &matrix[m * unknowns + l];
            *number = coupled[i][unknown[l]];
            for (size_t j = 0; j < count && unknown[l] == 0; j++)
                if (!rows[j].driven) *number += coupled[i][j] * rows[j].by_first;
        }
    }
    size_t order[SHAFTS];
    const bool solved = elimination_decompose(unknowns, matrix, order);
    if (solved) elimination_solve(unknowns, matrix, order, right);
    for (size_t m = 0; m < unknowns; m++) rows[unknown[m]].all = solved ? right[m] : (double)NAN;
    for (size_t j = 1; j < count; j++)
        if (!rows[j].driven) rows[j].all += rows[j].by_first * rows[0].all;
}
