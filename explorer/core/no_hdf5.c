// Stands in for the readers of HDF5, MAT and universal files: the explorer reads tables that are dropped onto its page,
// and no files.
#include "whirl/internal/arrays.h"

#include <math.h>

static whirl_status no_hdf5(void) {
    return whirl_fail(WHIRL_BAD_INPUT,
                      "HDF5, MAT and universal files need the library, which the explorer does not have");
}

bool arrays_is_file(const char *path) {
    (void)path;
    return false;
}

whirl_status arrays_open(const char *path, arrays_file **out) {
    (void)path;
    *out = NULL;
    return no_hdf5();
}

void arrays_close(arrays_file *file) {
    (void)file;
}

whirl_status arrays_find(arrays_file *file, const char *name, arrays_item *out) {
    (void)file, (void)name;
    *out = (arrays_item){.factor = 1.0};
    return no_hdf5();
}

whirl_status arrays_visit(arrays_file *file, arrays_visitor visit, void *context) {
    (void)file, (void)visit, (void)context;
    return no_hdf5();
}

whirl_status arrays_read(arrays_file *file, const char *name, const size_t *first, const size_t *count, double *out) {
    (void)file, (void)name, (void)first, (void)count, (void)out;
    return no_hdf5();
}

whirl_status arrays_text(arrays_file *file, const char *object, const char *attribute, char *text, size_t size) {
    (void)file, (void)object, (void)attribute, (void)size;
    *text = '\0';
    return no_hdf5();
}

whirl_status arrays_number(arrays_file *file, const char *object, const char *attribute, double *out) {
    (void)file, (void)object, (void)attribute;
    *out = NAN;
    return no_hdf5();
}
