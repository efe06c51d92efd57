/// Limits the processor time of trials, such as a few revolutions of a motion.
#ifndef CLI_LIMIT_H
#define CLI_LIMIT_H

#include "whirl/engine/system.h"

/// Begins a limit of `seconds` of processor time. The returned flag becomes true when it is over, and false when
/// another limit begins. Only one limit at a time, in a program with one thread.
const whirl_stop *limit_begin(long seconds);

/// Returns a copy of a system whose motions end when *stop becomes true.
whirl_system limit_system(const whirl_system *system, const whirl_stop *stop);

void limit_end(void);

#endif
