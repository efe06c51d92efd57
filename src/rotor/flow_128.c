#define VECTOR_ISA 1
#define MACHINE_FLOW machine_flow_128
#define MACHINE_SWITCHES machine_switches_128
#define MACHINE_FORCING machine_forcing_128
#define MACHINE_CONTACTS machine_contacts_128
#include "flow.inc"
