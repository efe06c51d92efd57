#include "support_brute.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_check.h"

double brute_mirrored(int number, int base) {
    int value = 0, size = 1;
    for (; number > 0; number /= base, size *= base) value = value * base + number % base;
    return (double)value / size;
}

static void rk4_step(const brute *b, int step, double *x) {
    const double h = 2.0 * pi / b->steps;
    double k[4][MAX_STATE], at[MAX_STATE];
    for (int stage = 0; stage < 4; stage++) {
        const double part = stage == 0 ? 0.0 : stage == 3 ? 1.0 : 0.5, t = h * (step + part);
        for (int i = 0; i < b->dimension; i++) at[i] = x[i] + (stage ? part * h * k[stage - 1][i] : 0.0);
        b->rate(b->parameter, cos(t), sin(t), at, k[stage]);
    }
    for (int i = 0; i < b->dimension; i++) x[i] += h / 6.0 * (k[0][i] + 2.0 * (k[1][i] + k[2][i]) + k[3][i]);
}

/// The least number of revolutions after which the section returns.
static int period_of(const outcome *o, double tolerance) {
    for (int n = 0; n < SEEN; n++) assert_true(isfinite(o->section[n][0]) && isfinite(o->section[n][1]));
    for (int k = 1; k <= LONGEST; k++) {
        double away = 0.0;
        for (int n = 0; n + k < SEEN; n++)
            for (int c = 0; c < 2; c++) away = fmax(away, fabs(o->section[n + k][c] - o->section[n][c]));
        if (away < tolerance) return k;
    }
    return 0;
}

outcome brute_follow(const brute *b, double *x, double tolerance) {
    outcome o = {.mean = 0.0};
    for (int n = 0; n < b->transient + SEEN; n++) {
        for (int step = 0; step < b->steps; step++) {
            rk4_step(b, step, x);
            if (n >= b->transient) o.mean += x[0] / (b->steps * SEEN);
        }
        if (n < b->transient) continue;
        o.section[n - b->transient][0] = x[0];
        o.section[n - b->transient][1] = x[1];
    }
    o.period = period_of(&o, tolerance);
    return o;
}

// ---------------------------------------------------------------- the paper's rotor

/// Computes capone's force of the short bearing on a journal at (x, y), without its coefficient.
static void film(double x, double y, double vx, double vy, double *fx, double *fy) {
    const double a = x - 2.0 * vy, b = y + 2.0 * vx, q = 1.0 - x * x - y * y, c = sqrt(a * a + b * b);
    const double p = x * b - y * a, u = x * a + y * b;
    *fx = *fy = 0.0;
    if (c == 0.0) return; // at rest in the middle, where the motions begin
    const double g = (pi + 2.0 * atan(p / (c * sqrt(q)))) / sqrt(q), v = (2.0 + p * g / c) / q;
    const double s = u * c / (c * c - u * u);
    *fx = (3.0 * x * v * c + g * b - 2.0 * s * a) / q;
    *fy = (3.0 * y * v * c - g * a - 2.0 * s * b) / q;
}

void brute_paper_rotor(double r_k, double cosine, double sine, const double *x, double *dx) {
    const double w = 0.2, disc = 420.0, journal = 50.0, omega = 650.0, gravity = 10.584 / (omega * omega * 2e-4);
    const double cos2 = cosine * cosine - sine * sine, sin2 = 2.0 * sine * cosine;
    const double along = r_k + 1.0 + (r_k - 1.0) * cos2, across = (r_k - 1.0) * sin2;
    const double dx1 = x[0] - x[2], dy1 = x[1] - x[3], *v = x + 4;
    const double spring[2] = {along * dx1 + across * dy1, along * dy1 + across * dx1};
    const double radius = hypot(x[0], x[1]);
    const double push = radius > 1.2 ? 10.0 * journal / (w * w * disc) * (1.0 - 1.2 / radius) : 0.0;
    double pull[2];
    film(x[2], x[3], v[2], v[3], &pull[0], &pull[1]);
    memcpy(dx, v, 4 * sizeof *dx);
    for (int i = 0; i < 2; i++) {
        const double weight = i == 1 ? gravity : 0.0;
        dx[4 + i] = -4300.0 / (disc * omega) * v[i] - journal / (2.0 * disc * w * w) * spring[i] +
                    0.08 * (i ? sine : cosine) - weight - push * (x[i] + (i ? 0.1 : -0.1) * x[1 - i]);
        dx[6 + i] =
            -9300.0 / (2.0 * journal * omega) * v[2 + i] + spring[i] / (4.0 * w * w) - 0.0042 * pull[i] - weight;
    }
}

whirl_case *brute_paper_case(const char *study) {
    FILE *stream = fopen(WHIRL_CASES "/paper.yaml", "r");
    char *text = calloc(1, 1 << 16), line[512];
    whirl_case *object;
    assert_true(stream && text);
    while (fgets(line, sizeof line, stream) && strncmp(line, "study:", 6) != 0) strcat(text, line);
    strcat(text, study);
    (void)fclose(stream);
    require_ok(whirl_case_parse(text, strlen(text), "paper.yaml", NULL, &object));
    free(text);
    return object;
}
