/// Number of cores that this process may use.
#ifndef CLI_CORES_H
#define CLI_CORES_H

/// Returns the number of cores on which this process may run. A scheduler or taskset may allow fewer than the computer
/// has.
int available_cores(void);

#endif
