// What the method of Dormand and Prince needs in lanes.
#include "adaptive_lanes.h"
#include "method.h"

static adaptive_lanes_revolve *const revolves[VECTOR_ISAS] = EVERY_ISA(, dop853_lanes);

static size_t group(size_t rates) {
    return rates <= 8 ? 4 : rates <= 20 ? 2 : 1;
}

static size_t lay_out(adaptive_lanes *lanes, double *block) {
    dop853_work *own = &lanes->dop853;
    size_t row = 0;
    for (size_t i = 0; i < DOP853_SLOPES; i++, row += lanes->rates) own->k[i] = lanes_row(lanes, block, row);
    own->base = lanes_row(lanes, block, row);
    lanes->slope = own->k[0];
    lanes->end_slope = own->k[DOP853_STAGES];
    lanes->later = own->k[1];
    return row + 2;
}

static void prepare(adaptive_lanes *lanes) {
    dop853_sums_fill(&lanes->dop853.sums, lanes->rates * lanes->stride);
}

const lanes_method dop853_in_lanes = {&dop853_formula, revolves, DENSE, group, lay_out, prepare};
