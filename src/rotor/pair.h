/// Pairs: machines of a disc and a journal that a shaft joins, with a film at the journal and a rub at the disc.
/// Integrators have loops of their own for them (pair_kernel.h).
#ifndef ROTOR_PAIR_H
#define ROTOR_PAIR_H

#include <stdbool.h>
#include <stddef.h>

struct assembly;
struct element;

enum { PAIR_STATIONS = 2 };
enum { PAIR_SHAFT_LAW, PAIR_RUB_LAW, PAIR_LAWS };

/// Returns true if a machine with these elements [count] is a pair. Writes the order of its stations (disc, journal)
/// and the laws of its shaft and its rub.
bool pair_find(const struct assembly *of, const struct element *elements, size_t count, size_t order[PAIR_STATIONS],
               int laws[PAIR_LAWS]);

#endif
