#define VECTOR_ISA 0
#define MACHINE_ACCELERATE machine_accelerate_scalar
#include "machine.inc"
