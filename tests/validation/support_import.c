#include "support_import.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "whirl/engine/rotor.h"

char *replace_all(char *text, const char *from, const char *to) {
    size_t count = 0;
    for (const char *c = text; (c = strstr(c, from)); c += strlen(from)) count++;
    assert_true(count > 0);
    char *const made = calloc(strlen(text) + count * strlen(to) + 1, 1);
    const char *rest = text;
    for (const char *c; (c = strstr(rest, from)); rest = c + strlen(from)) {
        strncat(made, rest, (size_t)(c - rest));
        strcat(made, to);
    }
    strcat(made, rest);
    free(text);
    return made;
}

char *whole_case(whirl_imported *imported) {
    // The lines of shafts stand before those of stations, and have all options in one.
    const char *const stations = strstr(imported->text, "\n  stations:");
    assert_non_null(stations);
    char *const shafts =
        replace_all(strndup(imported->text, (size_t)(stations - imported->text)), "shear: ", "reduce: no, shear: ");
    char *const made = malloc(strlen(shafts) + strlen(stations) + 1);
    strcat(strcpy(made, shafts), stations);
    free(shafts);
    whirl_imported_free(imported);
    return made;
}

whirl_case *parse_case(const char *text) {
    whirl_problems problems = {0};
    whirl_case *object;
    require_ok(whirl_case_parse(text, strlen(text), "imported", &problems, &object));
    whirl_problems_free(&problems);
    return object;
}

whirl_modes *modes_at(const whirl_case *object, double speed, double *clock) {
    whirl_rotor *rotor;
    whirl_modes *modes;
    require_ok(whirl_case_rotor(object, "speed", speed, &rotor));
    const whirl_system *const system = whirl_rotor_system(rotor);
    double *const start = calloc(system->dimension, sizeof *start);
    require_ok(whirl_modes_new(system, start, &modes));
    *clock = whirl_rotor_clock(rotor);
    free(start);
    whirl_rotor_free(rotor);
    return modes;
}
