#include "grasp/limits/drive_torques.h"

#include <algorithm>

#include "base/numbers.h"
#include "grasp/limits/joint_limits.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// Maximum lag of a coupled joint behind its drive, in units of the drive.
constexpr double kMaxCoupledLag = 1e-6;

/// One drive: its column of B, and the reactions that it adds.
class OneDrive {
 public:
  OneDrive(const Drive& drive, const VectorXd& q, Reactions& reactions)
      : drive_(drive), q_(q), reactions_(reactions) {}

  VectorXd torque() {
    if (!drive_.backdrivable) hold();
    return drive_.coupling == DriveCoupling::kBreakaway ? through_clutches() : shared();
  }

 private:
  [[nodiscard]] VectorXd unit(int coordinate) const {
    return VectorXd::Unit(q_.size(), coordinate);
  }

  /// Locks the coordinates of drives that do not move; others only cannot be driven back.
  void hold() {
    for (const DrivenCoordinate& move : drive_.moves)
      if (drive_.speed == 0)
        add_reaction(reactions_, unit(move.coordinate), -kInfinity, kInfinity);
      else
        reactions_.non_backdrivable.push_back(move.coordinate);
  }

  /// Returns tau = u r / (r'r) for unit effort.
  [[nodiscard]] VectorXd shared() const {
    VectorXd column = VectorXd::Zero(q_.size());
    for (const DrivenCoordinate& move : drive_.moves) column(move.coordinate) = move.ratio;
    return column / column.squaredNorm();
  }

  /// Returns the torque of unit effort at the outermost coupled joint, and adds reactions of
  /// clutches.
  VectorXd through_clutches() {
    const double closing = drive_.speed < 0 ? -1 : 1;
    const auto travel = [&](const DrivenCoordinate& move) {
      return closing * q_(move.coordinate) / move.ratio;
    };
    // Joints at the drive's farthest position are coupled; the last of them is the outermost.
    double farthest = -kInfinity;
    for (const DrivenCoordinate& move : drive_.moves) farthest = std::max(farthest, travel(move));
    const DrivenCoordinate* outermost = nullptr;
    for (const DrivenCoordinate& move : drive_.moves)
      if (travel(move) >= farthest - kMaxCoupledLag) outermost = &move;
    // Clutches of all other joints take their torques; the outermost gets the rest.
    for (const DrivenCoordinate& move : drive_.moves)
      if (&move != outermost)
        add_clutch(move, *outermost, travel(move) >= farthest - kMaxCoupledLag, closing);
    return unit(outermost->coordinate) / outermost->ratio;
  }

  /// Adds the torque c of one joint as a reaction of its clutch, which is closed or open.
  void add_clutch(const DrivenCoordinate& move, const DrivenCoordinate& outermost, bool coupled,
                  double closing) {
    VectorXd torque = unit(move.coordinate);
    // A coupled joint takes its torque from that of the outermost.
    if (coupled) torque(outermost.coordinate) -= move.ratio / outermost.ratio;
    const double back = coupled && drive_.backdrivable ? drive_.breakaway : 0;
    const bool rises = closing * move.ratio > 0;  // whether the joint closes upwards
    add_reaction(reactions_, torque, rises ? -back : -drive_.breakaway,
                 rises ? drive_.breakaway : back);
  }

  const Drive& drive_;
  const VectorXd& q_;
  Reactions& reactions_;
};

}  // namespace

DriveTorques drive_torques(const HandLayout& layout, const VectorXd& q) {
  DriveTorques torques;
  torques.B.resize(q.size(), static_cast<Eigen::Index>(layout.drives.size()));
  torques.reactions.R.resize(q.size(), 0);
  for (std::size_t k = 0; k < layout.drives.size(); ++k)
    torques.B.col(k) = OneDrive(layout.drives[k], q, torques.reactions).torque();
  return torques;
}

}  // namespace thenar
