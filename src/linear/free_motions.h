/// Zero eigenvalues of a Jacobian: displacements without a restoring force, and velocities without damping.
#ifndef LINEAR_FREE_MOTIONS_H
#define LINEAR_FREE_MOTIONS_H

#include "whirl/engine/system.h"

/// Record of one replacement of coordinates by their motion relative to free shapes.
typedef struct free_step free_step;

/// Removes all zero eigenvalues from a matrix [n][n], which becomes a matrix [left][left] with the other eigenvalues,
/// to rounding. A zero is recognised by its null vector, not by its size: elimination leaves nothing but the rounding
/// of the subtracted numbers. `displaced` is the number of independent null vectors in which a displacement (place [n]
/// true) moves. *first is NULL if there is no zero; it is freed by free_motions_end. Returns false without memory.
bool free_motions_take_out(size_t n, double *matrix, const bool *place, size_t *left, size_t *displaced,
                           free_step **first);

/// Converts the eigenvector [left][2] at the front of vector [n][2], whose eigenvalue is not 0, into the eigenvector of
/// the matrix [n][n], of Euclidean length 1. work [n][2] is workspace.
void free_motions_put_back(const free_step *first, double real, double imaginary, double *vector, double *work);

/// Frees the records of free_motions_take_out; accepts NULL.
void free_motions_end(free_step *first);

#endif
