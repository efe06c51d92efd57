#include "overhung.h"

#include <stdio.h>
#include <stdlib.h>

overhung_matrices overhung_read(const char *path) {
    overhung_matrices read;
    double *number = (double *)&read;
    const size_t count = sizeof read / sizeof *number;
    size_t i = 0;
    FILE *from = path ? fopen(path, "r") : NULL;
    char word[32];
    while (from && i < count && fscanf(from, "%31s", word) == 1) number[i++] = strtod(word, NULL);
    if (from) fclose(from);
    if (i == count) return read;
    fprintf(stderr, "bench: %s does not hold the overhung rotor's matrices\n", path ? path : "no file");
    exit(1);
}
