/// An interrupt from the keyboard or a scheduler ends a run in good order.
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include "whirl/engine/study.h"

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 set the flag that is returned; another one, half a second later or
/// more, kills as usual, but for SIGUSR1, by which schedulers only announce an end.
const whirl_stop *interrupt_watch(void);

/// Sets the flag in so many seconds from now.
void interrupt_after(double seconds);

/// Seconds until the time limit; infinite without one.
double interrupt_left(void);

/// interrupt_signal: the signal that arrived, 0 if none. interrupt_pass_on: sets the flag for a signal that arrived at
/// another process.
int interrupt_signal(void);
void interrupt_pass_on(int number);

/// Name of the interrupt.
const char *interrupt_text(void);

#endif
