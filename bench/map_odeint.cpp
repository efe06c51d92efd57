// The peer Boost.odeint over a map: runge_kutta_dopri5 with its step control, point after point (map_equations.h).
//
//   bench_map_odeint TRANSIENT RECORD STRIDE
//
// Every STRIDE-th point; prints seconds a point and the mean of x1 over all sections that are recorded.
#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "map_equations.h"

namespace odeint = boost::numeric::odeint;
using state = std::array<double, ROTOR_DIMENSION>;

struct machine {
    double r_k, rho, h = 1e-3;

    void operator()(const state &at, state &dz, double time) const {
        map_equations(r_k, rho, time, at.data(), dz.data());
    }
    template <class observer> void revolve(state &z, observer observe) {
        auto stepper = odeint::make_controlled(MAP_ATOL, MAP_RTOL, odeint::runge_kutta_dopri5<state>());
        odeint::integrate_adaptive(stepper, std::cref(*this), z, 0.0, 2.0 * ROTOR_PI, h, observe);
    }
};

/// Returns the factor by which the second motion's distance has grown, and scales it back to that of the perturbation.
static double renew(const state &z, state &twin) {
    double distance = 0.0;
    for (size_t i = 0; i < z.size(); i++) distance += (twin[i] - z[i]) * (twin[i] - z[i]);
    distance = std::sqrt(distance);
    for (size_t i = 0; i < z.size(); i++) twin[i] = z[i] + (twin[i] - z[i]) * (MAP_PERTURBATION / distance);
    return distance / MAP_PERTURBATION;
}

int main(int argc, char **argv) {
    if (argc != 4) return 1;
    const int transient = std::atoi(argv[1]), record = std::atoi(argv[2]), stride = std::atoi(argv[3]);
    const int watch = record + transient / 2;
    const std::clock_t start = std::clock();
    int points = 0;
    double largest = 0.0, growth = 0.0, section = 0.0;
    for (int point = 0; point < MAP_SIDE * MAP_SIDE; point += stride, points++) {
        machine m = {map_r_k(point % MAP_SIDE), map_rho(point / MAP_SIDE)}, other = m;
        state z = ROTOR_START, twin = z;
        for (int n = 0; n < transient + record; n++) {
            const bool last = n >= transient;
            if (n == transient + record - watch) {
                twin = z;
                twin[0] += MAP_PERTURBATION;
            }
            m.revolve(z, [&](const state &at, double) {
                if (last) largest = std::max(largest, at[0] * at[0] + at[1] * at[1]);
            });
            if (n < transient + record - watch) continue;
            other.revolve(twin, [](const state &, double) {});
            growth += std::log(renew(z, twin));
            if (last) section += z[0];
        }
    }
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    std::printf("Boost.odeint dopri5\t%.6g\t%.9f\n", seconds / points, section / (points * record));
    std::fprintf(stderr, "largest radius %g, growth %g\n", std::sqrt(largest), growth); // so that they are computed
    return 0;
}
