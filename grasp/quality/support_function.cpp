#include "grasp/quality/support_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

#include "base/lists.h"

namespace thenar::internal {

SupportFunction::SupportFunction(const WrenchSet& set, ForceNorm limit) : limit_(limit) {
  // Sort caps by contact, in the order of the first cap of each.
  std::vector<bool> taken(set.caps.size(), false);
  int contacts = 0;
  for (std::size_t i = 0; i < set.caps.size(); ++i) {
    double largest = 0;
    for (std::size_t j = i; j < set.caps.size() && !taken[i]; ++j) {
      const WrenchCap& cap = set.caps[j];
      if (j != i && (taken[j] || cap.contact < 0 || cap.contact != set.caps[i].contact)) continue;
      caps_.push_back({cap.c.vector(), Eigen::Matrix<double, 6, 3>::Zero(),
                       static_cast<int>(cap.A.cols()), contacts, false});
      caps_.back().A.leftCols(cap.A.cols()) = cap.A;
      largest = std::max(largest, cap.c.norm() + cap.A.norm());
      if (j != i) taken[j] = true;
    }
    if (taken[i]) continue;
    caps_.back().last_of_contact = true;
    ++contacts;
    // Size of the set: the largest cap of a contact, or their sum.
    max_norm_ = limit == ForceNorm::kL1 ? std::max(max_norm_, largest) : max_norm_ + largest;
  }
  rounding_ = 32 * std::numeric_limits<double>::epsilon() * max_norm_;
}

double SupportFunction::reach(const Cap& cap, const WrenchCoordinates& u) {
  double square = 0;
  for (int k = 0; k < cap.axes; ++k) {
    const double a = cap.A.col(k).dot(u);
    square += a * a;
  }
  return cap.c.dot(u) + std::sqrt(square);
}

void SupportFunction::add_point(const Cap& cap, const WrenchCoordinates& u,
                                WrenchCoordinates& sum) {
  sum += cap.c;
  Eigen::Vector3d z = Eigen::Vector3d::Zero();
  for (int k = 0; k < cap.axes; ++k) z(k) = cap.A.col(k).dot(u);
  const double length = z.norm();
  if (length == 0) return;  // every point of the cap is as good
  for (int k = 0; k < cap.axes; ++k) sum += z(k) / length * cap.A.col(k);
}

SupportPoint SupportFunction::operator()(const WrenchCoordinates& u) const {
  constexpr double kNoSupport = -std::numeric_limits<double>::infinity();
  SupportPoint out{0, WrenchCoordinates::Zero()};
  const Cap* best = nullptr;
  double best_reach = kNoSupport;
  // Best cap of each contact; Linf sums those with positive support.
  for (const Cap& cap : caps_) {
    const double h = reach(cap, u);
    if (h > best_reach) {
      best_reach = h;
      best = &cap;
    }
    if (limit_ == ForceNorm::kL1 || !cap.last_of_contact) continue;
    if (best_reach > 0) {
      out.h += best_reach;
      add_point(*best, u, out.p);
    }
    best_reach = kNoSupport;
  }
  if (limit_ == ForceNorm::kL1 && best != nullptr) {
    out.h = best_reach;
    add_point(*best, u, out.p);
  }
  return out;
}

namespace {

/// Unit vector that is orthogonal to the first `count` columns, near the axis least along these.
WrenchCoordinates across(const Eigen::Matrix<double, 6, 6>& basis, int count) {
  const auto used = basis.leftCols(count);
  Eigen::Index axis = 0;
  used.rowwise().squaredNorm().minCoeff(&axis);
  WrenchCoordinates u = WrenchCoordinates::Unit(axis);
  // Twice is enough: Gram-Schmidt to rounding.
  for (int again = 0; again < 2; ++again) u = (u - used * (used.transpose() * u)).normalized();
  return u;
}

}  // namespace

WrenchSpan span_of(const WrenchSet& set) {
  // All centres and semi-axes as columns; rank by singular values.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(wrench_columns(set), Eigen::ComputeFullU);
  const Eigen::VectorXd& sigma = svd.singularValues();
  return {static_cast<int>((sigma.array() > kWrenchRankTolerance * sigma(0)).count()),
          svd.matrixU()};
}

FirstSimplex first_simplex(const SupportFunction& support, double flat) {
  FirstSimplex out{{}, false, 1};
  out.points[0] = support(WrenchCoordinates::Unit(0)).p;
  Eigen::Matrix<double, 6, 6> basis = Eigen::Matrix<double, 6, 6>::Zero();
  for (int k = 0; k < 6; ++k) {
    // Extent across the affine hull of the points so far.
    const WrenchCoordinates u = across(basis, k);
    const WrenchCoordinates plus = support(u).p, minus = support(-u).p;
    out.supports += 2;
    const double rise = u.dot(plus - out.points[0]), fall = u.dot(out.points[0] - minus);
    if (std::max(rise, fall) <= flat * support.max_norm()) return out;
    const std::size_t next = static_cast<std::size_t>(k) + 1;
    out.points[next] = rise > fall ? plus : minus;
    // Extend its orthonormal basis by the new edge.
    WrenchCoordinates edge = out.points[next] - out.points[0];
    const auto used = basis.leftCols(k);
    for (int again = 0; again < 2; ++again) edge -= used * (used.transpose() * edge);
    basis.col(k) = edge.normalized();
  }
  out.found = true;
  return out;
}

namespace {

constexpr int kMaxPolishSteps = 30;  // maximum number of steps of a polish
constexpr int kMaxColumns = 20;      // maximum number of columns of a polish
constexpr double kLastStep = 1e-9;   // Length of a last step: the next would be its square [rad]
constexpr double kMaxSupportStep = 0.2;  // Longest step [rad]
constexpr double kNearCap = 0.3;     // caps this close to the best, relative to it, take part [1]
constexpr double kKinkShare = 0.05;  // |A'u| below this share of |A| is held at 0 [1]
// Minimum |A'u| over |A| in the first attempt, in which facets may hold a whole cap [1]
constexpr double kSharpShare = 1e-6;
// Constraints closer to each other's span are dependent [1]
constexpr double kDependentDistance = 1e-9;
constexpr double kFlatCurve = 1e-12;  // curvatures below this share of the size are zero [1]

// Unknowns of the polish: direction u and value t.
using PolishPoint = Eigen::Matrix<double, 7, 1>;
using Columns = Eigen::Matrix<double, 7, Eigen::Dynamic, 0, 7, kMaxColumns>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxColumns, 1>;
using Reduced = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;
using ReducedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;

enum class Role { kOut, kTight, kCounted };

/// Support of a cap at u; for contacts with a limit of their own, of their best cap.
struct Piece {
  const SupportFunction::Cap* cap = nullptr;
  double h = 0;
  Eigen::Vector3d z{0, 0, 0};  // A'u
  double length = 0;           // |A'u|
  bool kink = false;
  Role role = Role::kOut;
};

/// Minimiser of x'M x / 2 + g'x with the absolute values of all curvatures.
ReducedVector descend(const Reduced& M, const ReducedVector& g, double size) {
  const Eigen::LLT<Reduced> positive(M);
  // Positive definite: a Newton step.
  if (positive.info() == Eigen::Success && positive.rcond() > kFlatCurve) return positive.solve(-g);
  // Otherwise turn negative curvatures round and skip flat ones.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd{M});
  ReducedVector x = -(eigen.eigenvectors().transpose() * g);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double curve = std::abs(eigen.eigenvalues()(i));
    x(i) = curve > kFlatCurve * size ? x(i) / curve : 0;
  }
  return eigen.eigenvectors() * x;
}

/// Newton's method on the sphere for a local minimum of the support, with an active set of caps.
class Polish {
 public:
  Polish(const SupportFunction& support, const WrenchCoordinates& u, bool kinks)
      : support_(support), l1_(support.limit() == ForceNorm::kL1), kinks_(kinks), u_(u) {
    look();
    best_ = u;
    best_h_ = value_;
    choose_roles();
  }

