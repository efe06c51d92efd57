#include "support_peer.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include <cmocka.h>

static void read_point(const char *line, peer_point *point) {
    const size_t word = strcspn(line, "\t\n");
    char *rest;
    snprintf(point->kind, sizeof point->kind, "%.*s", (int)word, line);
    point->count = 0;
    for (const char *begin = line + word; *begin == '\t'; begin = rest) {
        assert_true(point->count < PEER_NUMBERS);
        point->numbers[point->count++] = strtod(begin, &rest);
        assert_true(rest > begin);
    }
}

bool run_peer(const char *command, peer_point *points, size_t most, size_t *count) {
    char line[4096];
    FILE *stream = popen(command, "r"); // NOLINT(cert-env33-c): a test's own command
    assert_non_null(stream);
    *count = 0;
    while (fgets(line, sizeof line, stream)) {
        if (line[0] == '#') continue;
        assert_true(*count < most);
        read_point(line, &points[(*count)++]);
    }
    const int status = pclose(stream);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 77) return false;
    assert_int_equal(status, 0);
    return true;
}

double multipliers_apart(size_t n, const double *parts, const double complex *others) {
    double largest = 0.0;
    for (size_t i = 0; i < n; i++) {
        double nearest = INFINITY;
        for (size_t j = 0; j < n; j++) nearest = fmin(nearest, cabs(parts[2 * i] + parts[2 * i + 1] * I - others[j]));
        largest = fmax(largest, nearest);
    }
    return largest;
}
