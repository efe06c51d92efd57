/// A store that keeps points in memory, for studies of one batch. Include after cmocka.h.
#ifndef STUDY_MEMORY_STORE_H
#define STUDY_MEMORY_STORE_H

#include <stdlib.h>
#include <string.h>

#include "whirl/engine/study.h"

#ifndef STORE_SLOTS
#define STORE_SLOTS 128 // a test that needs more defines STORE_SLOTS
#endif

enum { MAX_SLOTS = STORE_SLOTS, MAX_PASSES = 4 * (WHIRL_MAX_ROUNDS + 1), BLOCK = 512, MAX_DIMENSION = 4 };

/// `limit`: number of points that it stores before it fails, -1: all.
typedef struct memory_store {
    size_t slots, dimension;
    int written, recalled, limit;
    bool known[MAX_PASSES][MAX_SLOTS];
    double blocks[MAX_PASSES][MAX_SLOTS][BLOCK], ends[MAX_PASSES][MAX_SLOTS][MAX_DIMENSION];
    whirl_point_store store; ///< of a run whose result may ask it for blocks
} memory_store;

static inline whirl_status memory_write(void *context, size_t pass, size_t slot, const double *block, size_t size,
                                        const double *end, size_t dimension) {
    memory_store *memory = context;
    assert_true(pass < MAX_PASSES && slot < memory->slots && size <= BLOCK && !memory->known[pass][slot]);
    assert_true(dimension == (pass == 0 ? memory->dimension : 0));
    if (memory->written == memory->limit) return whirl_fail(WHIRL_IO_ERROR, "there is no room");
    memcpy(memory->blocks[pass][slot], block, size * sizeof *block);
    memcpy(memory->ends[pass][slot], end, dimension * sizeof *end);
    memory->known[pass][slot] = true;
    memory->written++;
    return whirl_ok();
}

static inline bool memory_recall(void *context, size_t pass, size_t slot, double *block, size_t size, double *end,
                                 size_t dimension) {
    memory_store *memory = context;
    assert_true(pass < MAX_PASSES && slot < memory->slots && dimension == (pass == 0 ? memory->dimension : 0));
    if (!memory->known[pass][slot]) return false;
    memcpy(block, memory->blocks[pass][slot], size * sizeof *block);
    memcpy(end, memory->ends[pass][slot], dimension * sizeof *end);
    memory->recalled++;
    return true;
}

static inline memory_store *store_new(size_t slots, size_t dimension) {
    memory_store *memory = calloc(1, sizeof *memory);
    assert_non_null(memory);
    assert_true(slots <= MAX_SLOTS && dimension <= MAX_DIMENSION);
    memory->slots = slots;
    memory->dimension = dimension;
    memory->limit = -1;
    return memory;
}

/// Runs with the store; the result belongs to the caller.
static inline whirl_result *run_with_store(const whirl_study *study, memory_store *memory, whirl_code expected) {
    const whirl_point_store store = {.keep = memory_write, .recall = memory_recall, .context = memory};
    whirl_result *result;
    memory->written = memory->recalled = 0;
    assert_int_equal(whirl_study_run(study, &(whirl_run_options){.threads = 2, .store = &store}, &result).code,
                     expected);
    return result;
}

static inline void expect_same_blocks(const whirl_result *a, const whirl_result *b) {
    const whirl_table *one = a->tables, *other = b->tables;
    assert_int_equal(one->count, other->count);
    assert_memory_equal(one->blocks, other->blocks, one->count * one->layout.size * sizeof(double));
}

#endif
