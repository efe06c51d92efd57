#define VECTOR_ISA 4
#define DOP853_LANES_REVOLVE dop853_lanes_avx512
#include "dop853_lanes.inc"
