/// Shared by the benchmark programs: each first shows by an end state that its result is right, then measures its
/// speed. C and C++.
///
/// A program is called with the seconds to measure for and prints one line for each thing that it measures:
/// name, steps a second of processor time, x1 after 20 revolutions; separated by tabs.
#ifndef BENCH_PEER_H
#define BENCH_PEER_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct peer {
    const char *name;
    size_t machines;                ///< number carried side by side
    void (*revolve)(void *context); ///< carries all machines over one revolution
    double (*x1)(void *context);    ///< returns x1 of the first machine
    void *context;
} peer;

/// Returns the seconds to measure for: the first argument of the command line, 0.3 without one.
double peer_seconds(int argc, char **argv);

/// Returns the processor time of this process in seconds: time that other processes take of the core does not count.
double peer_clock(void);

/// Carries the machines over 20 revolutions, then over as many more as the time allows, and prints the line.
void peer_measure(const peer *measured, double seconds);

/// Does the same where a revolution has `steps` steps, not ROTOR_STEPS.
void peer_measure_steps(const peer *measured, int steps, double seconds);

#ifdef __cplusplus
}
#endif
#endif
