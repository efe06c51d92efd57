// Influence coefficients and corrections by complex least squares.
#include "whirl/balance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix.h"

static const double two_pi = 6.283185307179586476925;

/// Complex least squares: unknowns x [n] of rows a x = b, each of its weight, by their normal equations.
typedef struct normal {
    size_t n;
    double matrix[(WHIRL_MAX_PLANES + 1) * (WHIRL_MAX_PLANES + 1)][2], side[WHIRL_MAX_PLANES + 1][2];
} normal;

static void normal_add(normal *of, const double (*a)[2], const double b[2], double weight) {
    for (size_t i = 0; i < of->n; i++) {
        of->side[i][0] += weight * (a[i][0] * b[0] + a[i][1] * b[1]);
        of->side[i][1] += weight * (a[i][0] * b[1] - a[i][1] * b[0]);
        for (size_t j = 0; j < of->n; j++) {
            double *out = of->matrix[i * of->n + j];
            out[0] += weight * (a[i][0] * a[j][0] + a[i][1] * a[j][1]);
            out[1] += weight * (a[i][0] * a[j][1] - a[i][1] * a[j][0]);
        }
    }
}

/// The unknowns in `side`; false where the rows do not tell all of them.
static bool normal_solve(normal *of) {
    static const double least = 1e-10; // of what remains of an unknown beside the others, in squares
    double scale[WHIRL_MAX_PLANES + 1], rest[(WHIRL_MAX_PLANES + 1) * (WHIRL_MAX_PLANES + 1)][2];
    const size_t n = of->n;
    for (size_t i = 0; i < n; i++) {
        scale[i] = sqrt(of->matrix[i * n + i][0]);
        if (!(scale[i] > 0.0)) return false;
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++)
            for (int c = 0; c < 2; c++) of->matrix[i * n + j][c] /= scale[i] * scale[j];
        for (int c = 0; c < 2; c++) of->side[i][c] /= scale[i];
    }
    // Cholesky's pivots tell how much of each unknown the ones before leave.
    memcpy(rest, of->matrix, sizeof rest);
    for (size_t k = 0; k < n; k++) {
        if (!(rest[k * n + k][0] > least)) return false;
        for (size_t i = k + 1; i < n; i++)
            for (size_t j = k + 1; j < n; j++) {
                const double *a = rest[i * n + k], *b = rest[k * n + j], pivot = rest[k * n + k][0];
                rest[i * n + j][0] -= (a[0] * b[0] - a[1] * b[1]) / pivot;
                rest[i * n + j][1] -= (a[0] * b[1] + a[1] * b[0]) / pivot;
            }
    }
    if (!matrix_solve_complex(n, of->matrix[0], 1, of->side[0])) return false;
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 2; c++) of->side[i][c] /= scale[i];
    return true;
}

// ---------------------------------------------------------------- influence

static bool is_row(const whirl_balance_row *row, const whirl_balance_vibration *seen) {
    return row->speed == seen->speed && strcmp(row->probe, seen->probe) == 0;
}

static void find_rows(const whirl_balance *of, whirl_correction *out) {
    for (size_t i = 0; i < of->vibration_count; i++) {
        const whirl_balance_vibration *seen = &of->vibrations[i];
        size_t r = 0;
        while (r < out->row_count && !is_row(&out->rows[r], seen)) r++;
        if (r == out->row_count)
            out->rows[out->row_count++] =
                (whirl_balance_row){.speed = seen->speed, .probe = seen->probe, .weight = seen->weight};
    }
}

static whirl_status find_influence(const whirl_balance *of, whirl_balance_row *row) {
    const double rpm = two_pi / 60.0;
    normal equations = {.n = of->plane_count + 1};
    size_t runs = 0;
    for (size_t i = 0; i < of->vibration_count; i++) {
        double a[WHIRL_MAX_PLANES + 1][2] = {{1.0, 0.0}};
        if (!is_row(row, &of->vibrations[i])) continue;
        for (size_t t = 0; t < of->trial_count; t++)
            if (of->trials[t].run == of->vibrations[i].run)
                for (int c = 0; c < 2; c++) a[1 + of->trials[t].plane][c] += of->trials[t].moment[c];
        normal_add(&equations, (const double(*)[2])a, of->vibrations[i].vibration, 1.0);
        runs++;
    }
    if (runs < of->plane_count + 1 || !normal_solve(&equations))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "probe '%.63s' at %.6g rpm was read in %zu run%s that do not tell %zu plane%s apart, expected one "
            "without and one more for every plane",
            row->probe, row->speed / rpm, runs, runs == 1 ? "" : "s", of->plane_count, of->plane_count == 1 ? "" : "s");
    memcpy(row->before, equations.side[0], sizeof row->before);
    memcpy(row->influence, equations.side + 1, of->plane_count * sizeof *row->influence);
    return whirl_ok();
}

