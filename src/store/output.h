// A file that appears whole or not at all: written under a temporary name beside its own, synced, then renamed.
#ifndef STORE_OUTPUT_H
#define STORE_OUTPUT_H

#include "whirl/status.h"

#include <stdio.h>

enum { OUTPUT_PATH_SIZE = 4096 };

typedef struct output {
    FILE *stream; // to write to; NULL when not open
    char path[OUTPUT_PATH_SIZE], temporary[OUTPUT_PATH_SIZE];
} output;

// Opens the temporary file. WHIRL_IO_ERROR with path and reason: a folder of that name, no such parent folder, ...
whirl_status output_open(output *out, const char *path);

// Gives the file its name when everything was written, removes it when not. Closes it in any case.
whirl_status output_commit(output *out);

// Removes what was written.
void output_discard(output *out);

// Makes a folder, and those above it that are missing. Well when it is there.
whirl_status output_folder(const char *path);

#endif
