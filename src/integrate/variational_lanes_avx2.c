#define VECTOR_ISA 3
#define VARIATIONAL_LANES_REVOLVE variational_lanes_avx2
#include "variational_lanes.inc"
