#define VECTOR_ISA 4
#define VARIATIONAL_LANES_REVOLVE variational_lanes_avx512
#include "variational_lanes.inc"
