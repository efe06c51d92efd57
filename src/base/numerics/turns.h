/// Angles in a state: whirl_system.turns and .angles have the length of a turn of each, 0 for other coordinates.
#ifndef BASE_TURNS_H
#define BASE_TURNS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/// Returns true if part i of a state is an angle; `turns` may be NULL.
static inline bool turns_on(const double *turns, size_t i) {
    return turns && turns[i] > 0.0;
}

/// Counts the angles among n parts.
static inline size_t turns_count(const double *turns, size_t n) {
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += turns_on(turns, i);
    return count;
}

/// Reduces an angle to its first turn.
static inline double in_first_turn(double angle, double turn) {
    return angle - turn * floor(angle / turn);
}

/// Difference of two values of part i: of an angle (whirl_system.angles, may be NULL) the short way round.
static inline double short_way(const double *angles, size_t i, double difference) {
    return turns_on(angles, i) ? remainder(difference, angles[i]) : difference;
}

/// Difference of part i of states a and b; 0 for coordinates that turn.
static inline double part_apart(const double *turns, const double *angles, size_t i, const double *a, const double *b) {
    return turns_on(turns, i) ? 0.0 : short_way(angles, i, a[i] - b[i]);
}

/// Part i after a revolution: coordinates that turn are reduced to their first turn, other angles to half a turn about
/// 0.
static inline double part_wrapped(const double *turns, const double *angles, size_t i, double value) {
    return turns_on(turns, i) ? in_first_turn(value, turns[i]) : short_way(angles, i, value);
}

#endif
