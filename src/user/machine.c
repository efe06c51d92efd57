// The whirl_system of a user's system, for one machine or for many machines in lanes.
//
// All machines of a study have one period, that of the system's own parameters, so that they stay in step. For a
// machine whose own period is T times longer, time runs T times faster; velocities, if the system names them, are
// derivatives by this common time.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "isa.h"
#include "user.h"
#include "vector.h"

enum {
    BLOCK = 8192,    ///< numbers that one call in lanes takes, for each of state, parameters and slopes
    MAX_LANES = 512, ///< largest number of lanes in a call
    MAX_IN_LANES = 256
};

typedef struct member {
    const whirl_user_system *from;
    double scale;        ///< T
    double *parameters;  ///< [parameter_count]
    double *start;       ///< [dimension]
    size_t *groups;      ///< [displacements + 1]
    whirl_probe *probes; ///< [station_count] in the user's units
    double (*units)[4];  ///< [station_count] units of the probes
    whirl_system system;
    struct whirl_lanes lanes;
} member;

// ---------------------------------------------------------------- slopes of a block of machines

/// Machines side by side in the user's own units: number k of machine i at [k * row + i].
typedef struct block {
    size_t count, row;
    double t[MAX_LANES], scale[MAX_LANES];
    double x[BLOCK], p[BLOCK], slopes[BLOCK];
} block;

/// Notes a function's failure code and its time; returns true for success.
static bool machine_note(const whirl_user_system *from, int code, double t) {
    int expected = 0;
    if (code == 0) return true;
    if (atomic_compare_exchange_strong(&from->failure->code, &expected, code)) {
        from->failure->time = t;
        atomic_store(&from->failure->reported, 1);
    }
    return false;
}

static bool slopes_of_each(const whirl_user_system *from, block *b) {
    double x[USER_MAX_STATES], p[USER_MAX_PARAMETERS], slopes[USER_MAX_STATES];
    for (size_t i = 0; i < b->count; i++) {
        for (size_t k = 0; k < from->dimension; k++) x[k] = b->x[k * b->row + i];
        for (size_t k = 0; k < from->parameter_count; k++) p[k] = b->p[k * b->row + i];
        if (!machine_note(from, from->rates(b->t[i], x, p, slopes, from->context), b->t[i])) return false;
        for (size_t k = 0; k < from->dimension; k++) b->slopes[k * b->row + i] = slopes[k];
    }
    return true;
}

/// Multiplies the rows of a block by the coordinates' units, or divides by them.
static void scale_rows(const whirl_user_system *from, const block *b, double *rows, bool divide) {
    for (size_t k = 0; from->units && k < from->dimension; k++)
        for (size_t i = 0; i < b->count; i++) {
            double *number = &rows[k * b->row + i];
            *number = divide ? *number / from->units[k] : *number * from->units[k];
        }
}

/// Computes the slopes of a block, whose states are converted to the user's units; NaN once a function has failed.
static void take_slopes(const whirl_user_system *from, block *b) {
    bool good = atomic_load(&from->failure->code) == 0;
    scale_rows(from, b, b->x, false);
    if (good && from->lanes)
        good = machine_note(from, from->lanes(b->count, b->row, b->t, b->x, b->p, b->slopes, from->context), b->t[0]);
    else if (good)
        good = slopes_of_each(from, b);
    for (size_t k = 0; !good && k < from->dimension; k++)
        for (size_t i = 0; i < b->count; i++) b->slopes[k * b->row + i] = NAN;
    scale_rows(from, b, b->slopes, true);
}

// ---------------------------------------------------------------- one machine

/// Returns true for velocities, which differ by a factor T between the common time and the user's.
static bool is_velocity(const whirl_user_system *from, size_t k) {
    return k >= from->displacements && k < 2 * from->displacements;
}

/// Converts slopes from the user's own time to the common one.
static void to_common(const whirl_user_system *from, double scale, const double *x, const double *slopes,
                      double *dxdt) {
    for (size_t k = 0; k < from->dimension; k++) dxdt[k] = scale * slopes[k];
    for (size_t k = 0; k < from->displacements; k++) {
        dxdt[k] = x[from->displacements + k];
        dxdt[from->displacements + k] *= scale;
    }
}

