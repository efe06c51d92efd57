/// Modes of shafts between their stations, which a process remembers for its latest shafts. Only problems whose numbers
/// are equal to the bit count as the same, so that results do not change. Can be used by all threads.
#ifndef ROTOR_INNER_MODES_H
#define ROTOR_INNER_MODES_H

#include <stdbool.h>
#include <stddef.h>

/// The problem K_II Phi = M_II Phi w^2, and Psi. The caller owns the arrays.
typedef struct inner_modes {
    size_t inner, kept;
    const double *k, *m; ///< [inner][inner]
    double *follow;      ///< [kept][inner] -K_IB, transposed; when solved, Psi
    double *squares;     ///< [inner] w^2
    double *shapes;      ///< [inner][inner] a mode in each row
} inner_modes;

/// Writes the solution of a problem if it is remembered. Otherwise returns false, and writes nothing.
bool inner_modes_recall(const inner_modes *of);

/// Copies a problem before it is solved. Returns the copy, which inner_modes_keep takes over; NULL if the problem is
/// too small or too large to be remembered, or without memory.
double *inner_modes_begin(const inner_modes *of);

/// Remembers the solution of a problem. Takes over `begun`, the copy by inner_modes_begin.
void inner_modes_keep(const inner_modes *of, double *begun);

#endif
