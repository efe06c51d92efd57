/// What is told while a study runs, and how it is stopped.
#ifndef CLI_CONSOLE_H
#define CLI_CONSOLE_H

#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

#include <stdbool.h>

// ---------------------------------------------------------------- cores

/// Cores that this process may run on, which a scheduler or taskset may have made fewer than the computer has.
int available_cores(void);

// ---------------------------------------------------------------- estimate
// How long a study takes, by a few of its revolutions.

/// Seconds that a batch takes on so many cores, to within a factor of two or so; of motions that settle at most. NaN
/// where it is not known: of branches, of machines at rest but for modes that take a second or more, which are
/// otherwise next to nothing, and of very large ones;
/// infinite where a revolution takes over 5 s. Takes a tenth of a second or so itself, and no longer than a few
/// revolutions of one machine. WHIRL_NO_MEMORY.
whirl_status estimate_seconds(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds);

// ---------------------------------------------------------------- guard
// What becomes of the program where a library does not survive a lack of memory: a sentence and exit status 1, no
// signal.

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

// ---------------------------------------------------------------- interrupt
// An interrupt from the keyboard or a scheduler ends a run in good order.

/// From now on SIGINT, SIGTERM, SIGHUP and SIGUSR1 set the flag that is returned; another one, half a second later or
/// more, kills as usual, but for SIGUSR1, by which schedulers only announce an end.
const whirl_stop *interrupt_watch(void);

/// Sets the flag in so many seconds from now.
void interrupt_after(double seconds);

/// Seconds until then; infinite where none were set.
double interrupt_left(void);

/// The signal that came, 0 where none did; sets the flag as a signal does that came to another process.
int interrupt_signal(void);
void interrupt_pass_on(int number);

/// What the interrupt was, in words.
const char *interrupt_text(void);

// ---------------------------------------------------------------- phases
// What `whirl check` says of forces that do not turn with the shaft.

/// Lines on standard output where forces of the batch's machines have phases of their own: by which phase sections are
/// taken (that of the shaft, or of the keyphasor of `rotor`), after how many revolutions forces repeat, or that they
/// fit none, and what the verdicts will be called. Errors as those of the machines.
whirl_status tell_phases(const whirl_study *study, const whirl_batch *batch, const whirl_rotor *rotor);

// ---------------------------------------------------------------- progress
// Progress of a run on standard error: a bar on a terminal, plain lines elsewhere.

typedef struct progress_view {
    bool terminal;
    double seconds; ///< of the run, when it was last shown
    int round;      ///< of refinement, and
    whirl_stage stage;
    size_t points;  ///< of the stage: more than before where a map is refined further
    int last_tenth; ///< of the run, the round or these points that a plain line was written for
    bool drawn;     ///< a bar stands on the current line
} progress_view;

/// "12 s", "3:05 min", "2:10 h".
void duration_text(double seconds, char *text, size_t size);

/// A view that suits standard error.
progress_view progress_begin(void);

/// Shows how far the run is; `view` is a progress_view. As whirl_run_options.progress wants it.
void progress_show(void *view, const whirl_progress *progress);

/// Takes the bar away.
void progress_end(progress_view *view);

// ---------------------------------------------------------------- summary
// What `whirl run` and `whirl check` say of a study before it is computed.

/// One line a batch: points, revolutions, steps.
void summarize_study(const whirl_study *study);

// ---------------------------------------------------------------- terminal
// What the terminal can show, if there is one.

/// Whether a file descriptor is a terminal.
bool is_terminal(int descriptor);

/// Whether colours may be written to it: a terminal that is not dumb, where NO_COLOR (no-color.org) is absent or empty.
bool has_colours(int descriptor);

/// Columns of the terminal behind a file descriptor, from 40 on; where there is none, those that COLUMNS says, else 80.
int terminal_columns(int descriptor);

/// Columns that a text takes: continuation bytes of UTF-8 take none.
int text_columns(const char *text);

/// Prints words to standard output, broken so that no line is longer than `width` where that is possible. The first
/// line goes on at column `at`, the others begin at `indent`. No newline at the end.
void print_wrapped(const char *text, int at, int indent, int width);

#endif
