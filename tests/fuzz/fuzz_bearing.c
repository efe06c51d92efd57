// Any bytes as a bearing's file: refused with a problem, or a bearing that is computed, or told not to be.
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "whirl/engine/bearing_table.h"
#include "whirl/engine/case.h"
#include "whirl/engine/figure.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

static void write_all(const whirl_bearing_table *table) {
    static FILE *nowhere;
    whirl_figure *figure;
    if (!nowhere) nowhere = fopen("/dev/null", "w");
    if (!nowhere) return;
    whirl_bearing_write_summary(table, nowhere);
    whirl_bearing_write_json(table, nowhere);
    whirl_bearing_write_csv(table, nowhere);
    const whirl_status element = whirl_bearing_write_element(table, "journal", true, nowhere);
    require(element.code == WHIRL_OK || element.message[0] != '\0');
    for (int k = 0; k < 3; k++) {
        if (whirl_bearing_figure(table, (const char *const[]){"curves", "sommerfeld", "locus"}[k], &figure).code ==
            WHIRL_OK)
            whirl_figure_write_json(figure, nowhere);
        whirl_figure_free(figure);
    }
}

/// One point on a coarse mesh: a fine one takes longer than inputs may.
static void check(whirl_bearing *bearing) {
    whirl_bearing_table *table;
    const whirl_bearing_options options = {.threads = 1};
    require(bearing->count >= 1 && bearing->pads.count >= 1 && bearing->pads.count <= WHIRL_MAX_PADS);
    require(bearing->ratio_count >= 1 && bearing->ratio_count <= WHIRL_MAX_WHIRL_RATIOS);
    require(bearing->viscosity > 0.0 && bearing->pad_clearance > 0.0 && bearing->radius > 0.0);
    bearing->count = 1;
    bearing->pads.fineness = 32;
    bearing->pads.halved = true;
    require(whirl_bearing_solve(bearing, &options, &table).code == WHIRL_OK);
    require(table->points[0].found || table->points[0].failure[0] != '\0');
    write_all(table);
    whirl_bearing_table_free(table);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 14) return 0;
    whirl_problems problems = {0};
    whirl_bearing *bearing = NULL;
    const whirl_status status = whirl_bearing_parse((const char *)data, size, "fuzz.yaml", &problems, &bearing);
    require((status.code == WHIRL_OK) == (bearing != NULL));
    require((status.code == WHIRL_OK) == (problems.count == 0));
    if (bearing) check(bearing);
    whirl_problems_free(&problems);
    whirl_bearing_free(bearing);
    return 0;
}
