/// An interrupt from the keyboard or a scheduler ends a run in good order.
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include <stdbool.h>

/// From now on SIGINT, SIGTERM and SIGHUP set the flag that is returned; another one, half a second later or more,
/// kills as usual.
const volatile bool *interrupt_watch(void);

/// What the interrupt was, in words.
const char *interrupt_text(void);

#endif
