#define VECTOR_ISA 3
#define FOLLOWER_LANES_REVOLVE follower_lanes_avx2
#include "follower_lanes.inc"
