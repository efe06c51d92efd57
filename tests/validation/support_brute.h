/// Brute force independent of whirl: its own equations, RK4 and quasi-random starts; kinds of motions follow from their
/// returns.
#ifndef SUPPORT_BRUTE_H
#define SUPPORT_BRUTE_H

#include "whirl/engine/case.h"

static const double pi = 3.14159265358979323846;

/// The digits of a number in base 2 or 3, mirrored at the point.
double brute_mirrored(int number, int base);

enum { MAX_STATE = 8, LONGEST = 16, SEEN = 64 };

/// A forced system in time tau of period 2 pi, [v, a] = f(tau, [x, v]).
typedef struct brute {
    void (*rate)(double parameter, double cosine, double sine, const double *x, double *dx);
    double parameter;
    int dimension, steps, transient;
} brute;

/// End of a motion: its period in revolutions, 0 if it does not return, and its section over the last revolutions.
typedef struct outcome {
    int period;
    double section[SEEN][2], mean;
} outcome;

/// Carries a motion from x over the transient, and returns its end; x becomes its last state.
outcome brute_follow(const brute *b, double *x, double tolerance);

/// The calibrated reading (cases/paper.yaml): disc and journal, in clearances and tau = omega t; x1, y1, x2, y2.
void brute_paper_rotor(double r_k, double cosine, double sine, const double *x, double *dx);

/// cases/paper.yaml with another study.
whirl_case *brute_paper_case(const char *study);

#endif
