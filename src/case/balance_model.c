// Influence coefficients, modes and bearing loads of a rotor to be balanced, from its case.
#include "whirl/internal/balance.h"

#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input.h"
#include "matrix.h"
#include "settings.h"
#include "two_pi.h"
#include "whirl/engine/case.h"
#include "whirl/engine/linear.h"

static const double moment = 1e-6; // unbalance of the responses, kg m

/// A model that is being computed, and its case.
typedef struct modelling {
    const whirl_balance *balance;
    whirl_balance_model *model;
    whirl_study study;
    whirl_batch batch; ///< a batch without a parameter
    size_t station[WHIRL_MAX_PLANES];
} modelling;

/// Responses to 1 kg m in each plane at a speed, about one equilibrium.
typedef struct responses {
    whirl_machine machine; ///< with an unbalance in the last plane
    size_t dimension;
    double *rest;     ///< [dimension]
    double *response; ///< [planes][dimension][2]
} responses;

static void model_release(const whirl_machine *machine) {
    if (machine->release) machine->release(machine->owner);
}

static void responses_free(responses *of) {
    model_release(&of->machine);
    free(of->rest);
    free(of->response);
    *of = (responses){.rest = NULL};
}

static whirl_status model_machine(const modelling *c, double speed, whirl_variant variant, const whirl_placed *placed,
                                  whirl_machine *out) {
    whirl_batch batch = c->batch;
    batch.speed = speed;
    batch.variant = variant;
    batch.placed = placed;
    batch.placed_count = placed ? 1 : 0;
    const whirl_status status = c->study.machine(c->study.family, &batch, 0.0, out);
    return status;
}

/// Computes the response to an unbalance in a plane.
static whirl_status model_respond_plane(const modelling *c, double speed, size_t plane, responses *out) {
    const whirl_placed placed = {.station = c->station[plane], .moment = moment};
    model_release(&out->machine);
    out->machine = (whirl_machine){.system = NULL};
    whirl_status status = model_machine(c, speed, WHIRL_AS_GIVEN, &placed, &out->machine);
    if (status.code != WHIRL_OK) return status;
    const size_t d = out->dimension = out->machine.system->dimension;
    if (!out->rest) {
        out->rest = calloc(d + 1, sizeof *out->rest);
        out->response = calloc(2 * d * c->balance->plane_count + 1, sizeof *out->response);
    }
    if (!out->rest || !out->response) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of a model");
    double *own = out->response + 2 * d * plane;
    status = whirl_forced_response(out->machine.system, out->machine.start, out->rest, own);
    for (size_t i = 0; i < 2 * d; i++) own[i] /= moment;
    return status;
}

static whirl_status model_respond(const modelling *c, double speed, responses *out) {
    whirl_status status = whirl_ok();
    for (size_t p = 0; p < c->balance->plane_count && status.code == WHIRL_OK; p++)
        status = model_respond_plane(c, speed, p, out);
    if (status.code == WHIRL_BAD_INPUT || status.code == WHIRL_NUMERICAL_FAILURE)
        status = whirl_fail(WHIRL_BAD_INPUT, "the model at %.6g rpm: %.300s", speed * 60.0 / two_pi, status.message);
    return status;
}

// ---------------------------------------------------------------- stations

/// Finds the index of a station of the model; `what` and `name` are for the message.
static whirl_status model_find_station(const whirl_system *system, const char *station, const char *what,
                                       const char *name, size_t *index) {
    const char *names[WHIRL_MAX_PROBES];
    char advice[WHY_SIZE];
    for (*index = 0; *index < system->probe_count; ++*index)
        if (strcmp(system->probes[*index].name, station) == 0) return whirl_ok();
    for (size_t i = 0; i < system->probe_count; i++) names[i] = system->probes[i].name;
    describe_names(station, names, system->probe_count, advice);
    return whirl_fail(WHIRL_BAD_INPUT, "%s '%.63s' is at station '%.63s', which the model lacks, %s", what, name,
                      station, advice);
}

