/// Cores that this process may use.
#ifndef CLI_CORES_H
#define CLI_CORES_H

/// Cores that this process may run on, which a scheduler or taskset may have made fewer than the computer has.
int available_cores(void);

#endif
