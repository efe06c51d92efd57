#include "whirl/status.h"

#include <stdarg.h>
#include <stdio.h>

whirl_status whirl_ok(void) {
    return (whirl_status){.code = WHIRL_OK};
}

whirl_status whirl_fail(whirl_code code, const char *format, ...) {
    whirl_status status = {.code = code};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(status.message, sizeof status.message, format, arguments);
    va_end(arguments);
    return status;
}

const char *whirl_code_text(whirl_code code) {
    static const char *const texts[] = {
        [WHIRL_OK] = "done",
        [WHIRL_BAD_INPUT] = "bad input",
        [WHIRL_NO_MEMORY] = "out of memory",
        [WHIRL_IO_ERROR] = "input or output failed",
        [WHIRL_NUMERICAL_FAILURE] = "numerical failure",
        [WHIRL_STOPPED] = "stopped",
        [WHIRL_MISSING_PROGRAM] = "a program is missing",
    };
    return (unsigned)code < sizeof texts / sizeof *texts ? texts[code] : "unknown";
}
