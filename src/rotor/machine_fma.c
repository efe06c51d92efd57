#define VECTOR_ISA 2
#define MACHINE_ACCELERATE machine_accelerate_fma
#include "machine.inc"
