/// Instruction sets of the kernels, and which of them this processor has.
#ifndef BASE_ISA_H
#define BASE_ISA_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/status.h"

/// An instruction set: its number in vector.h, name and lanes.
typedef struct isa {
    int number;
    const char *name; ///< name in WHIRL_ISA
    size_t lanes;
    bool fused; ///< a multiply-add rounds once
} isa;

/// Returns the instruction set of that number, or NULL if this processor or this build lacks it.
const isa *isa_at(int number);

/// Chooses the widest one, or the one in the environment variable WHIRL_ISA. WHIRL_BAD_INPUT for an unknown name or one
/// that this processor lacks.
whirl_status isa_choose(const isa **chosen);

#endif
