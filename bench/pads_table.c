// Writes the table of a pad of pads.h (src/rotor/pads/pad_tables.h) to a binary file: its coefficients as doubles.
//
//   bench_pads_table FILE
#include <stdio.h>

#include "machines.h"
#include "pad_table.h"
#include "pad_tables.h"
#include "pads.h"

int main(int argc, char **argv) {
    const pad_table_key key = {.arc = PADS_ARC, .ratio = PADS_LENGTH / (2.0 * PADS_RADIUS), .law = CAVITATION_REYNOLDS};
    double number;
    must(pad_table_number(&key, &number));
    const pad_table *table = pad_table_of(number);
    FILE *to = argc > 1 ? fopen(argv[1], "wb") : NULL;
    if (to && fwrite(table->coefficients, sizeof table->coefficients, 1, to) == 1 && fclose(to) == 0) return 0;
    must((whirl_status){.code = WHIRL_IO_ERROR, .message = "the table is not written"});
    return 1;
}
