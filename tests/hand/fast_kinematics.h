#pragma once

/// The chain of hand/chain.h on doubles, for a whole hand at once and without the heap:
/// poses of all links and position Jacobians of all tips.
///
/// It runs on any x86-64 and takes AVX2 where the processor has it; both give the same bits.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "hand/skeleton.h"

namespace thenar {

/// Which instructions to use.
enum class InstructionSet {
  kBest,      // whatever this processor offers
  kBaseline,  // what every x86-64 has
  kAvx2       // four doubles at a time; the processor must have it
};

inline constexpr int kMaxFastHinges = 32;  // that a hand may have here
inline constexpr int kMaxFastTips = 6;     // that a hand may have here

/// All links and tips at one posture.
class FastHandPose {
 public:
  using Jacobian = Eigen::Map<const Eigen::Matrix3Xd, Eigen::Aligned16, Eigen::OuterStride<4>>;

  /// Displacement of link `i` from the reference posture.
  [[nodiscard]] Pose<double> link(int i) const {
    const Eigen::Map<const Eigen::Matrix<double, 4, 4>> X(X_[i].front().data());
    return {X.topLeftCorner<3, 3>(), X.topRightCorner<3, 1>()};
  }
  /// Where the tip of digit `k` of Skeleton::tips is [m] (3).
  [[nodiscard]] Eigen::Vector3d tip(int k) const {
    return Eigen::Map<const Eigen::Vector3d>(tip_[k].data());
  }
  /// Position Jacobian of tip `k` (3, coordinates) [m/rad]; a view, valid as long as this hand.
  [[nodiscard]] Jacobian tip_jacobian(int k) const {
    return {J_[k].front().data(), 3, coordinates_};
  }

 private:
  friend class FastKinematics;
  using Column = std::array<double, 4>;  // a vector and a fourth number of no meaning

  FastHandPose() {}  // NOLINT(modernize-use-equals-default): `= default` would zero 10 kB

  alignas(32) std::array<std::array<Column, 4>, kMaxFastHinges> X_;  // columns of [R p]
  alignas(32) std::array<std::array<Column, kMaxFastHinges>, kMaxFastTips> J_;
  alignas(32) std::array<Column, kMaxFastTips> tip_;
  int coordinates_;
};

/// Constant once built; may be shared by threads.
class FastKinematics {
 public:
  /// @throws InputError if there are more than kMaxFastHinges hinges or kMaxFastTips tips, or
  ///   the processor has no AVX2 though it was asked for.
  explicit FastKinematics(const Skeleton& skeleton, InstructionSet simd = InstructionSet::kBest);

  /// @param q  (coordinates) [rad]
  /// @throws InputError if q has the wrong length.
  [[nodiscard]] FastHandPose pose(const Eigen::Ref<const Eigen::VectorXd>& q) const;

 private:
  using Column = FastHandPose::Column;

  /// One hinge.
  struct alignas(32) Turn {
    Column direction;  // reference posture
    Column point;      // reference posture [m]
    int parent;        // -1: the base
  };
  /// angle = ratio * q[coordinate] + offset of one hinge.
  struct Drive {
    int coordinate;
    double ratio;   // [rad/rad]
    double offset;  // [rad]
  };
  /// A tip and the range of movers_ that it has.
  struct alignas(32) Tip {
    Column p;  // reference posture [m]
    int link;  // -1: the base
    int first, last;
  };
  /// A hinge between a tip and the base.
  struct Mover {
    int hinge, coordinate;
    double ratio;  // [rad/rad]
  };
  struct Angles;

  template <typename V>
  void run(Angles& angles, FastHandPose& hand) const;
  void run_baseline(Angles& angles, FastHandPose& hand) const;
  void run_avx2(Angles& angles, FastHandPose& hand) const;

  std::vector<Turn> turns_;    // of every hinge
  std::vector<Drive> drives_;  // of every hinge
  std::vector<Tip> tips_;
  std::vector<Mover> movers_;  // of all tips in a row
  int coordinates_;
  bool avx2_;
};

}  // namespace thenar
