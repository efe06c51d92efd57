/// The rotor of all benchmarks: that of the paper of 2015, a disc and a journal, with the signs of the shaft's
/// stiffness as printed there, film coefficient Sf = 0.0045 and gravity G = 0.115976. It starts at rest at y1 = y2 =
/// -0.1 and is computed by RK4 in 1024 steps per revolution. C and C++.
#ifndef BENCH_ROTOR_H
#define BENCH_ROTOR_H

enum { ROTOR_STEPS = 1024, ROTOR_DIMENSION = 8 };

#define ROTOR_PI 3.14159265358979323846
#define ROTOR_START                                                                                                    \
    { 0, -0.1, 0, -0.1, 0, 0, 0, 0 } ///< x1, y1, x2, y2 and their derivatives by tau
#define ROTOR_R_K 0.6                ///< stiffness ratio of single machines
#define ROTOR_R_K_FIRST 1.0          ///< stiffness ratios of the first and the last of many machines
#define ROTOR_R_K_LAST 0.1

static const double rotor_w = 0.2, rotor_r_m = 8.4, rotor_xi1 = 0.0157509, rotor_xi2 = 0.286154;
static const double rotor_rho = 0.08, rotor_G = 0.115976, rotor_S_f = 0.0045;
static const double rotor_r_delta = 1.2, rotor_r_ck = 10.0, rotor_f = 0.1;

/// Coefficients of the equations that follow from the numbers above.
#define ROTOR_K1 (1.0 / (2.0 * rotor_r_m * rotor_w * rotor_w))
#define ROTOR_K2 (1.0 / (4.0 * rotor_w * rotor_w))
#define ROTOR_PUSH (rotor_r_ck / (rotor_r_m * rotor_w * rotor_w))

/// Returns the stiffness ratio of machine i of n side by side. The ratios spread over the range of the paper's diagram,
/// except the first: only the end state of the first machine is compared.
static inline double rotor_r_k(int i, int n) {
    return i == 0 ? ROTOR_R_K : ROTOR_R_K_FIRST + (ROTOR_R_K_LAST - ROTOR_R_K_FIRST) * i / (n > 1 ? n - 1 : 1);
}

#endif
