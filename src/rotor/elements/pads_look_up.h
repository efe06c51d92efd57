/// The numbers of bearings of pads, and their tables in lanes.
#ifndef ROTOR_PADS_LOOK_UP_H
#define ROTOR_PADS_LOOK_UP_H

#include "tables.h"
#include "vector.h"

enum { MAX_PADS = 6 };

/// Of the bearing: one over the pads' clearance in length scales; 2 over the speed of the shaft by tau, without its
/// sign, which stands beside it; of the tilts by tau what the film's force, a spring and a damper make of them, and of
/// pads on pivots that yield the same along the radius.
enum {
    PADS_OVER_CLEARANCE,
    PADS_TWICE,
    PADS_SIGN,
    PADS_TILT_FORCE,
    PADS_TILT_SPRING,
    PADS_TILT_DAMPER,
    PADS_YIELD_FORCE,
    PADS_YIELD_SPRING,
    PADS_YIELD_DAMPER,
    PADS_FIRST
};

/// Of every pad, from PADS_FIRST on: its middle; by what the preload moves the journal and how the pad lies at its
/// pivot, in the frame of the middle; half the arc; the number of its table.
enum {
    PAD_COSINE,
    PAD_SINE,
    PAD_SHIFT_X,
    PAD_SHIFT_Y,
    PAD_ALONG_X,
    PAD_ALONG_Y,
    PAD_HALF_COSINE,
    PAD_HALF_SINE,
    PAD_TABLE,
    PAD_NUMBERS,
    PADS_NUMBERS = PADS_FIRST + MAX_PADS * PAD_NUMBERS
};

/// States of a bearing of pads that tilt, at most: of every pad the tilt and its rate; of those on pivots that yield
/// then of every pad how far it has moved outwards, and that rate.
enum { PADS_STATES = 2 * MAX_PADS, PADS_YIELDING_STATES = 2 * PADS_STATES };

/// Four B-splines at u from 0 to 1 between two nodes; their derivatives by u.
VECTOR_INLINE void pads_splines(vec u, vec value[4]) {
    const vec m = v_sub(v_set(1.0), u), sixth = v_set(1.0 / 6.0), uu = v_mul(u, u), mm = v_mul(m, m);
    value[0] = v_mul(sixth, v_mul(mm, m));
    value[1] = v_fma(uu, v_fms(v_set(0.5), u, v_set(1.0)), v_set(2.0 / 3.0));
    value[2] = v_fma(mm, v_fms(v_set(0.5), m, v_set(1.0)), v_set(2.0 / 3.0));
    value[3] = v_mul(sixth, v_mul(uu, u));
}
VECTOR_INLINE void pads_spline_slopes(vec u, vec slope[4]) {
    const vec m = v_sub(v_set(1.0), u), half = v_set(0.5);
    slope[0] = v_sub(v_set(0.0), v_mul(half, v_mul(m, m)));
    slope[1] = v_mul(u, v_fms(v_set(1.5), u, v_set(2.0)));
    slope[2] = v_mul(m, v_fnma(v_set(1.5), m, v_set(2.0)));
    slope[3] = v_mul(half, v_mul(u, u));
}

enum { AXIS_T, AXIS_W, AXIS_ALPHA, PAD_AXES };

/// Where all lanes are on the axes of their tables.
typedef struct pads_cells {
    const pad_table *table[VECTOR_LANES];
    size_t cell[PAD_AXES][VECTOR_LANES];
    vec value[PAD_AXES][4], slope[PAD_AXES][4];
} pads_cells;

/// The cell of one lane, and where it is in it: not a number counts as the first node.
static inline size_t pads_cell(const pad_axis *of, double at, int cells, double *u, double *over) {
    const double place = (at - of->first) / of->step;
    const bool inside = place > 0.0 && place < cells;
    const double kept = place > 0.0 ? (place < cells ? place : cells) : 0.0;
    const int cell = kept < cells ? (int)kept : cells - 1;
    *u = kept - cell;
    *over = inside ? 1.0 / of->step : 0.0;
    return (size_t)cell;
}

