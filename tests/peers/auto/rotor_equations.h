/// The rotor of the 2015 paper without its stator, written from docs/theory.md for AUTO-07p: the equations of
/// rotor.yaml with derivatives, in their own words, so that what AUTO follows owes nothing to whirl.
#ifndef PEERS_ROTOR_EQUATIONS_H
#define PEERS_ROTOR_EQUATIONS_H

#include <math.h>

/// x1, y1, x2, y2, their derivatives by tau, then cos tau and sin tau as two states.
enum { ROTOR_STATES = 8, ROTOR_ALL = 10 };

/// A number with its derivatives by x, y, vx, vy.
typedef struct varied {
    double value, by[4];
} varied;

static inline varied varied_sum(double p, varied a, double q, varied b) {
    varied c = {p * a.value + q * b.value, {0.0}};
    for (int i = 0; i < 4; i++) c.by[i] = p * a.by[i] + q * b.by[i];
    return c;
}

static inline varied varied_product(varied a, varied b) {
    varied c = {a.value * b.value, {0.0}};
    for (int i = 0; i < 4; i++) c.by[i] = a.by[i] * b.value + a.value * b.by[i];
    return c;
}

/// Returns a function of a, from its value and slope.
static inline varied varied_function(varied a, double value, double slope) {
    varied c = {value, {0.0}};
    for (int i = 0; i < 4; i++) c.by[i] = slope * a.by[i];
    return c;
}

static inline varied varied_ratio(varied a, varied b) {
    return varied_product(a, varied_function(b, 1.0 / b.value, -1.0 / (b.value * b.value)));
}

/// Computes Capone's force on a journal at (x, y) in clearances with velocity (vx, vy), per F0; theory.md, "Oil film".
static inline void rotor_film(const double z[4], varied force[2]) {
    const varied one = {1.0, {0.0}}, x = {z[0], {1, 0, 0, 0}}, y = {z[1], {0, 1, 0, 0}};
    const varied a = {z[0] - 2.0 * z[3], {1, 0, 0, -2}}, b = {z[1] + 2.0 * z[2], {0, 1, 2, 0}};
    const varied q = varied_sum(1.0, one, -1.0, varied_sum(1.0, varied_product(x, x), 1.0, varied_product(y, y)));
    const varied cc = varied_sum(1.0, varied_product(a, a), 1.0, varied_product(b, b));
    const varied speed = varied_function(cc, sqrt(cc.value), 0.5 / sqrt(cc.value));
    const varied root = varied_function(q, sqrt(q.value), 0.5 / sqrt(q.value));
    // (cos alpha, sin alpha) points to where the film begins, against (a, b).
    const varied ca = varied_sum(-1.0, varied_ratio(a, speed), 0.0, one);
    const varied sa = varied_sum(-1.0, varied_ratio(b, speed), 0.0, one);
    const varied across = varied_sum(1.0, varied_product(y, ca), -1.0, varied_product(x, sa));
    const varied along = varied_sum(1.0, varied_product(x, ca), 1.0, varied_product(y, sa));
    const varied tangent = varied_ratio(across, root);
    const varied angle =
        varied_function(tangent, acos(-1.0) + 2.0 * atan(tangent.value), 2.0 / (1.0 + tangent.value * tangent.value));
    const varied G = varied_ratio(angle, root);
    const varied V = varied_ratio(varied_sum(2.0, one, 1.0, varied_product(across, G)), q);
    const varied S = varied_ratio(along, varied_sum(1.0, one, -1.0, varied_product(along, along)));
    const varied K = varied_ratio(speed, q);
    const varied gx = varied_sum(1.0, varied_product(sa, G), 2.0, varied_product(ca, S));
    const varied gy = varied_sum(-1.0, varied_product(ca, G), 2.0, varied_product(sa, S));
    force[0] = varied_product(K, varied_sum(1.0, gx, -3.0, varied_product(x, V)));
    force[1] = varied_product(K, varied_sum(1.0, gy, -3.0, varied_product(y, V)));
}

/// The numbers of the equations, as the paper prints them but for S_f.
typedef struct rotor_numbers {
    double xi1, half_xi2, gravity, k_disc, k_journal, rho, S_f;
} rotor_numbers;

static inline rotor_numbers rotor_printed(void) {
    const double m1 = 420.0, m2 = 50.0, omega = 650.0, clearance = 2e-4, w = 0.2;
    const rotor_numbers n = {.xi1 = 4300.0 / (m1 * omega),
                             .half_xi2 = 9300.0 / (2.0 * m2 * omega),
                             .gravity = 9.8 / (omega * omega * clearance),
                             .k_disc = m2 / (2.0 * m1 * w * w),
                             .k_journal = 1.0 / (4.0 * w * w),
                             .rho = 0.08,
                             .S_f = 0.0045};
    return n;
}

