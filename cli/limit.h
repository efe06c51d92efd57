/// Limit of processor time for trials, such as a few revolutions of a motion.
#ifndef CLI_LIMIT_H
#define CLI_LIMIT_H

#include "whirl/engine/stop.h"

/// Begins a time limit. The returned flag becomes true when it is over, and false when another limit begins; use it as
/// `stop` of whirl_integrate_options. One at a time, in a program with one thread.
const whirl_stop *limit_begin(long seconds);

void limit_end(void);

#endif
