#include "grasp/quality/polish.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace thenar::internal {
namespace {

constexpr int kMaxPolishSteps = 30;
constexpr int kMostColumns = 20;
constexpr double kDone = 1e-9;    // length of a last step: the next would be its square [rad]
constexpr double kLongest = 0.2;  // of a step [rad]
constexpr double kNear = 0.3;     // caps this close to the best, in parts of it, take part [1]
constexpr double kKink = 0.05;    // |A'u| below this part of |A| is held at 0 [1]
constexpr double kSharp = 1e-6;   // the same at first, as facets that hold a whole cap have 0 [1]
constexpr double kDependent = 1e-9;   // constraints this close to each other's span [1]
constexpr double kFlatCurve = 1e-12;  // curvatures below this part of the size are none [1]

// Directions u with the value t beneath them.
using PolishPoint = Eigen::Matrix<double, 7, 1>;
using Columns = Eigen::Matrix<double, 7, Eigen::Dynamic, 0, 7, kMostColumns>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostColumns, 1>;
using Reduced = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;
using ReducedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;

enum class Role { kOut, kTight, kCounted };

/// What a cap does at u; of the caps of one contact with a limit of its own, the best.
struct Piece {
  const Support::Cap* cap = nullptr;
  double h = 0;
  Eigen::Vector3d z{0, 0, 0};  // A'u
  double length = 0;           // |A'u|
  bool kink = false;
  Role role = Role::kOut;
};

/// Minimises M/2 x^2 + g'x as if all curvatures were positive.
ReducedVector descend(const Reduced& M, const ReducedVector& g, double size) {
  const Eigen::LLT<Reduced> positive(M);
  if (positive.info() == Eigen::Success && positive.rcond() > kFlatCurve) return positive.solve(-g);
  const Eigen::SelfAdjointEigenSolver<Reduced> eigen(M);
  ReducedVector x = -(eigen.eigenvectors().transpose() * g);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double curve = std::abs(eigen.eigenvalues()(i));
    x(i) = curve > kFlatCurve * size ? x(i) / curve : 0;
  }
  return eigen.eigenvectors() * x;
}

class Polish {
 public:
  Polish(const Support& support, const Wrench& u, bool kinks)
      : support_(support), l1_(support.limit() == ForceLimit::kL1), kinks_(kinks), u_(u) {
    look();
    best_ = u;
    best_h_ = value_;
    choose_roles();
  }

  /// @returns whether a last step was short
  bool run() {
    bool grown = false;  // caps taken in at this place may not be released at once
    for (int i = 0; i < kMaxPolishSteps && build(); ++i) {
      Eigen::ColPivHouseholderQR<Columns> qr(columns_);
      qr.setThreshold(kDependent);
      const Values multipliers = qr.solve(-slope_);
      if (!grown && release(multipliers)) continue;
      const Wrench before = u_;
      const double length = move(qr, multipliers);
      if (!std::isfinite(length)) return false;
      look();
      const bool better = value_ < best_h_;
      if (better) {
        best_h_ = value_;
        best_ = u_;
      }
      grown = overtaken();
      if (!grown && length < kDone) return true;
      if (!grown || better) continue;
      u_ = before;
      look();
    }
    return false;
  }

