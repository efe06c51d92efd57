/// A flag by which one thread, or a signal handler, asks work on other threads to end early.
#ifndef WHIRL_STOP_H
#define WHIRL_STOP_H

#ifdef __cplusplus
#include <atomic>
/// False until work shall end early; then true, for good. Work reads it between steps.
using whirl_stop = std::atomic<bool>;
#else
#include <stdatomic.h>
/// False until work shall end early; then true, for good. Work reads it between steps.
typedef atomic_bool whirl_stop;
#endif

#endif
