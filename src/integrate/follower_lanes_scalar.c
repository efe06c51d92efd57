#define VECTOR_ISA 0
#define FOLLOWER_LANES_REVOLVE follower_lanes_scalar
#include "follower_lanes.inc"