static void to_own(const member *own, const double *x, double *out) {
    for (size_t k = 0; k < own->from->dimension; k++) out[k] = is_velocity(own->from, k) ? x[k] / own->scale : x[k];
}

/// Converts a state or a perturbation to the user's units; `work` has dimension numbers.
static const double *in_units(const whirl_user_system *from, const double *x, double *work) {
    if (!from->units) return x;
    for (size_t k = 0; k < from->dimension; k++) work[k] = x[k] * from->units[k];
    return work;
}

static void leave_units(const whirl_user_system *from, double *slopes) {
    for (size_t k = 0; from->units && k < from->dimension; k++) slopes[k] /= from->units[k];
}

static bool slopes_at(const whirl_user_system *from, double t, const double *x, const double *p, double *slopes) {
    double work[USER_MAX_STATES];
    if (atomic_load(&from->failure->code) != 0) return false;
    if (from->calls_left && --*from->calls_left < 0) return false;
    const double *user = in_units(from, x, work);
    const int code = from->lanes ? from->lanes(1, 1, &t, user, p, slopes, from->context)
                                 : from->rates(t, user, p, slopes, from->context);
    leave_units(from, slopes);
    return machine_note(from, code, t);
}

/// Computes the derivative by the user's own function.
static bool own_tangent(const whirl_user_system *from, double t, const double *x, const double *p, const double *d,
                        double *out) {
    double work[2][USER_MAX_STATES];
    const int code =
        from->tangent(t, in_units(from, x, work[0]), p, in_units(from, d, work[1]), out, from->tangent_context);
    leave_units(from, out);
    return machine_note(from, code, t);
}

static bool own_slopes(const member *own, double t, const double *x, double *slopes) {
    return slopes_at(own->from, t, x, own->parameters, slopes);
}

static void machine_rhs(const void *model, double s, const double *forcing, const double *x, double *dxdt) {
    const member *own = model;
    double user[USER_MAX_STATES], slopes[USER_MAX_STATES];
    (void)forcing;
    to_own(own, x, user);
    const bool good = own_slopes(own, own->scale * s, user, slopes);
    for (size_t k = 0; !good && k < own->from->dimension; k++) slopes[k] = NAN;
    to_common(own->from, own->scale, x, slopes, dxdt);
}

static double length_of(const double *x, size_t count) {
    double sum = 0.0;
    for (size_t k = 0; k < count; k++) sum += x[k] * x[k];
    return sqrt(sum);
}

/// Returns the step of differences along a perturbation: the cube root of the rounding unit, relative to the size of
/// the state.
static double difference_step(double size, double length) {
    return length > 0.0 ? 6.06e-6 * fmax(size, 1e-3) / length : 1.0;
}

// ---------------------------------------------------------------- slopes that jump

enum { HALVINGS = 20 };

/// Finds the slope that differs most between two states, and the difference.
static double largest_change(size_t n, const double *lower, const double *upper, size_t *which) {
    double most = 0.0;
    for (size_t k = 0; k < n; k++)
        if (fabs(upper[k] - lower[k]) > most) most = fabs(upper[k] - lower[k]), *which = k;
    return most;
}

/// Returns true if the slopes jump between x - step d and x + step d; `lower` and `upper` are the slopes at these ends.
/// Bisection follows the larger change down to a millionth of the distance: that of continuous slopes shrinks with it.
/// A derivative does not describe what a jump does to a perturbation.
static bool machine_jumps(const whirl_user_system *from, double t, const double *p, const double *x, const double *d,
                          double step, const double *lower, const double *upper) {
    double ends[2][USER_MAX_STATES], between[USER_MAX_STATES], place[USER_MAX_STATES], low = -step, high = step;
    const size_t n = from->dimension;
    size_t which = 0;
    // A change that is small throughout is no jump.
    const double all = from->smooth ? largest_change(n, lower, upper, &which) : 0.0;
    if (!(all > 0.01 * length_of(upper, n)) || !isfinite(all)) return false;
    memcpy(ends[0], lower, n * sizeof *lower);
    memcpy(ends[1], upper, n * sizeof *upper);
    // Halve the interval, towards the larger change.
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (low + high);
        size_t first, second;
        for (size_t k = 0; k < n; k++) place[k] = x[k] + middle * d[k];
        if (!slopes_at(from, t, place, p, between)) return false;
        const bool above = largest_change(n, between, ends[1], &second) > largest_change(n, ends[0], between, &first);
        *(above ? &low : &high) = middle;
        memcpy(ends[above ? 0 : 1], between, n * sizeof *between);
    }
    // Note the first jump of the run, from any thread.
    const double left = largest_change(n, ends[0], ends[1], &which);
    if (!(left > 0.25 * all)) return false;
    int expected = 0;
    if (atomic_compare_exchange_strong(&from->failure->code, &expected, USER_JUMP)) {
        from->failure->time = t;
        from->failure->slope = which;
        from->failure->jump = left;
    }
    return true;
}

