#define VECTOR_ISA 2
#define MACHINE_FLOW machine_flow_fma
#define MACHINE_SWITCHES machine_switches_fma
#define MACHINE_FORCING machine_forcing_fma
#define MACHINE_CONTACTS machine_contacts_fma
#include "flow.inc"