// ---------------------------------------------------------------- correction

static void predict(const whirl_balance *of, const whirl_correction *with, whirl_balance_row *row) {
    memcpy(row->after, row->before, sizeof row->after);
    for (size_t p = 0; p < of->plane_count; p++) {
        const double *a = row->influence[p], *u = with->moment[p];
        row->after[0] += a[0] * u[0] - a[1] * u[1];
        row->after[1] += a[0] * u[1] + a[1] * u[0];
    }
}

static whirl_status solve(const whirl_balance *of, whirl_correction *out) {
    normal equations = {.n = of->plane_count};
    whirl_status status = whirl_ok();
    find_rows(of, out);
    for (size_t r = 0; r < out->row_count && status.code == WHIRL_OK; r++) {
        whirl_balance_row *row = &out->rows[r];
        status = find_influence(of, row);
        const double against[2] = {-row->before[0], -row->before[1]};
        normal_add(&equations, (const double(*)[2])row->influence, against, row->weight);
    }
    if (status.code != WHIRL_OK) return status;
    if (!normal_solve(&equations))
        return whirl_fail(
            WHIRL_BAD_INPUT,
            "%zu probe%s at a speed do not tell the weights of %zu plane%s apart, expected as many as planes at "
            "least, with weights above 0, which each plane moves in a way of its own",
            out->row_count, out->row_count == 1 ? "" : "s", of->plane_count, of->plane_count == 1 ? "" : "s");
    for (size_t p = 0; p < of->plane_count; p++) memcpy(out->moment[p], equations.side[p], sizeof out->moment[p]);
    for (size_t r = 0; r < out->row_count; r++) predict(of, out, &out->rows[r]);
    return status;
}

whirl_status whirl_balance_solve(const whirl_balance *balance, whirl_correction **correction) {
    whirl_correction *out = calloc(1, sizeof *out);
    *correction = NULL;
    if (out) out->rows = calloc(balance->vibration_count + 1, sizeof *out->rows);
    const whirl_status status =
        out && out->rows ? solve(balance, out) : whirl_fail(WHIRL_NO_MEMORY, "no memory to balance a rotor");
    if (status.code == WHIRL_OK)
        *correction = out;
    else
        whirl_correction_free(out);
    return status;
}

void whirl_correction_free(whirl_correction *correction) {
    if (correction) free(correction->rows);
    free(correction);
}

void whirl_balance_split(const whirl_balance *balance, size_t plane, const double moment[2], int hole[2],
                         double moments[2]) {
    const whirl_balance_plane *own = &balance->planes[plane];
    const double way = balance->against ? -1.0 : 1.0, step = two_pi / own->holes, size = hypot(moment[0], moment[1]);
    double place = way * (atan2(moment[1], moment[0]) - own->first_hole) / step;
    place -= own->holes * floor(place / own->holes);
    const double near = floor(place + 0.5), beyond = floor(place);
    const bool at_hole = fabs(place - near) < 1e-6 || own->holes < 3;
    hole[0] = 1 + (int)(at_hole ? near : beyond) % own->holes;
    hole[1] = 1 + hole[0] % own->holes;
    const double angle = (place - beyond) * step;
    moments[0] = at_hole ? size : size * sin(step - angle) / sin(step);
    moments[1] = at_hole ? 0.0 : size * sin(angle) / sin(step);
}

double whirl_balance_allowed(const whirl_balance *balance) {
    if (!(balance->mass > 0.0 && balance->grade > 0.0 && balance->service_speed > 0.0)) return NAN;
    return 1e-3 * balance->grade * balance->mass / balance->service_speed;
}