/// Computes the derivative along d, both in the user's own units, by central differences.
static bool own_difference(const member *own, double t, const double *x, const double *d, double *out) {
    double shifted[USER_MAX_STATES], lower[USER_MAX_STATES];
    const size_t n = own->from->dimension;
    const double step = difference_step(length_of(x, n), length_of(d, n));
    for (size_t k = 0; k < n; k++) shifted[k] = x[k] - step * d[k];
    if (!own_slopes(own, t, shifted, lower)) return false;
    for (size_t k = 0; k < n; k++) shifted[k] = x[k] + step * d[k];
    if (!own_slopes(own, t, shifted, out)) return false;
    if (machine_jumps(own->from, t, own->parameters, x, d, step, lower, out)) return false;
    for (size_t k = 0; k < n; k++) out[k] = (out[k] - lower[k]) / (2.0 * step);
    return true;
}

static void machine_tangent(const void *model, double s, const double *forcing, const double *x, const double *sides,
                            size_t count, const double *dx, double *ddxdt) {
    const member *own = model;
    const whirl_user_system *from = own->from;
    double user[USER_MAX_STATES], along[USER_MAX_STATES], slopes[USER_MAX_STATES];
    const double t = own->scale * s;
    (void)forcing, (void)sides;
    to_own(own, x, user);
    for (size_t i = 0; i < count; i++, dx += from->dimension, ddxdt += from->dimension) {
        to_own(own, dx, along);
        const bool good = from->tangent ? own_tangent(from, t, user, own->parameters, along, slopes)
                                        : own_difference(own, t, user, along, slopes);
        for (size_t k = 0; !good && k < from->dimension; k++) slopes[k] = NAN;
        to_common(from, own->scale, dx, slopes, ddxdt);
    }
}

// ---------------------------------------------------------------- machines in lanes

static void time_alone(const void *model, double s, double *forcing) {
    (void)model;
    *forcing = s;
}

/// A range of a view's lanes from `first` on, as many as a block has.
typedef struct part {
    const lanes_view *view;
    const whirl_user_system *from;
    size_t first, row; ///< first lane; row length of the view
} part;

static const double *row_of(const part *p, const void *rows, size_t set, size_t size, size_t k) {
    return (const double *)rows + (set * size + k) * p->row + p->first;
}

/// Returns a coordinate of the state (set 0) or of a perturbation (set above 0), in the common time.
static const double *machine_coordinate(const part *p, size_t set, size_t k) {
    const size_t d = p->from->displacements, n = p->from->dimension;
    return k < d ? row_of(p, p->view->q, set, d, k) : row_of(p, p->view->v, set, n - d, k - d);
}

static void begin_block(const part *p, block *b) {
    const double *s = row_of(p, p->view->forcing, 0, 0, 0);
    memcpy(b->scale, row_of(p, p->view->numbers, 0, 0, 0), b->count * sizeof *b->scale);
    for (size_t i = 0; i < b->count; i++) b->t[i] = b->scale[i] * s[i];
    for (size_t k = 0; k < p->from->parameter_count; k++)
        memcpy(b->p + k * b->row, row_of(p, p->view->numbers, 0, 0, k + 1), b->count * sizeof *b->p);
}

