/// Shafts of finite elements and coupled masses in lanes: products of matrices that all lanes share.
///
/// A few rows and a few vectors are summed at a time. So sums stay in registers; each column is loaded once for all
/// rows, and each number once for all vectors.
#ifndef ROTOR_BODY_KERNEL_H
#define ROTOR_BODY_KERNEL_H

#include "block.h"
#include "body.h"

/// Rows and vectors that are summed together: as many sums as fit into registers.
enum { SUM_ROWS = VECTOR_ISA == VECTOR_AVX512 ? 8 : 4, SUMS = VECTOR_ISA >= VECTOR_AVX2 ? 3 : 2 };

/// Arguments of a panel: the vectors k to before k + count of the block, of its state or of a perturbation.
typedef struct panel_work {
    const vec *q, *v, *steps; ///< steps: the machine's body_rates
    const vec *value;         ///< value of the forcing; NULL: none
    vec *a;
    size_t stride, rows; ///< rows: number of rows of the panel
    bool beside;         ///< a perturbation, on which steady forces do not act
} panel_work;

/// Returns a rate divided by a later one; with RATES as the later one, the rate itself.
static inline const vec *rate_over(const panel_work *w, body_rate rate, body_rate later) {
    return w->steps + body_step(rate, later) * w->stride;
}

VECTOR_INLINE void add_column(const double *number, const vec *x, size_t rows, size_t count, vec sum[SUM_ROWS][SUMS]) {
    VECTOR_FOR (r, rows)
        VECTOR_FOR (i, count) sum[r][i] = v_fma(v_set(number[r]), x[i], sum[r][i]);
}

VECTOR_INLINE void add_part(const body_panels *of, const body_part *part, const panel_work *w, size_t first,
                            size_t rows, size_t count, size_t k, vec sum[SUM_ROWS][SUMS]) {
    const vec *x = (part->kind.source == BODY_PLACE ? w->q : w->v) + k;
    const double *number = of->numbers + part->first_number + first;
    const unsigned *column = of->columns + part->first_column;
    VECTOR_BY_TWO
    for (size_t c = 0; c < part->common; c++, number += w->rows)
        add_column(number, x + *column++ * w->stride, rows, count, sum);
    column += first;
    for (size_t c = 0; c < part->lone; c++, number += w->rows, column += w->rows)
        VECTOR_FOR (r, rows) add_column(number + r, x + column[r] * w->stride, 1, count, sum + r);
}

/// Adds constant forces.
VECTOR_INLINE void add_steady(const double *number, size_t rows, size_t count, vec sum[SUM_ROWS][SUMS]) {
    VECTOR_FOR (r, rows)
        VECTOR_FOR (i, count) sum[r][i] = v_add(sum[r][i], v_set(number[r]));
}

VECTOR_INLINE void sum_panel(const body_panels *of, const body_panel *panel, const panel_work *w, size_t first,
                             size_t rows, size_t count, size_t k) {
    const body_part *part = of->parts + panel->first_part, *end = part + panel->part_count;
    const vec *factor;
    body_rate rate = part->kind.rate;
    vec sum[SUM_ROWS][SUMS], scale[SUMS];
    // Sum the parts of the panel. Those of an earlier rate come first, since a change of rate multiplies the sum.
    VECTOR_FOR (r, rows)
        VECTOR_FOR (i, count) sum[r][i] = v_set(0.0);
    for (; part < end; rate = part++->kind.rate) {
        if (rate != part->kind.rate) {
            factor = rate_over(w, rate, part->kind.rate) + k;
            VECTOR_FOR (r, rows)
                VECTOR_FOR (i, count) sum[r][i] = v_mul(factor[i], sum[r][i]);
        }
        if (part->kind.source != BODY_ONE)
            add_part(of, part, w, first, rows, count, k, sum);
        else if (!w->beside)
            add_steady(of->numbers + part->first_number + first, rows, count, sum);
    }
    // Scale the sum, and store or add it.
    factor = rate_over(w, rate, RATES) + k;
    VECTOR_FOR (i, count) scale[i] = w->value ? v_mul(factor[i], w->value[k + i]) : factor[i];
    VECTOR_FOR (r, rows) {
        vec *a = w->a + panel->row[first + r] * w->stride + k;
        VECTOR_FOR (i, count) a[i] = panel->begins ? v_mul(scale[i], sum[r][i]) : v_fma(scale[i], sum[r][i], a[i]);
    }
}

