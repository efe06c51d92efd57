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
    for (size_t first = 0, last; first < kept; first = last) {
        for (last = first + 1; last < kept && compare_sums(&of->terms[first], &of->terms[last]) == 0;) last++;
        of->terms[first].run = last - first;
    }
    return true;
}

void body_rates(double speed, double clock, double rates[RATES]) {
    rates[RATE_STATIC] = 1.0 / (clock * clock);
    rates[RATE_DAMPING] = 1.0 / clock;
    rates[RATE_GYRO] = speed / clock;
    rates[RATE_FOLLOWING] = speed / (clock * clock);
}
