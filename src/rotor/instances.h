/// The structures for which integrators have their own loops: the most frequent rotors.
///
/// A structure <name> consists of src/rotor/<name>_kernel.h, with the phases of its acceleration, and <name>.c, which
/// recognizes it when a rotor is built. It has one line and one block here. Integrators write their loops once
/// (integrate/kernels/*_instance.inc), with INSTANCE(word) for <name>_word and INSTANCE_SIZE(WORD) for <NAME>_WORD. If
/// INSTANCE_FILE is defined, this header includes that file for every structure.
#ifndef ROTOR_INSTANCES_H
#define ROTOR_INSTANCES_H

#include "lanes.h"

#define INSTANCES(X) X(pair, PAIR)

#define INSTANCE_NUMBER(name, NAME) INSTANCE_##NAME,
enum { INSTANCES(INSTANCE_NUMBER) INSTANCE_COUNT };
#undef INSTANCE_NUMBER

/// Tests whether an instance, which may be NULL, is of the structure NAME.
#define IS_INSTANCE(NAME, instance) ((instance) && (instance)->structure == INSTANCE_##NAME)

#endif

#include "pair_kernel.h"
#ifdef INSTANCE_FILE
#define INSTANCE(word) pair_##word
#define INSTANCE_SIZE(WORD) PAIR_##WORD
#define INSTANCE_STRUCTURE INSTANCE_PAIR
#include INSTANCE_FILE
#undef INSTANCE
#undef INSTANCE_SIZE
#undef INSTANCE_STRUCTURE
#endif

#undef INSTANCE_FILE
