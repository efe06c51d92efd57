#include "limit.h"

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/time.h>

static whirl_stop over;

static void set_over(int number) {
    (void)number;
    over = true;
}

static void set_timer(long seconds) {
    const struct itimerval timer = {.it_value = {.tv_sec = seconds}};
    setitimer(ITIMER_PROF, &timer, NULL);
}

const whirl_stop *limit_begin(long seconds) {
    const struct sigaction action = {.sa_handler = set_over};
    over = false;
    sigaction(SIGPROF, &action, NULL);
    set_timer(seconds);
    return &over;
}

whirl_system limit_system(const whirl_system *system, const whirl_stop *stop) {
    whirl_system limited = *system;
    limited.stop = stop;
    return limited;
}

void limit_end(void) {
    set_timer(0);
}
