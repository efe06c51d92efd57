#define VECTOR_ISA 3
#define MACHINE_ACCELERATE machine_accelerate_avx2
#include "machine.inc"
