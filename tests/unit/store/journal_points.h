// Points for journals: numbers that follow from batch and slot, special values among them.
#ifndef UNIT_STORE_JOURNAL_POINTS_H
#define UNIT_STORE_JOURNAL_POINTS_H

#include "synthetic.h"
#include "whirl/engine/journal.h"

enum { BLOCK_SIZE = 7, STATE_SIZE = 3, JOURNAL_POINTS = SYNTHETIC_POINTS + 1 };

typedef struct journal_point {
    size_t batch, slot;
    double block[BLOCK_SIZE], end[STATE_SIZE];
} journal_point;

/// Makes a point of the synthetic result: those of the sweep, then that of the detail.
static inline journal_point point_make(size_t index) {
    journal_point point = {.batch = index < SYNTHETIC_POINTS ? 0 : 1, .slot = index % SYNTHETIC_POINTS};
    const double special[BLOCK_SIZE] = {NAN, -0.0, INFINITY, 5e-324, 1.0 / 3.0, -1e308, 0.0};
    for (size_t i = 0; i < BLOCK_SIZE; ++i) point.block[i] = i == index ? special[i] : 0.1 * (double)(100 * index + i);
    for (size_t i = 0; i < STATE_SIZE; ++i) point.end[i] = index == 2 ? NAN : 1.0 / (double)(1 + index + i);
    return point;
}

static inline whirl_status point_write(whirl_journal *journal, size_t index) {
    const journal_point point = point_make(index);
    const whirl_point_store *store = whirl_journal_store(journal);
    return store->keep(store->context, point.batch, point.slot, point.block, BLOCK_SIZE, point.end, STATE_SIZE);
}

/// Returns 1 if the point is known, 0 if not; aborts if it is known with other numbers.
static inline int point_recall(whirl_journal *journal, size_t index) {
    const journal_point point = point_make(index);
    const whirl_point_store *store = whirl_journal_store(journal);
    journal_point got = {0};
    if (!store->recall(store->context, point.batch, point.slot, got.block, BLOCK_SIZE, got.end, STATE_SIZE)) return 0;
    if (memcmp(got.block, point.block, sizeof got.block) != 0 || memcmp(got.end, point.end, sizeof got.end) != 0)
        abort();
    return 1;
}

static inline int count_recalled(whirl_journal *journal) {
    int known = 0;
    for (size_t i = 0; i < JOURNAL_POINTS; ++i) known += point_recall(journal, i);
    return known;
}

#endif
