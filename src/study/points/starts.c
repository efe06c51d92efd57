// Several starts of every point: how they are spread, and their fields in the blocks.
#include "starts.h"
#include "added_field.h"
#include "whirl/engine/study.h"

double whirl_halton(size_t index, size_t coordinate) {
    static const unsigned char primes[WHIRL_MAX_RANGES] = {2,  3,  5,  7,   11,  13,  17,  19,  23,  29, 31,
                                                           37, 41, 43, 47,  53,  59,  61,  67,  71,  73, 79,
                                                           83, 89, 97, 101, 103, 107, 109, 113, 127, 131};
    const size_t base = primes[coordinate % WHIRL_MAX_RANGES];
    double mirrored = 0.0, place = 1.0;
    for (; index > 0; index /= base) {
        place /= (double)base;
        mirrored += place * (double)(index % base);
    }
    return mirrored;
}

whirl_status starts_add_fields(const whirl_batch *batch, size_t stations, whirl_layout *layout) {
    if (batch->starts <= 1) return whirl_ok();
    if (layout->field_count + 3 > WHIRL_MAX_FIELDS)
        return whirl_fail(WHIRL_BAD_INPUT, "the chosen analyses have more than %d fields", WHIRL_MAX_FIELDS - 3);
    study_add_field(layout, WHIRL_FIELD_STARTS_NUMBER, "1", "number of the start, from 1");
    study_add_field(layout, WHIRL_FIELD_STARTS_STATE, "length",
                    "x, y, vx, vy (where the motion began, from the centre)");
    whirl_field *field = &layout->fields[layout->field_count - 1];
    field->extent = WHIRL_PER_STATION;
    field->repeat = stations;
    field->columns = 4;
    layout->size += 4 * stations - 1;
    if (batch->neighbours > 0)
        study_add_field(layout, WHIRL_FIELD_STARTS_NEIGHBOUR, "1",
                        "place, from 1, of the neighbour at the end of whose motion this one began; 0: none");
    return whirl_ok();
}

void starts_note(const whirl_batch *batch, const beginning *start, const whirl_system *system,
                 const whirl_layout *layout, double *block) {
    const whirl_field *number = whirl_layout_field(layout, WHIRL_FIELD_STARTS_NUMBER);
    const whirl_field *state = whirl_layout_field(layout, WHIRL_FIELD_STARTS_STATE);
    const whirl_field *neighbour = whirl_layout_field(layout, WHIRL_FIELD_STARTS_NEIGHBOUR);
    if (batch->starts <= 1 || !number || !state) return;
    block[number->offset] = (double)(start->slot / batch->count + 1);
    for (size_t s = 0; s < state->repeat; s++) {
        const whirl_probe *probe = &system->probes[s];
        for (size_t c = 0; c < 4; c++) block[state->offset + 4 * s + c] = whirl_probe_value(probe, start->state, c);
    }
    if (neighbour)
        block[neighbour->offset] = start->origin == start->slot ? 0.0 : (double)(start->origin % batch->count + 1);
}