/// Fills a block with the states, in the user's own units. sign, step [count]: factors of a perturbation (set above 0)
/// that is added.
static void fill_states(const part *p, size_t set, double sign, const double *step, block *b) {
    for (size_t k = 0; k < p->from->dimension; k++) {
        const double *x = machine_coordinate(p, 0, k), *d = machine_coordinate(p, set, k);
        const bool velocity = is_velocity(p->from, k);
        for (size_t i = 0; i < b->count; i++) {
            const double value = set > 0 ? x[i] + sign * step[i] * d[i] : x[i];
            b->x[k * b->row + i] = velocity ? value / b->scale[i] : value;
        }
    }
}

/// Writes the slopes of velocities and first-order states to the view, times `sign` and `factor` [count] (NULL: 1);
/// `add`: adds them to the present values.
static void put_slopes(const part *p, size_t set, double sign, const double *factor, bool add, const block *b) {
    const size_t d = p->from->displacements, n = p->from->dimension;
    for (size_t k = d; k < n; k++) {
        double *to = (double *)p->view->a + (set * (n - d) + k - d) * p->row + p->first;
        for (size_t i = 0; i < b->count; i++) {
            const double scale = is_velocity(p->from, k) ? b->scale[i] * b->scale[i] : b->scale[i];
            const double slope = scale * b->slopes[k * b->row + i] * (factor ? sign * factor[i] : 1.0);
            to[i] = add ? to[i] + slope : slope;
        }
    }
}

/// Notes a jump of the slopes in lane i between the states on both sides of its own; the slopes there are `lower` and
/// those of the block.
static void look_for_jump(const part *p, size_t set, const block *b, size_t i, double step, const double *lower) {
    double x[MAX_IN_LANES], d[MAX_IN_LANES], q[USER_MAX_PARAMETERS], below[MAX_IN_LANES], above[MAX_IN_LANES];
    for (size_t k = 0; k < p->from->dimension; k++) {
        const double unit = is_velocity(p->from, k) ? 1.0 / b->scale[i] : 1.0;
        x[k] = machine_coordinate(p, 0, k)[i] * unit;
        d[k] = machine_coordinate(p, set, k)[i] * unit;
        below[k] = lower[k * b->row + i]; // NOLINT(clang-analyzer-core.uninitialized.Assign): memcpy has filled it
        above[k] = b->slopes[k * b->row + i];
    }
    for (size_t k = 0; k < p->from->parameter_count; k++) q[k] = b->p[k * b->row + i];
    machine_jumps(p->from, b->t[i], q, x, d, step, below, above);
}

/// Computes the derivative along a perturbation by central differences, with a step for each lane.
static void flow_shifted(const part *p, size_t set, block *b) {
    double step[MAX_LANES], half[MAX_LANES], size[MAX_LANES], length[MAX_LANES];
    memset(size, 0, sizeof size);
    memset(length, 0, sizeof length);
    // Choose a step for each lane by the sizes of its state and perturbation.
    for (size_t k = 0; k < p->from->dimension; k++) {
        const double *x = machine_coordinate(p, 0, k), *d = machine_coordinate(p, set, k);
        for (size_t i = 0; i < b->count; i++) {
            const double unit = is_velocity(p->from, k) ? 1.0 / b->scale[i] : 1.0;
            size[i] += x[i] * unit * x[i] * unit;
            length[i] += d[i] * unit * d[i] * unit;
        }
    }
    for (size_t i = 0; i < b->count; i++) {
        step[i] = difference_step(sqrt(size[i]), sqrt(length[i]));
        half[i] = 0.5 / step[i];
    }
    // Central differences.
    double lower[BLOCK];
    fill_states(p, set, -1.0, step, b);
    take_slopes(p->from, b);
    put_slopes(p, set, -1.0, half, false, b);
    memcpy(lower, b->slopes, p->from->dimension * b->row * sizeof *lower);
    fill_states(p, set, 1.0, step, b);
    take_slopes(p->from, b);
    put_slopes(p, set, 1.0, half, true, b);
    // Note jumps, across which differences mean nothing.
    for (size_t i = 0; p->from->smooth && i < b->count; i++) look_for_jump(p, set, b, i, step[i], lower);
}

