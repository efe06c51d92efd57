#ifndef BENCH_STRAIGHTFORWARD_H
#define BENCH_STRAIGHTFORWARD_H

/// The paper's rotor by its dimensionless numbers.
typedef struct straightforward_rotor {
    double r_k, r_m, w, xi1, xi2, rho, r_delta, r_ck, f, S_f, G;
} straightforward_rotor;

/// One revolution of RK4 in `steps` steps; z holds x1, y1, x2, y2 and their derivatives by tau.
void straightforward_revolve(const straightforward_rotor *rotor, int steps, double *z);

#endif
