#define VECTOR_ISA 3
#define DOP853_LANES_REVOLVE dop853_lanes_avx2
#include "dop853_lanes.inc"