VECTOR_INLINE void sum_rows(const body_panels *of, const body_panel *panel, const panel_work *w, size_t first,
                            size_t rows, size_t vectors) {
    size_t k = 0;
    for (; k + SUMS <= vectors; k += SUMS) sum_panel(of, panel, w, first, rows, SUMS, k);
    for (; k < vectors; k++) sum_panel(of, panel, w, first, rows, 1, k);
}

#if VECTOR_QUADS
enum { PANEL_QUADS = PANEL_ROWS / 4 };

/// Adds the columns of a part to the sums of a panel's rows, for one machine. Sums of missing rows are meaningless.
VECTOR_INLINE void add_part_alone(const body_panels *of, const body_part *part, const panel_work *w,
                                  quad sum[PANEL_QUADS]) {
    const double *x = part->kind.source == BODY_PLACE ? w->q : w->v, *number = of->numbers + part->first_number;
    const unsigned *column = of->columns + part->first_column;
    for (size_t c = 0; c < part->common; c++, number += w->rows) {
        const quad own = q_set(x[*column++]);
        VECTOR_FOR (i, PANEL_QUADS) sum[i] = q_fma(q_load(number + 4 * i), own, sum[i]);
    }
    for (size_t c = 0; c < part->lone; c++, number += w->rows, column += w->rows) {
        double own[PANEL_ROWS] = {0.0};
        for (size_t r = 0; r < w->rows; r++) own[r] = x[column[r]];
        VECTOR_FOR (i, PANEL_QUADS) sum[i] = q_fma(q_load(number + 4 * i), q_load(own + 4 * i), sum[i]);
    }
}

/// Computes the sums of a panel as sum_panel does, for one machine.
static void sum_panel_alone(const body_panels *of, const body_panel *panel, const panel_work *w) {
    const body_part *part = of->parts + panel->first_part, *end = part + panel->part_count;
    body_rate rate = part->kind.rate;
    quad sum[PANEL_QUADS];
    double sums[PANEL_ROWS];
    VECTOR_FOR (i, PANEL_QUADS) sum[i] = q_set(0.0);
    for (; part < end; rate = part++->kind.rate) {
        if (rate != part->kind.rate) {
            const quad factor = q_set(*rate_over(w, rate, part->kind.rate));
            VECTOR_FOR (i, PANEL_QUADS) sum[i] = q_mul(factor, sum[i]);
        }
        if (part->kind.source != BODY_ONE)
            add_part_alone(of, part, w, sum);
        else if (!w->beside)
            VECTOR_FOR (i, PANEL_QUADS) sum[i] = q_add(sum[i], q_load(of->numbers + part->first_number + 4 * i));
    }
    const double last = *rate_over(w, rate, RATES), scale = w->value ? last * *w->value : last;
    VECTOR_FOR (i, PANEL_QUADS) q_store(sums + 4 * i, sum[i]);
    for (size_t r = 0; r < w->rows; r++) {
        double *a = w->a + panel->row[r];
        *a = panel->begins ? scale * sums[r] : v_fma(scale, sums[r], *a);
    }
}
#endif

static void pass_panel(const body_panels *of, const body_panel *panel, const panel_work *w, size_t vectors) {
    size_t first = 0;
#if VECTOR_QUADS
    if (w->stride == 1) {
        sum_panel_alone(of, panel, w);
        return;
    }
#endif
    for (; first + SUM_ROWS <= w->rows; first += SUM_ROWS) sum_rows(of, panel, w, first, SUM_ROWS, vectors);
    for (; first + 4 <= w->rows; first += 4) sum_rows(of, panel, w, first, 4, vectors);
    switch (w->rows - first) {
    case 3:
        sum_rows(of, panel, w, first, 3, vectors);
        break;
    case 2:
        sum_rows(of, panel, w, first, 2, vectors);
        break;
    case 1:
        sum_rows(of, panel, w, first, 1, vectors);
        break;
    default:
        break;
    }
}

