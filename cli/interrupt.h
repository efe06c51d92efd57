/// An interrupt from the keyboard or a scheduler ends a run in good order.
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include <stdbool.h>

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 set the flag that is returned; another one, half a second later or
/// more, kills as usual, but for SIGUSR1, by which schedulers only announce an end.
const volatile bool *interrupt_watch(void);

/// Sets the flag in so many seconds from now.
void interrupt_after(double seconds);

/// Seconds until then; infinite where none were set.
double interrupt_left(void);

/// The signal that came, 0 where none did; sets the flag as a signal does that came to another process.
int interrupt_signal(void);
void interrupt_pass_on(int number);

/// What the interrupt was, in words.
const char *interrupt_text(void);

#endif
