// Journal bearings alone, over load and speed: independent points, on all threads.
#include "whirl/internal/bearing_table.h"

#include <math.h>
#include <omp.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "clock.h"
#include "mineral_oil.h"
#include "taylor_vortices.h"
#include "whirl/engine/study.h"

static const double pi = 3.14159265358979323846, zero_degrees = 273.15;

static void fill_nan(double *out, size_t count) {
    for (size_t i = 0; i < count; i++) out[i] = NAN;
}

// ---------------------------------------------------------------- warnings

static void bearing_remark(whirl_bearing_remark *to, size_t *count, whirl_bearing_remark one) {
    to[(*count)++] = one;
}

static bool has_idle_pads(const whirl_bearing *of, const whirl_bearing_point *point) {
    for (size_t i = 0; i < of->pads.count; i++)
        if (whirl_bearing_pad_idle(point, i)) return true;
    return false;
}

static void remark_flow(const whirl_bearing *of, whirl_bearing_point *point) {
    const double taylor = whirl_bearing_taylor(of, point);
    whirl_bearing_remark *to = point->remarks;
    size_t *count = &point->remark_count;
    if (of->pads.turbulence == WHIRL_LAMINAR) {
        if (taylor > FIRST_VORTICES) bearing_remark(to, count, WHIRL_FILM_NOT_LAMINAR);
        return;
    }
    if (taylor < FIRST_VORTICES)
        bearing_remark(to, count, WHIRL_FILM_LAMINAR);
    else if (taylor < 2.0 * FIRST_VORTICES)
        bearing_remark(to, count, WHIRL_FILM_BETWEEN);
    if (point->reynolds > WHIRL_MAX_REYNOLDS) bearing_remark(to, count, WHIRL_FILM_BEYOND);
}

static void remark_oil(const whirl_bearing *of, whirl_bearing_point *point) {
    const double first = of->oil_temperatures[0],
                 last = of->oil_temperatures[of->oil_count > 0 ? of->oil_count - 1 : 0];
    if (!of->heated && point->heating > 20.0) bearing_remark(point->remarks, &point->remark_count, WHIRL_OIL_WARMS);
    if (of->oil_count > 0 && (point->temperature < first - 30.0 || point->temperature > last + 30.0))
        bearing_remark(point->remarks, &point->remark_count, WHIRL_OIL_UNKNOWN);
}

static void remark_point(const whirl_bearing *of, whirl_bearing_point *point) {
    const double error = fmax(point->error_stiffness, point->error_damping);
    if (point->film < of->least_film) bearing_remark(point->remarks, &point->remark_count, WHIRL_FILM_THIN);
    remark_flow(of, point);
    remark_oil(of, point);
    if (!(error <= 0.01)) bearing_remark(point->remarks, &point->remark_count, WHIRL_MESH_COARSE);
    if (has_idle_pads(of, point)) bearing_remark(point->remarks, &point->remark_count, WHIRL_PADS_IDLE);
}

static void remark_bearing(const whirl_bearing *of, whirl_bearing_table *table) {
    const double share = of->pad_clearance / of->radius, ratio = of->pads.ratio;
    if (ratio < 0.1 || ratio > 2.0) bearing_remark(table->remarks, &table->remark_count, WHIRL_LENGTH_UNUSUAL);
    if (share < 3e-4 || share > 5e-3) bearing_remark(table->remarks, &table->remark_count, WHIRL_CLEARANCE_UNUSUAL);
}

double whirl_bearing_taylor(const whirl_bearing *of, const whirl_bearing_point *point) {
    return point->reynolds * sqrt(of->pad_clearance / of->radius);
}

bool whirl_bearing_pad_idle(const whirl_bearing_point *point, size_t pad) {
    return !point->state.loaded[pad] || point->state.load[pad] == 0.0;
}

// ---------------------------------------------------------------- a point

/// Finds the critical mass of a rigid rotor, per bearing: K - m w^2 + i w C is singular at one real w (Lund 1965).
/// Matrices are xx, xy, yx, yy.
static void find_critical_mass(const double *k, const double *c, double speed, double *mass, double *whirl) {
    const double together = (k[0] * c[3] + k[3] * c[0] - k[1] * c[2] - k[2] * c[1]) / (c[0] + c[3]);
    const double square = ((together - k[0]) * (together - k[3]) - k[1] * k[2]) / (c[0] * c[3] - c[1] * c[2]);
    *mass = square > 0.0 && together > 0.0 ? together / square : INFINITY;
    *whirl = square > 0.0 && together > 0.0 ? sqrt(square) / speed : NAN;
}

