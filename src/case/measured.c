// Measured numbers outside of a fit.
#include "whirl/internal/measured.h"

#include <stdlib.h>
#include <string.h>

#include "arena.h"
#include "content.h"
#include "fit_table.h"

/// A table and the memory of its lists.
typedef struct measured_lists {
    whirl_measured_table measured; ///< first member: the caller's
    memory_arena arena;
    fit_parts parts; ///< without unknowns and files
    fit_maker maker;
    whirl_problems problems;
} measured_lists;

whirl_status whirl_measured_read(const whirl_case *object, const char *name, const void *bytes, size_t size,
                                 const csv_chosen *chosen, size_t count, whirl_measured_table **out) {
    measured_lists *own = calloc(1, sizeof *own);
    *out = NULL;
    if (!own) return whirl_fail(WHIRL_NO_MEMORY, "no memory for measured numbers");
    case_reader reader = {.arena = &own->arena, .problems = &own->problems, .parameters = &object->content.parameters};
    own->parts.machine = &object->content.machine;
    own->maker = (fit_maker){.reader = &reader, .parts = &own->parts, .noise = 1.0};
    whirl_status status = fit_bytes_read(&own->maker, name, bytes, size, chosen, count);
    // Keep the lists, which are in the arena, and the title, which is in the table.
    own->measured.fit = own->maker.fit;
    own->measured.fit.motions = own->maker.motions;
    own->measured.fit.numbers = own->maker.numbers;
    own->measured.title = arena_text(&own->arena, own->maker.table.title, strlen(own->maker.table.title));
    if (status.code == WHIRL_OK && !own->measured.title)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for measured numbers");
    csv_free(&own->maker.table);
    if (status.code == WHIRL_OK)
        *out = &own->measured;
    else
        whirl_measured_free(&own->measured);
    return status;
}

void whirl_measured_free(whirl_measured_table *measured) {
    measured_lists *own = (measured_lists *)measured;
    if (!own) return;
    arena_free(&own->arena);
    free(own);
}