  /// @returns whether a last step was short
  bool run() {
    bool grown = false;  // caps taken in at this place may not be released at once
    for (int i = 0; i < kMaxPolishSteps && build(); ++i) {
      // Multipliers of the active constraints by least squares.
      Eigen::ColPivHouseholderQR<Columns> qr(columns_);
      qr.setThreshold(kDependentDistance);
      const Values multipliers = qr.solve(-slope_);
      // A constraint with a multiplier out of bounds leaves the active set.
      if (!grown && release(multipliers)) continue;
      const WrenchCoordinates before = u_;
      const double length = move(qr, multipliers);
      if (!std::isfinite(length)) return false;
      look();
      // Keep the best direction met.
      const bool better = value_ < best_h_;
      if (better) {
        best_h_ = value_;
        best_ = u_;
      }
      // Caps that went beyond their bounds enter; a step that only found these is undone.
      grown = overtaken();
      if (!grown && length < kLastStep) return true;
      if (!grown || better) continue;
      u_ = before;
      look();
    }
    return false;
  }

  [[nodiscard]] bool has_kinks() const {
    return any_of(pieces_, [](const Piece& p) {
      return p.role != Role::kOut && !p.kink && is_kink(p, kKinkShare);
    });
  }
  [[nodiscard]] double best_value() const { return best_h_; }
  [[nodiscard]] const WrenchCoordinates& best() const { return best_; }

