// Reads any bytes as the file of a bearing: they are refused with a problem, or are a bearing that can be computed.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "whirl/engine/case.h"
#include "whirl/internal/bearing_table.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

/// Checks the preconditions of the solver. The solver is not called, because a point takes seconds under the
/// sanitizers.
static void check(const whirl_bearing *bearing) {
    require(bearing->count >= 1 && bearing->pads.count >= 1 && bearing->pads.count <= WHIRL_MAX_PADS);
    require(bearing->ratio_count >= 1 && bearing->ratio_count <= WHIRL_MAX_WHIRL_RATIOS);
    require(bearing->viscosity > 0.0 && bearing->pad_clearance > 0.0 && bearing->radius > 0.0);
    require(bearing->length > 0.0 && bearing->pads.ratio > 0.0 && isfinite(bearing->pads.ratio));
    require(bearing->pads.fineness >= 0 && bearing->pads.fineness % 16 == 0);
    for (size_t i = 0; i < bearing->pads.count; i++) {
        const whirl_pad *pad = &bearing->pads.pads[i];
        require(isfinite(pad->pivot) && pad->arc > 0.0 && pad->arc < 6.3);
        require(pad->offset >= 0.0 && pad->offset <= 1.0 && fabs(pad->preload) < 1.0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 14) return 0;
    whirl_problems problems = {0};
    whirl_bearing *bearing = NULL;
    const whirl_status status = whirl_bearing_parse((const char *)data, size, "fuzz.yaml", &problems, &bearing);
    require((status.code == WHIRL_OK) == (bearing != NULL));
    require((status.code == WHIRL_OK) == (problems.count == 0));
    if (bearing) check(bearing);
    whirl_problems_free(&problems);
    whirl_bearing_free(bearing);
    return 0;
}