/// Computes the derivatives [10] by tau of u [10] at the stiffness ratio r_k, with the signs that the paper prints.
static inline void rotor_slope(double r_k, const double u[ROTOR_ALL], double f[ROTOR_ALL]) {
    const rotor_numbers n = rotor_printed();
    const double c = u[8], s = u[9], along = r_k + 1.0 + (r_k - 1.0) * (c * c - s * s),
                 across = (r_k - 1.0) * 2.0 * s * c;
    const double dx = u[0] - u[2], dy = u[1] - u[3], spring[2] = {along * dx + across * dy, along * dy + across * dx};
    const double around = 1.0 - c * c - s * s;
    varied film[2];
    rotor_film((double[4]){u[2], u[3], u[6], u[7]}, film);
    for (int i = 0; i < 4; i++) f[i] = u[4 + i];
    f[4] = -n.xi1 * u[4] - n.k_disc * spring[0] + n.rho * c;
    f[5] = -n.xi1 * u[5] - n.k_disc * spring[1] + n.rho * s - n.gravity;
    f[6] = -n.half_xi2 * u[6] + n.k_journal * spring[0] + n.S_f * film[0].value;
    f[7] = -n.half_xi2 * u[7] + n.k_journal * spring[1] + n.S_f * film[1].value - n.gravity;
    // On the unit circle, which attracts: the cosine and the sine.
    f[8] = c * around - s;
    f[9] = s * around + c;
}

/// Computes the derivatives of rotor_slope by u: by_state[i][j] = d f_i/d u_j.
static inline void rotor_slope_by_state(double r_k, const double u[ROTOR_ALL], double by_state[ROTOR_ALL][ROTOR_ALL]) {
    const rotor_numbers n = rotor_printed();
    const double b = r_k - 1.0, c = u[8], s = u[9], along = r_k + 1.0 + b * (c * c - s * s), across = b * 2.0 * s * c;
    const double d[2] = {u[0] - u[2], u[1] - u[3]}, k[2] = {-n.k_disc, n.k_journal}, around = 1.0 - c * c - s * s;
    varied film[2];
    rotor_film((double[4]){u[2], u[3], u[6], u[7]}, film);
    for (int i = 0; i < ROTOR_ALL; i++)
        for (int j = 0; j < ROTOR_ALL; j++) by_state[i][j] = i < 4 && j == i + 4 ? 1.0 : 0.0;
    for (int i = 0; i < 2; i++) {
        for (int body = 0; body < 2; body++) {
            double *row = by_state[4 + 2 * body + i];
            row[i] = k[body] * along;
            row[1 - i] = k[body] * across;
            row[2 + i] = -row[i];
            row[3 - i] = -row[1 - i];
            row[8] = 2.0 * k[body] * b * (c * d[i] + s * d[1 - i]);
            row[9] = 2.0 * k[body] * b * (c * d[1 - i] - s * d[i]);
        }
        by_state[4 + i][4 + i] = -n.xi1;
        by_state[4 + i][8 + i] += n.rho;
        by_state[6 + i][6 + i] = -n.half_xi2;
        for (int j = 0; j < 2; j++) {
            by_state[6 + i][2 + j] += n.S_f * film[i].by[j];
            by_state[6 + i][6 + j] += n.S_f * film[i].by[2 + j];
        }
    }
    by_state[8][8] = around - 2.0 * c * c;
    by_state[8][9] = -2.0 * c * s - 1.0;
    by_state[9][8] = -2.0 * c * s + 1.0;
    by_state[9][9] = around - 2.0 * s * s;
}

/// Computes the derivatives [10] of rotor_slope by r_k.
static inline void rotor_slope_by_ratio(const double u[ROTOR_ALL], double by_ratio[ROTOR_ALL]) {
    const rotor_numbers n = rotor_printed();
    const double along = 1.0 + u[8] * u[8] - u[9] * u[9], across = 2.0 * u[9] * u[8];
    const double dx = u[0] - u[2], dy = u[1] - u[3], x = along * dx + across * dy, y = along * dy + across * dx;
    for (int i = 0; i < ROTOR_ALL; i++) by_ratio[i] = 0.0;
    by_ratio[4] = -n.k_disc * x;
    by_ratio[5] = -n.k_disc * y;
    by_ratio[6] = n.k_journal * x;
    by_ratio[7] = n.k_journal * y;
}

#endif
