/// The instruction sets of the kernels, and which of them this processor has.
#ifndef BASE_ISA_H
#define BASE_ISA_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

/// Number of an instruction set as vector.h counts them; its name and its lanes.
typedef struct isa {
    int number;
    const char *name; ///< as WHIRL_ISA takes it
    size_t lanes;
    bool fused;
} isa;

/// The instruction set of that number, or NULL where this processor or this build has none.
const isa *isa_at(int number);

/// The widest one, or the one that the environment variable WHIRL_ISA names. WHIRL_BAD_INPUT for an unknown name or one
/// that this processor does not have.
whirl_status isa_choose(const isa **chosen);

#endif
