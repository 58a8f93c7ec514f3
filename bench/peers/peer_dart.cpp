// Scenes in DART.

#include <fmt/format.h>
#include <dart/collision/CollisionFilter.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "base/error.h"
#include "bench/peers/peer_machine.h"
#include "bench/peers/peer_scene.h"

namespace thenar::bench {
namespace {

namespace dd = dart::dynamics;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// How DART is used.
struct DartOptions {
  bool own_collision = false;  // DART's own, of balls and boxes only, instead of FCL's
  bool projected = false;      // projected Gauss and Seidel's iterations, not Dantzig's pivots
};

Isometry3d to_dart(const Pose<double>& X) {
  Isometry3d out = Isometry3d::Identity();
  out.linear() = X.R;
  out.translation() = X.p;
  return out;
}

Pose<double> to_pose(const Isometry3d& X) { return {X.linear(), X.translation()}; }

dd::ShapePtr dart_shape(const ShapeSpec& shape) {
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return std::make_shared<dd::SphereShape>(shape.size[0]);
    case ShapeKind::kBox:
      return std::make_shared<dd::BoxShape>(shape.size);
    default:  // capsules neither: both kinds of collision take them for something else
      throw InputError(fmt::format("DART is not given a {}", name_of(shape.kind)));
  }
}

template <typename Joint>
dd::BodyNode* add_node(const MovingScene& scene, std::size_t i, dd::Skeleton& skeleton,
                       dd::BodyNode* parent) {
  const MechanismBody& body = scene.mechanism.bodies[i];
  const MechanismJoint& joint = scene.mechanism.joints[i];
  typename Joint::Properties at;
  at.mName = body.name;
  at.mT_ParentBodyToJoint = to_dart(joint.X_PF);
  at.mT_ChildBodyToJoint = to_dart(joint.X_BM);
  if constexpr (std::is_same_v<Joint, dd::RevoluteJoint> ||
                std::is_same_v<Joint, dd::PrismaticJoint>)
    at.mAxis = Vector3d::UnitZ();
  dd::BodyNode::Properties properties;
  properties.mName = body.name;
  if (joint.kind != JointKind::kWeld)
    properties.mInertia = dd::Inertia(body.mass.mass, body.mass.com, body.mass.inertia);
  return skeleton.createJointAndBodyNodePair<Joint>(parent, at, properties).second;
}

/// Adds a body with its joint and shapes. @param parent  null: the world
dd::BodyNode* add_body(const MovingScene& scene, std::size_t i, dd::Skeleton& skeleton,
                       dd::BodyNode* parent) {
  dd::BodyNode* node = nullptr;
  switch (scene.mechanism.joints[i].kind) {
    case JointKind::kHinge:
      node = add_node<dd::RevoluteJoint>(scene, i, skeleton, parent);
      break;
    case JointKind::kSlide:
      node = add_node<dd::PrismaticJoint>(scene, i, skeleton, parent);
      break;
    case JointKind::kFree:
      node = add_node<dd::FreeJoint>(scene, i, skeleton, parent);
      break;
    default:
      node = add_node<dd::WeldJoint>(scene, i, skeleton, parent);
  }
  for (const ShapeSpec& shape : shapes_of(scene.mechanism.bodies[i])) {
    auto* at =
        node->createShapeNodeWith<dd::CollisionAspect, dd::DynamicsAspect>(dart_shape(shape));
    at->setRelativeTransform(to_dart(shape.X_BS));
    at->getDynamicsAspect()->setFrictionCoeff(scene.friction.coefficient);
  }
  return node;
}

class DartWorld final : public PeerWorld {
 public:
  DartWorld(const PeerScene& peer, double step, const DartOptions& options)
      : scene_(peer.scene), world_(dart::simulation::World::create()) {
    world_->setTimeStep(step);
    world_->setGravity(scene_.gravity);
    if (options.projected) {
      using Projected = dart::constraint::PgsBoxedLcpSolver;
      world_->setConstraintSolver(std::make_unique<dart::constraint::BoxedLcpConstraintSolver>(
          std::make_shared<Projected>()));
    }
    if (options.own_collision)
      world_->getConstraintSolver()->setCollisionDetector(
          dart::collision::DARTCollisionDetector::create());
    // A skeleton for each tree.
    for (std::size_t i = 0; i < scene_.mechanism.bodies.size(); ++i) {
      const MechanismJoint& joint = scene_.mechanism.joints[i];
      dd::BodyNode* parent =
          joint.parent < 0 ? nullptr : nodes_[static_cast<std::size_t>(joint.parent)];
      const dd::SkeletonPtr skeleton = parent == nullptr
                                           ? dd::Skeleton::create(scene_.mechanism.bodies[i].name)
                                           : parent->getSkeleton();
      nodes_.push_back(add_body(scene_, i, *skeleton, parent));
      if (joint.kind == JointKind::kWeld) skeleton->setMobile(false);
      if (parent == nullptr) roots_.push_back(skeleton);
    }
    for (const dd::SkeletonPtr& skeleton : roots_) world_->addSkeleton(skeleton);
    filter_pairs();
    start(motion_at(scene_, peer.rival_q(), scene_.v));
  }

