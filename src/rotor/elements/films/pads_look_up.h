/// The numbers of bearings with pads, and the interpolation of their tables in lanes.
#ifndef ROTOR_PADS_LOOK_UP_H
#define ROTOR_PADS_LOOK_UP_H

#include <stdbool.h>

#include "element.h"
#include "elementary.h"
#include "pad_table.h"
#include "pad_tables.h"

enum { MAX_PADS = WHIRL_MAX_TILTING };

/// Numbers of the bearing: 1 divided by the pads' clearance in length scales; 2 divided by the magnitude of the shaft's
/// speed by tau, and the sign of that speed; factors that convert the film's force, the spring and the damper to the
/// tilts' slopes by tau; for yielding pivots the same factors along the radius.
enum {
    PADS_OVER_CLEARANCE,
    PADS_CLEARANCE_UNIT,
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

/// Numbers of every pad, from PADS_FIRST on: cosine and sine of its middle; the shift by the preload, and the pad's
/// direction at its pivot, in the frame of the middle; cosine and 1 divided by the sine of half the arc; the number of
/// its table.
enum {
    PAD_COSINE,
    PAD_SINE,
    PAD_SHIFT_X,
    PAD_SHIFT_Y,
    PAD_ALONG_X,
    PAD_ALONG_Y,
    PAD_HALF_COSINE,
    PAD_OVER_HALF_SINE,
    PAD_TABLE,
    PAD_NUMBERS,
    PADS_NUMBERS = PADS_FIRST + MAX_PADS * PAD_NUMBERS
};

/// Maximum number of states of a bearing with tilting pads: tilt and rate of every pad (without inertia only the tilt);
/// and on yielding pivots also the outward displacement of every pad and its rate.
enum { PADS_STATES = 2 * MAX_PADS, PADS_YIELDING_STATES = 2 * PADS_STATES };

/// Returns true if the pads tilt without inertia.
static inline bool pads_are_light(const element *own) {
    return own->states / (size_t)own->law % 2 == 1;
}

/// Compute four B-splines at u, which is 0 to 1 between two nodes; and their derivatives by the coordinate along the
/// axis, whose unit changes u by over_step.
VECTOR_INLINE void pads_splines(vec u, vec value[4]) {
    const vec m = v_sub(v_set(1.0), u), sixth = v_set(1.0 / 6.0), uu = v_mul(u, u), mm = v_mul(m, m);
    value[0] = v_mul(sixth, v_mul(mm, m));
    value[1] = v_fma(uu, v_fms(v_set(0.5), u, v_set(1.0)), v_set(2.0 / 3.0));
    value[2] = v_fma(mm, v_fms(v_set(0.5), m, v_set(1.0)), v_set(2.0 / 3.0));
    value[3] = v_mul(sixth, v_mul(uu, u));
}
VECTOR_INLINE void pads_spline_slopes(vec u, vec over_step, vec slope[4]) {
    const vec m = v_sub(v_set(1.0), u), half = v_mul(v_set(0.5), over_step), three = v_mul(v_set(3.0), half);
    const vec four = v_add(over_step, over_step);
    slope[0] = v_sub(v_set(0.0), v_mul(half, v_mul(m, m)));
    slope[1] = v_mul(u, v_fms(three, u, four));
    slope[2] = v_mul(m, v_fnma(three, m, four));
    slope[3] = v_mul(half, v_mul(u, u));
}

/// A position on an axis: the cell, the position in the cell, and 1 divided by the step (0 beyond the ends of the
/// axis). NaN counts as the first node.
typedef struct pads_axis {
    vec cell, u, over_step;
} pads_axis;

VECTOR_INLINE pads_axis pads_on_axis(vec at, double first, double step, int cells) {
    const vec place = v_fma(at, v_set(1.0 / step), v_set(-first / step)), zero = v_set(0.0), most = v_set(cells);
    const vec kept = v_min(v_max(place, zero), most), down = v_round(v_sub(kept, v_set(0.5)));
    const vec over = v_select(v_less(zero, place), v_select(v_less(place, most), v_set(1.0 / step), zero), zero);
    pads_axis on = {.cell = v_min(down, v_set(cells - 1)), .over_step = over};
    on.u = v_sub(kept, on.cell);
    return on;
}

/// Sums over t and w: of values and, if derivatives are requested, of those by t and by w; and their number.
enum { PADS_VALUE, PADS_BY_T, PADS_BY_W, PADS_SUMS };

/// The journal's place in a pad's table, for any direction: the rows of every lane's table with the index of the first
/// one; and for every sum the weights of the rows, which are products of the splines along t and w.
typedef struct pads_spot {
    const double *rows[VECTOR_LANES];
    vec first;
    double weight[PADS_SUMS][4][4][VECTOR_LANES];
} pads_spot;

/// Returns the tables of all lanes.
VECTOR_INLINE void pads_tables(vec table, const pad_table *of[VECTOR_LANES]) {
    double id[VECTOR_LANES];
    memcpy(id, &table, sizeof id);
    of[0] = pad_table_of(id[0]);
    for (size_t lane = 1; lane < VECTOR_LANES; lane++)
        of[lane] = id[lane] == id[lane - 1] ? of[lane - 1] : pad_table_of(id[lane]);
}

VECTOR_INLINE void pads_products(const vec t[4], const vec w[4], double weight[4][4][VECTOR_LANES]) {
    VECTOR_FOR (i, 4)
        VECTOR_FOR (j, 4) {
            const vec product = v_mul(t[i], w[j]);
            memcpy(weight[i][j], &product, sizeof product);
        }
}

VECTOR_INLINE void pads_find(vec table, vec t, vec w, bool sloped, pads_spot *spot) {
    const pads_axis on_t = pads_on_axis(t, PAD_MIN_T, PAD_STEP_T, PAD_T_NODES - 1);
    const pads_axis on_w = pads_on_axis(w, -PAD_MAX_W, PAD_STEP_W, PAD_W_NODES - 1);
    const pad_table *of[VECTOR_LANES];
    pads_tables(table, of);
    for (size_t lane = 0; lane < VECTOR_LANES; lane++) spot->rows[lane] = of[lane]->rows;
    spot->first = v_fma(on_t.cell, v_set(PAD_T_APART), v_mul(on_w.cell, v_set(PAD_W_APART)));
    vec along_t[4], along_w[4], slope[4];
    pads_splines(on_t.u, along_t);
    pads_splines(on_w.u, along_w);
    pads_products(along_t, along_w, spot->weight[PADS_VALUE]);
    if (!sloped) return;
    pads_spline_slopes(on_t.u, on_t.over_step, slope);
    pads_products(slope, along_w, spot->weight[PADS_BY_T]);
    pads_spline_slopes(on_w.u, on_w.over_step, slope);
    pads_products(along_t, slope, spot->weight[PADS_BY_W]);
}

/// Interpolates `lean` of a table (pads/pad_tables.h) between its nodes, linearly along both axes.
VECTOR_INLINE vec pads_lean(vec table, vec t, vec w) {
    const pads_axis on_t = pads_on_axis(t, PAD_MIN_T, PAD_STEP_T, PAD_T_NODES - 1);
    const pads_axis on_w = pads_on_axis(w, -PAD_MAX_W, PAD_STEP_W, PAD_W_NODES - 1);
    double row[VECTOR_LANES], column[VECTOR_LANES], corner[4][VECTOR_LANES];
    const pad_table *of[VECTOR_LANES];
    pads_tables(table, of);
    memcpy(row, &on_t.cell, sizeof row);
    memcpy(column, &on_w.cell, sizeof column);
    for (size_t lane = 0; lane < VECTOR_LANES; lane++) {
        const double *near = &of[lane]->lean[(size_t)row[lane]][(size_t)column[lane]];
        for (size_t i = 0; i < 4; i++) corner[i][lane] = near[i / 2 * PAD_W_NODES + i % 2];
    }
    vec at[4];
    memcpy(at, corner, sizeof at);
    const vec low = v_fma(on_w.u, v_sub(at[1], at[0]), at[0]), high = v_fma(on_w.u, v_sub(at[3], at[2]), at[2]);
    return v_fma(on_t.u, v_sub(high, low), low);
}

/// Sums both forces for four B-splines of alpha from its cell on, lane by lane and row by row. A row is one vector of
/// the widest instruction set, or two to eight vectors of narrower ones.
VECTOR_INLINE void pads_sum(const pads_spot *spot, vec cell, bool sloped, vec sums[][8]) {
    enum { PARTS = 8 / VECTOR_LANES };
    const int kinds = sloped ? PADS_SUMS : 1;
    double begin[VECTOR_LANES], all[PADS_SUMS][VECTOR_LANES][8];
    const vec first = v_fma(cell, v_set(PAD_ALPHA_APART), spot->first);
    memcpy(begin, &first, sizeof begin);
    // Sum rows of eight numbers, four by four.
    for (size_t lane = 0; lane < VECTOR_LANES; lane++) {
        const double *here = spot->rows[lane] + (size_t)begin[lane];
        vec sum[PADS_SUMS][PARTS];
        for (int kind = 0; kind < kinds; kind++)
            VECTOR_FOR (k, PARTS) sum[kind][k] = v_set(0.0);
        VECTOR_FOR (i, 4)
            VECTOR_FOR (j, 4) {
                const double *from = here + i * PAD_T_APART + j * PAD_W_APART;
                VECTOR_FOR (k, PARTS) {
                    const vec row = v_load(from + k * VECTOR_LANES);
                    for (int kind = 0; kind < kinds; kind++)
                        sum[kind][k] = v_fma(v_set(spot->weight[kind][i][j][lane]), row, sum[kind][k]);
                }
            }
        for (int kind = 0; kind < kinds; kind++) memcpy(all[kind][lane], sum[kind], sizeof sum[kind]);
    }
    // Transpose the rows of lanes to vectors.
    for (int kind = 0; kind < kinds; kind++) v_transpose((const double(*)[8])all[kind], sums[kind]);
}

/// Sums the two forces with the weights of the four splines.
VECTOR_INLINE void pads_weigh(const vec rows[8], const vec weight[4], vec force[2]) {
    for (int n = 0; n < 2; n++)
        force[n] = v_fma(weight[3], rows[6 + n],
                         v_fma(weight[2], rows[4 + n], v_fma(weight[1], rows[2 + n], v_mul(weight[0], rows[n]))));
}

VECTOR_INLINE pads_axis pads_on_alpha(vec half) {
    return pads_on_axis(v_add(half, half), -PAD_HALF_TURN, PAD_STEP_ALPHA, PAD_ALPHA_NODES);
}

/// Computes V, half of alpha and 1/V for (a, b). The 2^-600 prevents a division by zero for a journal that neither
/// turns nor moves relative to the pad.
VECTOR_INLINE void pads_polar(vec a, vec b, vec *V, vec *half, vec *over) {
    const vec square = v_fma(a, a, v_fma(b, b, v_set(0x1p-600)));
    *V = v_sqrt(square);
    *over = v_div(v_set(1.0), *V);
    const vec part = v_mul(v_set(0.5), *over);
    *half = v_half_angle(v_mul(a, part), v_mul(b, part));
}

/// Place of all lanes in the tables of a pad. The places of all pads of a bearing are found before any table is read,
/// so that no read waits for its address.
typedef struct pads_entry {
    pads_spot spot;
    pads_axis alpha;
} pads_entry;

VECTOR_INLINE void pads_enter(vec table, vec t, vec w, vec half, bool sloped, pads_entry *entry) {
    entry->alpha = pads_on_alpha(half);
    pads_find(table, t, w, sloped, &entry->spot);
}

/// Reads and interpolates S of every lane.
static inline void pads_read(const pads_entry *entry, vec force[2]) {
    vec rows[1][8], weight[4];
    pads_sum(&entry->spot, entry->alpha.cell, false, rows);
    pads_splines(entry->alpha.u, weight);
    pads_weigh(rows[PADS_VALUE], weight, force);
}

/// Reads S with its derivatives by t, w and half the angle alpha, which are 0 beyond the table.
static inline void pads_read_sloped(const pads_entry *entry, vec force[2], vec slope[2][3]) {
    vec rows[3][8], weight[4], turned[4], by[3][2];
    pads_sum(&entry->spot, entry->alpha.cell, true, rows);
    pads_splines(entry->alpha.u, weight);
    pads_spline_slopes(entry->alpha.u, v_set(2.0 / PAD_STEP_ALPHA), turned);
    pads_weigh(rows[PADS_VALUE], weight, force);
    pads_weigh(rows[PADS_BY_T], weight, by[0]);
    pads_weigh(rows[PADS_BY_W], weight, by[1]);
    pads_weigh(rows[PADS_VALUE], turned, by[2]);
    for (int n = 0; n < 2; n++)
        for (int k = 0; k < 3; k++) slope[n][k] = by[k][n];
}

#endif
