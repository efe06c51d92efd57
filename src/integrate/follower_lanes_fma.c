#define VECTOR_ISA 2
#define FOLLOWER_LANES_REVOLVE follower_lanes_fma
#include "follower_lanes.inc"
