#include "grasp/quality/reach_proof.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Dense>

#include "grasp/quality/matrix_inequality.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kEnough = 1e-12;  // least eigenvalue asked of F, the set's size being 1 [1]
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr Index kDimensions = 7, kTime = 6;  // of x = (u, t), and the place of t

/// Points x with  l'x >= |Z x|; without rows of Z  l'x >= 0.
struct Cone {
  VectorXd l;  // (d)
  MatrixXd Z;  // (k, d)
};

/// Rows that a product with another cone may weigh: of a half line the line itself.
MatrixXd rows_of(const Cone& cone) {
  return cone.Z.rows() > 0 ? cone.Z : MatrixXd(cone.l.transpose());
}

MatrixXd symmetric(const MatrixXd& X) { return (X + X.transpose()) / 2; }

/// Where no cap reaches r; all sizes divided by that of the set.
std::vector<Cone> cones_of(const Support& support, double r) {
  std::vector<Cone> cones;
  for (const Support::Cap& cap : support.caps()) {
    Cone cone{(r / support.size()) * VectorXd::Unit(kDimensions, kTime),
              MatrixXd::Zero(cap.axes, kDimensions)};
    cone.l.head<6>() -= cap.c / support.size();
    cone.Z.leftCols<6>() = cap.A.leftCols(cap.axes).transpose() / support.size();
    cones.push_back(std::move(cone));
  }
  return cones;
}

/// The forms that F is made of, with what their weights must obey.
class Problem {
 public:
  explicit Problem(const std::vector<Cone>& cones) {
    for (const Cone& cone : cones)
      if (cone.Z.rows() > 0) add_weight(cone.Z.transpose() * cone.Z - cone.l * cone.l.transpose());
    for (std::size_t i = 0; i < cones.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) add_product(cones[i], cones[j]);
    // Cuts of the sphere also with (u, t) itself, |u| <= t.
    const Cone ball{VectorXd::Unit(kDimensions, kTime), MatrixXd::Identity(6, kDimensions)};
    for (const Cone& cone : cones)
      if (cone.Z.rows() == 0) add_product(cone, ball);
    VectorXd sphere = VectorXd::Zero(kDimensions);
    sphere.head<6>().setOnes();
    sphere(kTime) = -1;
    forms_.emplace_back(sphere.asDiagonal());
  }

  /// Weights for which F is positive definite, or as far as it goes.
  Raised find() const {
    const int least = static_cast<int>(forms_.size());  // the unknown below all eigenvalues of F
    MatrixInequality F{MatrixXd::Zero(kDimensions, kDimensions), {}};
    for (int k = 0; k < least; ++k) F.terms.emplace_back(k, forms_[static_cast<std::size_t>(k)]);
    F.terms.emplace_back(least, -MatrixXd::Identity(kDimensions, kDimensions));
    MatrixInequality sum{MatrixXd::Ones(1, 1), {}};
    std::vector<MatrixInequality> all{F};
    VectorXd y = VectorXd::Zero(least + 1);
    for (const int k : weights_) {
      all.push_back({MatrixXd::Zero(1, 1), {{k, MatrixXd::Ones(1, 1)}}});
      sum.terms.emplace_back(k, -MatrixXd::Ones(1, 1));
      y(k) = 0.5 / static_cast<double>(weights_.size() + products_.size());
    }
    for (const Product& each : products_) {
      all.push_back(bound_of(each));
      sum.terms.emplace_back(each.kappa, -MatrixXd::Ones(1, 1));
      y(each.kappa) = 0.5 / static_cast<double>(weights_.size() + products_.size());
    }
    all.push_back(sum);
    y(least) = smallest_eigenvalue(form(y)) - 0.5;
    return raise(all, std::move(y), least, kEnough);
  }

  /// Least eigenvalue of F, and of what its weights must obey; by eigenvalues, where the search had
  /// Cholesky factors. Less its rounding.
  [[nodiscard]] double check(const VectorXd& y) const {
    double least = std::numeric_limits<double>::infinity();
    for (const int k : weights_) least = std::min(least, y(k));
    for (const Product& each : products_)
      least = std::min(
          least, y(each.kappa) - Eigen::JacobiSVD<MatrixXd>(K_of(each, y)).singularValues()(0));
    double size = 0;
    for (std::size_t k = 0; k < forms_.size(); ++k)
      size += std::abs(y(static_cast<Index>(k))) * forms_[k].norm();
    return std::min(least, smallest_eigenvalue(form(y)) - kRounding * size);
  }

