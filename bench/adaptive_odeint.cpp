// The peer Boost.odeint, runge_kutta_dopri5 with its step control.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "equations.h"

#include "adaptive.h"
#include "peer.h"

namespace odeint = boost::numeric::odeint;

struct machine {
    using state_type = std::array<double, ROTOR_DIMENSION>;
    state_type z = ROTOR_START;
    double t = 0.0, h = 1e-3;

    void operator()(const state_type &at, state_type &dz, double time) const {
        equations(ROTOR_R_K, std::cos(time), std::sin(time), at.data(), dz.data());
    }
    static void revolve(void *context) {
        machine *m = static_cast<machine *>(context);
        auto stepper = odeint::make_controlled(ADAPTIVE_ATOL, ADAPTIVE_RTOL, odeint::runge_kutta_dopri5<state_type>());
        const double end = m->t + 2.0 * ROTOR_PI;
        odeint::integrate_adaptive(stepper, std::cref(*m), m->z, m->t, end, m->h);
        m->t = end;
    }
    static void state(void *context, double z[ROTOR_DIMENSION]) {
        const machine *m = static_cast<machine *>(context);
        for (int i = 0; i < ROTOR_DIMENSION; i++) z[i] = m->z[static_cast<size_t>(i)];
    }
};

int main(int argc, char **argv) {
    machine m;
    const adaptive_peer measured = {"Boost.odeint dopri5", 1, machine::revolve, machine::state, &m};
    adaptive_measure(&measured, peer_seconds(argc, argv));
    return 0;
}
