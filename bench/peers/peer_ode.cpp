// Scenes in the Open Dynamics Engine.

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <ode/ode.h>

#include "base/error.h"
#include "bench/peers/peer_scene.h"

namespace thenar::bench {
namespace {

using Eigen::Vector3d;

constexpr int kMaxContacts = 16;  // of a pair of shapes
constexpr double kGone = 1e5;     // from the origin [m]
constexpr double kSlips = 1e-9;   // slower contacts have no direction of slip [m/s]

/// How ODE is used.
struct OdeOptions {
  int quick_iterations = 0;  // of dWorldQuickStep; 0: dWorldStep
  bool along_slip = false;   // friction's axes follow the slip
  bool sleep = false;        // bodies at rest are disabled
};

void set_rotation(const Eigen::Matrix3d& R, dMatrix3 out) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) out[4 * i + j] = j < 3 ? R(i, j) : 0;
}

Vector3d vector_of(const dReal* v) { return {v[0], v[1], v[2]}; }

dGeomID geom_of(dSpaceID space, const ShapeSpec& shape) {
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return dCreateSphere(space, shape.size[0]);
    case ShapeKind::kBox:
      return dCreateBox(space, shape.size[0], shape.size[1], shape.size[2]);
    case ShapeKind::kCapsule:
      return dCreateCapsule(space, shape.size[0], shape.size[1]);
    default:
      throw InputError(fmt::format("ODE is not given a {}", name_of(shape.kind)));
  }
}

/// ODE's library, begun once.
void begin() {
  static const bool begun = dInitODE2(0) != 0;
  require(begun, "ODE does not begin");
}

class OdeWorld final : public PeerWorld {
 public:
  OdeWorld(const PeerScene& peer, double step, const OdeOptions& options)
      : scene_(peer.scene), step_(step), options_(options) {
    begin();
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, scene_.gravity.x(), scene_.gravity.y(), scene_.gravity.z());
    if (options.quick_iterations > 0)
      dWorldSetQuickStepNumIterations(world_, options.quick_iterations);
    dWorldSetAutoDisableFlag(world_, options.sleep ? 1 : 0);
    // Joints count from where bodies stand when they are attached: first the reference.
    const std::vector<BodyMotion> reference = motion_at(
        scene_, reference_position(scene_.mechanism), Eigen::VectorXd::Zero(scene_.v.size()));
    for (std::size_t i = 0; i < scene_.mechanism.bodies.size(); ++i) add_body(i, reference);
    for (std::size_t i = 0; i < scene_.mechanism.bodies.size(); ++i) add_joint(i);
    const std::vector<BodyMotion> bodies = motion_at(scene_, peer.rival_q(), scene_.v);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (body_[i] != nullptr) place(i, bodies[i]);
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void step() override {
    t_ += step_;
    if (gone()) return;
    const bool asleep = options_.sleep && all_disabled();
    if (!asleep) {
      apply_efforts();
      dSpaceCollide(space_, this, &OdeWorld::near);
    }
    if (options_.quick_iterations > 0) {
      dWorldQuickStep(world_, step_);
    } else {
      dWorldStep(world_, step_);
    }
    dJointGroupEmpty(contacts_);
  }

  [[nodiscard]] std::vector<BodyMotion> motion() const override {
    std::vector<BodyMotion> out(body_.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = motion_of(i);
    return out;
  }

 private:
  /// ODE's bodies have their origin at the centre of mass.
  void add_body(std::size_t i, const std::vector<BodyMotion>& bodies) {
    const MechanismBody& body = scene_.mechanism.bodies[i];
    const bool fixed = scene_.mechanism.joints[i].kind == JointKind::kWeld;
    body_.push_back(fixed ? nullptr : dBodyCreate(world_));
    fixed_.push_back(bodies[i].X_WB);
    if (!fixed) {
      const Eigen::Matrix3d& I = body.mass.inertia;
      dMass mass;
      dMassSetParameters(&mass, body.mass.mass, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1),
                         I(0, 2), I(1, 2));
      dBodySetMass(body_[i], &mass);
      place(i, bodies[i]);
    }
    for (const ShapeSpec& shape : shapes_of(body)) add_geom(i, shape);
  }

  void add_geom(std::size_t i, const ShapeSpec& shape) {
    const dGeomID geom = geom_of(space_, shape);
    dGeomSetData(geom, reinterpret_cast<void*>(i));
    dMatrix3 R;
    if (body_[i] != nullptr) {
      const Vector3d p = shape.X_BS.p - scene_.mechanism.bodies[i].mass.com;
      dGeomSetBody(geom, body_[i]);
      dGeomSetOffsetPosition(geom, p.x(), p.y(), p.z());
      set_rotation(shape.X_BS.R, R);
      dGeomSetOffsetRotation(geom, R);
      return;
    }
    const Pose<double> X = fixed_[i] * shape.X_BS;
    dGeomSetPosition(geom, X.p.x(), X.p.y(), X.p.z());
    set_rotation(X.R, R);
    dGeomSetRotation(geom, R);
  }

  void place(std::size_t i, const BodyMotion& motion) {
    const Vector3d p = motion.X_WB * scene_.mechanism.bodies[i].mass.com;
    dMatrix3 R;
    set_rotation(motion.X_WB.R, R);
    dBodySetPosition(body_[i], p.x(), p.y(), p.z());
    dBodySetRotation(body_[i], R);
    dBodySetLinearVel(body_[i], motion.linear.x(), motion.linear.y(), motion.linear.z());
    dBodySetAngularVel(body_[i], motion.angular.x(), motion.angular.y(), motion.angular.z());
  }

