// Scenes in Bullet, in double precision.

#include <cmath>
#include <memory>

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "bench/peers/peer_scene.h"

namespace thenar::bench {
namespace {

using Eigen::Vector3d;

/// How Bullet is used.
struct BulletOptions {
  int iterations = 10;    // of sequential impulses
  bool two_axes = false;  // of friction, instead of the one along the slip
  bool sleep = false;     // bodies at rest are deactivated
};

btVector3 to_bullet(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Vector3d to_eigen(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btTransform to_bullet(const Pose<double>& X) {
  const Eigen::Matrix3d& R = X.R;
  const btMatrix3x3 turn(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                         R(2, 2));
  return btTransform(turn, to_bullet(X.p));
}

Pose<double> to_eigen(const btTransform& X) {
  Pose<double> out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.R(i, j) = X.getBasis()[i][j];
  out.p = to_eigen(X.getOrigin());
  return out;
}

std::unique_ptr<btCollisionShape> bullet_shape(const ShapeSpec& shape) {
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return std::make_unique<btSphereShape>(shape.size[0]);
    case ShapeKind::kBox:
      return std::make_unique<btBoxShape>(to_bullet(0.5 * shape.size));
    case ShapeKind::kCapsule:
      return std::make_unique<btCapsuleShapeZ>(shape.size[0], shape.size[1]);
    default:
      throw InputError(fmt::format("Bullet is not given a {}", name_of(shape.kind)));
  }
}

/// Contacts are asked for as may_touch() says.
struct PairFilter : btOverlapFilterCallback {
  const MovingScene* scene = nullptr;
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const auto index = [](const btBroadphaseProxy* proxy) {
      return static_cast<std::size_t>(
          static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex());
    };
    return may_touch(*scene, index(a), index(b));
  }
};

class BulletWorld final : public PeerWorld {
 public:
  BulletWorld(const PeerScene& peer, double step, const BulletOptions& options)
      : scene_(peer.scene),
        step_(step),
        options_(options),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    filter_.scene = &scene_;
    world_.getPairCache()->setOverlapFilterCallback(&filter_);
    world_.setGravity(to_bullet(scene_.gravity));
    world_.getSolverInfo().m_numIterations = options.iterations;
    if (options.two_axes) world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    const std::vector<BodyMotion> bodies = motion_at(scene_, peer.rival_q(), scene_.v);
    for (std::size_t i = 0; i < bodies.size(); ++i) add_body(i, bodies[i]);
    for (std::size_t i = 0; i < bodies.size(); ++i) add_joint(i);
  }
  ~BulletWorld() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void step() override {
    apply_efforts();
    world_.stepSimulation(step_, 0);
    t_ += step_;
  }

  [[nodiscard]] std::vector<BodyMotion> motion() const override {
    std::vector<BodyMotion> out(bodies_.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].X_WB = to_eigen(bodies_[i]->getCenterOfMassTransform()) * X_BP_[i].inverse();
      out[i].linear = to_eigen(bodies_[i]->getLinearVelocity());
      out[i].angular = to_eigen(bodies_[i]->getAngularVelocity());
    }
    return out;
  }