  [[nodiscard]] MatrixXd form(const VectorXd& y) const {
    MatrixXd F = MatrixXd::Zero(kDimensions, kDimensions);
    for (std::size_t k = 0; k < forms_.size(); ++k) F += y(static_cast<Index>(k)) * forms_[k];
    return F;
  }

 private:
  /// kappa l_i l_j - z_i' K z_j: its unknowns from `kappa` on, K row by row.
  struct Product {
    int kappa;
    Index rows, columns;
  };

  void add_weight(const MatrixXd& form) {
    weights_.push_back(static_cast<int>(forms_.size()));
    forms_.push_back(form);
  }

  void add_product(const Cone& a, const Cone& b) {
    const MatrixXd plain = -symmetric(a.l * b.l.transpose());
    if (a.Z.rows() + b.Z.rows() == 0) return add_weight(plain);
    const MatrixXd A = rows_of(a), B = rows_of(b);
    products_.push_back({static_cast<int>(forms_.size()), A.rows(), B.rows()});
    forms_.push_back(plain);
    for (Index i = 0; i < A.rows(); ++i)
      for (Index j = 0; j < B.rows(); ++j)
        forms_.push_back(symmetric(A.row(i).transpose() * B.row(j)));
  }

  [[nodiscard]] static MatrixXd K_of(const Product& product, const VectorXd& y) {
    MatrixXd K(product.rows, product.columns);
    for (Index i = 0; i < K.rows(); ++i)
      for (Index j = 0; j < K.cols(); ++j) K(i, j) = y(product.kappa + 1 + i * K.cols() + j);
    return K;
  }

  /// [kappa I, K; K', kappa I] positive semidefinite.
  [[nodiscard]] static MatrixInequality bound_of(const Product& product) {
    const Index n = product.rows + product.columns;
    MatrixInequality bound{MatrixXd::Zero(n, n), {{product.kappa, MatrixXd::Identity(n, n)}}};
    for (Index i = 0; i < product.rows; ++i)
      for (Index j = 0; j < product.columns; ++j) {
        MatrixXd one = MatrixXd::Zero(n, n);
        one(i, product.rows + j) = one(product.rows + j, i) = 1;
        bound.terms.emplace_back(product.kappa + 1 + static_cast<int>(i * product.columns + j),
                                 one);
      }
    return bound;
  }

  [[nodiscard]] static double smallest_eigenvalue(const MatrixXd& X) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(X, Eigen::EigenvaluesOnly).eigenvalues()(0);
  }

  std::vector<MatrixXd> forms_;  // one an unknown
  std::vector<int> weights_;     // unknowns that are >= 0
  std::vector<Product> products_;
};

/// Across the directions that F, with its barrier, leaves in doubt: their mean and the way they lie
/// farthest apart from (F - least I)^-1, which is their second moment.
Cone cut_of(const MatrixXd& F, double least) {
  const MatrixXd one = MatrixXd::Identity(kDimensions, kDimensions);
  const MatrixXd moment = (F - least * one).ldlt().solve(one);
  const Wrench mean = moment.col(kTime).head<6>() / moment(kTime, kTime);
  const Eigen::Matrix<double, 6, 6> spread =
      moment.topLeftCorner<6, 6>() / moment(kTime, kTime) - mean * mean.transpose();
  const Wrench w =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(spread).eigenvectors().col(5);
  Cone cut{VectorXd::Zero(kDimensions), MatrixXd(0, kDimensions)};
  cut.l.head<6>() = w;
  cut.l(kTime) = -w.dot(mean);
  return cut;
}

}  // namespace

ReachProof prove_reach(const Support& support, double r, int most_parts) {
  ReachProof proof{false, 0, std::numeric_limits<double>::infinity()};
  const std::size_t caps = support.caps().size();
  if (support.limit() != ForceLimit::kL1 || caps == 0 || caps > kMostProofCaps || !(r > 0))
    return proof;
  std::vector<std::vector<Cone>> parts{cones_of(support, r)};
  while (!parts.empty()) {
    if (++proof.parts > most_parts) return proof;
    const std::vector<Cone> part = std::move(parts.back());
    parts.pop_back();
    const Problem problem(part);
    const Raised raised = problem.find();
    const double least = raised.reached ? problem.check(raised.y) : 0;
    if (least > 0) {
      proof.residual = std::min(proof.residual, least);
      continue;
    }
    const Cone cut = cut_of(problem.form(raised.y), raised.y(raised.y.size() - 1));
    if (!cut.l.allFinite()) return proof;
    for (const double side : {1.0, -1.0}) {
      parts.push_back(part);
      parts.back().push_back({side * cut.l, cut.Z});
    }
  }
  proof.found = true;
  return proof;
}

}  // namespace thenar::internal
