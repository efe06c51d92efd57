/// Crashes of libraries for lack of memory become a sentence and exit status 1, instead of a signal.
#ifndef CLI_GUARD_H
#define CLI_GUARD_H

/// Turns faults for lack of memory, and unexpected ends of the program, into a sentence.
void guard_begin(void);

/// The program ends of itself, as it may while arguments are read.
void guard_rest(void);

/// Registers a file that is written under a temporary name, which is removed if the program ends by a fault.
void guard_output(const char *path);

/// Notes that memory ran out: at exit libraries are not called any more, since they might crash.
void guard_note_exhausted(void);

/// Ends the program.
_Noreturn void guard_leave(int status);

#endif
