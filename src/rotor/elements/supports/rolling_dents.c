// The kernels of a rolling bearing with dents; the angles of its races and of a rolling element are states.
#include "rolling.h"

#define KERNEL_FILE "elements/supports/rolling_kernel.h"
#define ROLLING_DENTED
#define KERNEL_AXES 2
#define KERNEL_STATES DENTED_STATES
#define KERNEL_NUMBERS ROLLING_NUMBERS
#define KERNEL_SWITCHES 0

#include "generic.h"

const element_kernels ISA(rolling_dents_kernels) = GENERIC_KERNELS;

#if VECTOR_ISA == VECTOR_SCALAR
FOR_EVERY_ISA(const element_kernels, rolling_dents_kernels);
const element_kernels *const dented_kernels[VECTOR_ISAS] = EVERY_ISA(&, rolling_dents_kernels);
#endif
