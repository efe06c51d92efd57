/// Adds an instant to all observed quantities (whirl/engine/watched.h). The functions are written once, over the vector
/// type.
#ifndef INTEGRATE_WATCHED_KERNEL_H
#define INTEGRATE_WATCHED_KERNEL_H

#include "vector.h"
#include "whirl/engine/system.h"
#include "whirl/engine/watched.h"

/// Values of a station at an instant.
#define WATCHED_VALUES(array, extent, columns, ...) vec array[columns];
typedef struct watched_instant {
    WHIRL_WATCHED_OF_STATIONS(WATCHED_VALUES)
} watched_instant;
#undef WATCHED_VALUES

VECTOR_INLINE watched_instant watched_at(const whirl_probe *probe, vec x, vec y, vec vx, vec vy) {
    if (probe->units) {
        x = v_mul(x, v_set(probe->units[0])), y = v_mul(y, v_set(probe->units[1]));
        vx = v_mul(vx, v_set(probe->units[2])), vy = v_mul(vy, v_set(probe->units[3]));
    }
    // Computes the same values as whirl_probe_sees.
    if (probe->x == probe->y && probe->along_y) x = vx = v_set(0.0);
    if (probe->x == probe->y && !probe->along_y) y = vy = v_set(0.0);
    const vec square = v_fma(x, x, v_mul(y, y)), way = v_set(probe->clockwise ? -1.0 : 1.0);
    const vec turning = v_mul(way, v_fms(x, vy, v_mul(y, vx)));
    return (watched_instant){.max_radius = {square},
                             .min_radius = {square},
                             .mean = {x, y},
                             .backward = {v_select(v_less(turning, v_set(0.0)), v_set(1.0), v_set(0.0))}};
}

/// Combines the value at one more instant with the result so far.
VECTOR_INLINE vec watched_with(whirl_fold fold, vec value, vec so_far) {
    return fold == WHIRL_LARGEST    ? v_max(value, so_far)
           : fold == WHIRL_SMALLEST ? v_min(value, so_far)
                                    : v_add(so_far, value);
}

/// Adds a time `part` in which a contact is closed (now = 1) or open (now = 0). The share counts instants; per:
/// instants per unit of time.
VECTOR_INLINE void watch_contact(vec now, vec part, vec per, vec *before, vec *share, vec *number) {
    *share = v_fma(v_mul(now, part), per, *share);
    *number = v_fma(now, v_sub(v_set(1.0), *before), *number);
    *before = now;
}

/// Adds the effect of a contact's friction at an instant.
VECTOR_INLINE void watch_friction(vec torque, vec power, vec *sum, vec *most, vec *powers) {
    *sum = v_add(*sum, torque);
    *most = v_max(v_abs(torque), *most);
    *powers = v_add(*powers, power);
}

#endif
