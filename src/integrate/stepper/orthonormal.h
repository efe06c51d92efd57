/// Orthonormal sets of perturbations.
#ifndef INTEGRATE_ORTHONORMAL_H
#define INTEGRATE_ORTHONORMAL_H

#include <stddef.h>

/// Makes `count` <= `dimension` vectors [count][dimension] orthonormal, each within the span of itself and the previous
/// ones (Gram and Schmidt, modified). Adds the logarithm of the remaining length of each to growth [count]. A vector
/// without remaining length is replaced by one orthogonal to all others; its logarithm is that of the smallest normal
/// number.
void make_orthonormal(size_t dimension, size_t count, double *vectors, double *growth);

#endif
