// Dense matrices by Eigen, behind plain C.
#include "eigen_plain.h"

#include "matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cerrno>
#include <cmath>
#include <limits>

#include "matrix_balance.h"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows = Eigen::Map<RowMajor>;
using ConstRows = Eigen::Map<const RowMajor>;

/// Right-hand sides [count][n] as columns.
using Columns = Eigen::Map<MatrixXd>;

Index index_of(size_t n) {
    return static_cast<Index>(n);
}

/// Runs code that may throw, and returns its result, or false if it throws. Eigen throws only if memory runs out; errno
/// is then ENOMEM. Otherwise errno is restored: a malloc that succeeds may have set it to ENOMEM (in glibc, if the heap
/// cannot grow in place).
template <typename Work> bool attempt(Work work) noexcept {
    const int before = errno;
    try {
        const bool done = work();
        errno = before;
        return done;
    } catch (...) {
        errno = ENOMEM; // nothing else is thrown
        return false;
    }
}

/// Returns the index of the largest component; of several that are equal within 1e-6 the first, so that the choice does
/// not depend on the last bits.
template <typename Sizes> Index largest_of(const Sizes &sizes) {
    const double enough = (1.0 - 1e-6) * sizes.maxCoeff();
    Index i = 0;
    while (i + 1 < sizes.size() && !(sizes(i) >= enough)) i++;
    return i;
}

/// Computes Cholesky's factors; returns false if the matrix is not positive definite. Eigen itself checks only the last
/// pivots, and lets NaN pass.
bool factor(Eigen::LLT<MatrixXd> &factors, const MatrixXd &m) {
    factors.compute(m);
    return factors.info() == Eigen::Success && factors.matrixLLT().diagonal().minCoeff() > 0.0;
}

bool symmetric_modes(Index n, const double *k, const double *m, double *values, double *vectors) {
    // With masses M = L L', the problem is that of L^-1 K L'^-1.
    MatrixXd stiffness = ConstRows(k, n, n);
    Eigen::LLT<MatrixXd> factors;
    if (m != nullptr) {
        const MatrixXd mass = ConstRows(m, n, n);
        if (!mass.allFinite() || !factor(factors, mass)) return false;
        stiffness = stiffness.selfadjointView<Eigen::Lower>();
        factors.matrixL().solveInPlace(stiffness);
        factors.matrixU().solveInPlace<Eigen::OnTheRight>(stiffness);
    }
    if (!stiffness.allFinite()) return false;
    // Solve the standard problem.
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(stiffness);
    if (solver.info() != Eigen::Success) return false;
    Eigen::Map<VectorXd>(values, n) = solver.eigenvalues();
    // Transform modes back, and give the largest component of each a positive sign.
    Columns modes(vectors, n, n);
    modes = solver.eigenvectors();
    if (m != nullptr) factors.matrixU().solveInPlace(modes);
    for (Index mode = 0; mode < n; mode++) {
        auto shape = modes.col(mode);
        if (shape(largest_of(shape.cwiseAbs().eval())) < 0.0) shape = -shape;
    }
    return modes.allFinite();
}

/// Scales a vector to length 1 with its largest component real and positive; writes it as pairs.
void write_vector(const Eigen::VectorXcd &v, double *out) {
    const VectorXd sizes = v.cwiseAbs2();
    const std::complex<double> first = v(largest_of(sizes));
    const double length = std::sqrt(sizes.sum()), size = std::sqrt(std::norm(first));
    const double c = first.real() / size / length, s = first.imag() / size / length;
    for (Index i = 0; i < v.size(); i++) {
        out[2 * i] = v(i).real() * c + v(i).imag() * s;
        out[2 * i + 1] = v(i).imag() * c - v(i).real() * s;
    }
}