  void add_joint(std::size_t i) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    joint_.push_back(nullptr);
    if (!is_scalar(joint.kind)) return;
    const bool hinge = joint.kind == JointKind::kHinge;
    joint_[i] = hinge ? dJointCreateHinge(world_, nullptr) : dJointCreateSlider(world_, nullptr);
    const dBodyID parent =
        joint.parent < 0 ? nullptr : body_[static_cast<std::size_t>(joint.parent)];
    dJointAttach(joint_[i], body_[i], parent);
    const Pose<double> X = motion_of(i).X_WB * joint.X_BM;
    const Vector3d axis = X.R.col(2);
    if (hinge) {
      dJointSetHingeAnchor(joint_[i], X.p.x(), X.p.y(), X.p.z());
      dJointSetHingeAxis(joint_[i], axis.x(), axis.y(), axis.z());
    } else {
      dJointSetSliderAxis(joint_[i], axis.x(), axis.y(), axis.z());
    }
  }

  [[nodiscard]] BodyMotion motion_of(std::size_t i) const {
    BodyMotion out;
    out.X_WB = fixed_[i];
    if (body_[i] == nullptr) return out;
    const dReal* R = dBodyGetRotation(body_[i]);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) out.X_WB.R(row, column) = R[4 * row + column];
    out.X_WB.p =
        vector_of(dBodyGetPosition(body_[i])) - out.X_WB.R * scene_.mechanism.bodies[i].mass.com;
    out.linear = vector_of(dBodyGetLinearVel(body_[i]));
    out.angular = vector_of(dBodyGetAngularVel(body_[i]));
    return out;
  }

  void apply_efforts() {
    std::vector<BodyMotion> bodies;
    for (std::size_t i = 0; i < joint_.size(); ++i) {
      if (joint_[i] == nullptr) continue;
      JointMotion at{0, 0};
      if (effort_varies(scene_, i)) {
        if (bodies.empty()) bodies = motion();
        at = joint_motion(scene_.mechanism, i, bodies);
      }
      const double effort = joint_effort(scene_, i, t_ - step_, at);
      if (scene_.mechanism.joints[i].kind == JointKind::kHinge) {
        dJointAddHingeTorque(joint_[i], effort);
      } else {
        dJointAddSliderForce(joint_[i], effort);
      }
    }
  }

  /// Whether a body is so far away, or nowhere, that ODE would abort the program.
  [[nodiscard]] bool gone() const {
    return std::any_of(body_.begin(), body_.end(), [](const dBodyID body) {
      return body != nullptr && !(vector_of(dBodyGetPosition(body)).norm() < kGone);
    });
  }

  [[nodiscard]] bool all_disabled() const {
    for (const dBodyID body : body_)
      if (body != nullptr && dBodyIsEnabled(body) != 0) return false;
    return true;
  }

  static void near(void* data, dGeomID a, dGeomID b) { static_cast<OdeWorld*>(data)->meet(a, b); }

  void meet(dGeomID a, dGeomID b) {
    const auto i = reinterpret_cast<std::size_t>(dGeomGetData(a));
    const auto j = reinterpret_cast<std::size_t>(dGeomGetData(b));
    if (i == j || !may_touch(scene_, i, j)) return;
    std::array<dContactGeom, kMaxContacts> found;
    const int n = dCollide(a, b, kMaxContacts, found.data(), sizeof(dContactGeom));
    for (int k = 0; k < n; ++k) {
      dContact contact{};
      contact.geom = found[static_cast<std::size_t>(k)];
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = scene_.friction.coefficient;
      if (options_.along_slip) turn_along_slip(i, j, contact);
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), body_[i], body_[j]);
    }
  }

  [[nodiscard]] Vector3d velocity(std::size_t i, const dReal* point) const {
    if (body_[i] == nullptr) return Vector3d::Zero();
    dVector3 v;
    dBodyGetPointVel(body_[i], point[0], point[1], point[2], v);
    return vector_of(v);
  }

  /// ODE's friction is a box along two axes; slip along the first one meets the true bound.
  void turn_along_slip(std::size_t i, std::size_t j, dContact& contact) const {
    const Vector3d normal = vector_of(contact.geom.normal);
    Vector3d slip = velocity(i, contact.geom.pos) - velocity(j, contact.geom.pos);
    slip -= normal * normal.dot(slip);
    if (slip.norm() < kSlips) {
      // What would move it, if nothing moves yet.
      slip = scene_.gravity - normal * normal.dot(scene_.gravity);
      if (slip.norm() < kSlips) return;
    }
    slip.normalize();
    contact.surface.mode |= dContactFDir1;
    for (int k = 0; k < 3; ++k) contact.fdir1[k] = slip[k];
  }

  MovingScene scene_;
  double step_, t_ = 0;
  OdeOptions options_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<dBodyID> body_;        // null: fixed
  std::vector<Pose<double>> fixed_;  // of fixed bodies
  std::vector<dJointID> joint_;      // null: free or fixed
};

PeerSetting setting(const std::string& name, PeerUse use, const OdeOptions& options) {
  return stepped<OdeWorld>("ODE", name, use, options);
}

}  // namespace

std::vector<PeerSetting> ode_settings() {
  return {setting("QuickStep 20", PeerUse::kAll, {20, false, false}),
          setting("Step", PeerUse::kAll, {0, false, false}),
          setting("Step, axes along slip", PeerUse::kContacts, {0, true, false}),
          setting("Step, sleep", PeerUse::kContacts, {0, false, true})};
}

}  // namespace thenar::bench
