// Finds the numbers of a Jacobian, and of its factors, that can differ from zero.
#include "sparsity.h"

#include <stdlib.h>

/// Assigns perturbations to columns. Columns without a common row are found by one perturbation (Curtis, Powell, Reid
/// 1974): each column takes the first perturbation with which it has no common row. found [columns][rows]: rows that a
/// perturbation determines.
static void share_perturbations(sparsity *out, const bool *table, size_t rows, size_t columns, bool *found) {
    for (size_t c = 0; c < columns; c++) {
        size_t own = 0;
        for (size_t i = 0; i < rows; i++)
            if (table[i * columns + c] && found[own * rows + i]) {
                own++;
                i = (size_t)-1;
            }
        for (size_t i = 0; i < rows; i++) found[own * rows + i] |= table[i * columns + c];
        out->perturbation[c] = own;
        if (own >= out->perturbations) out->perturbations = own + 1;
    }
}

/// Marks the numbers that elimination fills in, row by row, without exchange of rows.
static void fill_in(bool *matrix, size_t n) {
    for (size_t i = 0; i < n; i++)
        for (size_t m = 0; m < i; m++)
            for (size_t j = m + 1; matrix[i * n + m] && j < n; j++) matrix[i * n + j] |= matrix[m * n + j];
}

enum { ALL, BELOW_DIAGONAL, ABOVE_DIAGONAL };

/// Writes the runs of nonzero numbers in the first `columns` columns of a table [rows][width] to `numbers`; `part`
/// chooses all of them or one side of the diagonal. Returns the rest of `numbers`.
static size_t *list(sparse_rows *out, size_t *numbers, const bool *table, size_t rows, size_t width, size_t columns,
                    int part) {
    size_t *next = numbers + rows + 1;
    out->begin = numbers;
    out->run = next;
    for (size_t i = 0; i < rows; i++) {
        const size_t from = part == ABOVE_DIAGONAL ? i + 1 : 0, to = part == BELOW_DIAGONAL ? i : columns;
        const bool *row = table + i * width;
        out->begin[i] = (size_t)(next - out->run) / 2;
        for (size_t c = from; c < to; c++) {
            if (row[c] && (c == from || !row[c - 1])) *next++ = c;
            if (row[c] && (c + 1 == to || !row[c + 1])) *next++ = c + 1;
        }
    }
    out->begin[rows] = (size_t)(next - out->run) / 2;
    return next;
}

sparsity *sparsity_new(size_t n, size_t m, void (*depends)(const void *model, bool *table), const void *model,
                       bool alone) {
    const size_t width = n + m;
    const size_t most = width + 4 * (m + 1) + m * (width + 4) + m * (m + 2); // at worst every run is one column
    sparsity *out = calloc(1, sizeof *out + most * sizeof(size_t));
    bool *table = calloc(m * width + width * m + m * m, sizeof *table);
    if (!out || !table) {
        free(out);
        free(table);
        return NULL;
    }
    // Make the table of which slope depends on which coordinate: if unknown, each on all.
    bool *matrix = table + 2 * m * width;
    out->perturbation = (size_t *)(out + 1);
    if (depends) depends(model, table);
    for (size_t i = 0; !depends && i < m * width; i++) table[i] = true;
    // Find the pattern of the matrix after elimination.
    for (size_t i = 0; i < m; i++)
        for (size_t c = 0; c < m; c++) matrix[i * m + c] = table[i * width + n + c] || (c < n && table[i * width + c]);
    fill_in(matrix, m);
    size_t filled = 0;
    for (size_t i = 0; i < m * m; i++) filled += matrix[i];
    out->dense = alone && 2 * filled > m * m;
    // Assign perturbations to columns, and list the dependences.
    if (out->dense) {
        out->perturbations = width;
        for (size_t c = 0; c < width; c++) out->perturbation[c] = c;
    } else {
        share_perturbations(out, table, m, width, table + m * width);
    }
    size_t *next = list(&out->by_q, out->perturbation + width, table, m, width, n, ALL);
    next = list(&out->by_v, next, table + n, m, width, m, ALL);
    next = list(&out->lower, next, matrix, m, m, m, BELOW_DIAGONAL);
    list(&out->upper, next, matrix, m, m, m, ABOVE_DIAGONAL);
    free(table);
    return out;
}
