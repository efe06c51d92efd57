/// The rotors of the validation cases, with masses, clearances and gaps of one unit, so that the scaled equations of
/// motion are those of the cases. Freed by whirl_rotor_free.
#ifndef SUPPORT_ROTOR_H
#define SUPPORT_ROTOR_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/rotor.h"

/// x'' = strength fx + rho cos tau, y'' = strength fy - weight + rho sin tau.
whirl_rotor *make_film_rotor(double strength, double weight, double rho);

/// A disc of mass 1 on a shaft of stiffness k to a journal of mass mj in a film; speed omega, gravity 1, clearance 1.
/// F0 is `load`.
whirl_rotor *make_flexible_film_rotor(double omega, double mj, double k, double load);

/// m = 1 on an asymmetric shaft to ground.
typedef struct shaft_case {
    double speed, damping, k1, k2;
    bool printed_signs; ///< of the 2015 paper, else those of a shaft that turns
    double eccentricity, angle, gravity;
} shaft_case;
whirl_rotor *make_shaft_rotor(const shaft_case *parameters);

/// z'' + 2 zeta z' + z + kap (1 - 1/|z|)(1 + i mu sgn v_t) z [|z| > 1] = e w^2 e^(iwt) - i gam in units of 1/omega_n.
typedef struct rub_case {
    double speed, zeta, kappa, friction, eccentricity, weight;
    bool follows_slip;
    double surface_radius, slip_speed; ///< for friction that follows the slip
} rub_case;
whirl_rotor *make_rub_rotor(const rub_case *parameters);

/// The state [4] on the circle of radius A that turns with the shaft, without weight, from the balance of forces
/// [1 + kap (1 - 1/A)(1 + i mu) - w^2 + 2 i zeta w] A e^(-i psi) = e w^2.
void start_on_rub_circle(const rub_case *parameters, double radius, double state[4]);

/// Row `row` of case C2 (case_c2), and its start on the circle.
rub_case start_case_c2(size_t row, double state[4]);

/// The 2015 paper's rotor with printed signs, Sf = .0045, G = .115976.
whirl_rotor *make_paper_rotor(double r_k);

#endif
