// Columns of measured files as handles (whirl/handles.h).
#include <stdlib.h>
#include <string.h>

#include "whirl/handles.h"
#include "whirl/internal/csv.h"

struct whirl_columns {
    csv_table table;
    char path[]; ///< that the table borrows
};

enum { COLUMNS_MAX = 4096 };

whirl_status whirl_columns_read(const char *path, const char *const *headings, const char *const *names, size_t count,
                                whirl_columns **columns) {
    *columns = NULL;
    if (count > COLUMNS_MAX)
        return whirl_fail(WHIRL_BAD_INPUT, "%zu columns are chosen, expected at most %d", count, COLUMNS_MAX);
    whirl_columns *own = calloc(1, sizeof *own + strlen(path) + 1);
    csv_chosen *chosen = calloc(count + 1, sizeof *chosen);
    whirl_status status = own && chosen ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for columns");
    if (status.code == WHIRL_OK) {
        strcpy(own->path, path);
        for (size_t i = 0; i < count; i++) chosen[i] = (csv_chosen){headings[i], names[i]};
        status = csv_load_chosen(own->path, chosen, count, COLUMNS_MAX, &own->table);
    }
    if (status.code == WHIRL_OK && own->table.count == 0)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: there is no row of numbers, expected a line of headings and some",
                            path);
    free(chosen);
    if (status.code == WHIRL_OK)
        *columns = own;
    else
        whirl_columns_free(own);
    return status;
}

size_t whirl_columns_count(const whirl_columns *columns) {
    return columns->table.column_count;
}

size_t whirl_columns_rows(const whirl_columns *columns) {
    return columns->table.count;
}

const char *whirl_columns_name(const whirl_columns *columns, size_t index) {
    return index < columns->table.column_count ? columns->table.columns[index].name : NULL;
}

const char *whirl_columns_unit(const whirl_columns *columns, size_t index) {
    return index < columns->table.column_count ? columns->table.columns[index].unit : NULL;
}

const double *whirl_columns_numbers(const whirl_columns *columns, size_t index) {
    return index < columns->table.column_count ? csv_numbers(&columns->table, index) : NULL;
}

void whirl_columns_free(whirl_columns *columns) {
    if (columns) csv_free(&columns->table);
    free(columns);
}
