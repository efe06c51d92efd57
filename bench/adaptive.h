/// Shared by the programs that integrate the rotor adaptively, with rtol 1e-9 and atol 1e-12 unless a program says
/// otherwise. Each measures the error after 20 revolutions, then the speed. C and C++.
///
/// A program is called with the seconds to measure for and prints one line for each thing that it measures:
/// name, revolutions a second of processor time, largest error of a coordinate after 20 revolutions; separated by tabs.
#ifndef BENCH_ADAPTIVE_H
#define BENCH_ADAPTIVE_H

#include <stddef.h>

#include "rotor.h"

#ifdef __cplusplus
extern "C" {
#endif

#define ADAPTIVE_RTOL 1e-9
#define ADAPTIVE_ATOL 1e-12

typedef struct adaptive_peer {
    const char *name;
    size_t machines;                ///< number carried side by side, the first with r_k = ROTOR_R_K
    void (*revolve)(void *context); ///< carries all machines over one revolution
    void (*state)(void *context, double z[ROTOR_DIMENSION]); ///< writes the state of the first machine
    void *context;
} adaptive_peer;

void adaptive_measure(const adaptive_peer *measured, double seconds);

#ifdef __cplusplus
}
#endif
#endif
