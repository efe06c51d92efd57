#include <stdio.h>
#include <stdlib.h>

#include "text_written.h"
#include "whirl/status.h"

whirl_status text_written(write_function *write, const void *of, const char *purpose, char **text) {
    size_t size;
    FILE *stream = open_memstream(text, &size);
    whirl_status status = stream ? write(of, stream) : whirl_fail(WHIRL_NO_MEMORY, "no memory %s", purpose);
    if (stream && fclose(stream) != 0 && status.code == WHIRL_OK)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory %s", purpose);
    if (status.code == WHIRL_OK) return status;
    if (stream) free(*text);
    *text = NULL;
    return status;
}
