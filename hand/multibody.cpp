#include "hand/multibody.h"

#include <utility>

#include <Simbody.h>

#include "base/error.h"

namespace thenar {
namespace {

using SpatialVectors = SimTK::Vector_<SimTK::SpatialVec>;

SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d to_eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::Vector to_simbody(const Eigen::VectorXd& v) {
  return SimTK::Vector(static_cast<int>(v.size()), v.data());
}

Eigen::VectorXd to_eigen(const SimTK::Vector& v) {
  return Eigen::VectorXd::NullaryExpr(v.size(),
                                      [&](Eigen::Index i) { return v[static_cast<int>(i)]; });
}

Eigen::MatrixXd to_eigen(const SimTK::Matrix& m) {
  return Eigen::MatrixXd::NullaryExpr(m.nrow(), m.ncol(), [&](Eigen::Index i, Eigen::Index j) {
    return m(static_cast<int>(i), static_cast<int>(j));
  });
}

/// Computes a frame whose z axis, about which a pin turns, is the hinge.
SimTK::Transform hinge_frame(const Hinge<double>& hinge) {
  const SimTK::UnitVec3 z(to_simbody(hinge.direction));
  return {SimTK::Rotation(z, SimTK::ZAxis), to_simbody(hinge.point)};
}

/// Builds a body whose frame is the base frame at the reference posture.
SimTK::Body::Rigid rigid_body(const LinkMass& body) {
  if (body.mass == 0)
    return SimTK::Body::Rigid(SimTK::MassProperties(0, SimTK::Vec3(0), SimTK::Inertia(0)));
  const Eigen::Matrix3d& I = body.inertia;
  const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  const SimTK::Vec3 com = to_simbody(body.com);
  return SimTK::Body::Rigid(
      SimTK::MassProperties(body.mass, com, central.shiftFromMassCenter(-com, body.mass)));
}

/// Returns for each link whether it moves a mass (links).
std::vector<bool> carries_mass(const Skeleton& skeleton) {
  std::vector<bool> carries(skeleton.tree.size());
  for (int i = static_cast<int>(skeleton.tree.size()) - 1; i >= 0; --i) {
    carries[i] = carries[i] || skeleton.masses[i].mass > 0;
    const int parent = skeleton.tree[i].parent;
    if (carries[i] && parent >= 0) carries[parent] = true;
  }
  return carries;
}

}  // namespace

struct Multibody::Parts {
  Parts(Skeleton s, Passive p) : skeleton(std::move(s)), passive(p), matter(system) {
    // Add the pins, then couplings between them.
    for (std::size_t i = 0; i < skeleton.tree.size(); ++i)
      add_pin(skeleton.tree[i], skeleton.masses[i]);
    for (std::size_t i = 0; i < skeleton.tree.size(); ++i) couple(static_cast<int>(i));
    state = system.realizeTopology();
    system.realizeModel(state);
    map_coordinates();
  }

  /// Adds a body on a pin joint.
  void add_pin(const Hinge<double>& hinge, const LinkMass& mass) {
    const SimTK::Transform X = hinge_frame(hinge);
    SimTK::MobilizedBody& parent = matter.updMobilizedBody(body(hinge.parent));
    SimTK::MobilizedBody::Pin(parent, X, rigid_body(mass), X);
  }

  /// Returns whether a hinge turns by its coordinate itself, rather than as a follower.
  [[nodiscard]] bool leads(int i) const {
    return skeleton.hinge_names[i] == skeleton.coordinate_names[skeleton.tree[i].coordinate];
  }

  /// Adds the constraint of a follower,  0 = ratio * leader - follower + offset.
  void couple(int i) {
    if (leads(i)) return;
    const Hinge<double>& hinge = skeleton.tree[i];
    // Find the hinge that turns by the coordinate itself.
    int leader = 0;
    while (skeleton.tree[leader].coordinate != hinge.coordinate || !leads(leader)) ++leader;
    // Add a linear constraint between both pin angles.
    const SimTK::Array_<SimTK::MobilizedBodyIndex> bodies{body(leader), body(i)};
    const SimTK::Array_<SimTK::MobilizerQIndex> angles(2, SimTK::MobilizerQIndex(0));
    const SimTK::Vector coefficients(SimTK::Vec3(hinge.ratio, -1, hinge.offset));
    SimTK::Constraint::CoordinateCoupler(matter, new SimTK::Function::Linear(coefficients), bodies,
                                         angles);  // owns the function
  }

