#define VECTOR_ISA 0
#define DOP853_LANES_REVOLVE dop853_lanes_scalar
#include "dop853_lanes.inc"
