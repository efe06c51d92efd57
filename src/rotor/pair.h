/// The laws of a rotor of the structure of pair_kernel.h.
#ifndef ROTOR_PAIR_H
#define ROTOR_PAIR_H

#include "element.h"

/// Of its elements only law and slip speed count.
struct lanes_pair {
    element shaft, rub;
};

#endif
