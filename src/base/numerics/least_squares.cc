// Levenberg and Marquardt's method with bounds, and the covariance at its end; decompositions by Eigen.
#include "eigen_plain.h"

#include "least_squares.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <vector>

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

constexpr double least_damping = 1e-12, first_damping = 1e-3, most_damping = 1e12;

/// The method between two evaluations.
struct State {
    const least_squares *problem;
    Index n, m;
    VectorXd p, r, longest; ///< longest: largest norms of the columns so far
    RowMajor jacobian;
    double sum, damping, growth;
};

State state_of(const least_squares &of) {
    const auto n = static_cast<Index>(of.unknowns), m = static_cast<Index>(of.count);
    return {&of, n, m, VectorXd(n), VectorXd(m), VectorXd::Zero(n), RowMajor(m, n), 0.0, first_damping, 2.0};
}

bool evaluate(const State &s, const VectorXd &at, VectorXd &residuals, RowMajor &derivatives) {
    return s.problem->evaluate(s.problem->context, at.data(), residuals.data(), derivatives.data()) &&
           residuals.allFinite() && derivatives.allFinite();
}

/// Returns true if p_i is at a bound and the sum of squares falls only beyond that bound.
bool held(const State &s, Index i, const VectorXd &gradient) {
    return (s.p(i) <= s.problem->low[i] && gradient(i) > 0.0) || (s.p(i) >= s.problem->high[i] && gradient(i) < 0.0);
}

/// Returns the next p, by the step of the present damping.
VectorXd next_of(const State &s) {
    // Unknowns that are held at a bound stay.
    const VectorXd gradient = s.jacobian.transpose() * s.r;
    std::vector<Index> free;
    for (Index i = 0; i < s.n; i++)
        if (!held(s, i, gradient)) free.push_back(i);
    const auto count = static_cast<Index>(free.size());
    VectorXd out = s.p;
    if (count == 0) return out;
    // Scale columns to length 1 at most, so that no choice of units makes a column look like rounding. Damping adds a
    // row for each.
    MatrixXd a = MatrixXd::Zero(s.m + count, count);
    VectorXd b = VectorXd::Zero(s.m + count);
    b.head(s.m) = -s.r;
    for (Index k = 0; k < count; k++) {
        const Index i = free[static_cast<size_t>(k)];
        a.col(k).head(s.m) = s.jacobian.col(i) / s.longest(i);
        a(s.m + k, k) = std::sqrt(s.damping);
    }
    // Take the step, cut at the bounds.
    const VectorXd step = a.colPivHouseholderQr().solve(b);
    for (Index k = 0; k < count; k++) {
        const Index i = free[static_cast<size_t>(k)];
        out(i) = std::min(std::max(s.p(i) + step(k) / s.longest(i), s.problem->low[i]), s.problem->high[i]);
    }
    return out;
}

/// Returns true if the step is too short to matter.
bool is_short(const State &s, const VectorXd &step) {
    const double part = s.problem->tolerance;
    for (Index i = 0; i < s.n; i++)
        if (std::abs(step(i)) > part * std::max(std::abs(s.p(i)), s.problem->scale[i] * part)) return false;
    return true;
}

/// Returns the predicted gain of a step: by how much it lowers the linearized sum of squares.
double promise_of(const State &s, const VectorXd &step) {
    return s.sum - (s.r + s.jacobian * step).squaredNorm();
}

/// Returns how the method ends at a p from which no step lowers the sum: at a minimum if a step with little damping is
/// short, too, or has so small a predicted gain that p is within a thousandth of a standard error of the minimum; else
/// stuck.
least_squares_end end_of(State &s) {
    constexpr double little = 1e-6;
    s.damping = std::min(s.damping, first_damping);
    const VectorXd step = next_of(s) - s.p;
    const bool flat = promise_of(s, step) <= little * s.sum / static_cast<double>(s.m);
    return flat || is_short(s, step) ? LEAST_SQUARES_FOUND : LEAST_SQUARES_STUCK;
}

void go(State &s, const VectorXd &to, const VectorXd &residuals, const RowMajor &derivatives) {
    s.p = to;
    s.r = residuals;
    s.jacobian = derivatives;
    s.sum = residuals.squaredNorm();
    for (Index i = 0; i < s.n; i++) {
        s.longest(i) = std::max(s.longest(i), derivatives.col(i).norm());
        if (!(s.longest(i) > 0.0)) s.longest(i) = 1.0 / s.problem->scale[i];
    }
    if (s.problem->accept != nullptr) s.problem->accept(s.problem->context);
}

