#define VECTOR_ISA 0
#define MACHINE_FLOW machine_flow_scalar
#define MACHINE_SWITCHES machine_switches_scalar
#define MACHINE_FORCING machine_forcing_scalar
#define MACHINE_CONTACTS machine_contacts_scalar
#include "flow.inc"