  void step() override {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!is_scalar(scene_.mechanism.joints[i].kind)) continue;
      dd::Joint* joint = nodes_[i]->getParentJoint();
      const JointMotion at{joint->getPosition(0), joint->getVelocity(0)};
      joint->setForce(0, joint_effort(scene_, i, world_->getTime(), at));
    }
    world_->step();
  }

  [[nodiscard]] std::vector<BodyMotion> motion() const override {
    std::vector<BodyMotion> out(nodes_.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].X_WB = to_pose(nodes_[i]->getWorldTransform());
      out[i].linear = nodes_[i]->getCOMLinearVelocity();
      out[i].angular = nodes_[i]->getAngularVelocity();
    }
    return out;
  }

 private:
  void filter_pairs() {
    const auto filter = std::make_shared<dart::collision::BodyNodeCollisionFilter>();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t j = i + 1; j < nodes_.size(); ++j)
        if (!may_touch(scene_, i, j)) filter->addBodyNodePairToBlackList(nodes_[i], nodes_[j]);
    for (const dd::SkeletonPtr& skeleton : roots_) skeleton->enableSelfCollisionCheck();
    world_->getConstraintSolver()->getCollisionOption().collisionFilter = filter;
  }

  void start(const std::vector<BodyMotion>& bodies) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      dd::Joint* joint = nodes_[i]->getParentJoint();
      if (is_scalar(scene_.mechanism.joints[i].kind)) {
        const JointMotion at = joint_motion(scene_.mechanism, i, bodies);
        joint->setPosition(0, at.value);
        joint->setVelocity(0, at.rate);
      } else if (auto* free = dynamic_cast<dd::FreeJoint*>(joint)) {
        const BodyMotion& body = bodies[i];
        const Vector3d arm = body.X_WB.R * scene_.mechanism.bodies[i].mass.com;
        free->setTransform(to_dart(body.X_WB));
        free->setLinearVelocity(body.linear - body.angular.cross(arm));
        free->setAngularVelocity(body.angular);
      }
    }
  }

  MovingScene scene_;
  dart::simulation::WorldPtr world_;
  std::vector<dd::BodyNode*> nodes_;
  std::vector<dd::SkeletonPtr> roots_;
};

PeerSetting setting(const std::string& name, PeerUse use, const DartOptions& options) {
  return stepped<DartWorld>("DART", name, use, options);
}

/// One skeleton, for its accelerations.
struct DartMachine {
  explicit DartMachine(const MovingScene& scene) : skeleton(dd::Skeleton::create("machine")) {
    skeleton->setGravity(scene.gravity);
    std::vector<dd::BodyNode*> nodes;
    for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i) {
      const int parent = scene.mechanism.joints[i].parent;
      nodes.push_back(add_body(scene, i, *skeleton,
                               parent < 0 ? nullptr : nodes[static_cast<std::size_t>(parent)]));
    }
  }

  const Eigen::VectorXd& operator()(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    skeleton->setPositions(q);
    skeleton->setVelocities(v);
    skeleton->computeForwardDynamics();
    accelerations = skeleton->getAccelerations();
    return accelerations;
  }

  dd::SkeletonPtr skeleton;
  Eigen::VectorXd accelerations;
};

}  // namespace

std::vector<PeerSetting> dart_settings() {
  return {setting("Dantzig", PeerUse::kAll, {}),
          setting("Dantzig, own collision", PeerUse::kContacts, {true, false}),
          setting("projected GS, own collision", PeerUse::kContacts, {true, true})};
}

PeerMachine dart_machine(const MovingScene& scene) {
  auto machine = std::make_shared<DartMachine>(scene);
  return {"DART",
          [machine](const Eigen::VectorXd& q, const Eigen::VectorXd& v) -> const Eigen::VectorXd& {
            return (*machine)(q, v);
          }};
}

}  // namespace thenar::bench
