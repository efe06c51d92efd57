// What rodas5p needs in lanes.
#include "adaptive_lanes.h"
#include "method.h"

static adaptive_lanes_revolve *const revolves[VECTOR_ISAS] = EVERY_ISA(, rodas5p_lanes);

static size_t group(size_t rates) {
    return rates <= 10 ? 4 : rates <= 20 ? 2 : 1;
}

static size_t lay_out(adaptive_lanes *lanes, double *block) {
    rodas5p_work *own = &lanes->rodas5p;
    const size_t n = lanes->degrees, m = lanes->rates, sets = 1 + lanes->dimension;
    const struct {
        double **array;
        size_t rows;
    } parts[] = {
        {&lanes->slope, m},       {&lanes->end_slope, m},
        {&own->unit_q, sets * n}, {&own->unit_v, sets * m},
        {&own->by, sets * m},     {&own->matrix, m * m},
        {&own->pivot, m},         {&own->doubtful, 1},
        {&own->shift, 1},         {&own->rate, m},
        {&own->right_q, n},       {&own->between_q, n},
        {&own->between_v, m},     {&own->ahead, lanes->forcing_count},
    };
    size_t row = 0;
    for (int i = 0; i < RODAS5P_STAGES; i++, row += n + m) {
        own->u_q[i] = lanes_row(lanes, block, row);
        own->u_v[i] = lanes_row(lanes, block, row + n);
    }
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += parts[i - 1].rows)
        *parts[i].array = lanes_row(lanes, block, row);
    lanes->later = own->rate;
    return row;
}

/// The unit disturbances, which stay: of positions, then of rates.
static void prepare(adaptive_lanes *lanes) {
    const size_t n = lanes->degrees, m = lanes->rates;
    for (size_t slot = 0; slot < lanes->slots; slot++) {
        for (size_t d = 0; d < n; d++) lanes->rodas5p.unit_q[((1 + d) * n + d) * lanes->slots + slot] = 1.0;
        for (size_t d = 0; d < m; d++) lanes->rodas5p.unit_v[((1 + n + d) * m + d) * lanes->slots + slot] = 1.0;
    }
}

const lanes_method rodas5p_in_lanes = {&rodas5p_formula, revolves, RODAS5P_DENSE, group, lay_out, prepare};