/// Adds the effect of the shaft's phase on perturbations, if the phase is a state.
static void pass_turned(const body_panels *of, const body_panel *panel, const panel_work *w, const block *b) {
    const vec *turned = b->turned + (size_t)panel->value * b->forcing_stride;
    for (size_t n = 1; n <= b->perturbations; n++)
        for (size_t k = 0; k < b->vectors; k++) {
            const vec by = v_mul(turned[k], phase_of(b, n, k));
            panel_work one = *w;
            one.q += k, one.v += k, one.steps += k, one.a += n * b->next_v + k, one.value = &by;
            pass_panel(of, panel, &one, 1);
        }
}

/// Adds the terms of a panel to unit perturbations, each with its rate.
static void pass_units(const body_panels *of, const body_panel *panel, const panel_work *w, const block *b) {
    for (size_t i = 0; i < panel->part_count; i++) {
        const body_part *part = &of->parts[panel->first_part + i];
        if (part->kind.source == BODY_ONE) continue;
        const size_t *unit = part->kind.source == BODY_PLACE ? b->unit_q : b->unit_v;
        for (size_t k = 0; k < b->vectors; k++) {
            const double *number = of->numbers + part->first_number;
            const vec last = rate_over(w, part->kind.rate, RATES)[k], rate = w->value ? v_mul(last, w->value[k]) : last;
            for (size_t c = 0; c < part->common; c++) {
                vec *a = column_of(b, unit[of->columns[part->first_column + c]]) + k;
                for (size_t r = 0; r < panel->rows; r++, number++) {
                    vec *own = a + panel->row[r] * b->stride;
                    *own = v_fma(rate, v_set(*number), *own);
                }
            }
            const unsigned *column = of->columns + part->first_column + part->common;
            for (size_t c = 0; c < part->lone; c++)
                for (size_t r = 0; r < panel->rows; r++, number++) {
                    vec *own = column_of(b, unit[*column++]) + panel->row[r] * b->stride + k;
                    *own = v_fma(rate, v_set(*number), *own);
                }
        }
    }
}

/// Adds a part's contribution to the trace.
static void trace_part(const body_panels *of, const body_panel *panel, const body_part *part, const panel_work *w,
                       const block *b) {
    for (size_t c = 0; c < part->common + part->lone; c++)
        for (size_t r = 0; r < panel->rows; r++)
            for (size_t k = 0; k < b->vectors; k++) {
                const size_t column = body_column(of, part, panel->rows, c, r);
                const vec last = rate_over(w, part->kind.rate, RATES)[k],
                          rate = w->value ? v_mul(last, w->value[k]) : last;
                const vec derivative = v_mul(v_set(of->numbers[part->first_number + c * panel->rows + r]), rate);
                b->divergence[k] = v_add(b->divergence[k], of_trace(b, panel->row[r], column, derivative));
            }
}

/// Adds the terms of shafts of finite elements: numbers that all lanes share, times the rates of each lane, of which
/// `steps` are the quotients.
static void pass_body(const body_panels *of, const vec *steps, const block *b) {
    for (size_t p = 0; p < of->count; p++) {
        const body_panel *panel = &of->panels[p];
        const bool steady = panel->value == BODY_STEADY;
        panel_work w = {.q = b->q,
                        .v = b->v,
                        .steps = steps,
                        .value = steady ? NULL : b->forcing + (size_t)panel->value * b->forcing_stride,
                        .a = b->a,
                        .stride = b->stride,
                        .rows = panel->rows};
        if (!steady && b->turned) pass_turned(of, panel, &w, b);
        for (size_t i = 0; i < panel->part_count && b->divergence; i++) {
            const body_part *part = &of->parts[panel->first_part + i];
            if (part->kind.source == BODY_VELOCITY) trace_part(of, panel, part, &w, b);
        }
        if (b->unit_q) pass_units(of, panel, &w, b);
        for (size_t n = 0; n <= (b->unit_q ? 0 : b->perturbations); n++, w.beside = true) {
            pass_panel(of, panel, &w, b->vectors);
            w.q += b->next, w.v += b->next_v, w.a += b->next_v;
        }
    }
}

