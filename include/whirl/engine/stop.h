/// A flag with which one thread, or a signal handler, asks work on other threads to end early.
#ifndef WHIRL_STOP_H
#define WHIRL_STOP_H

#ifdef __cplusplus
#include <atomic>
/// False; becomes true, for good, when work shall end early. Work reads it between steps.
using whirl_stop = std::atomic<bool>;
#else
#include <stdatomic.h>
/// False; becomes true, for good, when work shall end early. Work reads it between steps.
typedef atomic_bool whirl_stop;
#endif

#endif
