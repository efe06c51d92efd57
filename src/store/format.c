#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "format.h"
#include "items.h"
#include "shape.h"
#include "whirl/handles.h"

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
    if (field->rows != 1 || field->singles > 0) dimensions[rank++] = field->rows;
    if (field->singles > 0)
        dimensions[rank++] = field->singles;
    else if (field->columns != 1)
        dimensions[rank++] = field->columns;
    return rank;
}

int format_dimension_names(const whirl_field *field, shape points, char names[SHAPE_MAX_RANK][WHIRL_NAME_SIZE]) {
    static const char *const axes[SHAPE_AXES] = {"z", "y", "x"};
    const char *found[SHAPE_MAX_RANK] = {"point"};
    int rank = points.rank;
    for (int i = 0; rank > 1 && i < rank; ++i) found[i] = axes[SHAPE_AXES - rank + i];
    if (field->extent != WHIRL_PER_POINT) found[rank++] = format_extents[field->extent];
    if (field->rows != 1 || field->singles > 0) found[rank++] = field->singles > 0 ? "channel" : "row";
    if (field->columns != 1 || field->singles > 0) found[rank++] = field->singles > 0 ? "sample" : "column";
    for (int i = 0; i < rank; ++i) snprintf(names[i], WHIRL_NAME_SIZE, "%s", found[i]);
    return rank;
}

// ---------------------------------------------------------------- column
// Layout of datasets that are written or read point by point (items.h).

void column_lay(column *of, shape points, const size_t *dimensions, int rank, size_t element) {
    *of = (column){.dataset = H5I_INVALID_HID, .type = H5I_INVALID_HID, .rank = rank, .axes = points.rank};
    of->size = element;
    for (int i = 0; i < rank; ++i) of->dimensions[i] = dimensions[i];
    for (int i = points.rank; i < rank; ++i) of->size *= dimensions[i];
}

/// Returns how many points a step along an axis passes.
static size_t step_of(const column *of, int axis) {
    size_t step = 1;
    while (++axis < of->axes) step *= (size_t)of->dimensions[axis];
    return step;
}

static bool has_points(const column *of) {
    size_t count = 1;
    for (int i = 0; i < of->axes; ++i) count *= (size_t)of->dimensions[i];
    return count > 0;
}

bool column_buffer(column *of, const hsize_t *chunk) {
    of->divided = of->axes - 1;
    while (of->divided > 0 && chunk[of->divided] == of->dimensions[of->divided]) --of->divided;
    of->most = (size_t)chunk[of->divided] * step_of(of, of->divided);
    if (of->most == 0) of->most = 1;
    of->buffer = malloc((has_points(of) ? of->most * of->size : 0) + 1);
    return of->buffer;
}

size_t column_next_count(const column *of) {
    const size_t all = (size_t)of->dimensions[of->divided] * step_of(of, of->divided);
    const size_t left = all > 0 ? all - of->done % all : 0;
    return left < of->most ? left : of->most;
}

void column_box(const column *of, size_t points, hsize_t *first, hsize_t *count) {
    for (int i = 0; i < of->rank; ++i) {
        const size_t step = step_of(of, i);
        first[i] = i < of->axes && of->dimensions[i] > 0 ? of->done / step % of->dimensions[i] : 0;
        count[i] = i < of->divided ? 1 : i == of->divided ? points / step : of->dimensions[i];
    }
}

/// Returns true if an ending equals `lower`, ignoring case.
static bool format_is_ending(const char *ending, const char *lower) {
    while (*lower && tolower((unsigned char)*ending) == *lower) ending++, lower++;
    return !*lower && !*ending;
}

bool whirl_result_name_fits(const char *path) {
    static const char *const others[] = {"c",    "csv", "dat", "gif", "gz",   "html", "jpeg", "jpg", "json", "m",
                                         "mat",  "md",  "npy", "npz", "pdf",  "png",  "ps",   "py",  "svg",  "tar",
                                         "toml", "tsv", "txt", "xls", "xlsx", "xml",  "yaml", "yml", "zip"};
    const char *const slash = strrchr(path, '/'), *const dot = strrchr(slash ? slash : path, '.');
    for (size_t i = 0; dot && i < sizeof others / sizeof *others; i++)
        if (format_is_ending(dot + 1, others[i])) return false;
    return true;
}
