#define VECTOR_ISA 3
#define RK4_LANES_REVOLVE rk4_lanes_avx2
#include "rk4_lanes.inc"
