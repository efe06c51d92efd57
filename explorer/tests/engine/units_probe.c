// Reads quantities, one a line ("TEXT|EXPECTED UNIT"), by src/case/values/quantity.c, and prints the value and unit or
// the error of each. units.sh builds this program twice, with UDUNITS-2 and with explorer/core/units.c.
#include <stdio.h>
#include <string.h>

#include "quantity.h"
#include "tree.h"

int main(void) {
    char line[512], why[WHY_SIZE];
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = '\0';
        char *expected = strrchr(line, '|');
        if (!expected) continue;
        *expected++ = '\0';
        quantity read;
        why[0] = '\0';
        if (quantity_read(line, expected, &read, why))
            printf("%s|%s: %a %s\n", line, expected, read.value, read.unit);
        else
            printf("%s|%s: %s\n", line, expected, why);
    }
    return 0;
}