 private:
  /// Support of every piece at u, and the value of the whole set.
  void look() {
    std::size_t k = 0;
    bool first = true;
    double largest = -1e300, sum = 0;
    for (const SupportFunction::Cap& cap : support_.caps()) {
      if (k == pieces_.size()) pieces_.emplace_back();
      const Eigen::Vector3d z = cap.A.transpose() * u_;
      const double length = z.norm(), h = cap.c.dot(u_) + length;
      Piece& piece = pieces_[k];
      // Of the caps of one contact only the best counts.
      if (first || h > piece.h) {
        piece.cap = &cap;
        piece.h = h;
        piece.z = z;
        piece.length = length;
      }
      first = l1_ || cap.last_of_contact;
      if (!first) continue;
      largest = std::max(largest, piece.h);
      sum += std::max(0.0, piece.h);
      ++k;
    }
    value_ = l1_ ? largest : sum;
  }

  [[nodiscard]] static bool is_kink(const Piece& piece, double part) {
    return piece.cap->axes > 0 && piece.length < part * piece.cap->A.norm();
  }

  /// First active set: caps near the value (L1), or near 0 (Linf).
  void choose_roles() {
    const double near = kNearCap * std::abs(value_);
    for (Piece& piece : pieces_) {
      if (l1_)
        piece.role = piece.h >= value_ - near ? Role::kTight : Role::kOut;
      else if (std::abs(piece.h) < near)
        piece.role = Role::kTight;
      else
        piece.role = piece.h > 0 ? Role::kCounted : Role::kOut;
      piece.kink = is_kink(piece, kinks_ ? kKinkShare : kSharpShare);
    }
  }

  /// Gradient of h: c + A A'u / |A'u|, without the second part at a kink.
  [[nodiscard]] static WrenchCoordinates slope(const Piece& piece) {
    if (piece.kink || piece.length == 0) return piece.cap->c;
    return piece.cap->c + piece.cap->A * (piece.z / piece.length);
  }

  /// Adds the constraint of a tight piece: its support is the value (L1), or 0 (Linf).
  void constrain(const Piece& piece) {
    columns_.col(count_) << slope(piece), l1_ ? -1.0 : 0.0;
    values_(count_++) = piece.h - (l1_ ? value_ : 0) - (piece.kink ? piece.length : 0);
  }

  /// Builds the constraints, each a column, and the gradient of the objective. @returns false if
  /// there are too many columns
  bool build() {
    columns_.resize(7, kMaxColumns);
    values_.resize(kMaxColumns);
    slope_ = PolishPoint::Zero();
    slope_(6) = l1_ ? 1 : 0;
    // Unit length of u; under Linf t is not used.
    columns_.col(0) << u_, 0;
    columns_.col(1) = l1_ ? PolishPoint(PolishPoint::Zero()) : PolishPoint(PolishPoint::Unit(6));
    values_.head<2>().setZero();
    count_ = 2;
    for (const Piece& piece : pieces_) {
      if (piece.role == Role::kOut) continue;
      if (count_ + 4 > kMaxColumns) return false;
      // Tight pieces are constraints, counted ones part of the objective.
      if (piece.role == Role::kTight)
        constrain(piece);
      else
        slope_.head<6>() += slope(piece);
      // A kink holds A'u at zero.
      for (int k = 0; piece.kink && k < piece.cap->axes; ++k) {
        columns_.col(count_) << piece.cap->A.col(k), 0;
        values_(count_++) = piece.z(k);
      }
    }
    columns_.conservativeResize(7, count_);
    values_.conservativeResize(count_);
    return true;
  }

