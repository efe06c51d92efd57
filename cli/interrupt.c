#include "interrupt.h"

#include <math.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>

/// A signal handler can reach nothing but static storage.
static whirl_stop stopped;
static volatile sig_atomic_t received;

static volatile double first; ///< s, time of the first signal
static double last;           ///< s, time at which --max-time is over; 0: no limit

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/// Sets the flag at the first signal; kills the program at another one half a second later or more. Signals closer
/// together are one request: timeout(1) and batch systems signal a process and then its group.
static void on_signal(int number) {
    const double seconds = now();
    if (first == 0.0) first = seconds;
    if (!received) received = number;
    stopped = true;
    if (seconds - first > 0.5) {
        signal(number, SIG_DFL);
        raise(number);
    }
}

/// Sets the flag, and never kills: for signals that only announce an end.
static void on_announcement(int number) {
    if (!received) received = number;
    stopped = true;
}

static void handle(int number, void (*handler)(int)) {
    struct sigaction action = {.sa_handler = handler, .sa_flags = SA_RESTART}, before;
    sigemptyset(&action.sa_mask);
    // A signal that the parent ignores (nohup) stays ignored.
    if (sigaction(number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) sigaction(number, &action, NULL);
}

const whirl_stop *interrupt_watch(void) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) handle(signals[i], on_signal);
    handle(SIGUSR1, on_announcement);
    // If a file reaches its size limit, its write fails; the signal would kill the program.
    sigaction(SIGXFSZ, &(struct sigaction){.sa_handler = SIG_IGN}, NULL);
    return &stopped;
}

void interrupt_after(double seconds) {
    const double whole = floor(fmin(seconds, 1e9)); // 30 years
    const struct itimerval timer = {
        .it_value = {.tv_sec = (time_t)whole, .tv_usec = (suseconds_t)(1e6 * (fmin(seconds, 1e9) - whole)) + 1}};
    last = now() + seconds;
    handle(SIGALRM, on_announcement);
    setitimer(ITIMER_REAL, &timer, NULL);
}

double interrupt_left(void) {
    return last > 0.0 ? last - now() : (double)INFINITY;
}

int interrupt_signal(void) {
    return received;
}

void interrupt_pass_on(int number) {
    on_announcement(number);
}

const char *interrupt_text(void) {
    if (received == SIGALRM) return "the time of --max-time is over";
    return received ? strsignal(received) : "interrupted";
}
