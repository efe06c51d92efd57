/// The last turns of a run, as samples at equal angles of the shaft.
#ifndef ANALYZE_TURN_HISTORY_H
#define ANALYZE_TURN_HISTORY_H

#include <stddef.h>

/// A computed instant of a turn.
typedef struct turn_instant {
    double angle;    ///< rad within the turn
    double speed;    ///< rad/s
    double *numbers; ///< [width] as a row of turn_samples
    double *slopes;  ///< [2 probes] of x and y by time, 1/s
} turn_instant;

/// Instants of a turn at equal angles, the beginning of the turn first. An instant is one row of `numbers`: the time in
/// s; x and y of every probe, those of axial displacements last; normal force (N) and gap (below 0: pressed in) of
/// every contact; torques, N m; numbers of the shafts of a machine with several (RUNUP_SHAFT_NUMBERS each). Lengths are
/// those of the machine.
typedef struct turn_samples {
    size_t samples, probes, contacts;
    size_t torques;       ///< those on the shaft (RUNUP_SHAFT_TORQUES), then the watched ones; 0: none are wanted
    size_t shafts;        ///< shafts whose torques are told apart; 0: none are wanted
    size_t width;         ///< numbers of a row
    double *numbers;      ///< [samples][width]; in one block with the numbers of `ends`
    turn_instant ends[2]; ///< workspace
} turn_samples;

/// Makes samples of one turn; numbers are NULL without memory. Freed by free(numbers).
turn_samples turn_samples_new(size_t samples, size_t probes, size_t contacts, size_t torques, size_t shafts);

/// Numbers of a shaft: its torques as in whirl_shaft_torques, then its speed.
enum { RUNUP_SHAFT_PARTS = 7, RUNUP_SHAFT_NUMBERS = RUNUP_SHAFT_PARTS + 1 };

/// Fills in the instants at equal angles from one computed instant to before the next one: angles and displacements are
/// cubic in time between both (Hermite), forces, gaps and torques linear. An instant that is itself a computed one gets
/// its numbers unchanged.
void turn_samples_fill(turn_samples *to, const turn_instant *low, const turn_instant *high);

/// The last turns.
typedef struct turn_history {
    size_t capacity, held; ///< number of turns that must be kept; number in memory, up to twice as many
    size_t turn;           ///< numbers of a turn, samples times width
    double *numbers;       ///< [2 capacity][turn]
    double end;            ///< s, end of the last turn
} turn_history;

/// Makes the history of the last `capacity` turns; numbers are NULL without memory. Freed by free(numbers).
turn_history turn_history_new(size_t capacity, const turn_samples *of);

/// Adds a turn that ended at a time.
void turn_history_add(turn_history *to, const double *numbers, double end);

/// Returns the last turns [turns][samples][width]; NULL if there are fewer.
const double *turn_history_last(const turn_history *of, size_t turns);

#endif
