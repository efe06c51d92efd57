#define VECTOR_ISA 0
#define RK4_LANES_REVOLVE rk4_lanes_scalar
#include "rk4_lanes.inc"
