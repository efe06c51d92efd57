#define VECTOR_ISA 2
#define DOP853_LANES_REVOLVE dop853_lanes_fma
#include "dop853_lanes.inc"
