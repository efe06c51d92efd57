#define VECTOR_ISA 1
#define RK4_LANES_REVOLVE rk4_lanes_128
#include "rk4_lanes.inc"
