/// Programs that tests run for comparison, and that print a table of points: a word, then numbers, separated by tabs;
/// lines that begin with "#" are notes.
#ifndef SUPPORT_PEER_H
#define SUPPORT_PEER_H

#include <complex.h>
#include <stdbool.h>
#include <stddef.h>

enum { PEER_NUMBERS = 48 };

typedef struct peer_point {
    char kind[32];
    size_t count;
    double numbers[PEER_NUMBERS];
} peer_point;

/// Runs the command and reads at most `most` points, *count of them. False where it ends with 77, which says what is
/// not installed; the test ends where it fails otherwise.
bool run_peer(const char *command, peer_point *points, size_t most, size_t *count);

/// The distance of each of n multipliers, real and imaginary parts [n][2], from the nearest of others [n]; the largest.
double multipliers_apart(size_t n, const double *parts, const double complex *others);

#endif
