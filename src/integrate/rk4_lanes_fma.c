#define VECTOR_ISA 2
#define RK4_LANES_REVOLVE rk4_lanes_fma
#include "rk4_lanes.inc"
