#include "interrupt.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <time.h>

/// A signal handler can reach nothing but static storage.
static volatile bool stopped;
static volatile sig_atomic_t received;

static volatile double first; ///< seconds, when the first one came

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/// One wish to stop may come as several signals: timeout(1) and batch systems signal a process and then its group. Only
/// a later one ends the program at once.
static void on_signal(int number) {
    const double seconds = now();
    if (!received) {
        first = seconds;
        received = number;
        stopped = true;
    } else if (seconds - first > 0.5) {
        signal(number, SIG_DFL);
        raise(number);
    }
}

const volatile bool *interrupt_watch(void) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        struct sigaction before;
        // What a parent has set to be ignored (nohup) stays ignored.
        if (sigaction(signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
    }
    // A file that may grow no further is an error of its write, not the end of the program.
    sigaction(SIGXFSZ, &(struct sigaction){.sa_handler = SIG_IGN}, NULL);
    return &stopped;
}

const char *interrupt_text(void) {
    return received ? strsignal(received) : "interrupted";
}
