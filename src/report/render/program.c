#include "program.h"

#include <stdlib.h>
#include <string.h>

char *program_found(const char *program) {
    return strchr(program, '/') ? realpath(program, NULL) : strdup(program);
}
