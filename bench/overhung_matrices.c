// Writes the matrices of overhung.h to a text file that C, Octave and NumPy read: rows of 22 numbers, by the public
// library alone.
//
//   bench_overhung_matrices FILE
//
// The Jacobian of the rotor without films and rub holds K, which falls with the square of the speed, and G, which does
// not depend on it; both are checked at a second speed. A spring at a station subtracts its stiffness times a column of
// P. Gravity and the unbalance (g, u, w) follow from the right-hand side at rest at the instants 0, pi/2 and pi.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "machines.h"
#include "overhung.h"

enum { N = OVERHUNG_DEGREES };

typedef struct jacobian {
    double place[N][N], velocity[N][N]; ///< derivatives of the accelerations, [column][row]
} jacobian;

static jacobian jacobian_of(double speed, const char *station, double stiffness) {
    whirl_rotor *rotor = overhung_free_rotor(speed, station, stiffness);
    const whirl_system *system = whirl_rotor_system(rotor);
    double x[2 * N] = {0}, column[2 * N], forcing[WHIRL_MAX_FORCING];
    jacobian j;
    if (system->dimension != OVERHUNG_DIMENSION)
        must((whirl_status){.code = WHIRL_NUMERICAL_FAILURE, .message = "not 22 coordinates"});
    system->forcing(system->model, 0.0, forcing);
    for (int i = 0; i < 2 * N; i++) {
        double unit[2 * N] = {0};
        unit[i] = 1.0;
        system->tangent(system->model, 0.0, forcing, x, NULL, 1, unit, column);
        for (int k = 0; k < N; k++) (i < N ? j.place[i] : j.velocity[i - N])[k] = column[N + k];
    }
    whirl_rotor_free(rotor);
    return j;
}

/// Checks that K falls with the square of the speed, and that G does not depend on it.
static void check_speed(const jacobian *j) {
    const double speed = 2.0 * OVERHUNG_SPEED;
    const jacobian other = jacobian_of(speed, NULL, 0.0);
    double apart = 0.0;
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            apart = fmax(apart, fabs(other.place[i][k] * 4.0 - j->place[i][k]));
            apart = fmax(apart, fabs(other.velocity[i][k] - j->velocity[i][k]));
        }
    if (!(apart < 1e-8))
        must((whirl_status){.code = WHIRL_NUMERICAL_FAILURE,
                            .message = "K or G does not depend on the speed as it should"});
}

static void write_row(FILE *to, const double *row, double scale) {
    for (int i = 0; i < N; i++) fprintf(to, "%.17g%c", scale * row[i], i + 1 < N ? ' ' : '\n');
}

/// Writes a matrix, a line for each of its rows.
static void write_matrix(FILE *to, const double from[N][N]) {
    double row[N];
    for (int k = 0; k < N; k++) {
        for (int i = 0; i < N; i++) row[i] = from[i][k];
        write_row(to, row, -1.0);
    }
}

/// Writes the columns of P, 1/kg, a line each.
static void write_ports(FILE *to, const jacobian *j) {
    static const char *const station[] = {"left", "right", "disc"};
    const double stiffness = 1e9;
    for (int p = 0; p < OVERHUNG_PORTS; p++) {
        const jacobian held = jacobian_of(OVERHUNG_SPEED, station[p / 2], stiffness);
        double column[N];
        for (int k = 0; k < N; k++) column[k] = j->place[p][k] - held.place[p][k];
        write_row(to, column, OVERHUNG_SPEED * OVERHUNG_SPEED / stiffness);
    }
}

/// Writes g, u and w.
static void write_forces(FILE *to) {
    whirl_rotor *rotor = overhung_free_rotor(OVERHUNG_SPEED, NULL, 0.0);
    const whirl_system *system = whirl_rotor_system(rotor);
    double slope[3][2 * N], x[2 * N] = {0}, forcing[WHIRL_MAX_FORCING], g[N], u[N], w[N];
    for (int i = 0; i < 3; i++) {
        system->forcing(system->model, i * acos(0.0), forcing);
        system->rhs(system->model, i * acos(0.0), forcing, x, slope[i]);
    }
    for (int k = 0; k < N; k++) {
        g[k] = -0.5 * (slope[0][N + k] + slope[2][N + k]);
        u[k] = 0.5 * (slope[0][N + k] - slope[2][N + k]);
        w[k] = slope[1][N + k] + g[k];
    }
    write_row(to, g, 1.0);
    write_row(to, u, 1.0);
    write_row(to, w, 1.0);
    whirl_rotor_free(rotor);
}

int main(int argc, char **argv) {
    FILE *to = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!to) {
        fprintf(stderr, "bench: expected a file to write\n");
        return 1;
    }
    const jacobian j = jacobian_of(OVERHUNG_SPEED, NULL, 0.0);
    check_speed(&j);
    write_matrix(to, j.place);
    write_matrix(to, j.velocity);
    write_ports(to, &j);
    write_forces(to);
    return fclose(to) != 0;
}
