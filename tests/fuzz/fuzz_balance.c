// Any bytes as a balancing file: refused with a problem, or numbers that are balanced or refused with a sentence.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "whirl/balance.h"
#include "whirl/case.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

static void check(const whirl_balance *balance) {
    static FILE *nowhere;
    whirl_correction *found;
    if (!nowhere) nowhere = fopen("/dev/null", "w");
    require(balance->plane_count >= 1 && balance->plane_count <= WHIRL_MAX_PLANES);
    for (size_t i = 0; i < balance->trial_count; i++) require(balance->trials[i].plane < balance->plane_count);
    const whirl_status status = whirl_balance_solve(balance, &found);
    require((status.code == WHIRL_OK) == (found != NULL));
    require(status.code == WHIRL_OK || status.message[0] != '\0');
    if (!found || !nowhere) return;
    whirl_balance_write_summary(balance, found, nowhere);
    whirl_balance_write_json(balance, found, nowhere);
    whirl_correction_free(found);
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
