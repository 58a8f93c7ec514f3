#pragma once

/// Digits that move in closed form, and an index finger with all that its muscles need.

#include <memory>
#include <string>

#include "tendons/linear_tendons.h"
#include "tendons/muscle/simulate.h"
#include "tests/hand/sample_subjects.h"

namespace thenar::sample {

inline Segment body(const std::string& name, double mass, const Eigen::Vector3d& com,
                    double inertia) {
  Segment segment = bone(name, Eigen::Vector3d::Zero(), 2 * com, 0);
  segment.mass = mass;
  segment.com = com;
  segment.inertia = inertia * Eigen::Matrix3d::Identity();
  return segment;
}

inline MuscleUnit muscle(const std::string& name, double F0) {
  MuscleUnit unit;
  unit.name = unit.strand = name;
  unit.max_force = F0;
  return unit;
}

/// A rod that hangs along -y from a hinge about z, and one muscle FLX with a constant arm.
struct Pendulum {
  double mass = 0.020;     // [kg]
  double distance = 0.04;  // of its centre from the hinge [m]
  double central = 5e-6;   // moment of inertia about its centre [kg m^2]
  double arm = 0.01;       // [m]
  double F0 = 2;           // [N]

  [[nodiscard]] double inertia() const { return central + mass * distance * distance; }

  [[nodiscard]] Subject subject() const {
    Subject s;
    s.name = "pendulum";
    s.side = "right";
    s.base = "Base";
    s.segments = {bone("Base", {0, 0, 0}, {0, 0, 0}, 0),
                  body("Rod", mass, {0, -distance, 0}, central)};
    s.joints = {hinge("J1", "Base", "Rod", {0, 0, 1}, {0, 0, 0})};
    Strand strand;
    strand.name = "FLX";
    strand.arms = {{"J1", arm}};
    s.strands = {strand};
    s.muscles = {muscle("FLX", F0)};
    s.digits = {digit("index", "Rod", {0, -2 * distance, 0})};
    return s;
  }
};

/// The index finger of data/subjects, with a slack length of every tendon.
/// Muscles alone, or with the passive moments of its joints.
inline Subject index_finger(PassiveMoments passive = PassiveMoments::kOff) {
  Subject s = with_passive(
      read_subject(std::string(THENAR_DATA_DIR) + "/subjects/an_chao_index.toml"), passive);
  for (MuscleUnit& unit : s.muscles) unit.tendon_slack = 0.2;  // [m]
  return s;
}

/// One digit with its muscles on one rung.
struct Mover {
  Mover(const Subject& subject, Muscle rung, const HillOptions& hill = {})
      : tendons(build_linear_tendons(subject, subject.digits.front().name)),
        contraction(
            build_contraction(musculotendons(subject, tendons->digit(), rung), rung, hill)) {}

  [[nodiscard]] MotionModel model() const { return {*tendons, *contraction}; }
  [[nodiscard]] Eigen::Index joints() const { return tendons->digit().model.coordinates; }
  [[nodiscard]] Eigen::VectorXd excited(double by) const {
    return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(contraction->muscles().size()), by);
  }

  std::unique_ptr<DigitTendons> tendons;
  std::unique_ptr<Contraction> contraction;
};

}  // namespace thenar::sample
