#include "solvers/sparse/gmres.h"

#include <Eigen/QR>

namespace thenar {

Eigen::VectorXd gmres(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                      const Eigen::VectorXd& b, double tolerance, int max_iterations) {
  const double size = b.norm();
  if (!(size > 0)) return b;
  // Orthonormal basis of the Krylov space, and the Hessenberg matrix.
  Eigen::MatrixXd basis(b.size(), max_iterations + 1);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(max_iterations + 1, max_iterations);
  basis.col(0) = b / size;
  Eigen::VectorXd y;
  int steps = 0;
  for (bool done = false; steps < max_iterations && !done;) {
    const int k = steps++;
    Eigen::VectorXd next = apply(basis.col(k));
    // Orthogonalise twice against rounding errors.
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd part = basis.leftCols(k + 1).transpose() * next;
      H.col(k).head(k + 1) += part;
      next -= basis.leftCols(k + 1) * part;
    }
    H(k + 1, k) = next.norm();
    // Minimise the residual over the basis.
    Eigen::VectorXd right_side = Eigen::VectorXd::Zero(k + 2);
    right_side[0] = size;
    const auto hessenberg = H.topLeftCorner(k + 2, k + 1);
    y = hessenberg.householderQr().solve(right_side);
    done =
        H(k + 1, k) <= tolerance * size || (right_side - hessenberg * y).norm() <= tolerance * size;
    if (!done) basis.col(k + 1) = next / H(k + 1, k);
  }
  return basis.leftCols(steps) * y;
}

}  // namespace thenar