least_squares_result solve(State &s) {
    least_squares_result out = {LEAST_SQUARES_NOWHERE, 1, std::numeric_limits<double>::infinity()};
    VectorXd residuals(s.m);
    RowMajor derivatives(s.m, s.n);
    const VectorXd start = s.p;
    if (!evaluate(s, start, residuals, derivatives)) return out;
    go(s, start, residuals, derivatives);
    for (out.end = LEAST_SQUARES_STEPS; out.steps < s.problem->most_steps;) {
        // Propose a step, and end if it is too short to matter.
        const VectorXd to = next_of(s), step = to - s.p;
        const double promised = promise_of(s, step);
        if (is_short(s, step)) {
            out.end = end_of(s);
            break;
        }
        out.steps++;
        const bool computed = evaluate(s, to, residuals, derivatives);
        const double gain = computed ? s.sum - residuals.squaredNorm() : -1.0;
        // A predicted gain below this part of the sum is hidden by rounding.
        const bool rounds = computed && promised <= 1e-13 * s.sum && gain > -1e-12 * s.sum;
        // Accept a step that lowers the sum: the better the prediction was, the less damping follows.
        if (computed && (gain > 1e-4 * promised || rounds)) {
            const double ratio = promised > 0.0 ? gain / promised : 1.0;
            go(s, to, residuals, derivatives);
            s.damping = std::max(s.damping * std::max(0.1, 1.0 - std::pow(2.0 * ratio - 1.0, 3)), least_damping);
            s.growth = 2.0;
            if (!rounds) continue;
            out.end = LEAST_SQUARES_FOUND;
            break;
        }
        // Try again with more damping.
        s.damping = std::max(s.damping, least_damping) * s.growth;
        s.growth *= 2.0;
        if (s.damping < most_damping) continue;
        out.end = end_of(s);
        break;
    }
    out.sum = s.sum;
    return out;
}

} // namespace

least_squares_result least_squares_solve(const least_squares *problem, double *p, double *residuals,
                                         double *derivatives) {
    try {
        State s = state_of(*problem);
        for (Index i = 0; i < s.n; i++) s.p(i) = std::min(std::max(p[i], problem->low[i]), problem->high[i]);
        const least_squares_result out = solve(s);
        Eigen::Map<VectorXd>(p, s.n) = s.p;
        if (out.end == LEAST_SQUARES_NOWHERE) return out;
        Eigen::Map<VectorXd>(residuals, s.m) = s.r;
        Eigen::Map<RowMajor>(derivatives, s.m, s.n) = s.jacobian;
        return out;
    } catch (const std::bad_alloc &) {
        return {LEAST_SQUARES_MEMORY, 0, std::numeric_limits<double>::infinity()};
    }
}

bool least_squares_describe(size_t unknowns, size_t count, const double *derivatives, double *errors,
                            double *correlations, least_squares_facts *facts) {
    // rounding: singular values below this part of the largest count as rounding errors of the derivatives. belongs: an
    // unknown with a larger component belongs to a singular vector.
    constexpr double rounding = 1e-8, belongs = 1e-3;
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    try {
        const auto n = static_cast<Index>(unknowns), m = static_cast<Index>(count);
        MatrixXd a = Eigen::Map<const RowMajor>(derivatives, m, n);
        const VectorXd lengths = a.colwise().norm();
        for (Index i = 0; i < n; i++)
            if (lengths(i) > 0.0) a.col(i) /= lengths(i);
        const Eigen::JacobiSVD<MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
        const VectorXd &values = svd.singularValues();
        const MatrixXd &v = svd.matrixV();
        // Sum the covariance over singular vectors on which r depends. Unknowns that belong to other singular vectors
        // have no finite error.
        MatrixXd covariance = MatrixXd::Zero(n, n);
        std::vector<bool> lost(unknowns, false);
        facts->rank = 0;
        for (Index k = 0; k < n; k++) {
            const double value = k < values.size() ? values(k) : 0.0;
            if (value > rounding * values(0)) {
                covariance += v.col(k) * v.col(k).transpose() / (value * value);
                facts->rank++;
            } else if (k < v.cols()) {
                for (Index i = 0; i < n; i++)
                    if (std::abs(v(i, k)) > belongs) lost[static_cast<size_t>(i)] = true;
            }
        }
        for (Index i = 0; i < n && m < n; i++) lost[static_cast<size_t>(i)] = true;
        facts->condition = facts->rank == unknowns ? values(0) / values(n - 1) : unbounded;
        for (Index i = 0; i < n; i++) {
            errors[i] = lost[static_cast<size_t>(i)] ? unbounded : std::sqrt(covariance(i, i)) / lengths(i);
            for (Index k = 0; k < n; k++)
                correlations[i * n + k] = lost[static_cast<size_t>(i)] || lost[static_cast<size_t>(k)]
                                              ? missing
                                              : covariance(i, k) / std::sqrt(covariance(i, i) * covariance(k, k));
        }
        return true;
    } catch (const std::bad_alloc &) {
        return false;
    }
}

double least_squares_student(size_t degrees) {
    constexpr double x = 1.959963984540054;
    if (degrees == 0) return std::numeric_limits<double>::infinity();
    if (degrees == 1) return 12.706204736432095;
    if (degrees == 2) return 4.302652729911275;
    const double d = static_cast<double>(degrees), x2 = x * x;
    const double g1 = (x2 + 1.0) * x / 4.0, g2 = ((5.0 * x2 + 16.0) * x2 + 3.0) * x / 96.0;
    const double g3 = (((3.0 * x2 + 19.0) * x2 + 17.0) * x2 - 15.0) * x / 384.0;
    const double g4 = ((((79.0 * x2 + 776.0) * x2 + 1482.0) * x2 - 1920.0) * x2 - 945.0) * x / 92160.0;
    return x + (g1 + (g2 + (g3 + g4 / d) / d) / d) / d;
}
