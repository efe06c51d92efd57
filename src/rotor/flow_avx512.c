#define VECTOR_ISA 4
#define MACHINE_FLOW machine_flow_avx512
#define MACHINE_SWITCHES machine_switches_avx512
#define MACHINE_FORCING machine_forcing_avx512
#define MACHINE_CONTACTS machine_contacts_avx512
#include "flow.inc"
