// The functions of ranks.h for `whirl`, which has one process.
#include "ranks.h"

#include "cores.h"

/// Numbers that ranks_add and its relatives change, by their index.
static int64_t words[RANKS_WORDS];

void ranks_begin(int *argc, char ***argv) {
    (void)argc, (void)argv;
}

int ranks_end(int status, ranks_meanwhile meanwhile) {
    (void)meanwhile;
    return status;
}

int ranks_count(void) {
    return 1;
}

int ranks_number(void) {
    return 0;
}

void ranks_dismiss(void) {}

int ranks_threads(void) {
    return available_cores();
}

int ranks_agree(int outcome) {
    return outcome;
}

void ranks_share(void *bytes, size_t size) {
    (void)bytes, (void)size;
}

int64_t ranks_add(size_t word, int64_t amount) {
    const int64_t before = words[word];
    words[word] += amount;
    return before;
}

void ranks_add_all(size_t word, size_t count, int64_t *amounts) {
    for (size_t i = 0; i < count; i++) amounts[i] += ranks_add(word + i, amounts[i]);
}

void ranks_raise(size_t word, int64_t value) {
    if (words[word] < value) words[word] = value;
}

void ranks_rest(void) {}
