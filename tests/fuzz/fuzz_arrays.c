// Any bytes as a measured file of another program (HDF5, MAT, universal): refused with a sentence, or read, up to a few
// thousand numbers of each dataset.
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "foreign.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int condition) {
    if (!condition) abort();
}

static whirl_status walk(void *context, const char *name, const arrays_item *item) {
    enum { MOST = 4096, EACH = 20 };
    static double numbers[MOST];
    size_t first[ARRAYS_MAX_RANK] = {0}, count[ARRAYS_MAX_RANK] = {0}, all = 1;
    arrays_item found;
    const whirl_status there = arrays_find(context, name, &found);
    require(there.code == WHIRL_OK || *there.message);
    require(strlen(found.unit) < ARRAYS_TEXT);
    require(item->rank >= 0 && item->rank <= ARRAYS_MAX_RANK && strlen(item->unit) < ARRAYS_TEXT);
    for (int i = 0; i < item->rank; i++) {
        count[i] = item->sizes[i] < EACH ? item->sizes[i] : EACH;
        all *= count[i];
    }
    if (all > MOST) return whirl_ok();
    const whirl_status status = arrays_read(context, name, first, count, numbers);
    require(status.code == WHIRL_OK || *status.message);
    return whirl_ok();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size > 1 << 16) return 0;
    unsigned char *bytes = malloc(size ? size : 1);
    arrays_file *file;
    double number;
    char text[64];
    require(bytes != NULL);
    memcpy(bytes, data, size);
    const whirl_status status = arrays_open_bytes(bytes, size, "fuzz.h5", &file);
    require((status.code == WHIRL_OK) == (file != NULL));
    require(status.code == WHIRL_OK || *status.message);
    if (file) {
        arrays_visit(file, walk, file);
        arrays_text(file, "a", "unit", text, sizeof text);
        arrays_number(file, "/", "number", &number);
    }
    arrays_close(file);
    free(bytes);
    return 0;
}