/// Computes rows `first` and following of C times g.
VECTOR_INLINE void couple_rows(const coupling *by, size_t first, size_t rows, size_t begin, size_t end, const vec *g,
                               size_t count, vec *a, size_t stride) {
    vec sum[SUM_ROWS][SUMS];
    VECTOR_FOR (r, rows)
        VECTOR_FOR (i, count) sum[r][i] = v_set(0.0);
    for (size_t j = begin; j < end; j++, g += SUMS)
        VECTOR_FOR (r, rows)
            VECTOR_FOR (i, count) sum[r][i] = v_fma(v_set(by->share[(first + r) * by->count + j]), g[i], sum[r][i]);
    VECTOR_FOR (r, rows)
        VECTOR_FOR (i, count) a[by->row[first + r] * stride + i] = sum[r][i];
}

/// Couples one group of coordinates, for `count` vectors.
VECTOR_INLINE void couple_some(const coupling *by, size_t begin, size_t end, size_t count, vec *a, size_t stride) {
    vec g[AXES * WHIRL_MAX_STATIONS * SUMS];
    for (size_t j = begin; j < end; j++)
        VECTOR_FOR (i, count) g[(j - begin) * SUMS + i] = a[by->row[j] * stride + i];
    size_t row = begin;
    for (; row + 4 <= end; row += 4) couple_rows(by, row, 4, begin, end, g, count, a, stride);
    for (; row + 3 <= end; row += 3) couple_rows(by, row, 3, begin, end, g, count, a, stride);
    for (; row < end; row++) couple_rows(by, row, 1, begin, end, g, count, a, stride);
}

#if VECTOR_QUADS
enum { COUPLING_QUADS = COUPLING_MARGIN / 4 };

/// Couples one group of coordinates of one machine. Rows behind the last of the group are computed, too, and dropped.
static void couple_alone(const coupling *by, size_t begin, size_t end, double *a) {
    double g[AXES * WHIRL_MAX_STATIONS], out[AXES * WHIRL_MAX_STATIONS + COUPLING_MARGIN];
    const size_t count = end - begin, *row = by->row + begin;
    bool any = false;
    for (size_t j = 0; j < count; j++) {
        g[j] = a[row[j]];
        any = any || g[j] != 0.0;
    }
    if (!any) return;
    for (size_t first = 0; first < count; first += COUPLING_MARGIN) {
        const double *column = by->columns + begin * by->apart + begin + first;
        quad sum[COUPLING_QUADS];
        VECTOR_FOR (i, COUPLING_QUADS) sum[i] = q_set(0.0);
        for (size_t j = 0; j < count; j++, column += by->apart)
            VECTOR_FOR (i, COUPLING_QUADS) sum[i] = q_fma(q_load(column + 4 * i), q_set(g[j]), sum[i]);
        VECTOR_FOR (i, COUPLING_QUADS) q_store(out + first + 4 * i, sum[i]);
    }
    for (size_t j = 0; j < count; j++) a[row[j]] = out[j];
}
#endif

/// Applies mass coupling: converts forces divided by each coordinate's own inertia to accelerations a = C g.
static void couple(const block *b) {
    const coupling *by = b->coupled;
#if VECTOR_QUADS
    for (size_t n = 0; b->stride == 1 && n <= b->perturbations; n++)
        for (size_t begin = 0; begin < by->count; begin = by->end[begin])
            couple_alone(by, begin, by->end[begin], b->a + n * b->next_v);
    if (b->stride == 1) return;
#endif
    for (size_t n = 0; n <= b->perturbations; n++)
        for (size_t begin = 0; begin < by->count; begin = by->end[begin]) {
            vec *a = b->a + n * b->next_v;
            size_t k = 0;
            for (; k + SUMS <= b->vectors; k += SUMS) couple_some(by, begin, by->end[begin], SUMS, a + k, b->stride);
            for (; k < b->vectors; k++) couple_some(by, begin, by->end[begin], 1, a + k, b->stride);
        }
}

#endif
