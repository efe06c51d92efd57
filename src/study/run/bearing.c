// Journal bearings by themselves over load and speed: points that know nothing of one another, on all threads.
#include "whirl/bearing_table.h"

#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "whirl/study.h"

static const double pi = 3.14159265358979323846, um = 1e-6;

/// J/(m3 K) of mineral oils, density times specific heat; and Taylor's number, at which vortices begin (Taylor 1923).
static const double heat = 1.7e6, first_vortices = 41.2;

static void fill_nan(double *out, size_t count) {
    for (size_t i = 0; i < count; i++) out[i] = NAN;
}

// ---------------------------------------------------------------- warnings

static void __attribute__((format(printf, 3, 4))) remark(char (*to)[200], size_t *count, const char *format, ...) {
    if (*count >= WHIRL_MAX_REMARKS) return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(to[(*count)++], 200, format, arguments);
    va_end(arguments);
}

static void remark_idle_pads(const whirl_bearing *of, whirl_bearing_point *point) {
    char names[100] = "";
    size_t idle = 0;
    for (size_t i = 0; i < of->pads.count; i++)
        if (!point->state.loaded[i] || point->state.load[i] == 0.0) {
            const size_t used = strlen(names);
            snprintf(names + used, sizeof names - used, "%s%zu", idle++ ? ", " : "", i + 1);
        }
    if (idle && of->pads.tilting)
        remark(point->remarks, &point->remark_count,
               "no film holds pad%s %s: free to flutter, told with a tilt of 0 and no stiffness", idle > 1 ? "s" : "",
               names);
    else if (idle)
        remark(point->remarks, &point->remark_count, "pad%s %s carr%s nothing", idle > 1 ? "s" : "", names,
               idle > 1 ? "y" : "ies");
}

static void remark_point(const whirl_bearing *of, whirl_bearing_point *point) {
    const double taylor = point->reynolds * sqrt(of->pad_clearance / of->radius);
    const double error = fmax(point->error_stiffness, point->error_damping);
    char(*to)[200] = point->remarks;
    size_t *count = &point->remark_count;
    if (point->film < of->least_film)
        remark(to, count, "the film is %.3g um thin, below %.3g um", point->film / um, of->least_film / um);
    if (taylor > first_vortices)
        remark(to, count,
               "the film is not laminar: Taylor's number is %.3g, above %.3g (Reynolds number %.4g); what is told here "
               "is of a laminar one",
               taylor, first_vortices, point->reynolds);
    if (point->heating > 20.0)
        remark(to, count, "the power would warm the leaving oil by %.3g K: is the viscosity that of the warm film?",
               point->heating);
    if (!(error <= 0.01)) remark(to, count, "coefficients differ by %.2g %% on a mesh half as fine", 100.0 * error);
    remark_idle_pads(of, point);
}

static void remark_bearing(const whirl_bearing *of, whirl_bearing_table *table) {
    const double share = of->pad_clearance / of->radius, ratio = of->pads.ratio;
    if (ratio < 0.1 || ratio > 2.0)
        remark(table->remarks, &table->remark_count, "length over diameter is %.3g, and bearings have 0.1 to 2 of it",
               ratio);
    if (share < 3e-4 || share > 5e-3)
        remark(table->remarks, &table->remark_count,
               "the radial clearance of the pads is %.3g times the radius, and bearings have 0.0003 to 0.005 of it: is "
               "it radial, and in the right unit?",
               share);
}

// ---------------------------------------------------------------- a point

/// A rigid rotor whirls above that mass a bearing: K - m w^2 + i w C has no inverse at one real w (Lund 1965).
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

static void scale(const double *from, double unit, double *to) {
    for (int i = 0; i < 4; i++) to[i] = unit * from[i];
}

/// What is told of a state without dimensions; unit: that of forces.
static void give_dimensions(const whirl_bearing *of, double unit, whirl_bearing_point *point) {
    const double r = of->radius, c = of->pad_clearance, speed = point->speed;
    const whirl_pads_state *state = &point->state;
    point->eccentricity = c * hypot(state->at[0], state->at[1]);
    point->attitude = remainder(atan2(state->at[1], state->at[0]) - of->load_angle, 2.0 * pi);
    point->film = c * state->thinnest;
    point->pressure = 6.0 * of->viscosity * speed * (r / c) * (r / c) * state->highest;
    point->flow = speed * r * c * of->length * state->leaving;
    point->power = of->viscosity * speed * speed * r * r * r * of->length / c * state->drag;
    point->heating = point->power / (heat * point->flow);
    scale(state->stiffness[0], unit / c, point->stiffness[0]);
    scale(state->damping[0], unit / (c * speed), point->damping[0]);
    for (size_t i = 0; i < of->ratio_count; i++) {
        const double inertia = of->inertia * speed * pow(c / r, 3.0) / (of->viscosity * of->length * r * r);
        double k[2][2], d[2][2];
        whirl_pads_reduced(&of->pads, state, of->ratios[i], inertia, k, d);
        scale(k[0], unit / c, point->reduced[i][0][0]);
        scale(d[0], unit / (c * speed), point->reduced[i][1][0]);
    }
    for (size_t i = 0; i < of->pads.count; i++) point->tilt[i] = state->tilt[i] * c / r;
    if (!of->pads.tilting)
        find_critical_mass(point->stiffness[0], point->damping[0], speed, &point->critical_mass, &point->whirl);
}

