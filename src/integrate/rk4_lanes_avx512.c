#define VECTOR_ISA 4
#define RK4_LANES_REVOLVE rk4_lanes_avx512
#include "rk4_lanes.inc"
