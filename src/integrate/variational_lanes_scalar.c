#define VECTOR_ISA 0
#define VARIATIONAL_LANES_REVOLVE variational_lanes_scalar
#include "variational_lanes.inc"
