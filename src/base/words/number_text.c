#include "number_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void number_text(double value, char text[NUMBER_SIZE]) {
    // A decimal of 15 digits survives the way to a double and back, and 17 distinguish all doubles (IEEE 754, 5.12.2).
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, NUMBER_SIZE, "%.*g", digits, value);
        if (digits == 17 || strtod(text, NULL) == value) break;
    }
    for (char *c = text; *c; c++)
        if (!strchr("+-.0123456789e", *c)) *c = '.'; // a locale's comma
}