  /// Calls f(piece, index of its multiplier or -1) for all pieces that take part.
  template <typename F>
  void each(F f) {
    Eigen::Index k = 2;
    for (Piece& piece : pieces_) {
      if (piece.role == Role::kOut) continue;
      f(piece, piece.role == Role::kTight ? k++ : -1);
      if (piece.kink) k += piece.cap->axes;
    }
  }

  /// Changes the role of the constraint whose multiplier is farthest out of bounds.
  bool release(const Values& multipliers) {
    double worst = 1e-9;
    Piece* gone = nullptr;
    Role role = Role::kOut;
    each([&](Piece& piece, Eigen::Index k) {
      if (k < 0) return;
      const double below = -multipliers(k), above = l1_ ? 0 : multipliers(k) - 1;
      if (std::max(below, above) <= worst) return;
      worst = std::max(below, above);
      gone = &piece;
      role = above > below ? Role::kCounted : Role::kOut;
    });
    if (gone != nullptr) gone->role = role;
    return gone != nullptr;
  }

  /// Hessian of the Lagrangian along u.
  Eigen::Matrix<double, 6, 6> hessian(const Values& multipliers) {
    Eigen::Matrix<double, 6, 6> H = multipliers(0) * Eigen::Matrix<double, 6, 6>::Identity();
    each([&](const Piece& piece, Eigen::Index k) {
      if (piece.kink || piece.length == 0) return;
      const double weight = (k < 0 ? 1 : multipliers(k)) / piece.length;
      const WrenchCoordinates a = piece.cap->A * (piece.z / piece.length);
      H.noalias() += weight * (piece.cap->A * piece.cap->A.transpose());
      H.noalias() -= weight * a * a.transpose();
    });
    return H;
  }

  /// One Newton step. @returns its length [rad]
  double move(const Eigen::ColPivHouseholderQR<Columns>& qr, const Values& multipliers) {
    // Part along the constraints: meets them to first order.
    const Eigen::Index rank = qr.rank();
    const Eigen::Matrix<double, 7, 7> Q = qr.householderQ();
    const Values wanted = -(qr.colsPermutation().transpose() * values_);
    const ReducedVector along = qr.matrixQR()
                                    .topLeftCorner(rank, rank)
                                    .template triangularView<Eigen::Upper>()
                                    .transpose()
                                    .solve(wanted.head(rank));
    PolishPoint d = Q.leftCols(rank) * along;
    // Part in their null space: minimum of the quadratic model.
    if (rank < 7) {
      const auto Z = Q.rightCols(7 - rank);
      const Eigen::Matrix<double, 6, 6> H = hessian(multipliers);
      PolishPoint pull = slope_;
      pull.head<6>() += H * d.head<6>();
      const Reduced M = Z.topRows<6>().transpose() * H * Z.topRows<6>();
      d += Z * descend(M, Z.transpose() * pull, support_.max_norm());
    }
    // Limited step on the sphere.
    const double length = d.head<6>().norm();
    u_ = (u_ + std::min(1.0, kMaxSupportStep / length) * d.head<6>()).normalized();
    return std::min(length, kMaxSupportStep);
  }

  /// Includes pieces that went beyond their bounds. @returns whether there are any
  bool overtaken() {
    const double beyond = support_.rounding();
    // L1: the level is the highest tight piece; Linf: zero.
    double level = 0;
    if (l1_) {
      level = -1e300;
      for (const Piece& piece : pieces_)
        if (piece.role == Role::kTight) level = std::max(level, piece.h);
    }
    bool any = false;
    for (Piece& piece : pieces_) {
      const bool out = piece.role == Role::kOut && piece.h > level + beyond;
      const bool in = piece.role == Role::kCounted && piece.h < level - beyond;
      if (!out && !in) continue;
      piece.role = Role::kTight;
      any = true;
    }
    return any;
  }

  const SupportFunction& support_;
  bool l1_, kinks_;
  std::vector<Piece> pieces_;
  WrenchCoordinates u_, best_;
  double value_ = 0, best_h_ = 0;
  Columns columns_;
  Values values_;
  PolishPoint slope_;
  Eigen::Index count_ = 0;
};

}  // namespace

WrenchCoordinates descend_support(const SupportFunction& support, const WrenchCoordinates& u) {
  // First without kinks; if some are near, again with A'u held at 0 there.
  Polish smooth(support, u, false);
  if (smooth.run() || !smooth.has_kinks()) return smooth.best();
  Polish sharp(support, smooth.best(), true);
  (void)sharp.run();
  return sharp.best();
}

}  // namespace thenar::internal
