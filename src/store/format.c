#include "format.h"

#include <stdio.h>
#include <string.h>

const char *const format_extents[3] = {
    [WHIRL_PER_POINT] = "point", [WHIRL_PER_STATION] = "station", [WHIRL_PER_CONTACT] = "contact"};

bool format_reserved(const char *name) {
    static const char *const reserved[] = {"case", "parameters", "stations", "contacts", "provenance"};
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; ++i)
        if (strcmp(name, reserved[i]) == 0) return true;
    return false;
}

bool format_is_name(const char *name, int slashes) {
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    for (;; --slashes) {
        const size_t length = strspn(name, letters);
        if (length == 0) return false;
        name += length;
        if (*name == '\0') return slashes == 0;
        if (*name != '/') return false;
        ++name;
    }
}

int format_dimensions(const whirl_field *field, shape points, size_t dimensions[SHAPE_MAX_RANK]) {
    int rank = 0;
    for (int i = 0; i < points.rank; ++i) dimensions[rank++] = points.sizes[i];
    if (field->extent != WHIRL_PER_POINT) dimensions[rank++] = field->repeat;
    if (field->rows != 1) dimensions[rank++] = field->rows;
    if (field->columns != 1) dimensions[rank++] = field->columns;
    return rank;
}

int format_dimension_names(const whirl_field *field, shape points, char names[SHAPE_MAX_RANK][WHIRL_NAME_SIZE]) {
    static const char *const axes[SHAPE_AXES] = {"z", "y", "x"};
    const char *found[SHAPE_MAX_RANK] = {"point"};
    int rank = points.rank;
    for (int i = 0; rank > 1 && i < rank; ++i) found[i] = axes[SHAPE_AXES - rank + i];
    if (field->extent != WHIRL_PER_POINT) found[rank++] = format_extents[field->extent];
    if (field->rows != 1) found[rank++] = "row";
    if (field->columns != 1) found[rank++] = "column";
    for (int i = 0; i < rank; ++i) snprintf(names[i], WHIRL_NAME_SIZE, "%s", found[i]);
    return rank;
}
