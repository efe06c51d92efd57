/// Angles in a state, by the arrays `turns` and `angles` of whirl_system: the length of a turn of each coordinate, 0
/// for those that are no angles. `turns` are phases that grow at a rate which no state changes; `angles` are all other
/// angles, such as that of a pendulum.
#ifndef BASE_TURNS_H
#define BASE_TURNS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/// Returns true if coordinate i of a state is an angle; `turns` may be NULL.
static inline bool turns_on(const double *turns, size_t i) {
    return turns && turns[i] > 0.0;
}

/// Counts the angles among n coordinates.
static inline size_t turns_count(const double *turns, size_t n) {
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += turns_on(turns, i);
    return count;
}

/// Reduces an angle to its first turn.
static inline double in_first_turn(double angle, double turn) {
    return angle - turn * floor(angle / turn);
}

/// Returns the difference of two values of coordinate i, for an angle reduced to half a turn at most; `angles` may be
/// NULL.
static inline double short_way(const double *angles, size_t i, double difference) {
    return turns_on(angles, i) ? remainder(difference, angles[i]) : difference;
}

/// Returns the difference of coordinate i of states a and b; 0 for one in `turns`.
static inline double part_apart(const double *turns, const double *angles, size_t i, const double *a, const double *b) {
    return turns_on(turns, i) ? 0.0 : short_way(angles, i, a[i] - b[i]);
}

/// Returns the value of coordinate i to go on with after a revolution: one in `turns` is reduced to its first turn, one
/// in `angles` to half a turn about 0.
static inline double part_wrapped(const double *turns, const double *angles, size_t i, double value) {
    return turns_on(turns, i) ? in_first_turn(value, turns[i]) : short_way(angles, i, value);
}

#endif
