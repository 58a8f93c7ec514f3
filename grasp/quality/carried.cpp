#include "grasp/quality/carried.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "grasp/quality/force_set.h"
#include "grasp/quality/stops.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Whether a number is no more than rounding beside the torques of unit forces.
constexpr double kNoTorque = 1e-12;

/// Shares of a row that are no more than rounding [1].
constexpr double kForceRounding = 1e-8;

/// A coordinate presses where its normal lever is no less than this share of its longest, and than
/// half of the best such share among all coordinates [1].
constexpr double kAlong = 1e-3, kAsWell = 0.5;

/// Which coordinates do work on forces that cancel out on the object. Others, like an arm's, move
/// all contacts as one body would.
std::vector<bool> squeezing(const WrenchSet& set, const MatrixXd& T) {
  std::vector<bool> squeezing(static_cast<std::size_t>(T.rows()), false);
  if (T.size() == 0) return squeezing;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(free_forces(set).wrench.transpose());
  qr.setThreshold(kForceRounding);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(T.cols(), qr.rank());
  const MatrixXd internal = T - (T * Q) * Q.transpose();
  for (Index j = 0; j < T.rows(); ++j)
    squeezing[static_cast<std::size_t>(j)] =
        internal.row(j).norm() > kForceRounding * T.row(j).norm();
  return squeezing;
}

/// One contact, as its joints feel it: torques (coordinates, size).
class OneContact {
 public:
  OneContact(const MatrixXd& torques, const Reactions& reactions,
             const std::vector<bool>& squeezing, double zero)
      : torques_(torques), reactions_(reactions), squeezing_(squeezing), zero_(zero) {
    for (Index j = 0; j < torques.rows(); ++j)
      if (!is_locked(reactions, j)) least_along_ = std::max(least_along_, kAsWell * along(j));
  }

  [[nodiscard]] Carried carried() const {
    Carried found{Carrier::kStructure, -1, 0, torques_.cols(), VectorXd::Zero(torques_.rows())};
    for (const int j : reactions_.held)
      if (along(j) >= least_along_) found.presser = std::max(found.presser, j);
    if (found.presser < 0)
      for (const int j : reactions_.held)
        if (feels(j)) found.presser = std::max(found.presser, j);
    bool pressed = false;
    for (Index j = 0; j < torques_.rows(); ++j) {
      if (!presses(j, found.presser)) continue;
      found.levers(j) = std::copysign(longest_lever(j), torques_(j, 0));
      pressed = true;
    }
    if (pressed) found.by = found.presser >= 0 ? Carrier::kWorm : Carrier::kEffort;
    if (pressed || found.presser >= 0) return found;
    found.presser = longest_stop();
    if (found.presser >= 0) found.by = Carrier::kStop;
    return found;
  }

 private:
  [[nodiscard]] bool feels(Index j) const { return torques_.row(j).cwiseAbs().maxCoeff() > zero_; }
  [[nodiscard]] double longest_lever(Index j) const {
    return std::max(std::abs(torques_(j, 0)), torques_.row(j).tail(torques_.cols() - 1).norm());
  }
  /// How much of what a coordinate does here is along the normal [1]; 0 if it squeezes nothing.
  [[nodiscard]] double along(Index j) const {
    if (!squeezing_[static_cast<std::size_t>(j)] || !feels(j)) return 0;
    return std::abs(torques_(j, 0)) / longest_lever(j);
  }
  [[nodiscard]] bool is_stopped(Index j) const {
    return along(j) > kAlong && bears_torque(reactions_, j, torques_(j, 0));
  }

  /// Whether the effort at a coordinate presses the contact. @param worm  that does, or -1
  [[nodiscard]] bool presses(Index j, int worm) const {
    if (along(j) < least_along_ || is_locked(reactions_, j)) return false;
    const auto& held = reactions_.held;
    if (std::find(held.begin(), held.end(), j) != held.end()) return j == worm;
    return !is_stopped(j);
  }

  /// Of the coordinates on stops that the normal force pushes them to, that with the longest lever.
  [[nodiscard]] int longest_stop() const {
    int longest = -1;
    for (Index j = 0; j < torques_.rows(); ++j)
      if (!is_locked(reactions_, j) && is_stopped(j) &&
          (longest < 0 || std::abs(torques_(j, 0)) > std::abs(torques_(longest, 0))))
        longest = static_cast<int>(j);
    return longest;
  }

  const MatrixXd& torques_;
  const Reactions& reactions_;
  const std::vector<bool>& squeezing_;
  double zero_, least_along_ = kAlong;
};

/// Splits the forces of one contact between what is pressed and what is borne.
void split(Felt& felt, const std::vector<int>& held, const Carried& carried) {
  VectorXd borne = felt.x.col(carried.first);
  for (const int j : held) {
    borne(j) = 0;
    if (j != carried.presser) felt.x.row(j).segment(carried.first, carried.size).setZero();
  }
  felt.p.conservativeResize(felt.x.rows(), felt.p.cols() + 1);
  felt.p.rightCols(1) = borne;
}

}  // namespace

Felt felt_by(const WrenchSet& set, const MatrixXd& T, const Reactions& reactions) {
  const double zero = T.size() > 0 ? kNoTorque * T.cwiseAbs().maxCoeff() : 0;
  const std::vector<bool> does_work = squeezing(set, T);
  Felt felt{T, MatrixXd(T.rows(), 0), {}, {}, {}};
  Index first = 0;
  for (const WrenchCap& cap : set.caps) {
    const Index size = 1 + cap.A.cols();
    const MatrixXd torques = T.middleCols(first, size);
    Carried carried = OneContact(torques, reactions, does_work, zero).carried();
    carried.first = first;
    if (carried.by != Carrier::kEffort) {
      split(felt, reactions.held, carried);
      felt.borne.push_back(static_cast<int>(felt.contacts.size()));
    }
    felt.contacts.push_back(carried);
    first += size;
  }
  for (int j = 0; j < T.rows(); ++j) {
    const double x = felt.x.cols() > 0 ? felt.x.row(j).cwiseAbs().maxCoeff() : 0;
    const double p = felt.p.cols() > 0 ? felt.p.row(j).cwiseAbs().maxCoeff() : 0;
    if (std::max(x, p) > zero) felt.rows.push_back(j);
  }
  return felt;
}

}  // namespace thenar::internal
