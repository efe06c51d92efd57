#define VECTOR_ISA 1
#define MACHINE_ACCELERATE machine_accelerate_128
#include "machine.inc"
