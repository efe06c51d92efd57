/// Handles crashes of libraries that run out of memory: they become a sentence and exit status 1, instead of a signal.
#ifndef CLI_GUARD_H
#define CLI_GUARD_H

/// From now on a fault for lack of memory, or an unexpected exit, prints a sentence.
void guard_begin(void);

/// From now on the program may exit without a sentence, as argp does while it reads arguments.
void guard_rest(void);

/// Registers the path of a file to be written, whose temporary file is removed if the program ends by a fault.
void guard_output(const char *path);

/// Notes that memory ran out: at exit the handlers of libraries are skipped, since they might crash.
void guard_note_exhausted(void);

/// Ends the program with this exit status.
_Noreturn void guard_leave(int status);

#endif
