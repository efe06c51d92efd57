#include "peer.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "rotor.h"

double peer_clock(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double peer_seconds(int argc, char **argv) {
    const double seconds = argc > 1 ? strtod(argv[1], NULL) : 0.3;
    return seconds > 0.0 ? seconds : 0.3;
}

void peer_measure_steps(const peer *measured, int steps, double seconds) {
    for (int i = 0; i < 20; i++) measured->revolve(measured->context);
    const double x1 = measured->x1(measured->context), start = peer_clock();
    double revolutions = 0.0, spent = 0.0;
    while (spent < seconds) {
        measured->revolve(measured->context);
        revolutions += 1.0;
        spent = peer_clock() - start;
    }
    printf("%s\t%.6g\t%.13f\n", measured->name, revolutions * steps * (double)measured->machines / spent, x1);
}

void peer_measure(const peer *measured, double seconds) {
    peer_measure_steps(measured, ROTOR_STEPS, seconds);
}
