#define VECTOR_ISA 4
#define FOLLOWER_LANES_REVOLVE follower_lanes_avx512
#include "follower_lanes.inc"
