/// Shared by the benchmark programs: proof, then measurement. C and C++.
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
    size_t machines;                ///< carried side by side
    void (*revolve)(void *context); ///< all machines over one revolution
    double (*x1)(void *context);    ///< of the first machine
    void *context;
} peer;

/// Seconds to measure for, from the command line: its first argument, 0.3 without.
double peer_seconds(int argc, char **argv);

/// Processor time of this process, in seconds: what other processes take of the core does not count.
double peer_clock(void);

/// Carries the machines over 20 revolutions, then over as many more as the time allows, and prints the line.
void peer_measure(const peer *measured, double seconds);

/// The same where a revolution is not of ROTOR_STEPS steps.
void peer_measure_steps(const peer *measured, int steps, double seconds);

#ifdef __cplusplus
}
#endif
#endif
