#include "grasp/quality/support_proof.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "base/numbers.h"
#include "base/stop_scope.h"
#include "solvers/matrix_inequality.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Minimum eigenvalue of F for a set of size 1 [1]
constexpr double kMinEigenvalue = 1e-12;
// Rounding of an eigenvalue, over the size of the matrix [1]
constexpr double kProofRounding = 64 * std::numeric_limits<double>::epsilon();
constexpr double kSomeWeight = 0.25;  // least sum of the weights in F, the largest being 1 [1]
constexpr Index kTimeIndex = 6;       // index of t in x = (u, t, levels)
constexpr double kSameCap = 1e-14;    // difference of equal caps, the set's size being 1 [1]

/// Points x with  l'x >= |Z x|; without rows of Z  l'x >= 0.
struct Cone {
  VectorXd l;  // (d)
  MatrixXd Z;  // (k, d)
};

/// Rows that a product with another cone may weigh; for a half space the row l itself.
MatrixXd rows_of(const Cone& cone) {
  return cone.Z.rows() > 0 ? cone.Z : MatrixXd(cone.l.transpose());
}

MatrixXd symmetric(const MatrixXd& X) { return (X + X.transpose()) / 2; }

/// Caps without duplicates. L1, and points of one patch: a second equal cap adds nothing. Linf
/// patches that consist of the same single cap act as one cap, their sum.
std::vector<SupportFunction::Cap> distinct_caps(const SupportFunction& support) {
  const bool linf = support.limit() == ForceNorm::kLinf;
  std::vector<SupportFunction::Cap> kept, first;  // `first`: the first of equal ones, unsummed
  std::vector<int> patch_size(support.caps().size(), 0);
  for (const SupportFunction::Cap& cap : support.caps()) ++patch_size[cap.contact];
  const auto alone = [&](const SupportFunction::Cap& cap) { return patch_size[cap.contact] == 1; };
  for (const SupportFunction::Cap& cap : support.caps()) {
    // Caps are interchangeable if they are equal and their limits may be joined.
    const auto same =
        std::find_if(first.begin(), first.end(), [&](const SupportFunction::Cap& other) {
          const bool joined = !linf || other.contact == cap.contact || (alone(other) && alone(cap));
          return joined && other.axes == cap.axes &&
                 (other.c - cap.c).norm() + (other.A - cap.A).norm() <=
                     kSameCap * support.max_norm();
        });
    if (same == first.end()) {
      kept.push_back(cap);
      first.push_back(cap);
      // Two patches of one cap: their limits add up.
    } else if (linf && same->contact != cap.contact) {
      SupportFunction::Cap& sum = kept[same - first.begin()];
      sum.c += cap.c;
      sum.A += cap.A;
    }
  }
  return kept;
}

/// Upper levels of the caps where the set does not reach r. L1: r t for each cap. Linf: levels >=
/// 0, one for each contact, whose sum is r t.
std::vector<VectorXd> levels_of(const std::vector<SupportFunction::Cap>& caps, double r,
                                ForceNorm limit) {
  const VectorXd all = r * VectorXd::Unit(kTimeIndex + 1, kTimeIndex);
  if (limit == ForceNorm::kL1) return std::vector<VectorXd>(caps.size(), all);
  const bool two = caps.size() > 1 && caps[0].contact != caps[1].contact;
  if (!two) return std::vector<VectorXd>(caps.size(), all);
  const VectorXd level = VectorXd::Unit(kTimeIndex + 2, kTimeIndex + 1);
  return {level, r * VectorXd::Unit(kTimeIndex + 2, kTimeIndex) - level};
}

/// Cones of the directions in which the set does not reach r; all sizes divided by that of the set.
std::vector<Cone> cones_of(const std::vector<SupportFunction::Cap>& caps,
                           const SupportFunction& support, double r) {
  // Caps that distinct_caps() merged may reach less by its rounding.
  const double margin = kSameCap * static_cast<double>(support.caps().size());
  const std::vector<VectorXd> levels =
      levels_of(caps, r / support.max_norm() + margin, support.limit());
  const Index d = levels[0].size();
  std::vector<Cone> cones;
  // |A'u| < level - c'u for each cap.
  for (std::size_t i = 0; i < caps.size(); ++i) {
    Cone cone{levels[i], MatrixXd::Zero(caps[i].axes, d)};
    cone.l.head<6>() -= caps[i].c / support.max_norm();
    cone.Z.leftCols<6>() = caps[i].A.leftCols(caps[i].axes).transpose() / support.max_norm();
    cones.push_back(std::move(cone));
  }
  // Levels of Linf are not negative.
  if (d > kTimeIndex + 1)
    for (const VectorXd& level : levels) cones.push_back({level, MatrixXd(0, d)});
  return cones;
}

