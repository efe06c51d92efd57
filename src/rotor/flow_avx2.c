#define VECTOR_ISA 3
#define MACHINE_FLOW machine_flow_avx2
#define MACHINE_SWITCHES machine_switches_avx2
#define MACHINE_FORCING machine_forcing_avx2
#define MACHINE_CONTACTS machine_contacts_avx2
#include "flow.inc"
