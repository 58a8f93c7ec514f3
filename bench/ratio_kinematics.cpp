// Poses of all links and five tip Jacobians of a hand of 21 hinges, against plain Simbody.

#include <Simbody.h>

#include "bench/ratios.h"
#include "tests/hand/fast_kinematics.h"
#include "tests/hand/sample_subjects.h"

namespace thenar::bench {
namespace {

SimTK::Vec3 vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Simbody used as its manual says: one call for all five Jacobians, which is its fastest way.
class PlainSimbody {
 public:
  explicit PlainSimbody(const Skeleton& skeleton) : matter_(system_) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(1)));
    for (const Hinge<double>& hinge : skeleton.tree) {
      const SimTK::Transform X(
          SimTK::Rotation(SimTK::UnitVec3(vec3(hinge.direction)), SimTK::ZAxis), vec3(hinge.point));
      SimTK::MobilizedBody::Pin(
          matter_.updMobilizedBody(SimTK::MobilizedBodyIndex(hinge.parent + 1)), X, body, X);
    }
    for (const SkeletonTip& tip : skeleton.tips) {
      bodies_.push_back(SimTK::MobilizedBodyIndex(tip.link + 1));
      stations_.push_back(vec3(tip.p));
    }
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    for (std::size_t i = 0; i < skeleton.tree.size(); ++i)
      column_.push_back(matter_.getMobilizedBody(SimTK::MobilizedBodyIndex(static_cast<int>(i) + 1))
                            .getFirstQIndex(state_));
  }

  /// One Vec3 per tip and pin.
  const SimTK::Matrix_<SimTK::Vec3>& jacobians(const Eigen::VectorXd& q) {
    for (std::size_t i = 0; i < column_.size(); ++i)
      state_.updQ()[column_[i]] = q[static_cast<Eigen::Index>(i)];
    system_.realize(state_, SimTK::Stage::Position);
    matter_.calcStationJacobian(state_, bodies_, stations_, J_);
    return J_;
  }

  [[nodiscard]] SimTK::Vec3 element(int tip, int hinge) const {
    return J_(tip, column_[static_cast<std::size_t>(hinge)]);
  }

  [[nodiscard]] SimTK::Vec3 link(int i) const {
    return matter_.getMobilizedBody(SimTK::MobilizedBodyIndex(i + 1)).getBodyOriginLocation(state_);
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::State state_;
  SimTK::Array_<SimTK::MobilizedBodyIndex> bodies_;
  SimTK::Array_<SimTK::Vec3> stations_;
  SimTK::Matrix_<SimTK::Vec3> J_;
  std::vector<int> column_;  // of each hinge
};

/// What FastKinematics answers, from the templated chain that fits run on jets.
struct ChainPose {
  TreeState<double> links;
  std::vector<Eigen::Matrix3Xd> jacobians;

  [[nodiscard]] const Pose<double>& link(int i) const { return links[i].X; }
  [[nodiscard]] const Eigen::Matrix3Xd& tip_jacobian(int t) const { return jacobians[t]; }
};

ChainPose chain_pose(const Skeleton& skeleton, const Eigen::VectorXd& q) {
  ChainPose pose{pose_tree(skeleton.tree, q), {}};
  pose.jacobians.reserve(skeleton.tips.size());
  for (const SkeletonTip& tip : skeleton.tips)
    pose.jacobians.push_back(position_jacobian(skeleton.tree, pose.links, tip.link,
                                               moved(pose.links, tip.link, tip.p),
                                               skeleton.coordinates()));
  return pose;
}

template <typename Hand>
double difference(const Hand& hand, const PlainSimbody& simbody, int hinges, int tips) {
  double error = 0;
  for (int i = 0; i < hinges; ++i)
    for (int k = 0; k < 3; ++k) {
      error = std::max(error, std::abs(hand.link(i).p[k] - simbody.link(i)[k]));
      for (int t = 0; t < tips; ++t)
        error = std::max(error, std::abs(hand.tip_jacobian(t)(k, i) - simbody.element(t, i)[k]));
    }
  return error;
}

/// The task, done by pose(q), against plain Simbody on the same postures.
template <typename PoseAt>
Row against_simbody(const std::string& name, double required, const Skeleton& skeleton,
                    const PoseAt& pose) {
  const int hinges = static_cast<int>(skeleton.tree.size());
  PlainSimbody simbody(skeleton);
  sample::Draw draw(2);
  std::vector<Eigen::VectorXd> postures;
  for (int i = 0; i < 64; ++i) postures.push_back(draw.posture(skeleton));

  Duel duel{name, {}, {}, required, 0, 1e-12};
  for (const Eigen::VectorXd& q : postures) {
    (void)simbody.jacobians(q);
    duel.error = std::max(duel.error, difference(pose(q), simbody, hinges, 5));
  }
  duel.ours = [&, i = 0U]() mutable { keep(pose(postures[i++ % 64])); };
  duel.rival = [&, i = 0U]() mutable { keep(simbody.jacobians(postures[i++ % 64])); };
  return measure(duel);
}

}  // namespace

Row ratio_kinematics() {
  const Skeleton skeleton = build_skeleton(sample::random_hand(1, 1));
  const FastKinematics fast(skeleton);
  return against_simbody("poses and 5 tip Jacobians, 21 hinges", 40, skeleton,
                         [&](const Eigen::VectorXd& q) { return fast.pose(q); });
}

Row ratio_chain() {
  const Skeleton skeleton = build_skeleton(sample::random_hand(1, 1));
  return against_simbody("the same on the templated chain", 0, skeleton,
                         [&](const Eigen::VectorXd& q) { return chain_pose(skeleton, q); });
}

}  // namespace thenar::bench
