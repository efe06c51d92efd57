#define VECTOR_ISA 4
#define MACHINE_ACCELERATE machine_accelerate_avx512
#include "machine.inc"
