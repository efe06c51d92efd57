#include "body.h"

#include <stdlib.h>
#include <string.h>

void body_add(body *to, size_t row, size_t column, body_kind kind, double number) {
    if (number == 0.0) return;
    if (to->count == to->capacity) {
        const size_t capacity = 2 * to->capacity + 256;
        body_term *longer = realloc(to->terms, capacity * sizeof *longer);
        to->no_memory = to->no_memory || !longer;
        if (!longer) return;
        to->terms = longer;
        to->capacity = capacity;
    }
    to->terms[to->count++] = (body_term){.row = row, .column = column, .kind = kind, .number = number};
}

void body_clear(body *of) {
    free(of->terms);
    *of = (body){0};
}

int body_compare_kinds(body_kind one, body_kind other) {
    if (one.value != other.value) return one.value < other.value ? -1 : 1;
    if (one.rate != other.rate) return one.rate < other.rate ? -1 : 1;
    return one.source < other.source ? -1 : one.source > other.source;
}

/// Orders terms by their inputs.
static int compare_inputs(const body_term *a, const body_term *b) {
    const int kinds = body_compare_kinds(a->kind, b->kind);
    if (kinds != 0) return kinds;
    return a->column < b->column ? -1 : a->column > b->column;
}

static int compare_terms(const void *one, const void *other) {
    const body_term *a = one, *b = other;
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    const int inputs = compare_inputs(a, b);
    if (inputs != 0) return inputs;
    // Sort by size, so that the sum does not depend on the order in which parts are listed.
    return a->number < b->number ? -1 : a->number > b->number;
}

bool body_finish(body *of) {
    size_t kept = 0;
    if (of->no_memory) return false;
    if (of->count > 0) qsort(of->terms, of->count, sizeof *of->terms, compare_terms);
    for (size_t i = 0; i < of->count; i++) {
        body_term *last = kept > 0 ? &of->terms[kept - 1] : NULL;
        if (last && last->row == of->terms[i].row && compare_inputs(last, &of->terms[i]) == 0)
            last->number += of->terms[i].number;
        else
            of->terms[kept++] = of->terms[i];
    }
    of->count = kept;
    return true;
}

// ---------------------------------------------------------------- panels

/// The terms of a row that depend on one value of the forcing.
typedef struct body_row {
    const body_term *first, *last;
} body_row;

static body_row row_from(const body *of, const body_term *first) {
    const body_term *last = first + 1, *end = of->terms + of->count;
    while (last < end && last->row == first->row && last->kind.value == first->kind.value) last++;
    return (body_row){first, last};
}

/// An input that a few rows share, and their terms with it; NULL for rows without such a term.
typedef struct body_input {
    size_t rows; ///< number of rows that have such a term
    const body_term *term[PANEL_ROWS];
} body_input;

/// Merges the inputs of a few rows, in order. Finished rows are skipped.
static size_t unite(const body_row *rows, size_t count, body_input *inputs) {
    const body_term *at[PANEL_ROWS];
    for (size_t r = 0; r < count; r++) at[r] = rows[r].first;
    for (size_t united = 0;; united++) {
        const body_term *next = NULL;
        for (size_t r = 0; r < count; r++)
            if (at[r] < rows[r].last && (!next || compare_inputs(at[r], next) < 0)) next = at[r];
        if (!next) return united;
        inputs[united] = (body_input){0};
        for (size_t r = 0; r < count; r++) {
            if (at[r] == rows[r].last || compare_inputs(at[r], next) != 0) continue;
            inputs[united].term[r] = at[r]++;
            inputs[united].rows++;
        }
    }
}

/// Returns true if rows are worth a panel: each row has three quarters of the shared inputs, and no more inputs of its
/// own than these. Rows of one plane are worth it, rows of both planes are not.
static bool is_dense(const body_row *rows, size_t count, body_input *inputs) {
    const size_t united = unite(rows, count, inputs);
    size_t common = 0, own[PANEL_ROWS] = {0};
    for (size_t k = 0; k < united; k++) {
        const body_input *input = &inputs[k];
        common += input->rows > 1;
        for (size_t r = 0; r < count; r++) own[r] += input->rows > 1 && input->term[r];
    }
    for (size_t r = 0; r < count; r++)
        if (4 * own[r] < 3 * common || 2 * own[r] < (size_t)(rows[r].last - rows[r].first)) return false;
    return true;
}

/// Returns the largest number of inputs that a row has alone, or 0 if separating them saves nothing.
static size_t count_lone(size_t count, const body_input *first, const body_input *last) {
    size_t most = 0, all = 0, own[PANEL_ROWS] = {0};
    for (const body_input *input = first; input < last; input++)
        for (size_t r = 0; r < count; r++) own[r] += input->rows == 1 && input->term[r];
    for (size_t r = 0; r < count; r++) {
        most = own[r] > most ? own[r] : most;
        all += own[r];
    }
    return most < all ? most : 0;
}

static void fill_part(body_panels *to, const body_part *part, size_t count, const body_input *first,
                      const body_input *last) {
    unsigned *column = to->columns + part->first_column;
    double *number = to->numbers + part->first_number;
    size_t c = 0, own[PANEL_ROWS] = {0};
    memset(column, 0, (part->common + part->lone * count) * sizeof *column);
    memset(number, 0, (part->common + part->lone) * count * sizeof *number);
    for (const body_input *input = first; input < last; input++) {
        const bool lone = part->lone > 0 && input->rows == 1;
        for (size_t r = 0; r < count; r++) {
            const body_term *term = input->term[r];
            if (!term) continue;
            const size_t at = lone ? part->common + own[r]++ : c;
            number[at * count + r] = term->number;
            column[lone ? part->common + (at - part->common) * count + r : c] = (unsigned)term->column;
        }
        c += !lone;
    }
}

