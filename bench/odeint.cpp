// The peer Boost.odeint, runge_kutta4: one machine in doubles, and as many machines as a vector has lanes in
// std::experimental::simd, with an arctangent that stays in vectors.
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <experimental/simd>

namespace stdx = std::experimental;
using pack = stdx::native_simd<double>;

static inline pack below_zero(const pack &a) {
    return stdx::min(a, pack(0.0));
}

/// Returns the arctangent, measured from the nearest of 0, pi/4 and pi/2; a polynomial of ten terms for the rest.
static inline pack atan(const pack &y) {
    const double terms[] = {0x1.5c499b265fce1p-6, -0x1.651538dff7b49p-5, 0x1.d253e722db8aap-5, -0x1.1005137c53d01p-4,
                            0x1.3afc32143df6bp-4, -0x1.745bc2f2036d0p-4, 0x1.c71c65ccd3f69p-4, -0x1.24924905743e5p-3,
                            0x1.9999999949591p-3, -0x1.5555555555317p-2};
    const double quarter = std::atan(1.0);
    const pack size = stdx::abs(y);
    pack up = size, down = 1.0, centre = 0.0;
    stdx::where(size > 0.41421356237309503, up) = size - 1.0;
    stdx::where(size > 0.41421356237309503, down) = size + 1.0;
    stdx::where(size > 0.41421356237309503, centre) = quarter;
    stdx::where(size > 2.4142135623730949, up) = -1.0;
    stdx::where(size > 2.4142135623730949, down) = size;
    stdx::where(size > 2.4142135623730949, centre) = 2.0 * quarter;
    const pack u = up / down, s = u * u;
    pack p = terms[0];
    for (int i = 1; i < 10; i++) p = p * s + terms[i];
    return stdx::copysign(centre + u + u * s * p, y);
}

#include "equations.h"
#include "peer.h"

template <class number> struct machine {
    using state = std::array<number, ROTOR_DIMENSION>;
    number r_k;
    state z;
    boost::numeric::odeint::runge_kutta4<state, double, state, double, boost::numeric::odeint::array_algebra> stepper;

    void operator()(const state &at, state &dz, double t) const {
        equations(r_k, std::cos(t), std::sin(t), at.data(), dz.data());
    }
    static void revolve(void *context) {
        machine *m = static_cast<machine *>(context);
        boost::numeric::odeint::integrate_n_steps(m->stepper, std::cref(*m), m->z, 0.0, 2.0 * ROTOR_PI / ROTOR_STEPS,
                                                  ROTOR_STEPS);
    }
};

static double first(double a) {
    return a;
}
static double first(const pack &a) {
    return a[0];
}

template <class number> static void measure(const char *name, const number &r_k, size_t machines, double seconds) {
    const double start[ROTOR_DIMENSION] = ROTOR_START;
    machine<number> m;
    m.r_k = r_k;
    for (int i = 0; i < ROTOR_DIMENSION; i++) m.z[i] = start[i];
    const peer measured = {name, machines, machine<number>::revolve,
                           [](void *context) { return first(static_cast<machine<number> *>(context)->z[0]); }, &m};
    peer_measure(&measured, seconds);
}

int main(int argc, char **argv) {
    const double seconds = peer_seconds(argc, argv);
    const int lanes = static_cast<int>(pack::size());
    measure<double>("Boost.odeint", ROTOR_R_K, 1, seconds);
    measure<pack>("Boost.odeint simd", pack([&](auto i) { return rotor_r_k(static_cast<int>(i), lanes); }),
                  pack::size(), seconds);
    return 0;
}
