// Any bytes as a balancing file: refused with a problem, or numbers that are balanced or refused with a sentence.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "whirl/engine/case.h"
#include "whirl/internal/balance.h"
#include "whirl/internal/findings.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

static void solve(const whirl_balance *balance, const whirl_balance_model *model) {
    static FILE *nowhere;
    whirl_correction *found;
    whirl_findings *findings;
    if (!nowhere) nowhere = fopen("/dev/null", "w");
    const whirl_status status = whirl_balance_solve(balance, model, &found);
    require((status.code == WHIRL_OK) == (found != NULL));
    require(status.code == WHIRL_OK || status.message[0] != '\0');
    if (!found || !nowhere) return;
    if (whirl_balance_findings(balance, model, found, NULL, &findings).code == WHIRL_OK)
        whirl_findings_write_text(findings, nowhere);
    whirl_findings_free(findings);
    whirl_balance_write_json(balance, model, found, NULL, nowhere);
    whirl_correction_free(found);
}

/// Makes a model of the right sizes, without the case that the file names.
static void make_up(const whirl_balance *balance, whirl_balance_model *out) {
    *out = (whirl_balance_model){.row_count = balance->vibration_count};
    out->rows = calloc(balance->vibration_count + 1, sizeof *out->rows);
    for (size_t i = 0; i < balance->vibration_count && out->rows; i++) {
        whirl_modelled_row *row = &out->rows[i];
        row->speed = balance->vibrations[i].speed;
        row->probe = balance->vibrations[i].probe;
        for (size_t p = 0; p < balance->plane_count; p++) row->influence[p][i % 2] = 1.0 + (double)(i * p % 5);
    }
    for (size_t p = 0; p < balance->plane_count; p++) {
        out->load[p] = p % 2 ? (double)NAN : 1000.0;
        out->position[p] = 0.1 * (double)p;
        for (size_t n = 0; n < balance->mode_count; n++) out->shape[n][p][n % 2] = sin(1.0 + (double)((n + 1) * p));
    }
}

static void check(const whirl_balance *balance) {
    require(balance->plane_count >= 1 && balance->plane_count <= WHIRL_MAX_PLANES);
    require(balance->mode_count <= WHIRL_MAX_PLANES && balance->probe_count <= WHIRL_MAX_BALANCE_PROBES);
    for (size_t i = 0; i < balance->trial_count; i++) {
        const whirl_balance_trial *trial = &balance->trials[i];
        require(trial->plane == WHIRL_BALANCE_SET ? trial->mode < balance->mode_count
                                                  : trial->plane < balance->plane_count);
    }
    whirl_balance_model model;
    make_up(balance, &model);
    solve(balance, NULL);
    if (model.rows) solve(balance, &model);
    free(model.rows);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 14) return 0;
    whirl_problems problems = {0};
    whirl_balance *balance = NULL;
    const whirl_status status = whirl_balance_parse((const char *)data, size, "fuzz.yaml", &problems, &balance);
    require((status.code == WHIRL_OK) == (balance != NULL));
    require((status.code == WHIRL_OK) == (problems.count == 0));
    if (balance) check(balance);
    whirl_problems_free(&problems);
    whirl_balance_free(balance);
    return 0;
}
