#include "guard.h"

#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command.h"

enum { PATH_SIZE = 4096 + 64 };

/// A signal handler can reach nothing but static storage.
static volatile sig_atomic_t watching;
static bool exhausted;
static char half_written[PATH_SIZE];

/// Ends the program with a sentence, by calls that are safe in a signal handler.
static _Noreturn void give_up(void) {
    static const char sentence[] =
        "whirl: there is no memory left, and a library could not go on; nothing is half written\n";
    if (half_written[0]) unlink(half_written);
    const ssize_t said = write(STDERR_FILENO, sentence, sizeof sentence - 1);
    (void)said;
    _exit(EXIT_FAILED);
}

/// Handles a fault. After a lack of memory (errno) a library has used a null pointer or aborted: ends the program with
/// a sentence. Any other fault is an error of the program, and kills it as usual.
static void on_fault(int number) {
    if (errno == ENOMEM) give_up();
    signal(number, SIG_DFL);
    raise(number);
}

/// Called at exit: prints the sentence if a library has ended the program (the lexer of UDUNITS-2, HDF5, OpenMP do so).
static void on_exit_of_others(void) {
    if (watching) give_up();
}

static void watch_faults(void) {
    enum { STACK_SIZE = 1 << 16 };
    static const int faults[] = {SIGSEGV, SIGBUS, SIGABRT};
    // The handler has its own stack: HDF5 1.10 recurses until the stack is full if it cannot start.
    static char stack[STACK_SIZE];
    const stack_t own = {.ss_sp = stack, .ss_size = sizeof stack};
    struct sigaction action = {.sa_handler = on_fault, .sa_flags = SA_ONSTACK}, before;
    if (sigaltstack(&own, NULL) != 0) action.sa_flags = 0;
    sigemptyset(&action.sa_mask);
    // Keep the handlers of sanitizers.
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        if (sigaction(faults[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL)
            sigaction(faults[i], &action, NULL);
}

void guard_begin(void) {
    static bool ready;
    if (!ready && atexit(on_exit_of_others) == 0) watch_faults();
    ready = true;
    watching = 1;
}

void guard_rest(void) {
    watching = 0;
}

void guard_output(const char *path) {
    snprintf(half_written, sizeof half_written, "%s.tmp-%ld", path, (long)getpid());
}

void guard_note_exhausted(void) {
    exhausted = true;
}

// The failure may be an out-of-memory error inside a library, whose atexit handler would then crash.
_Noreturn void guard_leave(int status) {
    guard_rest();
    if (!exhausted && status != EXIT_FAILED) exit(status);
    fflush(stdout);
    _exit(status);
}
