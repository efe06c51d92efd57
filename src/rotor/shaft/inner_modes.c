// Remembers modes of shafts between their stations. Machines of a study differ in speed, bearings or loads far more
// often than in their shafts, and computing these modes takes most of the time of making a machine with a fine shaft.
#include <stdlib.h>
#include <string.h>

#include "inner_modes.h"
#include "lock.h"

/// Maximum number of shafts that are remembered, and of numbers of all of them (64 MiB). Problems with fewer inner
/// coordinates than MIN_INNER are solved without being remembered.
enum { MAX_SHAFTS = 16, MAX_NUMBERS = 8 << 20, MIN_INNER = 24 };

/// A problem and its solution, which follows it in memory.
typedef struct remembered {
    size_t inner, kept;
    double *numbers;
} remembered;

static lock guard = LOCK_OPEN;
static remembered shafts[MAX_SHAFTS]; ///< [shaft_count] the oldest first
static size_t shaft_count, number_count;

/// Returns how many numbers a problem has: k, m, follow.
static size_t inner_modes_key_size(size_t inner, size_t kept) {
    return inner * (2 * inner + kept);
}

/// Returns how many numbers a solution has: squares, shapes, follow.
static size_t inner_modes_solution_size(size_t inner, size_t kept) {
    return inner * (1 + inner + kept);
}

static size_t inner_modes_size(size_t inner, size_t kept) {
    return inner_modes_key_size(inner, kept) + inner_modes_solution_size(inner, kept);
}

static bool inner_modes_alike(const double *numbers, const double *key, size_t count) {
    return memcmp(numbers, key, count * sizeof *key) == 0;
}

/// Returns the numbers of a problem, or NULL if it is not remembered. Requires the guard.
static const double *inner_modes_find(const inner_modes *of) {
    const size_t square = of->inner * of->inner;
    for (size_t i = 0; i < shaft_count; i++) {
        const double *numbers = shafts[i].numbers;
        if (shafts[i].inner == of->inner && shafts[i].kept == of->kept && inner_modes_alike(numbers, of->k, square) &&
            inner_modes_alike(numbers + square, of->m, square) &&
            inner_modes_alike(numbers + 2 * square, of->follow, of->inner * of->kept))
            return numbers;
    }
    return NULL;
}

bool inner_modes_recall(const inner_modes *of) {
    const size_t square = of->inner * of->inner;
    if (of->inner < MIN_INNER) return false;
    lock_take(&guard);
    const double *numbers = inner_modes_find(of);
    if (numbers) {
        numbers += inner_modes_key_size(of->inner, of->kept);
        memcpy(of->squares, numbers, of->inner * sizeof *numbers);
        memcpy(of->shapes, numbers + of->inner, square * sizeof *numbers);
        memcpy(of->follow, numbers + of->inner + square, of->inner * of->kept * sizeof *numbers);
    }
    lock_leave(&guard);
    return numbers != NULL;
}

double *inner_modes_begin(const inner_modes *of) {
    const size_t square = of->inner * of->inner, size = inner_modes_size(of->inner, of->kept);
    double *numbers = of->inner < MIN_INNER || size > MAX_NUMBERS ? NULL : malloc(size * sizeof *numbers);
    if (!numbers) return NULL;
    memcpy(numbers, of->k, square * sizeof *numbers);
    memcpy(numbers + square, of->m, square * sizeof *numbers);
    memcpy(numbers + 2 * square, of->follow, of->inner * of->kept * sizeof *numbers);
    return numbers;
}

/// Forgets the oldest shaft. Requires the guard.
static void inner_modes_forget_oldest(void) {
    number_count -= inner_modes_size(shafts[0].inner, shafts[0].kept);
    free(shafts[0].numbers);
    shaft_count--;
    for (size_t i = 0; i < shaft_count; i++) shafts[i] = shafts[i + 1];
}

void inner_modes_keep(const inner_modes *of, double *numbers) {
    const size_t square = of->inner * of->inner, size = inner_modes_size(of->inner, of->kept);
    if (!numbers) return;
    double *solution = numbers + inner_modes_key_size(of->inner, of->kept);
    memcpy(solution, of->squares, of->inner * sizeof *solution);
    memcpy(solution + of->inner, of->shapes, square * sizeof *solution);
    memcpy(solution + of->inner + square, of->follow, of->inner * of->kept * sizeof *solution);
    const inner_modes key = {of->inner, of->kept, numbers, numbers + square, numbers + 2 * square, NULL, NULL};
    lock_take(&guard);
    const bool is_new = !inner_modes_find(&key); // another thread may have solved it meanwhile
    while (is_new && (shaft_count == MAX_SHAFTS || number_count + size > MAX_NUMBERS)) inner_modes_forget_oldest();
    if (is_new) shafts[shaft_count++] = (remembered){of->inner, of->kept, numbers};
    if (is_new) number_count += size;
    lock_leave(&guard);
    if (!is_new) free(numbers);
}
