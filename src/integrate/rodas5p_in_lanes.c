// What rodas5p needs in lanes.
#include "adaptive_lanes.h"
#include "method.h"

static adaptive_lanes_revolve *const revolves[VECTOR_ISAS] = EVERY_ISA(, rodas5p_lanes);

static size_t group(size_t degrees) {
    return degrees <= 10 ? 4 : degrees <= 20 ? 2 : 1;
}

static size_t lay_out(adaptive_lanes *lanes, double *block) {
    rodas5p_work *own = &lanes->rodas5p;
    const size_t n = lanes->degrees, set = (1 + 2 * n) * n;
    const struct {
        double **array;
        size_t rows;
    } parts[] = {
        {&lanes->slope, n},   {&lanes->end_slope, n},
        {&own->unit_q, set},  {&own->unit_v, set},
        {&own->by, set},      {&own->matrix, n * n},
        {&own->pivot, n},     {&own->doubtful, 1},
        {&own->shift, 1},     {&own->rate, n},
        {&own->right_q, n},   {&own->between_q, n},
        {&own->between_v, n}, {&own->ahead, lanes->forcing_count},
    };
    size_t row = 0;
    for (int i = 0; i < RODAS5P_STAGES; i++, row += 2 * n) {
        own->u_q[i] = lanes_row(lanes, block, row);
        own->u_v[i] = lanes_row(lanes, block, row + n);
    }
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++, row += parts[i - 1].rows)
        *parts[i].array = lanes_row(lanes, block, row);
    lanes->later = own->rate;
    return row;
}

/// The unit disturbances, which stay: of positions, then of velocities.
static void prepare(adaptive_lanes *lanes) {
    const size_t n = lanes->degrees;
    for (size_t d = 0; d < n; d++)
        for (size_t slot = 0; slot < lanes->slots; slot++) {
            lanes->rodas5p.unit_q[((1 + d) * n + d) * lanes->slots + slot] = 1.0;
            lanes->rodas5p.unit_v[((1 + n + d) * n + d) * lanes->slots + slot] = 1.0;
        }
}

const lanes_method rodas5p_in_lanes = {&rodas5p_formula, revolves, RODAS5P_DENSE, group, lay_out, prepare};
