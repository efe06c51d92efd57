// Lists of the arrays of measured files (listed.h).
#include "listed.h"

#include <stdlib.h>
#include <string.h>

void listed_free(listed_table *table) {
    for (size_t i = 0; i < table->count; i++) free(table->arrays[i].name);
    free(table->arrays);
    free(table->records);
    mat_stream_close(table->stream);
    *table = (listed_table){.kind = LISTED_NONE};
}

listed_array *listed_add(foreign_file *file, listed_table *table, const char *name) {
    if (table->count == LISTED_MAX_NAMES) {
        foreign_fail(file, "has more than %d arrays", LISTED_MAX_NAMES);
        return NULL;
    }
    if (table->count == table->capacity) {
        const size_t capacity = table->capacity ? 2 * table->capacity : 16;
        listed_array *arrays = realloc(table->arrays, capacity * sizeof *arrays);
        if (!arrays) {
            foreign_no_memory(file);
            return NULL;
        }
        table->arrays = arrays;
        table->capacity = capacity;
    }
    listed_array *own = &table->arrays[table->count];
    *own = (listed_array){.name = strdup(name), .item = {.factor = 1.0}};
    if (!own->name) {
        foreign_no_memory(file);
        return NULL;
    }
    table->count++;
    return own;
}