 private:
  /// Bullet's bodies have principal axes at the centre of mass.
  void add_body(std::size_t i, const BodyMotion& motion) {
    const MechanismBody& body = scene_.mechanism.bodies[i];
    const bool fixed = scene_.mechanism.joints[i].kind == JointKind::kWeld;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(body.mass.inertia);
    Pose<double> X_BP;
    X_BP.p = body.mass.com;
    if (!body.mass.inertia.isDiagonal()) {
      X_BP.R = axes.eigenvectors();
      if (X_BP.R.determinant() < 0) X_BP.R.col(0) *= -1;
    }
    const Eigen::Matrix3d I = X_BP.R.transpose() * body.mass.inertia * X_BP.R;
    X_BP_.push_back(X_BP);
    auto compound = std::make_unique<btCompoundShape>();
    for (const ShapeSpec& shape : shapes_of(body)) {
      shapes_.push_back(bullet_shape(shape));
      compound->addChildShape(to_bullet(X_BP.inverse() * shape.X_BS), shapes_.back().get());
    }
    btRigidBody::btRigidBodyConstructionInfo info(fixed ? 0 : body.mass.mass, nullptr,
                                                  compound.get(), to_bullet(I.diagonal()));
    info.m_friction = std::sqrt(scene_.friction.coefficient);  // of a pair: the product
    shapes_.push_back(std::move(compound));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& rigid = *bodies_.back();
    rigid.setUserIndex(static_cast<int>(i));
    rigid.setCenterOfMassTransform(to_bullet(motion.X_WB * X_BP));
    rigid.setLinearVelocity(to_bullet(motion.linear));
    rigid.setAngularVelocity(to_bullet(motion.angular));
    if (!options_.sleep) rigid.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&rigid);
  }

  /// Slides along an axis of the world are factors, which are exact; all else are constraints.
  void add_joint(std::size_t i) {
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    if (!is_scalar(joint.kind)) return;
    const Pose<double> X_PM = X_BP_[i].inverse() * joint.X_BM;
    if (joint.kind == JointKind::kSlide) {
      const Vector3d axis = joint.X_PF.R.col(2).cwiseAbs();
      require(joint.parent < 0 && std::abs(axis.maxCoeff() - 1) < 1e-12,
              "Bullet is given slides on the world along its axes only");
      bodies_[i]->setLinearFactor(to_bullet(axis));
      bodies_[i]->setAngularFactor(btVector3(0, 0, 0));
      return;
    }
    // Bullet's hinges turn about z of their frames, too.
    if (joint.parent < 0) {
      joints_.push_back(std::make_unique<btHingeConstraint>(*bodies_[i], to_bullet(X_PM)));
    } else {
      const auto parent = static_cast<std::size_t>(joint.parent);
      joints_.push_back(std::make_unique<btHingeConstraint>(
          *bodies_[parent], *bodies_[i], to_bullet(X_BP_[parent].inverse() * joint.X_PF),
          to_bullet(X_PM)));
    }
    world_.addConstraint(joints_.back().get(), true);
  }

  void apply_efforts() {
    const std::vector<MechanismJoint>& joints = scene_.mechanism.joints;
    const std::vector<BodyMotion> now = motion();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (!is_scalar(joints[i].kind)) continue;
      const double effort = joint_effort(scene_, i, t_, joint_motion(scene_.mechanism, i, now));
      const Vector3d along = effort * (now[i].X_WB.R * joints[i].X_BM.R.col(2));
      if (joints[i].kind == JointKind::kSlide) {
        bodies_[i]->applyCentralForce(to_bullet(along));
        continue;
      }
      bodies_[i]->applyTorque(to_bullet(along));
      if (joints[i].parent >= 0)
        bodies_[static_cast<std::size_t>(joints[i].parent)]->applyTorque(to_bullet(-along));
    }
  }

  MovingScene scene_;
  double step_, t_ = 0;
  BulletOptions options_;
  PairFilter filter_;
  std::vector<Pose<double>> X_BP_;  // principal axes in each body
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
};

PeerSetting setting(const std::string& name, PeerUse use, const BulletOptions& options) {
  return stepped<BulletWorld>("Bullet", name, use, options);
}

}  // namespace

std::vector<PeerSetting> bullet_settings() {
  return {setting("SI 10", PeerUse::kAll, {10, false, false}),
          setting("SI 50", PeerUse::kContacts, {50, false, false}),
          setting("SI 50, two axes of friction", PeerUse::kContacts, {50, true, false}),
          setting("SI 50, sleep", PeerUse::kContacts, {50, false, true})};
}

}  // namespace thenar::bench
