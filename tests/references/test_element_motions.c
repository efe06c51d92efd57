// Verdicts on machines with one element each, compared with the motions of an independent program.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"
#include "support_known.h"
#include "whirl/engine.h"

/// A line of the table: machine, parameter, where its first station starts, motion ("?": not clear to the program).
typedef struct row {
    char machine[32], motion[32];
    double parameter, start[2], exponent;
} row;

/// Motions that come to rest more slowly, and tori, need more revolutions than are watched, and undetermined is right.
static const double slow = -0.03; // per revolution

enum { MAX_ROWS = 256 };
static row rows[MAX_ROWS];
static size_t row_count;

static bool read_row(const char *line, row *to) {
    return line[0] != '#' && sscanf(line, "%31s %lf %lf %lf %31s %lf", to->machine, &to->parameter, &to->start[0],
                                    &to->start[1], to->motion, &to->exponent) == 6;
}

static void read_rows(void) {
    char line[256];
    FILE *table = fopen(REFERENCES "/element_motions.txt", "r");
    while (table && fgets(line, sizeof line, table)) {
        row *next = &rows[row_count];
        row_count += row_count < MAX_ROWS && read_row(line, next) && strcmp(next->motion, "?") != 0;
    }
    if (table) fclose(table);
}

static bool make_motion(size_t index, known_motion *m) {
    char path[512];
    whirl_case *machine;
    if (index >= row_count) return false;
    const row *of = &rows[index];
    snprintf(path, sizeof path, "%s/motions/%s.yaml", REFERENCES, of->machine);
    require_ok(whirl_case_load(path, NULL, &machine));
    require_ok(whirl_case_rotor(machine, "p", of->parameter, &m->rotor));
    whirl_case_free(machine);
    memcpy(m->start, of->start, sizeof of->start);
    snprintf(m->expected, sizeof m->expected, "%s", of->motion);
    m->trap = of->exponent > slow && strcmp(of->motion, "chaotic") != 0;
    snprintf(m->label, sizeof m->label, "%s, p = %g", of->machine, of->parameter);
    return true;
}

/// The program gives the numbers of the table for a few motions.
static void table_is_the_programs(void **state) {
    char line[256];
    size_t found = 0;
    row now;
    (void)state;
    FILE *program = popen(REFERENCE " crack 4", "r"); // NOLINT(cert-env33-c): a test's own command
    assert_non_null(program);
    while (fgets(line, sizeof line, program)) {
        if (!read_row(line, &now)) continue;
        for (size_t i = 0; i < row_count; i++) {
            if (strcmp(rows[i].machine, now.machine) != 0 || rows[i].parameter != now.parameter) continue;
            assert_string_equal(rows[i].motion, now.motion);
            found++;
        }
    }
    assert_int_equal(pclose(program), 0);
    assert_int_equal(found, 4);
}

static const known_family families[] = {
    {"machines of one element each", "element_motions.c", 0, make_motion},
};

int main(void) {
    const struct CMUnitTest more[] = {cmocka_unit_test(table_is_the_programs)};
    read_rows();
    return run_families("elements", families, 1, 12, more, 1, 155);
}
