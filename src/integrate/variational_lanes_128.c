#define VECTOR_ISA 1
#define VARIATIONAL_LANES_REVOLVE variational_lanes_128
#include "variational_lanes.inc"