/// Bounds how far rounding moves each eigenvalue: the norm of the matrix times the rounding unit. For slow modes it is
/// multiplied by the condition of the eigenvalue, the length of its row in the inverse of the matrix of eigenvectors
/// (Golub, Van Loan 2013, 7.2.2).
void write_rounding(const RowMajor &balanced, const Eigen::EigenSolver<MatrixXd> &solver, double *rounding) {
    static const double fast = 1e-3;
    const Index n = balanced.rows();
    const double one = std::numeric_limits<double>::epsilon() * balanced.norm();
    const VectorXd sizes = solver.eigenvalues().cwiseAbs();
    const double least = fast * sizes.maxCoeff();
    Eigen::Map<VectorXd>(rounding, n).setConstant(one);
    if (!(sizes.minCoeff() < least)) return;
    const Eigen::MatrixXcd inverse = solver.eigenvectors().partialPivLu().inverse();
    for (Index i = 0; i < n; i++)
        if (sizes(i) < least) rounding[i] = one * inverse.row(i).norm();
}

bool eigen(Index n, double *a, double *real, double *imaginary, double *vectors, double *rounding) {
    VectorXd scale(n);
    Rows rows(a, n, n);
    if (!rows.allFinite()) return false;
    matrix_balance(static_cast<size_t>(n), a, scale.data());
    const Eigen::EigenSolver<MatrixXd> solver(rows, vectors != nullptr);
    if (solver.info() != Eigen::Success) return false;
    Eigen::Map<VectorXd>(real, n) = solver.eigenvalues().real();
    Eigen::Map<VectorXd>(imaginary, n) = solver.eigenvalues().imag();
    if (rounding != nullptr) write_rounding(rows, solver, rounding);
    if (vectors == nullptr) return true;
    const Eigen::MatrixXcd found = solver.eigenvectors();
    for (Index i = 0; i < n; i++) write_vector(scale.asDiagonal() * found.col(i), vectors + 2 * n * i);
    return found.allFinite();
}

bool solve(MatrixXd &a, Columns &b) {
    if (!a.allFinite() || !b.allFinite()) return false;
    const Eigen::PartialPivLU<Eigen::Ref<MatrixXd>> factors(a);
    if (!(a.diagonal().cwiseAbs().minCoeff() > 0.0)) return false;
    b = factors.solve(b).eval();
    return b.allFinite();
}

bool eigen_by_inverse(Index n, const double *a, double *real, double *imaginary, double *vectors, double *rounding) {
    VectorXd scale(n);
    RowMajor balanced = ConstRows(a, n, n);
    if (!balanced.allFinite()) return false;
    matrix_balance(static_cast<size_t>(n), balanced.data(), scale.data());
    MatrixXd factored = balanced, inverse = MatrixXd::Identity(n, n);
    Columns sides(inverse.data(), n, n);
    if (!solve(factored, sides)) return false;
    const Eigen::EigenSolver<MatrixXd> solver(inverse);
    if (solver.info() != Eigen::Success) return false;
    const Eigen::MatrixXcd columns = solver.eigenvectors(), rows = columns.partialPivLu().inverse();
    const MatrixXd sizes = balanced.cwiseAbs();
    for (Index i = 0; i < n; i++) {
        const std::complex<double> value = solver.eigenvalues()(i);
        const double square = std::norm(value);
        real[i] = value.real() / square;
        imaginary[i] = (0.0 - value.imag()) / square;
        const VectorXd moved = sizes * columns.col(i).cwiseAbs();
        rounding[i] = std::numeric_limits<double>::epsilon() * rows.row(i).cwiseAbs().dot(moved);
        write_vector(scale.asDiagonal() * columns.col(i), vectors + 2 * n * i);
        if (!std::isfinite(real[i]) || !std::isfinite(imaginary[i])) return false;
    }
    return columns.allFinite();
}