  /// Maps coordinates to pin angles,  N q + offset,  in Simbody's order of the pins.
  void map_coordinates() {
    const auto hinges = static_cast<Eigen::Index>(skeleton.tree.size());
    N = Eigen::MatrixXd::Zero(hinges, skeleton.coordinates());
    offset = Eigen::VectorXd::Zero(hinges);
    leader_of.assign(skeleton.coordinates(), 0);
    // Fill the rows in Simbody's order.
    for (Eigen::Index i = 0; i < hinges; ++i) {
      const Hinge<double>& hinge = skeleton.tree[i];
      const int row = matter.getMobilizedBody(body(static_cast<int>(i))).getFirstUIndex(state);
      N(row, hinge.coordinate) = hinge.ratio;
      offset[row] = hinge.offset;
      if (leads(static_cast<int>(i))) leader_of[hinge.coordinate] = row;
    }
  }

  /// Returns Simbody's index of a link.
  static SimTK::MobilizedBodyIndex body(int link) { return SimTK::MobilizedBodyIndex(link + 1); }

  void require_length(const char* name, const Eigen::Ref<const Eigen::VectorXd>& v) const {
    require(v.size() == skeleton.coordinates(), "the skeleton has {} coordinates, {} has {}",
            skeleton.coordinates(), name, v.size());
  }

  void require_link(int link) const {
    const int links = static_cast<int>(skeleton.tree.size());
    require(link >= -1 && link < links, "no link {}; there are {}", link, links);
  }

  /// Sets the posture.
  void set(const Eigen::Ref<const Eigen::VectorXd>& q) {
    require_length("q", q);
    state.updQ() = to_simbody(Eigen::VectorXd(N * q + offset));
    system.realize(state, SimTK::Stage::Position);
  }

  /// Sets posture and speeds.
  void set(const JointMotion& motion) {
    set(motion.q);
    require_length("q_dot", motion.q_dot);
    state.updU() = to_simbody(Eigen::VectorXd(N * motion.q_dot));
    system.realize(state, SimTK::Stage::Velocity);
  }

  /// Throws unless the inertia of every link is known, which dynamics needs; weights need mass
  /// only.
  void require_inertia() const {
    for (const LinkMass& link : skeleton.masses)
      require(link.segment_without_inertia.empty(),
              "segment '{}' has mass but neither moments of inertia nor a radius",
              link.segment_without_inertia);
  }

