// Tables of numbers from files of either kind.
#include <stdlib.h>

#include "input.h"
#include "whirl/internal/arrays.h"
#include "whirl/internal/csv.h"

enum { CSV_MAX_BYTES = 1 << 30 };

whirl_status csv_load(const char *path, size_t most_columns, csv_table *out) {
    char *text = NULL;
    size_t length = 0;
    input_file in;
    *out = (csv_table){.path = path};
    if (arrays_is_file(path)) return csv_load_vectors(path, NULL, 0, most_columns, out);
    if (!input_read(path, CSV_MAX_BYTES, &in, &text, &length))
        return whirl_fail(in.no_memory ? WHIRL_NO_MEMORY : WHIRL_BAD_INPUT, "cannot read %.200s: %.128s", path,
                          in.reason);
    const whirl_status status = in.size > length ? whirl_fail(WHIRL_BAD_INPUT, "%.200s: is larger than 1 GiB", path)
                                                 : csv_read(path, text, length, most_columns, out);
    free(text);
    return status;
}
