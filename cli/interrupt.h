/// Signals and --max-time set a flag, at which a run stops and saves its state.
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include "whirl/engine/study.h"

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 set the returned flag. Another signal half a second later or more
/// kills as usual, except SIGUSR1, by which schedulers only announce an end.
const whirl_stop *interrupt_watch(void);

/// Sets the flag after this time.
void interrupt_after(double seconds);

/// Returns the seconds until the time limit; infinite without one.
double interrupt_left(void);

/// interrupt_signal: returns the signal that arrived, 0 if none. interrupt_pass_on: sets the flag for a signal that
/// arrived at another rank.
int interrupt_signal(void);
void interrupt_pass_on(int number);

/// Returns the cause in words: "the time of --max-time is over" or the name of a signal.
const char *interrupt_text(void);

#endif
