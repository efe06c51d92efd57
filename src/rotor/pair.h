/// The laws of a rotor of the structure of pair_kernel.h.
#ifndef ROTOR_PAIR_H
#define ROTOR_PAIR_H

#include <stddef.h>

struct lanes_pair {
    int shaft_law, rub_law;
};

#endif