/// Slopes beyond the table are 0.
VECTOR_INLINE void pads_find(size_t stride, const vec *pad, const vec at[PAD_AXES], bool sloped, pads_cells *found) {
    double where[PAD_AXES][VECTOR_LANES], u[PAD_AXES][VECTOR_LANES], over[PAD_AXES][VECTOR_LANES], id[VECTOR_LANES];
    memcpy(where, at, sizeof where);
    memcpy(id, &pad[PAD_TABLE * stride], sizeof id);
    for (size_t lane = 0; lane < VECTOR_LANES; lane++) {
        const pad_table *table = pad_table_of(id[lane]);
        const pad_axis *axes[] = {&table->t, &table->w, &table->alpha};
        found->table[lane] = table;
        for (int k = 0; k < PAD_AXES; k++)
            found->cell[k][lane] =
                pads_cell(axes[k], where[k][lane], axes[k]->count - (k != AXIS_ALPHA), &u[k][lane], &over[k][lane]);
    }
    for (int k = 0; k < PAD_AXES; k++) {
        vec place, by;
        memcpy(&place, u[k], sizeof place);
        memcpy(&by, over[k], sizeof by);
        pads_splines(place, found->value[k]);
        if (!sloped) continue;
        pads_spline_slopes(place, found->slope[k]);
        for (int i = 0; i < 4; i++) found->slope[k][i] = v_mul(by, found->slope[k][i]);
    }
}

/// One lane: both sums with these weights.
static inline void pads_sum(const pads_cells *at, size_t lane, const double t[4], const double w[4], const double a[4],
                            double out[2]) {
    const pad_table *table = at->table[lane];
    const size_t columns = 2 * (size_t)(table->alpha.count + 3), rows = columns * (size_t)(table->w.count + 2);
    const double *first = table->coefficients + at->cell[AXIS_T][lane] * rows + at->cell[AXIS_W][lane] * columns +
                          2 * at->cell[AXIS_ALPHA][lane];
    double sum[8] = {0.0};
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++) {
            const double *row = first + i * rows + j * columns, weight = t[i] * w[j];
            for (int k = 0; k < 8; k++) sum[k] += weight * row[k];
        }
    for (int n = 0; n < 2; n++) out[n] = (a[0] * sum[n] + a[1] * sum[2 + n]) + (a[2] * sum[4 + n] + a[3] * sum[6 + n]);
}

static inline void pads_weights(const vec from[4], double to[4][VECTOR_LANES]) {
    memcpy(to, from, 4 * sizeof *from);
}

/// S of every lane, and unless NULL its derivatives by t, w and half the angle alpha.
static inline void pads_look_up(size_t stride, const vec *pad, vec t, vec w, vec half, vec sum[2], vec slope[2][3]) {
    pads_cells found;
    const vec at[PAD_AXES] = {t, w, v_add(half, half)};
    double value[PAD_AXES][4][VECTOR_LANES], turned[PAD_AXES][4][VECTOR_LANES], out[4][2][VECTOR_LANES];
    pads_find(stride, pad, at, slope != NULL, &found);
    for (int k = 0; k < PAD_AXES; k++) {
        pads_weights(found.value[k], value[k]);
        if (slope) pads_weights(found.slope[k], turned[k]);
    }
    // Which axis a derivative is by: none, then one after the other.
    for (int by = -1; by < (slope ? PAD_AXES : 0); by++)
        for (size_t lane = 0; lane < VECTOR_LANES; lane++) {
            double own[PAD_AXES][4], two[2];
            for (int k = 0; k < PAD_AXES; k++)
                for (int i = 0; i < 4; i++) own[k][i] = k == by ? turned[k][i][lane] : value[k][i][lane];
            pads_sum(&found, lane, own[AXIS_T], own[AXIS_W], own[AXIS_ALPHA], two);
            for (int n = 0; n < 2; n++) out[by + 1][n][lane] = two[n];
        }
    for (int n = 0; n < 2; n++) {
        memcpy(&sum[n], out[0][n], sizeof sum[n]);
        for (int k = 0; slope && k < 3; k++) memcpy(&slope[n][k], out[k + 1][n], sizeof slope[n][k]);
        if (slope) slope[n][2] = v_add(slope[n][2], slope[n][2]);
    }
}

#endif