/// The quadratic forms that F consists of, and the constraints of their weights.
class Problem {
 public:
  explicit Problem(const std::vector<Cone>& cones) : d_(cones[0].l.size()) {
    // Squares of cones, then products of pairs.
    for (const Cone& cone : cones)
      if (cone.Z.rows() > 0) add_weight(cone.Z.transpose() * cone.Z - cone.l * cone.l.transpose());
    for (std::size_t i = 0; i < cones.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) add_product(cones[i], cones[j]);
    // Half spaces also with the ball |u| <= t.
    const Cone ball{VectorXd::Unit(d_, kTimeIndex), MatrixXd::Identity(6, d_)};
    for (const Cone& cone : cones)
      if (cone.Z.rows() == 0) add_product(cone, ball);
    // |u|^2 - t^2 is zero: its weight has any sign.
    VectorXd sphere = VectorXd::Zero(d_);
    sphere.head<6>().setOnes();
    sphere(kTimeIndex) = -1;
    forms_.emplace_back(sphere.asDiagonal());
  }

  /// Weights for which F is positive definite, or its least eigenvalue as large as possible.
  [[nodiscard]] MaximisedComponent find() const {
    const int least = static_cast<int>(forms_.size());  // the unknown below all eigenvalues of F
    // Matrix inequality F(y) >= least I.
    MatrixInequality F{MatrixXd::Zero(d_, d_), {}};
    for (int k = 0; k < least; ++k) F.terms.emplace_back(k, forms_[k]);
    F.terms.emplace_back(least, -MatrixXd::Identity(d_, d_));
    // A multiple of F proves the same: the sum of weights is kept of order 1, so that an F that is
    // not positive definite does not shrink to 0.
    MatrixInequality sum{MatrixXd::Ones(1, 1), {}}, some{-kSomeWeight * MatrixXd::Ones(1, 1), {}};
    std::vector<MatrixInequality> all{F};
    const auto add_to_sum = [&](int k) {
      sum.terms.emplace_back(k, -MatrixXd::Ones(1, 1));
      some.terms.emplace_back(k, MatrixXd::Ones(1, 1));
    };
    VectorXd y = VectorXd::Zero(least + 1);
    // Each weight is positive, and each product has |K| <= kappa.
    for (const int k : weights_) {
      all.push_back({MatrixXd::Zero(1, 1), {{k, MatrixXd::Ones(1, 1)}}});
      add_to_sum(k);
      y(k) = 0.5 / static_cast<double>(weights_.size() + products_.size());
    }
    for (const Product& each : products_) {
      all.push_back(bound_of(each));
      add_to_sum(each.kappa);
      y(each.kappa) = 0.5 / static_cast<double>(weights_.size() + products_.size());
    }
    // Start inside: equal weights, and least below the eigenvalues.
    all.push_back(sum);
    all.push_back(some);
    y(least) = smallest_eigenvalue(form(y)) - 0.5;
    return maximise_component(all, std::move(y), least, kMinEigenvalue);
  }

  /// Returns the smallest eigenvalue of F and of the constraints of its weights, less their
  /// rounding errors. Recomputed by eigenvalues, where the search had Cholesky factors.
  [[nodiscard]] double check(const VectorXd& y) const {
    if (!y.allFinite()) return kNaN;
    // Constraints of the weights.
    double least = kInfinity;
    for (const int k : weights_) least = min_or_nan(least, y(k));
    for (const Product& each : products_)
      least = min_or_nan(
          least, y(each.kappa) - Eigen::JacobiSVD<MatrixXd>(K_of(each, y)).singularValues()(0));
    // F itself, less the rounding of its sum.
    double size = 0;
    for (std::size_t k = 0; k < forms_.size(); ++k)
      size += std::abs(y(static_cast<Index>(k))) * forms_[k].norm();
    return min_or_nan(least, smallest_eigenvalue(form(y)) - kProofRounding * size);
  }

