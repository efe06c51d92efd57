// Reads signals of a data set, a few records at a time: all of them may be larger than the memory.
#include "items.h"
#include "stored.h"
#include "whirl/engine/analyze.h"
#include "whirl/handles.h"

/// A range of records of a file, and where their signals go.
typedef struct some_signals {
    size_t sizes[3], first, count;
    float *out; ///< NULL: only the sizes are read
} some_signals;

static void read_signals(whirl_status *status, void *context, hid_t root) {
    some_signals *own = context;
    const hid_t group = get_group(status, root, "records");
    const hid_t dataset = get_dataset(status, group, WHIRL_FIELD_DATASET_SIGNALS);
    // Sizes of the dataset.
    stored_array outline;
    stored_outline(status, dataset, &outline);
    if (status->code == WHIRL_OK && (outline.rank != 3 || !outline.single))
        *status = whirl_fail(WHIRL_BAD_INPUT, "its signals are not an array [record][channel][sample]");
    for (size_t i = 0; i < 3 && status->code == WHIRL_OK; i++) own->sizes[i] = outline.sizes[i];
    if (status->code == WHIRL_OK && (own->first > own->sizes[0] || own->count > own->sizes[0] - own->first))
        *status = whirl_fail(WHIRL_BAD_INPUT, "it has %zu records, expected rows %zu to %zu among them", own->sizes[0],
                             own->first, own->first + own->count);
    // Signals of the records.
    if (status->code == WHIRL_OK && own->out && own->count > 0) {
        const hsize_t first[] = {own->first, 0, 0}, count[] = {own->count, own->sizes[1], own->sizes[2]};
        const hid_t space = H5Dget_space(dataset), memory = H5Screate_simple(3, count, NULL);
        if (H5Sselect_hyperslab(space, H5S_SELECT_SET, first, NULL, count, NULL) < 0 ||
            H5Dread(dataset, H5T_NATIVE_FLOAT, memory, space, H5P_DEFAULT, own->out) < 0)
            *status = whirl_fail(WHIRL_BAD_INPUT, "its signals cannot be read: the file is damaged");
        H5Sclose(memory);
        H5Sclose(space);
    }
    close_dataset(dataset);
    close_group(group);
}

whirl_status whirl_signals_shape(const char *path, size_t sizes[3]) {
    some_signals own = {.out = NULL};
    const whirl_status status = stored_open(path, read_signals, &own);
    for (size_t i = 0; i < 3; i++) sizes[i] = status.code == WHIRL_OK ? own.sizes[i] : 0;
    return status;
}

whirl_status whirl_signals_read(const char *path, size_t first, size_t count, float *out) {
    some_signals own = {.first = first, .count = count, .out = out};
    return stored_open(path, read_signals, &own);
}