static double difference_of(const double *a, const double *b) {
    double largest = 0.0, most = 0.0;
    for (int i = 0; i < 4; i++) {
        largest = fmax(largest, fabs(a[i]));
        most = fmax(most, fabs(a[i] - b[i]));
    }
    return most / largest;
}

static void bearing_scale(const double *from, double unit, double *to) {
    for (int i = 0; i < 4; i++) to[i] = unit * from[i];
}

/// Returns the unit of force, mu Omega R L (R/c)^2.
static double bearing_unit_of(const whirl_bearing *of, const whirl_bearing_point *point) {
    const double share = of->radius / of->pad_clearance;
    return point->viscosity * point->speed * of->radius * of->length * share * share;
}

/// Returns the pads in dimensionless form, at a point's speed and viscosity.
static whirl_pads pads_of(const whirl_bearing *of, const whirl_bearing_point *point) {
    const double c = of->pad_clearance, unit = bearing_unit_of(of, point), speed = point->speed, share = of->radius / c;
    whirl_pads pads = of->pads;
    pads.reynolds = pads.turbulence == WHIRL_LAMINAR ? 0.0 : of->density * speed * of->radius * c / point->viscosity;
    pads.supply = of->supply_pressure / (6.0 * point->viscosity * speed * share * share);
    pads.pivot_stiffness = of->pivot_stiffness * c / unit;
    pads.pivot_damping = of->pivot_damping * c * speed / unit;
    pads.pad_mass = of->pad_mass * c * speed * speed / unit;
    return pads;
}

static whirl_status bearing_rest(const whirl_bearing *of, const whirl_bearing_point *point, const whirl_pads *pads,
                                 whirl_pads_state *state) {
    const double size = point->load / bearing_unit_of(of, point);
    const double load[] = {size * cos(of->load_angle), size * sin(of->load_angle)};
    return whirl_pads_rest(pads, load, state);
}

static double flow_of(const whirl_bearing *of, const whirl_bearing_point *point, const whirl_pads_state *state) {
    return point->speed * of->radius * of->pad_clearance * of->length * state->leaving;
}

static double power_of(const whirl_bearing *of, const whirl_bearing_point *point, const whirl_pads_state *state) {
    return point->viscosity * pow(point->speed, 2.0) * pow(of->radius, 3.0) * of->length / of->pad_clearance *
           state->drag;
}

/// Returns the temperature rise of the leaving oil if it absorbs all of the power.
static double heating_of(const whirl_bearing *of, const whirl_bearing_point *point, const whirl_pads_state *state) {
    return power_of(of, point, state) / (of->density * of->specific_heat * flow_of(of, point, state));
}

void whirl_bearing_reduced(const whirl_bearing *of, const whirl_bearing_point *point, double ratio,
                           double out[2][2][2]) {
    const double r = of->radius, c = of->pad_clearance, speed = point->speed, unit = bearing_unit_of(of, point);
    const double inertia = of->inertia * c * speed * speed / (unit * r * r);
    const whirl_pads pads = pads_of(of, point);
    double k[2][2], d[2][2];
    whirl_pads_reduced(&pads, &point->state, ratio, inertia, k, d);
    bearing_scale(k[0], unit / c, out[0][0]);
    bearing_scale(d[0], unit / (c * speed), out[1][0]);
}

/// Converts a dimensionless state to SI in the point.
static void give_dimensions(const whirl_bearing *of, whirl_bearing_point *point) {
    const double r = of->radius, c = of->pad_clearance, speed = point->speed, unit = bearing_unit_of(of, point);
    const whirl_pads_state *state = &point->state;
    point->eccentricity = c * hypot(state->at[0], state->at[1]);
    point->attitude = remainder(atan2(state->at[1], state->at[0]) - of->load_angle, 2.0 * pi);
    point->film = c * state->thinnest;
    point->pressure = 6.0 * point->viscosity * speed * (r / c) * (r / c) * state->highest;
    point->flow = flow_of(of, point, state);
    point->power = power_of(of, point, state);
    point->heating = heating_of(of, point, state);
    if (of->heated) point->outlet = of->temperature + of->heat_share * point->heating;
    bearing_scale(state->stiffness[0], unit / c, point->stiffness[0]);
    bearing_scale(state->damping[0], unit / (c * speed), point->damping[0]);
    for (size_t i = 0; i < of->ratio_count; i++) whirl_bearing_reduced(of, point, of->ratios[i], point->reduced[i]);
    for (size_t i = 0; i < of->pads.count; i++) {
        point->tilt[i] = state->tilt[i] * c / r;
        point->yield[i] = state->yield[i] * c;
    }
    if (!of->pads.tilting)
        find_critical_mass(point->stiffness[0], point->damping[0], speed, &point->critical_mass, &point->whirl);
}

