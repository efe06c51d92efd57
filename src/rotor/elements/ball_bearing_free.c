// A ball bearing whose balls do not pass a whole number of times in a revolution: the angle of its cage is a state.
#define KERNEL_FILE "elements/ball_bearing_kernel.h"
#define KERNEL_AXES 2
#define KERNEL_STATES 1
#define KERNEL_NUMBERS BALL_NUMBERS
#define KERNEL_SWITCHES 0

#include "ball_bearing.h"
#include "generic.h"

const element_kernels ISA(ball_bearing_free_kernels) = GENERIC_KERNELS;
