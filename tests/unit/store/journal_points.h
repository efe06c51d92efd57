// Points for journals: numbers that follow from batch and slot, special values among them.
#ifndef UNIT_STORE_KEPT_H
#define UNIT_STORE_KEPT_H

#include "synthetic.h"
#include "whirl/engine/journal.h"

enum { KEPT_SIZE = 7, KEPT_DIMENSION = 3, KEPT_POINTS = SYNTHETIC_POINTS + 1 };

typedef struct kept_point {
    size_t batch, slot;
    double block[KEPT_SIZE], end[KEPT_DIMENSION];
} kept_point;

/// Makes a point of the synthetic result: those of the sweep, then that of the detail.
static inline kept_point kept_make(size_t index) {
    kept_point point = {.batch = index < SYNTHETIC_POINTS ? 0 : 1, .slot = index % SYNTHETIC_POINTS};
    const double special[KEPT_SIZE] = {NAN, -0.0, INFINITY, 5e-324, 1.0 / 3.0, -1e308, 0.0};
    for (size_t i = 0; i < KEPT_SIZE; ++i) point.block[i] = i == index ? special[i] : 0.1 * (double)(100 * index + i);
    for (size_t i = 0; i < KEPT_DIMENSION; ++i) point.end[i] = index == 2 ? NAN : 1.0 / (double)(1 + index + i);
    return point;
}

static inline whirl_status kept_keep(whirl_journal *journal, size_t index) {
    const kept_point point = kept_make(index);
    const whirl_point_store *store = whirl_journal_store(journal);
    return store->keep(store->context, point.batch, point.slot, point.block, KEPT_SIZE, point.end, KEPT_DIMENSION);
}

/// Returns 1 if the point is known, 0 if not; aborts if it is known with other numbers.
static inline int kept_recall(whirl_journal *journal, size_t index) {
    const kept_point point = kept_make(index);
    const whirl_point_store *store = whirl_journal_store(journal);
    kept_point got = {0};
    if (!store->recall(store->context, point.batch, point.slot, got.block, KEPT_SIZE, got.end, KEPT_DIMENSION))
        return 0;
    if (memcmp(got.block, point.block, sizeof got.block) != 0 || memcmp(got.end, point.end, sizeof got.end) != 0)
        abort();
    return 1;
}

static inline int kept_count(whirl_journal *journal) {
    int known = 0;
    for (size_t i = 0; i < KEPT_POINTS; ++i) known += kept_recall(journal, i);
    return known;
}

#endif
