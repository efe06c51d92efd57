// Any bytes as a claims file: refused with a problem, or claims within their ranges.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "claims.h"
#include "whirl/engine/claims.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

static void check_claim(const whirl_claim *claim) {
    require(isfinite(claim->from) && isfinite(claim->to) && claim->from <= claim->to);
    require(claim->period >= 0 && claim->period <= WHIRL_MAX_PERIOD);
    require(claim->line_count <= WHIRL_MAX_CLAIM_LINES);
    require(memchr(claim->where, '\0', sizeof claim->where) != NULL);
    require(memchr(claim->says, '\0', sizeof claim->says) != NULL);
    require(memchr(claim->whirl, '\0', sizeof claim->whirl) != NULL);
    require(!claim->has_band || claim->band[0] < claim->band[1]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 16) return 0;
    whirl_problems problems = {0};
    whirl_claims *claims = NULL;
    const whirl_status status = claims_parse((const char *)data, size, "fuzz.yaml", &problems, &claims);
    require((status.code == WHIRL_OK) == (claims != NULL));
    require((status.code == WHIRL_OK) == (problems.count == 0));
    for (size_t i = 0; claims && i < claims->count; i++) check_claim(&claims->items[i]);
    whirl_problems_free(&problems);
    whirl_claims_free(claims);
    return 0;
}
