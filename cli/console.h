/// Console of a running study: progress, estimates, interrupts.
#ifndef CLI_CONSOLE_H
#define CLI_CONSOLE_H

#include "whirl/engine/rotor.h"
#include "whirl/engine/study.h"

#include <stdbool.h>

// ---------------------------------------------------------------- cores

/// Cores that this process may run on, which a scheduler or taskset may have made fewer than the computer has.
int available_cores(void);

// ---------------------------------------------------------------- estimate
// Duration of a study, estimated from a few of its revolutions.

/// Estimates the seconds that a batch takes on so many cores, to within a factor of about two; for motions that settle
/// an upper bound. NaN if unknown: for branches, very large studies, and studies at rest, except modes that take a
/// second or more. Infinite if a revolution takes over 5 s. The estimate takes about a tenth of a second, at most a few
/// revolutions of one machine. WHIRL_NO_MEMORY.
whirl_status estimate_seconds(const whirl_study *study, const whirl_batch *batch, int cores, double *seconds);

// ---------------------------------------------------------------- guard
// Crashes of libraries for lack of memory become a sentence and exit status 1, instead of a signal.

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

// ---------------------------------------------------------------- interrupt
// An interrupt from the keyboard or a scheduler ends a run in good order.

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

// ---------------------------------------------------------------- phases
// Report of `whirl check` on forces that do not rotate with the shaft.

/// Prints lines if forces of the batch's machines do not repeat with the shaft: the phase of sections (the shaft's, or
/// that of the keyphasor of `rotor`), the period of the forces or that they have none, and the names of the verdicts.
/// Returns errors of the machines.
whirl_status print_phases(const whirl_study *study, const whirl_batch *batch, const whirl_rotor *rotor);

// ---------------------------------------------------------------- progress
// Progress of a run on standard error: a bar on a terminal, plain lines elsewhere.

typedef struct progress_view {
    bool terminal;
    double seconds; ///< time in the run of the last update
    int round;      ///< round of refinement
    whirl_stage stage;
    size_t points;  ///< points of the stage; grows while a map is refined
    int last_tenth; ///< tenth of the run, the round or these points for which a plain line was written
    bool drawn;     ///< a bar is on the current line
} progress_view;

/// "12 s", "3:05 min", "2:10 h".
void duration_text(double seconds, char *text, size_t size);

/// A view that suits standard error.
progress_view progress_begin(void);

/// Shows how far the run is; `view` is a progress_view. As whirl_run_options.progress wants it.
void progress_show(void *view, const whirl_progress *progress);

/// Removes the bar.
void progress_end(progress_view *view);

// ---------------------------------------------------------------- summary
// Description of a study before it is computed, for `whirl run` and `whirl check`.

/// One line a batch: points, revolutions, steps.
void summarize_study(const whirl_study *study);

// ---------------------------------------------------------------- terminal
// Properties of the terminal, if there is one.

/// Returns true if a file descriptor is a terminal.
bool is_terminal(int descriptor);

/// Returns true if colours may be written: to a terminal that is not dumb, without NO_COLOR (no-color.org).
bool has_colours(int descriptor);

/// Columns of the terminal of a file descriptor, at least 40; without a terminal COLUMNS, else 80.
int terminal_columns(int descriptor);

/// Columns of a text, in which continuation bytes of UTF-8 do not count.
int text_columns(const char *text);

/// Prints words to standard output, in lines of at most `width` columns where possible. The first line continues at
/// column `at`, the others begin at `indent`. No newline at the end.
void print_wrapped(const char *text, int at, int indent, int width);

#endif
