/// What becomes of the program where a library does not survive a lack of memory: a sentence and exit status 1, no
/// signal.
#ifndef CLI_GUARD_H
#define CLI_GUARD_H

/// From now on a fault for lack of memory, and an end of the program that is not its own, are told in a sentence.
void guard_begin(void);

/// The program ends of itself, as it may while arguments are read.
void guard_rest(void);

/// A file that is written whole or not at all while the guard watches: what is half written of it, under its temporary
/// name, is removed where the program ends by a fault.
void guard_output(const char *path);

/// Memory ran out: at the end nothing is left to libraries, which may not be able to tidy up.
void guard_note_exhausted(void);

/// Ends the program.
_Noreturn void guard_leave(int status);

#endif