  /// Computes weights and forces on every body, about its origin.
  [[nodiscard]] SpatialVectors body_forces(const Loads& loads) const {
    SpatialVectors F(matter.getNumBodies(), SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
    const auto add = [&](int link, const Eigen::Vector3d& p, const Eigen::Vector3d& f_W) {
      matter.getMobilizedBody(body(link))
          .applyForceToBodyPoint(state, to_simbody(p), to_simbody(f_W), F);
    };
    // Add weights at the centres of mass.
    for (std::size_t i = 0; i < skeleton.masses.size(); ++i)
      add(static_cast<int>(i), skeleton.masses[i].com, skeleton.masses[i].mass * loads.gravity);
    // Add forces at their points.
    for (const PointForce& force : loads.forces) {
      require_link(force.link);
      add(force.link, force.p, force.f_W);
    }
    return F;
  }

  /// Computes the torque of springs and dampers.
  [[nodiscard]] Eigen::VectorXd passive_torque(const JointMotion& motion) const {
    Eigen::VectorXd tau = Eigen::VectorXd::Zero(skeleton.coordinates());
    if (passive == Passive::kOff) return tau;
    tau = thenar::passive_torque(skeleton, motion.q);
    for (int i = 0; i < skeleton.coordinates(); ++i)
      tau[i] -= skeleton.limits[i].damping * motion.q_dot[i];
    return tau;
  }

  Skeleton skeleton;
  Passive passive;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::State state;
  Eigen::MatrixXd N;           // pin angles per coordinate [rad/rad] (hinges, coordinates)
  Eigen::VectorXd offset;      // offset of the pin angles [rad] (hinges)
  std::vector<int> leader_of;  // pin that turns by the coordinate itself (coordinates)
};

Multibody::Multibody(const Skeleton& skeleton, Passive passive)
    : parts_(std::make_unique<Parts>(skeleton, passive)) {}
Multibody::~Multibody() = default;
Multibody::Multibody(Multibody&&) noexcept = default;
Multibody& Multibody::operator=(Multibody&&) noexcept = default;

std::vector<Pose<double>> Multibody::pose(const Eigen::Ref<const Eigen::VectorXd>& q) {
  parts_->set(q);
  std::vector<Pose<double>> poses(parts_->skeleton.tree.size());
  // Copy Simbody's transforms: they are displacements, since body frames start at the base.
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const SimTK::Transform& X = parts_->matter.getMobilizedBody(Parts::body(static_cast<int>(i)))
                                    .getBodyTransform(parts_->state);
    for (int k = 0; k < 3; ++k) poses[i].R.col(k) = to_eigen(SimTK::Vec3(X.R().col(k)));
    poses[i].p = to_eigen(X.p());
  }
  return poses;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> Multibody::jacobian(
    const Eigen::Ref<const Eigen::VectorXd>& q, int link, const Eigen::Vector3d& p) {
  parts_->require_link(link);
  parts_->set(q);
  SimTK::Matrix J;
  parts_->matter.calcFrameJacobian(parts_->state, Parts::body(link), to_simbody(p), J);
  return to_eigen(J) * parts_->N;
}

Eigen::VectorXd Multibody::load_torque(const Eigen::Ref<const Eigen::VectorXd>& q,
                                       const Loads& loads) {
  parts_->set(q);
  SimTK::Vector tau;
  parts_->matter.multiplyBySystemJacobianTranspose(parts_->state, parts_->body_forces(loads), tau);
  return parts_->N.transpose() * to_eigen(tau);
}

Eigen::MatrixXd Multibody::mass_matrix(const Eigen::Ref<const Eigen::VectorXd>& q) {
  parts_->require_inertia();
  parts_->set(q);
  SimTK::Matrix M;
  parts_->matter.calcM(parts_->state, M);
  return parts_->N.transpose() * to_eigen(M) * parts_->N;
}

double Multibody::kinetic_energy(const JointMotion& motion) {
  parts_->require_inertia();
  parts_->set(motion);
  return parts_->matter.calcKineticEnergy(parts_->state);
}

Eigen::VectorXd Multibody::inverse_dynamics(const JointMotion& motion,
                                            const Eigen::Ref<const Eigen::VectorXd>& q_ddot,
                                            const Loads& loads) {
  parts_->require_inertia();
  parts_->set(motion);
  parts_->require_length("q_ddot", q_ddot);
  SimTK::Vector tau;
  parts_->matter.calcResidualForceIgnoringConstraints(
      parts_->state, SimTK::Vector(), parts_->body_forces(loads),
      to_simbody(Eigen::VectorXd(parts_->N * q_ddot)), tau);
  return parts_->N.transpose() * to_eigen(tau) - parts_->passive_torque(motion);
}

Eigen::VectorXd Multibody::forward_dynamics(const JointMotion& motion,
                                            const Eigen::Ref<const Eigen::VectorXd>& tau,
                                            const Loads& loads) {
  parts_->require_inertia();
  parts_->set(motion);
  parts_->require_length("tau", tau);
  const std::vector<bool> carries = carries_mass(parts_->skeleton);
  for (std::size_t i = 0; i < carries.size(); ++i)
    require(carries[i], "joint '{}' moves nothing that has mass", parts_->skeleton.hinge_names[i]);
  parts_->system.realize(parts_->state, SimTK::Stage::Dynamics);

  // Apply the torques to the leaders; constraints move the followers.
  const Eigen::VectorXd total = tau + parts_->passive_torque(motion);
  SimTK::Vector on_pins(static_cast<int>(parts_->skeleton.tree.size()), 0.0), u_dot;
  for (Eigen::Index i = 0; i < total.size(); ++i) on_pins[parts_->leader_of[i]] = total[i];
  SpatialVectors A;
  parts_->matter.calcAcceleration(parts_->state, on_pins, parts_->body_forces(loads), u_dot, A);

  // Read the accelerations of the leaders.
  Eigen::VectorXd q_ddot(total.size());
  for (Eigen::Index i = 0; i < total.size(); ++i) q_ddot[i] = u_dot[parts_->leader_of[i]];
  return q_ddot;
}

}  // namespace thenar