  [[nodiscard]] MatrixXd form(const VectorXd& y) const {
    MatrixXd F = MatrixXd::Zero(d_, d_);
    for (std::size_t k = 0; k < forms_.size(); ++k) F += y(static_cast<Index>(k)) * forms_[k];
    return F;
  }

 private:
  /// kappa l_i l_j - z_i' K z_j: its unknowns start at `kappa`, then K row by row.
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

  // NOLINTNEXTLINE(readability-identifier-naming): K of the inequality below
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

  Index d_;                      // size of x
  std::vector<MatrixXd> forms_;  // one for each unknown
  std::vector<int> weights_;     // unknowns that are >= 0
  std::vector<Product> products_;
};

/// Second moment of the points x that F, with its barrier, leaves unproven; that of t is 1.
MatrixXd doubts_of(const MatrixXd& F, double least) {
  const MatrixXd one = MatrixXd::Identity(F.rows(), F.cols());
  const MatrixXd moment = (F - least * one).ldlt().solve(one);
  return moment / moment(kTimeIndex, kTimeIndex);
}

/// Returns a half space across the unproven points, through their mean, in the direction in which
/// they lie farthest apart.
Cone cut_of(const MatrixXd& doubts) {
  const Index d = doubts.rows();
  const VectorXd mean = doubts.col(kTimeIndex);
  const MatrixXd spread = doubts - mean * mean.transpose();
  const VectorXd w = Eigen::SelfAdjointEigenSolver<MatrixXd>(spread).eigenvectors().col(d - 1);
  Cone cut{w, MatrixXd(0, d)};
  cut.l(kTimeIndex) = w(kTimeIndex) - w.dot(mean);
  return cut;
}

/// The unproven direction of least support, descended from the mean and from the main directions.
WrenchCoordinates least_of(const SupportFunction& support, const MatrixXd& doubts) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> main(MatrixXd(doubts.topLeftCorner<6, 6>()));
  std::vector<WrenchCoordinates> ways{doubts.col(kTimeIndex).head<6>()};
  for (const int k : {5, 4})
    for (const double sign : {1.0, -1.0}) ways.emplace_back(sign * main.eigenvectors().col(k));
  WrenchCoordinates best = WrenchCoordinates::Unit(0);
  double least = kInfinity;
  for (const WrenchCoordinates& way : ways) {
    if (!(way.norm() > 0) || !way.allFinite()) continue;
    const WrenchCoordinates u = descend_support(support, way.normalized());
    if (const double h = support(u).h; h < least) {
      least = h;
      best = u;
    }
  }
  return best;
}

}  // namespace

SupportProof prove_support(const SupportFunction& support, double r, int max_parts) {
  SupportProof proof{false, 0, kInfinity, {}};
  // Only a few different caps can be proven.
  const std::vector<SupportFunction::Cap> caps = distinct_caps(support);
  if (caps.empty() || caps.size() > kMaxProofCaps || !(r > 0)) return proof;
  std::vector<std::vector<Cone>> parts{cones_of(caps, support, r)};
  // Parts of the sphere, each until a proof or a counterexample is found.
  while (!parts.empty()) {
    if (++proof.parts > max_parts) return proof;
    end_if_stopped();
    const std::vector<Cone> part = std::move(parts.back());
    parts.pop_back();
    // Positive definite F: this part is proven.
    const Problem problem(part);
    const MaximisedComponent raised = problem.find();
    const double least = raised.reached ? problem.check(raised.y) : 0;
    if (least > 0) {
      proof.residual = std::min(proof.residual, least);
      continue;
    }
    // A direction below r refutes the claim.
    const MatrixXd doubts = doubts_of(problem.form(raised.y), raised.y(raised.y.size() - 1));
    if (!doubts.allFinite()) return proof;
    if (const WrenchCoordinates u = least_of(support, doubts);
        support(u).h + support.rounding() < r) {
      proof.below = u;
      return proof;
    }
    // Cut the part in two.
    const Cone cut = cut_of(doubts);
    for (const double side : {1.0, -1.0}) {
      parts.push_back(part);
      parts.back().push_back({side * cut.l, cut.Z});
    }
  }
  proof.found = true;
  return proof;
}

}  // namespace thenar::internal
