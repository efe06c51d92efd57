#define VECTOR_ISA 1
#define FOLLOWER_LANES_REVOLVE follower_lanes_128
#include "follower_lanes.inc"