/// Computes the derivative along a perturbation by the user's own function, one lane at a time.
static void flow_along(const part *p, size_t set, block *b) {
    double x[MAX_IN_LANES], d[MAX_IN_LANES], q[USER_MAX_PARAMETERS], out[MAX_IN_LANES];
    const whirl_user_system *from = p->from;
    for (size_t i = 0; i < b->count; i++) {
        for (size_t k = 0; k < from->dimension; k++) {
            const double unit = is_velocity(from, k) ? 1.0 / b->scale[i] : 1.0;
            x[k] = machine_coordinate(p, 0, k)[i] * unit;
            d[k] = machine_coordinate(p, set, k)[i] * unit;
        }
        for (size_t k = 0; k < from->parameter_count; k++) q[k] = b->p[k * b->row + i];
        const bool good = atomic_load(&from->failure->code) == 0 && own_tangent(from, b->t[i], x, q, d, out);
        for (size_t k = 0; k < from->dimension; k++) b->slopes[k * b->row + i] = good ? out[k] : (double)NAN;
    }
    put_slopes(p, set, 1.0, NULL, false, b);
}

static void machine_flow_lanes(const lanes_view *view, size_t lanes) {
    const member *model = view->model;
    const whirl_user_system *from = model->from;
    const size_t all = view->vectors * lanes;
    const size_t most = BLOCK / (from->dimension > from->parameter_count ? from->dimension : from->parameter_count);
    block b;
    b.row = most < MAX_LANES ? most : MAX_LANES;
    for (part p = {.view = view, .from = from, .row = view->stride * lanes}; p.first < all; p.first += b.row) {
        b.count = all - p.first < b.row ? all - p.first : b.row;
        begin_block(&p, &b);
        fill_states(&p, 0, 0.0, NULL, &b);
        take_slopes(from, &b);
        put_slopes(&p, 0, 1.0, NULL, false, &b);
        for (size_t set = 1; set <= view->tangents; set++)
            if (from->tangent)
                flow_along(&p, set, &b);
            else
                flow_shifted(&p, set, &b);
        for (size_t i = 0; view->divergence && i < b.count; i++) ((double *)view->divergence)[p.first + i] = NAN;
    }
}

// Flow functions, one for every instruction set: they differ only in their lanes.
#define OF_ISA(name, lanes_there)                                                                                      \
    static void flow_##name(const lanes_view *view) {                                                                  \
        machine_flow_lanes(view, lanes_there);                                                                         \
    }                                                                                                                  \
    static void times_##name(const void *model, size_t stride, size_t vectors, const void *t, void *forcing) {         \
        (void)model, (void)stride;                                                                                     \
        memcpy(forcing, t, vectors *(lanes_there) * sizeof(double));                                                   \
    }
OF_ISA(scalar, 1)
OF_ISA(128, 2)
#if VECTOR_BUILT(VECTOR_FMA)
OF_ISA(fma, 1)
#endif
#if VECTOR_BUILT(VECTOR_AVX2)
OF_ISA(avx2, 4)
#endif
#if VECTOR_BUILT(VECTOR_AVX512)
OF_ISA(avx512, 8)
#endif

static void lane_numbers(const void *model, double *out) {
    const member *own = model;
    *out++ = own->scale;
    memcpy(out, own->parameters, own->from->parameter_count * sizeof *out);
}

static bool lane_alike(const void *one, const void *other) {
    return ((const member *)one)->from == ((const member *)other)->from;
}

static size_t lane_part(const void *model, size_t *places) {
    (void)places;
    return 1 + ((const member *)model)->from->parameter_count;
}

static void lane_depends(const void *model, bool *table) {
    const whirl_user_system *from = ((const member *)model)->from;
    for (size_t i = 0; i < (from->dimension - from->displacements) * from->dimension; i++) table[i] = true;
}