static void estimate_error(const whirl_bearing *of, const whirl_pads *pads, whirl_bearing_point *point) {
    whirl_pads coarse = *pads;
    whirl_pads_state other;
    coarse.halved = true;
    if (bearing_rest(of, point, &coarse, &other).code != WHIRL_OK) return;
    const whirl_pads_state *state = &point->state;
    point->error_place = of->pad_clearance * hypot(state->at[0] - other.at[0], state->at[1] - other.at[1]);
    point->error_stiffness = difference_of(state->stiffness[0], other.stiffness[0]);
    point->error_damping = difference_of(state->damping[0], other.damping[0]);
}

// ---------------------------------------------------------------- temperature

static void bearing_warm(const whirl_bearing *of, double temperature, whirl_bearing_point *point) {
    point->temperature = temperature;
    point->viscosity =
        of->density * mineral_oil_viscosity(of->oil_temperatures, of->oil_viscosities, of->oil_count, temperature);
}

/// Computes the excess of `temperature` over the film temperature that results from its heat, the mean of the
/// temperatures of inflow and outflow. Infinite if no equilibrium carries the load: too hot.
static whirl_status bearing_surplus(const whirl_bearing *of, double temperature, bool coarse,
                                    whirl_bearing_point *point, double *out) {
    bearing_warm(of, temperature, point);
    whirl_pads pads = pads_of(of, point);
    pads.halved = coarse;
    const whirl_status status = bearing_rest(of, point, &pads, &point->state);
    *out = INFINITY;
    if (status.code == WHIRL_NO_MEMORY) return status;
    if (status.code == WHIRL_OK)
        *out = temperature - of->temperature - 0.5 * of->heat_share * heating_of(of, point, &point->state);
    return whirl_ok();
}

/// Finds the film temperature, to a thousandth of a kelvin. It lies between the temperature of the inlet and the one
/// that the film would have with the inlet's viscosity. Solves on a mesh half as fine, then corrects on the fine mesh,
/// with the slope found on the coarse one.
static whirl_status balance_heat(const whirl_bearing *of, whirl_bearing_point *point) {
    static const double hottest = 473.15, enough = 1e-3;
    double value, slope = 1.0, at = of->temperature;
    // Bracket the temperature on the coarse mesh.
    whirl_status status = bearing_surplus(of, at, true, point, &value);
    if (status.code != WHIRL_OK) return status;
    if (isinf(value))
        return whirl_fail(WHIRL_NUMERICAL_FAILURE,
                          "no place was found where the films of the bearing carry the load, cold as the oil comes in");
    bracket between = bracket_between(at, value, fmin(at - value, hottest), 0.0);
    status = bearing_surplus(of, between.b, true, point, &between.fb);
    if (status.code == WHIRL_OK && between.fb < 0.0 && between.b < hottest) {
        between.b = hottest;
        status = bearing_surplus(of, hottest, true, point, &between.fb);
    }
    if (status.code == WHIRL_OK && between.fb < 0.0)
        return whirl_fail(WHIRL_NUMERICAL_FAILURE,
                          "the oil that leaves does not carry the heat below %.4g degC (%.4g degF)",
                          hottest - zero_degrees, 1.8 * (hottest - zero_degrees) + 32.0);
    // Narrow the bracket, and keep the slope.
    for (int k = 0; k < 60 && status.code == WHIRL_OK && fabs(value) > enough && bracket_width(&between) > 0.1 * enough;
         k++) {
        const double last = at, before = value;
        at = isinf(between.fb) ? 0.5 * (between.a + between.b) : bracket_next(&between);
        status = bearing_surplus(of, at, true, point, &value);
        bracket_update(&between, at, value);
        if (isfinite(value) && value != before) slope = (value - before) / (at - last);
    }
    // Correct on the fine mesh.
    for (int k = 0; k < 8 && status.code == WHIRL_OK; k++) {
        status = bearing_surplus(of, at, false, point, &value);
        if (status.code != WHIRL_OK || !(fabs(value) > enough)) return status;
        if (isinf(value)) break;
        at -= value / fmax(slope, 1.0);
    }
    return status.code == WHIRL_OK ? whirl_fail(WHIRL_NUMERICAL_FAILURE, "the temperature of the film does not settle")
                                   : status;
}