/// Returns the probe of that name; by default along x, at the station of that name.
static whirl_balance_probe model_probe(const whirl_balance *of, const char *name) {
    whirl_balance_probe own = {.limit = INFINITY};
    for (size_t i = 0; i < of->probe_count; i++)
        if (strcmp(of->probes[i].name, name) == 0) return of->probes[i];
    snprintf(own.name, sizeof own.name, "%s", name);
    snprintf(own.station, sizeof own.station, "%s", name);
    return own;
}

// ---------------------------------------------------------------- rows

/// Computes the vibration at a probe by 1 kg m in each plane: amplitudes as in the file, phases from the probe's mark.
static whirl_status model_vibration(const modelling *c, const responses *at, const char *name, double (*out)[2]) {
    const whirl_balance_probe own = model_probe(c->balance, name);
    const whirl_system *system = at->machine.system;
    size_t station;
    const whirl_status status = model_find_station(system, own.station, "probe", name, &station);
    if (status.code != WHIRL_OK) return status;
    const whirl_probe *probe = &system->probes[station];
    const double complex turned = cexp(I * whirl_probe_way(probe) * c->balance->keyphasor);
    for (size_t p = 0; p < c->balance->plane_count; p++) {
        const double *x = at->response + 2 * (at->dimension * p + probe->x),
                     *y = at->response + 2 * (at->dimension * p + probe->y);
        double complex seen = 0.0;
        if (whirl_probe_sees(probe, 0)) seen += cos(own.angle) * (x[0] + x[1] * I);
        if (whirl_probe_sees(probe, 1)) seen += sin(own.angle) * (y[0] + y[1] * I);
        seen *= turned * (at->machine.length * c->balance->kind);
        out[p][0] = creal(seen);
        out[p][1] = cimag(seen);
    }
    return status;
}

/// Fills in all rows at this speed: the influence by the model, and by models whose critical speeds are lower, and
/// higher, by the model's error.
static whirl_status model_fill_speed(const modelling *c, double speed) {
    whirl_status status = whirl_ok();
    for (int shift = -1; shift <= 1 && status.code == WHIRL_OK; shift++) {
        // If the machine's critical speeds are higher than the model's by a fraction, it behaves like the model at a
        // speed lower by that fraction.
        responses at = {.rest = NULL};
        status = model_respond(c, speed * (1.0 - shift * c->balance->model_error), &at);
        for (size_t r = 0; r < c->model->row_count && status.code == WHIRL_OK; r++) {
            whirl_modelled_row *row = &c->model->rows[r];
            if (row->speed == speed)
                status =
                    model_vibration(c, &at, row->probe, shift == 0 ? row->influence : row->shifted[shift > 0 ? 0 : 1]);
        }
        responses_free(&at);
    }
    return status;
}

static whirl_status model_find_rows(modelling *c) {
    whirl_balance_model *model = c->model;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < c->balance->vibration_count; i++) {
        const whirl_balance_vibration *seen = &c->balance->vibrations[i];
        size_t r = 0;
        while (r < model->row_count &&
               (model->rows[r].speed != seen->speed || strcmp(model->rows[r].probe, seen->probe) != 0))
            r++;
        if (r == model->row_count)
            model->rows[model->row_count++] = (whirl_modelled_row){.speed = seen->speed, .probe = seen->probe};
    }
    for (size_t r = 0; r < model->row_count && status.code == WHIRL_OK; r++) {
        bool known = false;
        for (size_t k = 0; k < r; k++) known = known || model->rows[k].speed == model->rows[r].speed;
        if (!known) status = model_fill_speed(c, model->rows[r].speed);
    }
    return status;
}

// ---------------------------------------------------------------- modes

