/// Sparsity: the numbers of a Jacobian, and of the factors of an implicit method's matrix, that can differ from zero.
/// They are the same for all lanes, and are found once for a structure.
#ifndef INTEGRATE_SPARSITY_H
#define INTEGRATE_SPARSITY_H

#include <stdbool.h>
#include <stddef.h>

/// Nonzero columns of rows. Those of row i are the runs begin[i] to before begin[i + 1], ascending; run r has the
/// columns run[2 r] to before run[2 r + 1].
typedef struct sparse_rows {
    size_t *begin, *run;
} sparse_rows;

typedef struct sparsity {
    size_t perturbations;
    size_t *perturbation;     ///< [dimension] perturbation that determines a column, for positions and rates
    sparse_rows by_q, by_v;   ///< the Jacobian of the rates by positions and by rates
    sparse_rows lower, upper; ///< factors of the matrix of the stages, in which both are added
    bool dense; ///< most numbers of the factors are nonzero, and each column has a perturbation of its own
} sparsity;

/// Finds the sparsity of a machine with `degrees` positions and `rates` rates. `depends` is as in whirl_lanes; NULL:
/// every rate depends on every coordinate. alone: for one machine, whose matrices may be stored as dense ones. The
/// result is one block, which the caller frees with free(). Returns NULL without memory.
sparsity *sparsity_new(size_t degrees, size_t rates, void (*depends)(const void *model, bool *table), const void *model,
                       bool alone);

#endif