static whirl_status bearing_compute(const whirl_bearing *of, whirl_bearing_point *point) {
    whirl_status status = of->heated ? balance_heat(of, point) : whirl_ok();
    const whirl_pads pads = pads_of(of, point);
    if (!of->heated) status = bearing_rest(of, point, &pads, &point->state);
    point->sommerfeld = bearing_unit_of(of, point) / (pi * point->load);
    point->reynolds = of->density * point->speed * of->radius * of->pad_clearance / point->viscosity;
    point->found = status.code == WHIRL_OK;
    snprintf(point->failure, sizeof point->failure, "%s", status.message);
    if (status.code == WHIRL_NO_MEMORY || !point->found) return status;
    give_dimensions(of, point);
    estimate_error(of, &pads, point);
    remark_point(of, point);
    return status;
}

static void bearing_begin(const whirl_bearing *of, size_t i, whirl_bearing_point *point) {
    *point = (whirl_bearing_point){.speed = of->speeds[i],
                                   .load = of->loads[i],
                                   .viscosity = of->viscosity,
                                   .temperature = of->temperature,
                                   .outlet = NAN};
    point->eccentricity = point->attitude = point->film = point->pressure = point->flow = point->power = NAN;
    point->heating = point->critical_mass = point->whirl = NAN;
    point->error_place = point->error_stiffness = point->error_damping = NAN;
    fill_nan(point->stiffness[0], 4);
    fill_nan(point->damping[0], 4);
    fill_nan(point->reduced[0][0][0], sizeof point->reduced / sizeof(double));
    fill_nan(point->tilt, WHIRL_MAX_PADS);
    fill_nan(point->yield, WHIRL_MAX_PADS);
}

// ---------------------------------------------------------------- all of them

/// Reports progress to the caller.
typedef struct bearing_reporter {
    const whirl_bearing_options *options;
    whirl_progress progress;
    double started, reported;
} bearing_reporter;

static void bearing_report(bearing_reporter *to) {
    const double now = clock_seconds() - to->started;
    to->progress.points_done++;
    to->progress.revolutions_done = (double)to->progress.points_done;
    if (!to->options || !to->options->progress || now < 1.0 || now - to->reported < 0.2)
        return; // short tables report no progress
    to->reported = to->progress.seconds = now;
    to->options->progress(to->options->context, &to->progress);
}

static bool bearing_stopped(const whirl_bearing_options *options) {
    return options && whirl_stop_is_set(options->stop);
}

whirl_status whirl_bearing_solve(const whirl_bearing *of, const whirl_bearing_options *options,
                                 whirl_bearing_table **out) {
    const int threads = options && options->threads > 0 ? options->threads : omp_get_num_procs();
    whirl_bearing_table *table = calloc(1, sizeof *table);
    whirl_bearing_point *points = calloc(of->count + 1, sizeof *points);
    bearing_reporter to = {.options = options,
                           .progress = {.points_total = of->count, .revolutions_total = (double)of->count},
                           .started = clock_seconds()};
    atomic_int worst = points && table ? WHIRL_OK : WHIRL_NO_MEMORY;
    *out = NULL;
    // Begin all points, and compute them on all threads.
    for (size_t i = 0; i < of->count && points; i++) bearing_begin(of, i, &points[i]);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t i = 0; i < of->count; i++) {
        if (atomic_load(&worst) != WHIRL_OK || bearing_stopped(options)) continue;
        if (bearing_compute(of, &points[i]).code == WHIRL_NO_MEMORY) atomic_store(&worst, WHIRL_NO_MEMORY);
#pragma omp critical(whirl_bearing)
        bearing_report(&to);
    }
    // Hand over the table, or say why there is none.
    if (atomic_load(&worst) != WHIRL_OK || bearing_stopped(options)) {
        free(points);
        free(table);
        return bearing_stopped(options) ? whirl_fail(WHIRL_STOPPED, "stopped before the end of the table")
                                        : whirl_fail(WHIRL_NO_MEMORY, "no memory for a bearing");
    }
    *table = (whirl_bearing_table){.bearing = of, .count = of->count, .points = points};
    remark_bearing(of, table);
    *out = table;
    return whirl_ok();
}

void whirl_bearing_table_free(whirl_bearing_table *table) {
    if (!table) return;
    free(table->points);
    free(table);
}