/// Solves with real and imaginary parts, [A, -B; B, A], so that all divisions are of real numbers.
bool solve_complex(Index n, const double *a, Index count, double *b) {
    // Fill in the real matrix, and both parts of the right sides.
    MatrixXd both(2 * n, 2 * n), sides(2 * n, count);
    for (Index i = 0; i < n; i++)
        for (Index k = 0; k < n; k++) {
            const double *entry = a + 2 * (i * n + k);
            both(i, k) = both(n + i, n + k) = entry[0];
            both(n + i, k) = entry[1];
            both(i, n + k) = -entry[1];
        }
    for (Index c = 0; c < count; c++)
        for (Index i = 0; i < n; i++) {
            sides(i, c) = b[2 * (c * n + i)];
            sides(n + i, c) = b[2 * (c * n + i) + 1];
        }
    // Solve, and put the parts together again.
    Columns columns(sides.data(), 2 * n, count);
    if (!solve(both, columns)) return false;
    for (Index c = 0; c < count; c++)
        for (Index i = 0; i < n; i++) {
            b[2 * (c * n + i)] = sides(i, c);
            b[2 * (c * n + i) + 1] = sides(n + i, c);
        }
    return true;
}

} // namespace

bool matrix_symmetric_modes(size_t n, const double *k, const double *m, double *values, double *vectors) {
    return n == 0 || attempt([&] { return symmetric_modes(index_of(n), k, m, values, vectors); });
}

bool matrix_eigen(size_t n, double *a, double *real, double *imaginary, double *vectors) {
    return matrix_eigen_rounding(n, a, real, imaginary, vectors, nullptr);
}

bool matrix_eigen_rounding(size_t n, double *a, double *real, double *imaginary, double *vectors, double *rounding) {
    return n == 0 || attempt([&] { return eigen(index_of(n), a, real, imaginary, vectors, rounding); });
}

bool matrix_eigen_by_inverse(size_t n, const double *a, double *real, double *imaginary, double *vectors,
                             double *rounding) {
    return n == 0 || attempt([&] { return eigen_by_inverse(index_of(n), a, real, imaginary, vectors, rounding); });
}

bool matrix_hessenberg(size_t n, double *a, double *q) {
    return n == 0 || attempt([&] {
               Rows rows(a, index_of(n), index_of(n));
               if (!rows.allFinite()) return false;
               const Eigen::HessenbergDecomposition<MatrixXd> parts(rows);
               Rows(q, index_of(n), index_of(n)) = parts.matrixQ();
               rows = parts.matrixH();
               return rows.allFinite();
           });
}

bool matrix_solve(size_t n, const double *a, size_t count, double *b) {
    return n == 0 || count == 0 || attempt([&] {
               MatrixXd columns = ConstRows(a, index_of(n), index_of(n));
               Columns sides(b, index_of(n), index_of(count));
               return solve(columns, sides);
           });
}

bool matrix_solve_complex(size_t n, const double *a, size_t count, double *b) {
    return n == 0 || count == 0 || attempt([&] { return solve_complex(index_of(n), a, index_of(count), b); });
}

bool matrix_solve_definite(size_t n, const double *a, size_t count, double *b) {
    return n == 0 || count == 0 || attempt([&] {
               Eigen::LLT<MatrixXd> factors;
               const MatrixXd columns = ConstRows(a, index_of(n), index_of(n));
               Columns sides(b, index_of(n), index_of(count));
               if (!columns.allFinite() || !factor(factors, columns)) return false;
               factors.solveInPlace(sides);
               return sides.allFinite();
           });
}

bool matrix_solve_shortest(size_t n, const double *a, double tolerance, double *b, size_t *rank) {
    return n == 0 || attempt([&] {
               const MatrixXd columns = ConstRows(a, index_of(n), index_of(n));
               Eigen::Map<VectorXd> side(b, index_of(n));
               if (!columns.allFinite() || !side.allFinite()) return false;
               Eigen::CompleteOrthogonalDecomposition<MatrixXd> parts;
               parts.setThreshold(tolerance);
               parts.compute(columns);
               side = parts.solve(side).eval();
               if (rank != nullptr) *rank = static_cast<size_t>(parts.rank());
               return side.allFinite();
           });
}
