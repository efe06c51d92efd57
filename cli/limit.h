/// Limits what is only tried, such as a few revolutions of a motion, in processor time.
#ifndef CLI_LIMIT_H
#define CLI_LIMIT_H

#include "whirl/engine/stop.h"

/// Begins a time of so many seconds. What it gives becomes true when they are over, and false where another one begins:
/// the `stop` of whirl_integrate_options. One at a time, in a program of one thread.
const whirl_stop *limit_begin(long seconds);

void limit_end(void);

#endif
