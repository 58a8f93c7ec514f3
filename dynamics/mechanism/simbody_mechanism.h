#pragma once

/// Conversion of a mechanism to a Simbody multibody system, for further forces and contacts.

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

// Conversions of vectors and poses to and from Simbody's types.

[[nodiscard]] SimTK::Vec<3, double, 1> to_simbody(const Eigen::Vector3d& v);
[[nodiscard]] SimTK::Transform_<double> to_simbody(const Pose<double>& X);
[[nodiscard]] Eigen::Vector3d from_simbody(const SimTK::Vec<3, double, 1>& v);
[[nodiscard]] Pose<double> from_simbody(const SimTK::Transform_<double>& X);

}  // namespace internal

/// Simbody System with the bodies, joints and couplings of a mechanism; its topology is not
/// realized yet. Simbody's index of a body is the mechanism's + 1; the world is 0. Joints that
/// share a coordinate are coupled by constraints to the first of them that follows it linearly.
class SimbodyMechanism {
 public:
  /// Builds the Simbody system. @throws InputError as check_mechanism(); if no joint follows a
  /// shared coordinate linearly; if Simbody refuses the mass or inertia of a body, with its name.
  explicit SimbodyMechanism(const Mechanism& mechanism);
  ~SimbodyMechanism();
  SimbodyMechanism(SimbodyMechanism&&) noexcept;
  SimbodyMechanism& operator=(SimbodyMechanism&&) noexcept;

  [[nodiscard]] SimTK::MultibodySystem& system() const;
  [[nodiscard]] SimTK::SimbodyMatterSubsystem& matter() const;
  [[nodiscard]] const Mechanism& mechanism() const;
  [[nodiscard]] const MechanismLayout& layout() const;

  /// Returns the leading joint of a coordinate: the first that follows it linearly.
  [[nodiscard]] int leader(int coordinate) const;

  /// Writes positions and velocities into a Simbody state. @param q  (q);  @param v  (v)
  void write_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v, SimTK::State& state) const;
  /// Reads positions and velocities, and normalises quaternions. @param q  (q);  @param v  (v)
  void read_state(const SimTK::State& state, Eigen::VectorXd& q, Eigen::VectorXd& v) const;

  /// Correspondence of a velocity of the mechanism to Simbody's:  theirs = ratio times ours.  A
  /// coordinate corresponds to the velocity of its leading joint.
  struct Speed {
    int theirs = 0, ours = 0;  // entries of both velocity vectors
    double ratio = 1;          // [1], [m/rad] or [rad/m]
  };
  /// Returns the correspondence of all velocities of the mechanism.
  [[nodiscard]] std::vector<Speed> speeds(const SimTK::State& state) const;
  /// Computes the matrix N of Simbody's velocities  u = N v  (u, v).
  [[nodiscard]] Eigen::MatrixXd speed_map(const SimTK::State& state) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