static void fill_lanes(member *own) {
    // Functions by instruction set; such systems have no switches and no contacts.
    static lanes_flow *const flows[VECTOR_ISAS] = EVERY_ISA(, flow);
    static lanes_forcing *const times[VECTOR_ISAS] = EVERY_ISA(, times);
    static lanes_switches *const no_switches[VECTOR_ISAS];
    static lanes_contacts *const no_contacts[VECTOR_ISAS];
    static const size_t no_places[1];
    const size_t d = own->from->displacements;
    // Every displacement is a group of its own.
    for (size_t i = 0; i <= d; i++) own->groups[i] = i;
    own->lanes = (struct whirl_lanes){.degrees = d,
                                      .states = own->from->dimension - 2 * d,
                                      .number_count = 1 + own->from->parameter_count,
                                      .numbers = lane_numbers,
                                      .alike = lane_alike,
                                      .places = no_places,
                                      .part = lane_part,
                                      .depends = lane_depends,
                                      .group_count = d,
                                      .groups = own->groups,
                                      .modulated = true,
                                      .flow = flows,
                                      .switches = no_switches,
                                      .forcing = times,
                                      .contacts = no_contacts};
    own->system.lanes = &own->lanes;
}

// ---------------------------------------------------------------- a machine

static void machine_release(void *owner) {
    member *own = owner;
    free(own->parameters);
    free(own->start);
    free(own->groups);
    free(own->probes);
    free(own->units);
    free(own);
}

/// Makes the stations, which show positions in the user's units.
static whirl_status make_probes(member *own) {
    const whirl_user_system *from = own->from;
    own->probes = malloc((from->station_count + 1) * sizeof *own->probes);
    own->units = malloc((from->station_count + 1) * sizeof *own->units);
    if (!own->probes || !own->units) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    for (size_t i = 0; i < from->station_count; i++) {
        const whirl_probe *one = &from->stations[i];
        const size_t at[] = {one->x, one->y, one->vx, one->vy};
        for (size_t k = 0; k < 4; k++) own->units[i][k] = from->units[at[k]];
        own->probes[i] = *one;
        own->probes[i].units = own->units[i];
    }
    own->system.probes = own->probes;
    return whirl_ok();
}

static whirl_status machine_make(member *own, const double *parameters) {
    const whirl_user_system *from = own->from;
    double values[USER_MAX_PARAMETERS], period, common;
    // The time of a machine is scaled so that all have the period of the case's parameters.
    for (size_t k = 0; k < from->parameter_count; k++) values[k] = from->parameters[k].value;
    whirl_status status = user_period(from, values, &common);
    if (status.code == WHIRL_OK) status = user_period(from, parameters, &period);
    if (status.code != WHIRL_OK) return status;
    own->scale = period / common;
    // Copy the parameters and the start.
    own->parameters = malloc((from->parameter_count + 1) * sizeof *own->parameters);
    own->start = malloc(from->dimension * sizeof *own->start);
    own->groups = calloc(from->displacements + 1, sizeof *own->groups);
    if (!own->parameters || !own->start || !own->groups) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    memcpy(own->parameters, parameters, from->parameter_count * sizeof *parameters);
    for (size_t k = 0; k < from->dimension; k++)
        own->start[k] = is_velocity(from, k) ? from->start[k] * own->scale : from->start[k];
    leave_units(from, own->start);
    // Make the system, in lanes if it is small enough.
    own->system = (whirl_system){.dimension = from->dimension,
                                 .period = common,
                                 .forcing_count = 1,
                                 .forcing = time_alone,
                                 .rhs = machine_rhs,
                                 .kinked = from->kinked,
                                 .angles = from->angles,
                                 .tangent = machine_tangent,
                                 .probe_count = from->station_count,
                                 .probes = from->stations,
                                 .model = own};
    if (from->displacements > 0 && from->dimension <= MAX_IN_LANES) fill_lanes(own);
    return from->units ? make_probes(own) : status;
}

whirl_status user_machine(const whirl_user_system *system, const double *parameters, const whirl_stop *stop,
                          whirl_machine *machine) {
    member *own = calloc(1, sizeof *own);
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a machine");
    own->from = system;
    const whirl_status status = machine_make(own, parameters);
    if (status.code != WHIRL_OK) {
        machine_release(own);
        return status;
    }
    own->system.stop = stop;
    *machine = (whirl_machine){.system = &own->system,
                               .start = own->start,
                               .owner = own,
                               .release = machine_release,
                               .clock = 2.0 * acos(-1.0) / own->system.period / own->scale,
                               .speed = 2.0 * acos(-1.0) / own->system.period / own->scale};
    return status;
}