/// Eigenvectors of a Jacobian [n][n], and of its transpose for the same eigenvalues.
typedef struct both_sides {
    size_t n;
    double *real, *imaginary, *right, *other_real, *other_imaginary, *left;
} both_sides;

static bool model_decompose(const double *jacobian, both_sides *of) {
    const size_t n = of->n;
    double *work = calloc(n * n + 1, sizeof *work);
    if (!work) return false;
    memcpy(work, jacobian, n * n * sizeof *work);
    bool well = matrix_eigen(n, work, of->real, of->imaginary, of->right);
    for (size_t i = 0; i < n && well; i++)
        for (size_t j = 0; j < n; j++) work[i * n + j] = jacobian[j * n + i];
    well = well && matrix_eigen(n, work, of->other_real, of->other_imaginary, of->left);
    free(work);
    return well;
}

/// Returns the left eigenvector [n][2] of eigenvalue `value`.
static const double *model_left_vector(const both_sides *of, size_t value) {
    size_t best = 0;
    double least = INFINITY;
    for (size_t i = 0; i < of->n; i++) {
        const double distance =
            hypot(of->other_real[i] - of->real[value], of->other_imaginary[i] - of->imaginary[value]);
        if (distance < least) least = distance, best = i;
    }
    return of->left + 2 * of->n * best;
}

static double complex model_product(size_t n, const double *a, const double *b) {
    double complex sum = 0.0;
    for (size_t i = 0; i < n; i++) sum += (a[2 * i] + a[2 * i + 1] * I) * (b[2 * i] + b[2 * i + 1] * I);
    return sum;
}

/// Extracts the mode with the largest part in the responses. With z and q its left and right vectors, |q| = 1, that
/// part of a response r is q (z r)/(z q); z r is the excitation of the mode by each plane.
static void model_take_mode(const modelling *c, const both_sides *of, const responses *at, size_t mode) {
    const size_t planes = c->balance->plane_count;
    double largest = 0.0;
    for (size_t i = 0; i < of->n; i++) {
        if (!(of->imaginary[i] > 0.0)) continue;
        const double *left = model_left_vector(of, i);
        const double complex scale = model_product(of->n, left, of->right + 2 * of->n * i);
        double complex own[WHIRL_MAX_PLANES], most = 0.0;
        for (size_t p = 0; p < planes; p++) {
            own[p] = model_product(of->n, left, at->response + 2 * of->n * p);
            if (cabs(own[p]) > cabs(most) * (1.0 + 1e-9)) most = own[p];
        }
        if (!(cabs(most / scale) > largest)) continue;
        largest = cabs(most / scale);
        c->model->natural[mode] = of->imaginary[i] * at->machine.clock;
        for (size_t p = 0; p < planes; p++) {
            c->model->shape[mode][p][0] = creal(own[p] / most);
            c->model->shape[mode][p][1] = cimag(own[p] / most);
        }
    }
}

static whirl_status model_find_mode(const modelling *c, size_t mode) {
    responses at = {.rest = NULL};
    whirl_status status = model_respond(c, c->balance->modes[mode].speed, &at);
    const size_t n = at.dimension;
    double *block = status.code == WHIRL_OK ? calloc(5 * n * n + 5 * n + 1, sizeof *block) : NULL;
    if (status.code == WHIRL_OK && !block) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of a model");
    if (block) {
        double *jacobian = block, *slope = block + 5 * n * n;
        both_sides of = {n, slope + n, slope + 2 * n, block + n * n, slope + 3 * n, slope + 4 * n, block + 3 * n * n};
        status = whirl_rest_slope(at.machine.system, at.rest, slope, jacobian);
        if (status.code == WHIRL_OK && !model_decompose(jacobian, &of))
            status = whirl_fail(WHIRL_NUMERICAL_FAILURE, "the modes of the model were not found");
        if (status.code == WHIRL_OK) model_take_mode(c, &of, &at, mode);
    }
    free(block);
    responses_free(&at);
    return status;
}