  [[nodiscard]] bool has_kinks() const {
    return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) {
      return p.role != Role::kOut && !p.kink && is_kink(p, kKink);
    });
  }
  [[nodiscard]] double best_value() const { return best_h_; }
  [[nodiscard]] const Wrench& best() const { return best_; }

 private:
  void look() {
    std::size_t k = 0;
    bool first = true;
    double largest = -1e300, sum = 0;
    for (const Support::Cap& cap : support_.caps()) {
      if (k == pieces_.size()) pieces_.emplace_back();
      const Eigen::Vector3d z = cap.A.transpose() * u_;
      const double length = z.norm(), h = cap.c.dot(u_) + length;
      Piece& piece = pieces_[k];
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

  void choose_roles() {
    const double near = kNear * std::abs(value_);
    for (Piece& piece : pieces_) {
      if (l1_)
        piece.role = piece.h >= value_ - near ? Role::kTight : Role::kOut;
      else if (std::abs(piece.h) < near)
        piece.role = Role::kTight;
      else
        piece.role = piece.h > 0 ? Role::kCounted : Role::kOut;
      piece.kink = is_kink(piece, kinks_ ? kKink : kSharp);
    }
  }

  [[nodiscard]] static Wrench slope(const Piece& piece) {
    if (piece.kink || piece.length == 0) return piece.cap->c;
    return piece.cap->c + piece.cap->A * (piece.z / piece.length);
  }

  /// Constraints, each a column, and the slope of the objective. @returns false if there is no room
  bool build() {
    columns_.resize(7, kMostColumns);
    values_.resize(kMostColumns);
    slope_ = PolishPoint::Zero();
    slope_(6) = l1_ ? 1 : 0;
    columns_.col(0) << u_, 0;
    columns_.col(1) = l1_ ? PolishPoint(PolishPoint::Zero()) : PolishPoint(PolishPoint::Unit(6));
    values_.head<2>().setZero();
    count_ = 2;
    for (const Piece& piece : pieces_) {
      if (piece.role == Role::kOut) continue;
      if (count_ + 4 > kMostColumns) return false;
      if (piece.role == Role::kTight) {
        columns_.col(count_) << slope(piece), l1_ ? -1.0 : 0.0;
        values_(count_++) = piece.h - (l1_ ? value_ : 0) - (piece.kink ? piece.length : 0);
      } else {
        slope_.head<6>() += slope(piece);
      }
      for (int k = 0; piece.kink && k < piece.cap->axes; ++k) {
        columns_.col(count_) << piece.cap->A.col(k), 0;
        values_(count_++) = piece.z(k);
      }
    }
    columns_.conservativeResize(7, count_);
    values_.conservativeResize(count_);
    return true;
  }

  /// Calls f(piece, place of its multiplier or -1) for all that take part.
  template <typename F>
  void each(F f) {
    Eigen::Index k = 2;
    for (Piece& piece : pieces_) {
      if (piece.role == Role::kOut) continue;
      f(piece, piece.role == Role::kTight ? k++ : -1);
      if (piece.kink) k += piece.cap->axes;
    }
  }

  /// Gives the constraint whose multiplier is furthest out of bounds a new role.
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
      const Wrench a = piece.cap->A * (piece.z / piece.length);
      H.noalias() += weight * (piece.cap->A * piece.cap->A.transpose());
      H.noalias() -= weight * a * a.transpose();
    });
    return H;
  }

  /// One step. @returns its length [rad]
  double move(const Eigen::ColPivHouseholderQR<Columns>& qr, const Values& multipliers) {
    const Eigen::Index rank = qr.rank();
    const Eigen::Matrix<double, 7, 7> Q = qr.householderQ();
    const Values wanted = -(qr.colsPermutation().transpose() * values_);
    const ReducedVector along = qr.matrixQR()
                                    .topLeftCorner(rank, rank)
                                    .template triangularView<Eigen::Upper>()
                                    .transpose()
                                    .solve(wanted.head(rank));
    PolishPoint d = Q.leftCols(rank) * along;
    if (rank < 7) {
      const auto Z = Q.rightCols(7 - rank);
      const Eigen::Matrix<double, 6, 6> H = hessian(multipliers);
      PolishPoint pull = slope_;
      pull.head<6>() += H * d.head<6>();
      const Reduced M = Z.topRows<6>().transpose() * H * Z.topRows<6>();
      d += Z * descend(M, Z.transpose() * pull, support_.size());
    }
    const double length = d.head<6>().norm();
    u_ = (u_ + std::min(1.0, kLongest / length) * d.head<6>()).normalized();
    return std::min(length, kLongest);
  }

  /// Takes in what went beyond its bounds.
  bool overtaken() {
    const double beyond = support_.rounding();
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

  const Support& support_;
  bool l1_, kinks_;
  std::vector<Piece> pieces_;
  Wrench u_, best_;
  double value_ = 0, best_h_ = 0;
  Columns columns_;
  Values values_;
  PolishPoint slope_;
  Eigen::Index count_ = 0;
};

}  // namespace

Wrench polish(const Support& support, const Wrench& u) {
  Polish smooth(support, u, false);
  if (smooth.run() || !smooth.has_kinks()) return smooth.best();
  Polish sharp(support, smooth.best(), true);
  (void)sharp.run();
  return sharp.best();
}

}  // namespace thenar::internal