static void estimate_error(const whirl_bearing *of, const double load[2], whirl_bearing_point *point) {
    whirl_pads coarse = of->pads;
    whirl_pads_state other;
    coarse.halved = true;
    if (whirl_pads_rest(&coarse, load, &other).code != WHIRL_OK) return;
    const whirl_pads_state *state = &point->state;
    point->error_place = of->pad_clearance * hypot(state->at[0] - other.at[0], state->at[1] - other.at[1]);
    point->error_stiffness = difference_of(state->stiffness[0], other.stiffness[0]);
    point->error_damping = difference_of(state->damping[0], other.damping[0]);
}

static whirl_status compute(const whirl_bearing *of, whirl_bearing_point *point) {
    const double r = of->radius, c = of->pad_clearance, speed = point->speed;
    const double unit = of->viscosity * speed * r * of->length * (r / c) * (r / c), size = point->load / unit;
    const double load[] = {size * cos(of->load_angle), size * sin(of->load_angle)};
    const whirl_status status = whirl_pads_rest(&of->pads, load, &point->state);
    point->sommerfeld = 1.0 / (pi * size);
    point->reynolds = of->density * speed * r * c / of->viscosity;
    point->found = status.code == WHIRL_OK;
    snprintf(point->failure, sizeof point->failure, "%s", status.message);
    if (status.code == WHIRL_NO_MEMORY || !point->found) return status;
    give_dimensions(of, unit, point);
    estimate_error(of, load, point);
    remark_point(of, point);
    return status;
}

static void begin(const whirl_bearing *of, size_t i, whirl_bearing_point *point) {
    *point = (whirl_bearing_point){.speed = of->speeds[i], .load = of->loads[i]};
    point->eccentricity = point->attitude = point->film = point->pressure = point->flow = point->power = NAN;
    point->heating = point->critical_mass = point->whirl = NAN;
    point->error_place = point->error_stiffness = point->error_damping = NAN;
    fill_nan(point->stiffness[0], 4);
    fill_nan(point->damping[0], 4);
    fill_nan(point->reduced[0][0][0], sizeof point->reduced / sizeof(double));
    fill_nan(point->tilt, WHIRL_MAX_PADS);
}

// ---------------------------------------------------------------- all of them

/// Who is told of how far it is.
typedef struct teller {
    const whirl_bearing_options *options;
    whirl_progress progress;
    double started, told;
} teller;

static void tell(teller *to) {
    const double now = clock_seconds() - to->started;
    to->progress.points_done++;
    to->progress.revolutions_done = (double)to->progress.points_done;
    if (!to->options || !to->options->progress || now < 1.0 || now - to->told < 0.2)
        return; // of a short table nothing is told
    to->told = to->progress.seconds = now;
    to->options->progress(to->options->context, &to->progress);
}

static bool stopped(const whirl_bearing_options *options) {
    return options && options->stop && *options->stop;
}

whirl_status whirl_bearing_solve(const whirl_bearing *of, const whirl_bearing_options *options,
                                 whirl_bearing_table **out) {
    const int threads = options && options->threads > 0 ? options->threads : omp_get_num_procs();
    whirl_bearing_table *table = calloc(1, sizeof *table);
    whirl_bearing_point *points = calloc(of->count + 1, sizeof *points);
    teller to = {.options = options,
                 .progress = {.points_total = of->count, .revolutions_total = (double)of->count},
                 .started = clock_seconds()};
    atomic_int worst = points && table ? WHIRL_OK : WHIRL_NO_MEMORY;
    *out = NULL;
    for (size_t i = 0; i < of->count && points; i++) begin(of, i, &points[i]);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (size_t i = 0; i < of->count; i++) {
        if (atomic_load(&worst) != WHIRL_OK || stopped(options)) continue;
        if (compute(of, &points[i]).code == WHIRL_NO_MEMORY) atomic_store(&worst, WHIRL_NO_MEMORY);
#pragma omp critical(whirl_bearing)
        tell(&to);
    }
    if (atomic_load(&worst) != WHIRL_OK || stopped(options)) {
        free(points);
        free(table);
        return stopped(options) ? whirl_fail(WHIRL_STOPPED, "stopped before the end of the table")
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
