#include <stdlib.h>
#include <string.h>

#include "program.h"

char *program_found(const char *program) {
    return strchr(program, '/') ? realpath(program, NULL) : strdup(program);
}
