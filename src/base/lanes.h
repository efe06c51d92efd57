/// What a system must give so that many machines of its kind run side by side in vector lanes.
///
/// All machines of a block have the same structure (stations, elements, laws) and each its own numbers. Arrays hold for
/// every quantity `stride` vectors: quantity k of lane l is at [k * stride * VECTOR_LANES + l].
#ifndef BASE_LANES_H
#define BASE_LANES_H

#include <stdbool.h>
#include <stddef.h>

/// Accelerations `a` [degrees] of `vectors` vectors at positions q and velocities v [degrees]; `forcing` holds the
/// values that depend on time alone. The arrays are vectors of the instruction set that the function is made for.
typedef void lanes_accelerate(const void *model, size_t stride, size_t vectors, const void *numbers,
                              const double *forcing, const void *q, const void *v, void *a);

/// The state is degrees positions, then their derivatives; stations are pairs of positions 2s, 2s + 1.
struct whirl_lanes {
    size_t degrees;
    size_t number_count;                               ///< numbers of one machine
    void (*numbers)(const void *model, double *out);   ///< [number_count]
    bool (*alike)(const void *one, const void *other); ///< same structure
    size_t contact_count;
    void (*contact)(const void *model, size_t index, size_t *station, double *gap);
    lanes_accelerate *const *accelerate; ///< one for every instruction set of vector.h; NULL where it is not built
};

#endif
