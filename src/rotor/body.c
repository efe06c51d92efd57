#include "body.h"

#include <math.h>
#include <stdlib.h>

void body_add(body *to, size_t row, size_t column, body_kind kind, double number) {
    if (number == 0.0) return;
    if (to->count == to->room) {
        const size_t room = 2 * to->room + 256;
        body_term *longer = realloc(to->terms, room * sizeof *longer);
        to->no_memory = to->no_memory || !longer;
        if (!longer) return;
        to->terms = longer;
        to->room = room;
    }
    to->terms[to->count++] = (body_term){.row = row, .column = column, .kind = kind, .number = number};
}

void body_clear(body *of) {
    free(of->terms);
    *of = (body){0};
}

int body_compare_kinds(body_kind one, body_kind other) {
    if (one.source != other.source) return one.source < other.source ? -1 : 1;
    if (one.rate != other.rate) return one.rate < other.rate ? -1 : 1;
    return one.value < other.value ? -1 : one.value > other.value;
}

static int compare_sums(const body_term *a, const body_term *b) {
    if (a->row != b->row) return a->row < b->row ? -1 : 1;
    return body_compare_kinds(a->kind, b->kind);
}

static int compare_terms(const void *one, const void *other) {
    const body_term *a = one, *b = other;
    const int sums = compare_sums(a, b);
    if (sums != 0) return sums;
    if (a->column != b->column) return a->column < b->column ? -1 : 1;
    // By size, so that the sum does not depend on the order in which parts are listed.
    return a->number < b->number ? -1 : a->number > b->number;
}

bool body_finish(body *of) {
    size_t kept = 0;
    if (of->no_memory) return false;
    if (of->count > 0) qsort(of->terms, of->count, sizeof *of->terms, compare_terms);
    for (size_t i = 0; i < of->count; i++) {
        body_term *last = kept > 0 ? &of->terms[kept - 1] : NULL;
        if (last && compare_sums(last, &of->terms[i]) == 0 && last->column == of->terms[i].column)
            last->number += of->terms[i].number;
        else
            of->terms[kept++] = of->terms[i];
    }
    of->count = kept;
    return true;
}

// ---------------------------------------------------------------- panels

/// A row's terms of one kind.
typedef struct body_row {
    const body_term *first, *last;
} body_row;

static body_row row_from(const body *of, const body_term *first) {
    const body_term *last = first + 1, *end = of->terms + of->count;
    while (last < end && compare_sums(first, last) == 0) last++;
    return (body_row){first, last};
}

/// The columns of a few rows together, rising, written where `columns` is not NULL. A row that has come to its end
/// stands aside.
static size_t unite(const body_row *rows, size_t count, unsigned *columns) {
    const body_term *at[PANEL_ROWS];
    size_t united = 0;
    for (size_t r = 0; r < count; r++) at[r] = rows[r].first;
    for (;;) {
        size_t next = (size_t)-1;
        for (size_t r = 0; r < count; r++)
            if (at[r] < rows[r].last && at[r]->column < next) next = at[r]->column;
        if (next == (size_t)-1) return united;
        for (size_t r = 0; r < count; r++) at[r] += at[r] < rows[r].last && at[r]->column == next;
        if (columns) columns[united] = (unsigned)next;
        united++;
    }
}

/// Rows are together while less than half of their panel is zeros: those of one plane are, those of both are not.
static bool is_dense(const body_row *rows, size_t count) {
    size_t terms = 0;
    for (size_t r = 0; r < count; r++) terms += (size_t)(rows[r].last - rows[r].first);
    return count * unite(rows, count, NULL) < 2 * terms;
}

static void add_panel(body_panels *to, const body_row *rows, size_t count) {
    body_panel panel = {.kind = rows[0].first->kind,
                        .rows = count,
                        .columns = unite(rows, count, NULL),
                        .first_column = to->column_count,
                        .first_number = to->number_count};
    for (size_t r = 0; r < count; r++) panel.row[r] = rows[r].first->row;
    if (to->panels) {
        unsigned *columns = to->columns + panel.first_column;
        to->panels[to->count] = panel;
        unite(rows, count, columns);
        for (size_t c = 0; c < panel.columns; c++)
            for (size_t r = 0; r < count; r++) {
                double *number = &to->numbers[panel.first_number + c * count + r];
                *number = 0.0;
                for (const body_term *term = rows[r].first; term < rows[r].last; term++)
                    if (term->column == columns[c]) *number = term->number;
            }
    }
    to->count++;
    to->column_count += panel.columns;
    to->number_count += panel.columns * count;
}

/// Fills up the panel that the first row begins with the next rows that go with it; notes which rows are done.
static void gather_from(const body_row *rows, size_t count, size_t first, bool *done, body_panels *to) {
    body_row together[PANEL_ROWS] = {rows[first]};
    size_t taken = 1;
    for (size_t i = first + 1; i < count && taken < PANEL_ROWS; i++) {
        if (done[i] || body_compare_kinds(rows[i].first->kind, rows[first].first->kind) != 0) continue;
        together[taken] = rows[i];
        done[i] = is_dense(together, taken + 1);
        taken += done[i];
    }
    add_panel(to, together, taken);
}

bool body_gather(const body *of, body_panels *to) {
    body_row *rows = calloc(of->count + 1, sizeof *rows);
    bool *done = calloc(of->count + 1, sizeof *done);
    size_t count = 0;
    for (size_t i = 0; i < of->count && rows && done; i = (size_t)(rows[count++].last - of->terms))
        rows[count] = row_from(of, of->terms + i);
    to->count = to->column_count = to->number_count = 0;
    for (size_t i = 0; i < count; i++)
        if (!done[i]) gather_from(rows, count, i, done, to);
    const bool good = rows && done;
    free(rows);
    free(done);
    return good;
}

void body_rates(double speed, double clock, double rates[RATES]) {
    rates[RATE_STATIC] = 1.0 / (clock * clock);
    rates[RATE_DAMPING] = 1.0 / clock;
    rates[RATE_GYRO] = speed / clock;
    rates[RATE_FOLLOWING] = speed / (clock * clock);
}
