/// A flag with which one thread, or a signal handler, asks work on other threads to end early.
#ifndef WHIRL_STOP_H
#define WHIRL_STOP_H

#include <stdbool.h>

// C++ programs often include C headers in a block of extern "C", where templates are errors; extern "C++" allows them
// there again.

// The first branch is for C.
#ifndef __cplusplus
#include <stdatomic.h>
/// False; becomes true, for good, when work shall end early. Work reads it between steps.
typedef atomic_bool whirl_stop;
#else
extern "C++" {
#include <atomic>
/// False; becomes true, for good, when work shall end early. Work reads it between steps.
using whirl_stop = std::atomic<bool>;
}
#endif

/// Returns true if work with this flag shall end; false for NULL.
static inline bool whirl_stop_is_set(const whirl_stop *stop) {
    return stop && *stop;
}

#endif
