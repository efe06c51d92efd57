// Names lines of spectra by the orders that parts of the machine have.
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "named_lines.h"
#include "whirl/engine/system.h"

/// Largest difference between the order of a line, which is interpolated between bins of the spectrum, and a named
/// order.
static const double tolerance = 0.005;

/// Writes the name of a line that is a multiple or a sideband of a named order. Returns its rank, 1 for the simplest
/// name, or 0 if it is neither.
static int simplest(double line, const whirl_named_order *of, char name[LINE_NAME_SIZE]) {
    enum { MULTIPLES = 4 };
    for (int n = 1; n <= MULTIPLES; n++) {
        if (fabs(line - n * of->order) > tolerance) continue;
        if (n == 1)
            snprintf(name, LINE_NAME_SIZE, "%s", of->name);
        else
            snprintf(name, LINE_NAME_SIZE, "%d %s", n, of->name);
        return n;
    }
    for (int side = -1; side <= 1; side += 2) {
        if (fabs(line - of->order - side) > tolerance) continue;
        snprintf(name, LINE_NAME_SIZE, "%s %c 1X", of->name, side < 0 ? '-' : '+');
        return MULTIPLES + 1;
    }
    return 0;
}

bool named_line(const whirl_system *system, double order, size_t station, char name[LINE_NAME_SIZE],
                whirl_named_order *of) {
    int best = 0;
    whirl_named_order next;
    for (size_t i = 0; system->named_order && system->named_order(system->model, i, &next); i++) {
        char called[LINE_NAME_SIZE];
        const int rank = 2 * simplest(order, &next, called) + (next.probe != station);
        if (rank < 2 || (best > 0 && rank >= best)) continue;
        best = rank;
        *of = next;
        snprintf(name, LINE_NAME_SIZE, "%s", called);
    }
    return best > 0;
}
