/// Parts of a state that are angles: whirl_system.turns and .angles say what one turn of each is, 0 of what is none.
#ifndef BASE_TURNS_H
#define BASE_TURNS_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/// Whether part i of a state is such an angle; `turns` may be NULL, where none is.
static inline bool turns_on(const double *turns, size_t i) {
    return turns && turns[i] > 0.0;
}

/// How many of the n parts are.
static inline size_t turns_count(const double *turns, size_t n) {
    size_t count = 0;
    for (size_t i = 0; i < n; i++) count += turns_on(turns, i);
    return count;
}

/// An angle brought back into its first turn.
static inline double in_first_turn(double angle, double turn) {
    return angle - turn * floor(angle / turn);
}

/// A difference of two values of part i: of an angle (whirl_system.angles, which may be NULL) the short way round.
static inline double short_way(const double *angles, size_t i, double difference) {
    return turns_on(angles, i) ? remainder(difference, angles[i]) : difference;
}

/// How far part i of state a is from that of b: what turns on and on is never apart.
static inline double part_apart(const double *turns, const double *angles, size_t i, const double *a, const double *b) {
    return turns_on(turns, i) ? 0.0 : short_way(angles, i, a[i] - b[i]);
}

/// Part i as it is after a revolution: what turns on and on in its first turn, other angles within half a turn of 0.
static inline double part_wrapped(const double *turns, const double *angles, size_t i, double value) {
    return turns_on(turns, i) ? in_first_turn(value, turns[i]) : short_way(angles, i, value);
}

#endif