// ---------------------------------------------------------------- loads

/// Finds the load on the bearing nearest to each plane, if the machine has weight.
static whirl_status model_find_loads(const modelling *c) {
    whirl_machine machine = {.system = NULL};
    whirl_status status = model_machine(c, 0.0, WHIRL_WITH_STATICS, NULL, &machine);
    if (status.code == WHIRL_BAD_INPUT) return whirl_ok(); // no shaft whose weight bearings carry: loads stay unknown
    for (size_t p = 0; p < c->balance->plane_count && status.code == WHIRL_OK; p++) {
        const whirl_probe *probes = machine.system->probes, *own = &probes[c->station[p]];
        double nearest = INFINITY;
        c->model->position[p] = own->shaft ? own->position : (double)NAN;
        for (size_t i = 0; own->shaft && i < machine.system->probe_count; i++) {
            const double distance = fabs(probes[i].position - own->position);
            if (probes[i].shaft != own->shaft || !(machine.statics[i].bearings > 0.0) || !(distance < nearest))
                continue;
            nearest = distance;
            c->model->load[p] = fabs(9.80665 * machine.statics[i].carried);
            snprintf(c->model->bearing[p], sizeof c->model->bearing[p], "%s", probes[i].name);
        }
    }
    model_release(&machine);
    return status;
}

// ---------------------------------------------------------------- the whole model

static whirl_status model_find_planes(modelling *c) {
    whirl_machine machine = {.system = NULL};
    whirl_status status = model_machine(c, 0.0, WHIRL_AS_GIVEN, NULL, &machine);
    for (size_t p = 0; p < c->balance->plane_count && status.code == WHIRL_OK; p++) {
        const whirl_balance_plane *own = &c->balance->planes[p];
        c->model->load[p] = c->model->position[p] = NAN;
        status = model_find_station(machine.system, *own->station ? own->station : own->name, "plane", own->name,
                                    &c->station[p]);
    }
    model_release(&machine);
    return status;
}

static whirl_status model_compute(const whirl_balance *balance, const whirl_case *object, whirl_balance_model *model) {
    modelling c = {.balance = balance, .model = model};
    whirl_status status = whirl_case_study(object, &c.study);
    if (status.code != WHIRL_OK) return status;
    c.batch = c.study.batches[0];
    c.batch.parameter[0] = c.batch.second[0] = c.batch.third[0] = '\0';
    c.batch.given_count = 0;
    status = model_find_planes(&c);
    if (status.code == WHIRL_OK) status = model_find_loads(&c);
    if (status.code == WHIRL_OK) status = model_find_rows(&c);
    for (size_t n = 0; n < balance->mode_count && status.code == WHIRL_OK; n++)
        if (!balance->modes[n].shaped) status = model_find_mode(&c, n);
    return status;
}

whirl_status whirl_balance_consult(const whirl_balance *balance, const char *path, whirl_problems *problems,
                                   whirl_balance_model **model) {
    char place[4096];
    whirl_case *object;
    *model = NULL;
    if (!*balance->model) return whirl_ok();
    if (!input_path_from(path, balance->model, place, sizeof place))
        return whirl_fail(WHIRL_BAD_INPUT, "%.100s is too long for the path of a case", balance->model);
    whirl_status status = whirl_case_load(place, problems, &object);
    if (status.code != WHIRL_OK) return status;
    whirl_balance_model *out = calloc(1, sizeof *out);
    if (out) out->rows = calloc(balance->vibration_count + 1, sizeof *out->rows);
    status =
        out && out->rows ? model_compute(balance, object, out) : whirl_fail(WHIRL_NO_MEMORY, "no memory for a model");
    whirl_case_free(object);
    if (status.code == WHIRL_OK)
        *model = out;
    else
        whirl_balance_model_free(out);
    return status;
}

void whirl_balance_model_free(whirl_balance_model *model) {
    if (model) free(model->rows);
    free(model);
}
