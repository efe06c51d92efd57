#define VECTOR_ISA 1
#define DOP853_LANES_REVOLVE dop853_lanes_128
#include "dop853_lanes.inc"