/// Adds the part of one kind: inputs from `first` to before `last`.
static void add_part(body_panels *to, size_t count, body_kind kind, const body_input *first, const body_input *last) {
    body_part part = {.kind = kind,
                      .lone = count_lone(count, first, last),
                      .first_column = to->column_count,
                      .first_number = to->number_count};
    for (const body_input *input = first; input < last; input++) part.common += part.lone == 0 || input->rows > 1;
    if (to->panels) {
        to->parts[to->part_count] = part;
        fill_part(to, &part, count, first, last);
    }
    to->part_count++;
    to->column_count += part.common + part.lone * count;
    to->number_count += (part.common + part.lone) * count;
}

static body_kind body_kind_of(const body_input *input) {
    size_t r = 0;
    while (!input->term[r]) r++;
    return input->term[r]->kind;
}

static void body_add_panel(body_panels *to, const body_row *rows, size_t count, body_input *inputs) {
    const body_input *end = inputs + unite(rows, count, inputs), *last;
    body_panel panel = {.value = body_kind_of(inputs).value, .rows = count, .first_part = to->part_count};
    for (size_t r = 0; r < count; r++) panel.row[r] = rows[r].first->row;
    for (const body_input *first = inputs; first < end; first = last) {
        const body_kind kind = body_kind_of(first);
        for (last = first + 1; last < end && body_compare_kinds(body_kind_of(last), kind) == 0;) last++;
        add_part(to, count, kind, first, last);
    }
    panel.part_count = to->part_count - panel.first_part;
    if (to->panels) to->panels[to->count] = panel;
    to->count++;
}

/// Completes the panel that row `first` begins with further rows that fit, and marks them as done.
static void gather_from(const body_row *rows, size_t count, size_t first, bool *done, body_input *inputs,
                        body_panels *to) {
    body_row together[PANEL_ROWS] = {rows[first]};
    size_t taken = 1;
    for (size_t i = first + 1; i < count && taken < PANEL_ROWS; i++) {
        if (done[i] || rows[i].first->kind.value != rows[first].first->kind.value) continue;
        together[taken] = rows[i];
        done[i] = is_dense(together, taken + 1, inputs);
        taken += done[i];
    }
    body_add_panel(to, together, taken, inputs);
}

bool body_gather(const body *of, body_panels *to) {
    body_row *rows = calloc(of->count + 1, sizeof *rows);
    bool *done = calloc(of->count + 1, sizeof *done);
    body_input *inputs = calloc(of->count + 1, sizeof *inputs);
    const bool good = rows && done && inputs;
    size_t count = 0;
    for (size_t i = 0; i < of->count && good; i = (size_t)(rows[count++].last - of->terms))
        rows[count] = row_from(of, of->terms + i);
    to->count = to->part_count = to->column_count = to->number_count = 0;
    for (size_t i = 0; i < count; i++)
        if (!done[i]) gather_from(rows, count, i, done, inputs, to);
    free(rows);
    free(done);
    free(inputs);
    return good;
}

/// Returns true for a panel that acts at all times, and whose rows ascend from `from` on.
static bool may_begin(const body_panel *panel, size_t from) {
    return panel->value == BODY_STEADY && panel->row[0] >= from;
}

size_t body_begin(body_panels *of, size_t first, size_t rows) {
    for (size_t begun = 0; first < rows; first++, begun = 0) {
        for (size_t i = 0; i < of->count; i++) begun += may_begin(&of->panels[i], first) ? of->panels[i].rows : 0;
        if (begun == rows - first) break;
    }
    for (size_t i = 0; i < of->count; i++) of->panels[i].begins = may_begin(&of->panels[i], first);
    return first;
}

bool body_alike(const body_panels *one, const body_panels *other) {
    if (one->count != other->count || one->part_count != other->part_count ||
        one->column_count != other->column_count || one->number_count != other->number_count)
        return false;
    for (size_t i = 0; i < one->count; i++) {
        const body_panel *x = &one->panels[i], *y = &other->panels[i];
        if (x->value != y->value || x->rows != y->rows || x->part_count != y->part_count ||
            memcmp(x->row, y->row, sizeof x->row) != 0)
            return false;
    }
    for (size_t i = 0; i < one->part_count; i++) {
        const body_part *x = &one->parts[i], *y = &other->parts[i];
        if (body_compare_kinds(x->kind, y->kind) != 0 || x->common != y->common || x->lone != y->lone) return false;
    }
    return memcmp(one->columns, other->columns, one->column_count * sizeof *one->columns) == 0 &&
           memcmp(one->numbers, other->numbers, one->number_count * sizeof *one->numbers) == 0;
}

void body_rates(double speed, double clock, double steps[BODY_STEPS]) {
    const double over_next[RATES] = {clock, speed / clock, clock, 1.0 / (clock * clock)};
    for (body_rate rate = 0; rate < RATES; rate++) {
        double step = 1.0;
        for (body_rate later = rate + 1; later <= RATES; later++)
            steps[body_step(rate, later)] = step *= over_next[later - 1];
    }
}
