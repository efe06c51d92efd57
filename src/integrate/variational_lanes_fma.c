#define VECTOR_ISA 2
#define VARIATIONAL_LANES_REVOLVE variational_lanes_fma
#include "variational_lanes.inc"
