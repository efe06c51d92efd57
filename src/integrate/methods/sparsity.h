/// Which entries of a Jacobian, and of the factors of an implicit method's matrix, can differ from zero: the same for
/// all lanes, found once for a structure.
#ifndef INTEGRATE_SPARSITY_H
#define INTEGRATE_SPARSITY_H

#include <stdbool.h>
#include <stddef.h>

/// Those of row i are in the runs begin[i] to before begin[i + 1], ascending: run r in the columns run[2 r] to before
/// run[2 r + 1].
typedef struct sparse_rows {
    size_t *begin, *run;
} sparse_rows;

typedef struct sparsity {
    size_t perturbations;
    size_t *perturbation;     ///< [dimension] by which a column is found, that of a position or of a rate
    sparse_rows by_q, by_v;   ///< the Jacobian of the rates by positions and by rates
    sparse_rows lower, upper; ///< of the decomposed sum of both, below and above the diagonal
} sparsity;

/// Of a machine with so many positions and rates; depends as whirl_lanes has it, NULL: all by all. In one block, freed
/// by free(); NULL where there is no memory.
sparsity *sparsity_new(size_t degrees, size_t rates, void (*depends)(const void *model, bool *table),
                       const void *model);

#endif
