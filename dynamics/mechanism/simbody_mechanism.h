#pragma once

/// A mechanism as bodies and joints of Simbody, to which others add forces and contacts.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace SimTK {
class MultibodySystem;
class SimbodyMatterSubsystem;
class State;
template <int M, class E, int Stride>
class Vec;
template <class P>
class Transform_;
}  // namespace SimTK

namespace thenar {
namespace internal {

// Vectors and poses of ours as Simbody's, and back.

[[nodiscard]] SimTK::Vec<3, double, 1> to_simbody(const Eigen::Vector3d& v);
[[nodiscard]] SimTK::Transform_<double> to_simbody(const Pose<double>& X);
[[nodiscard]] Eigen::Vector3d from_simbody(const SimTK::Vec<3, double, 1>& v);
[[nodiscard]] Pose<double> from_simbody(const SimTK::Transform_<double>& X);

}  // namespace internal

/// Bodies, joints and couplings of a mechanism in a Simbody System, whose topology is not realized.
/// Simbody's number of a body is ours + 1, and 0 of the world. Joints that share a coordinate are
/// held together by constraints on the first of them that follows it linearly.
class SimbodyMechanism {
 public:
  /// @throws InputError as check_mechanism(), if no joint follows a shared coordinate linearly, or
  /// naming the body whose mass or inertia Simbody refuses.
  explicit SimbodyMechanism(const Mechanism& mechanism);
  ~SimbodyMechanism();
  SimbodyMechanism(SimbodyMechanism&&) noexcept;
  SimbodyMechanism& operator=(SimbodyMechanism&&) noexcept;

  [[nodiscard]] SimTK::MultibodySystem& system() const;
  [[nodiscard]] SimTK::SimbodyMatterSubsystem& matter() const;
  [[nodiscard]] const Mechanism& mechanism() const;
  [[nodiscard]] const MechanismLayout& layout() const;

  /// Joint that turns by a coordinate linearly.
  [[nodiscard]] int leader(int coordinate) const;

  /// Writes positions and speeds into a state. @param q  (q);  @param v  (v)
  void write(const Eigen::VectorXd& q, const Eigen::VectorXd& v, SimTK::State& state) const;
  /// Reads them; quaternions have length 1. @param q  (q);  @param v  (v)
  void read(const SimTK::State& state, Eigen::VectorXd& q, Eigen::VectorXd& v) const;

  /// A speed of ours, coordinates by the joint that leads:  Simbody's = ratio times ours.
  struct Speed {
    int theirs = 0, ours = 0;  // entries of both vectors
    double ratio = 1;          // [1], [m/rad] or [rad/m]
  };
  /// All speeds of ours.
  [[nodiscard]] std::vector<Speed> speeds(const SimTK::State& state) const;
  /// Matrix N of all speeds of Simbody,  N v.
  [[nodiscard]] Eigen::MatrixXd speed_map(const SimTK::State& state) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
