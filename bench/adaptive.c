#include "adaptive.h"

#include <math.h>
#include <stdio.h>

#include "peer.h"

/// State after 20 revolutions at r_k = 0.6, in extended precision with contacts located.
static const double reference[ROTOR_DIMENSION] = {0.345742007211082,  -0.960673474907434, 0.357385561474779,
                                                  -0.838058876108404, 0.029677947868724,  -0.238524876790490,
                                                  0.022189656319900,  -0.057177790683174};

void adaptive_measure(const adaptive_peer *measured, double seconds) {
    double z[ROTOR_DIMENSION], error = 0.0, revolutions = 0.0, spent = 0.0;
    for (int i = 0; i < 20; i++) measured->revolve(measured->context);
    measured->state(measured->context, z);
    for (int i = 0; i < ROTOR_DIMENSION; i++) error = fmax(error, fabs(z[i] - reference[i]));
    const double start = peer_clock();
    while (spent < seconds) {
        measured->revolve(measured->context);
        revolutions += (double)measured->machines;
        spent = peer_clock() - start;
    }
    printf("%s\t%.6g\t%.3g\n", measured->name, revolutions / spent, error);
}
