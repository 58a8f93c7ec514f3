// Slow dynamics is static closing: where the assumptions of grasp/closing hold, the simulator ends
// in its contacts, and in the forces of a static balance.

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "dynamics/scene/build_scene.h"
#include "dynamics/stepping/simulate_scene.h"
#include "grasp/closing/approach_sampling.h"
#include "grasp/closing/grasp.h"
#include "grasp/robot/robot_hand.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A motor is a damper to a target that moves on: free, it runs at its speed; blocked, it has its
// largest effort, to the bit.
constexpr double kSpeed = 0.25;      // of closing, times RobotDof::speed [rad/s]
constexpr double kEffort = 0.3;      // of a blocked motor [N m]
constexpr double kArm = 0.1;         // speed of a slide over that of a hinge [m/rad]
constexpr double kBack = 3e-3;       // the palm stands off the object [m]
constexpr double kMinForce = 0.05;   // least normal force of a contact, over kEffort / kArm [1]
constexpr double kClearance = 1e-5;  // at which grasp/closing lets links touch [m]
constexpr double kSamePlace = 1e-3;  // [m]
// A tenth of a millimetre, from clearance and facets, on radii and arms of 20 mm or more.
constexpr double kSameDirection = 5e-3;  // [rad]
constexpr double kSameForce = 1e-2;      // relative: of both [1]
constexpr int kStarts = 2000;            // that are looked through for one grasp

/// A robot of which some motors close and all others are locked, and an object.
struct LadderPair {
  std::string robot, object;
  std::vector<std::string> motors;  // that close; empty: all that do by the robot's file
};

const std::vector<std::string> kBarrett{"finger 1", "finger 2", "finger 3"};
const std::vector<std::string> kThreeFinger{"finger 1 J1", "finger 2 J2", "finger 3 J2"};

std::ostream& operator<<(std::ostream& out, const LadderPair& pair) {
  return out << pair.robot << " on " << pair.object;
}

RobotSpec robot_of(const LadderPair& pair) {
  RobotSpec robot = read_robot(kData + "/robots/" + pair.robot + ".toml");
  for (RobotDof& dof : robot.dofs) {
    const bool closes =
        pair.motors.empty() || std::count(pair.motors.begin(), pair.motors.end(), dof.name) > 0;
    if (!closes) dof.speed = 0;
    if (closes) dof.kind = DriveCoupling::kRigid;  // clutches stay shut
    dof.backdrivable = dof.speed != 0;             // what nothing drives is locked
  }
  return robot;
}

/// What a link of the hand does to the object.
struct Touch {
  std::vector<Vector3d> points;  // world [m] (3)
  Vector3d normal{0, 0, 0};      // of the push on the object, unit (3)
  Vector3d force{0, 0, 0};       // on the object [N] (3)
};
using Touches = std::map<std::string, Touch>;  // by link

/// A hand closed by statics.
struct Closed {
  Pose<double> X_WH;
  VectorXd q;  // (coordinates)
  Touches touches;
  std::vector<Eigen::Matrix3Xd> J;  // of the contact of each link, in their order (3, coordinates)
  MatrixXd normal;                  // work of a unit normal force (links, pressing)
  std::vector<Index> pressing;      // coordinates that motors press on contacts
};

/// Effort of a blocked motor [N m] or [N]. @param slides  its joints do
double effort_of(const RobotDof& dof, bool slides) {
  return std::copysign(slides ? kEffort / kArm : kEffort, dof.speed);
}

class StaticLimit : public testing::TestWithParam<LadderPair> {
 protected:
  void SetUp() override {
    robot_ = robot_of(GetParam());
    hand_.emplace(robot_);
    object_.body = read_object(kData + "/objects/" + GetParam().object + ".toml");
    object_.body.name = "object";
    object_.dynamic = false;
    touching_ = collision_hand(*hand_);
    scene_.object = build_body(object_);
    scene_.materials = built_in_materials();
    find_motors();
    std::mt19937 random(1);
    for (int start = 0; start < kStarts && !closed_; ++start) closed_ = closed_from(random);
    ASSERT_TRUE(closed_) << "no start ends in a grasp with unique forces";
  }

  /// Effort at each coordinate when its motor is blocked.
  void find_motors() {
    tau_ = VectorXd::Zero(static_cast<Index>(hand_->layout().coordinates.size()));
    for (const RobotDof& dof : robot_.dofs) {
      if (dof.speed == 0) continue;
      const auto& names = hand_->layout().coordinates;
      const auto at = std::find(names.begin(), names.end(), dof.name);
      ASSERT_NE(at, names.end()) << dof.name << " is no rigid motor";
      tau_[at - names.begin()] = effort_of(dof, slides(robot_, dof));
    }
  }

  /// A random start, closed; nothing if less than two links touch or forces are not unique.
  std::optional<Closed> closed_from(std::mt19937& random) {
    CloseOptions options;
    options.self = false;
    options.accuracy = kClearance;
    const VectorXd open = open_posture(hand_->layout());
    const Pose<double> far = sample_approach_pose(touching_, open, scene_.object, random);
    const ApproachResult near = approach(
        touching_, far, open, scene_, approach_distance(touching_, open, scene_.object), options);
    if (!near.touches || !near.overlaps.empty()) return {};
    Closed out;
    out.X_WH = near.X_WH;
    out.X_WH.p -= kBack * (near.X_WH.R * hand_->layout().approach.direction);
    const ClosedHand closed = close_hand(touching_, out.X_WH, open, scene_, options);
    if (!closed.finished) return {};
    out.q = closed.q;
    if (!note_touches(out) || !balances(out)) return {};
    // A link may touch where its motor is at a limit: then nothing presses.
    for (const Index j : out.pressing)
      if (closed.stopped[static_cast<std::size_t>(j)] != StoppedBy::kContact) return {};
    return out;
  }

  /// Notes which links touch, and where. @returns whether these are two links of fingers or
  /// more; one if there is one motor
  bool note_touches(Closed& out) {
    const PosedCollisionHand posed{touching_, out.X_WH, hand_->pose(out.q)};
    std::map<std::string, int> surfaces;
    for (const HandContact& each : find_contacts(posed, scene_)) {
      const LinkSurface& link = hand_->surfaces()[static_cast<std::size_t>(each.surface)];
      Touch& touch = out.touches[link.name];
      touch.points.push_back(each.contact.p);
      touch.normal += each.contact.n;
      surfaces[link.name] = each.surface;
      if (link.link < 0) return false;
    }
    for (auto& [name, touch] : out.touches) {
      touch.normal.normalize();
      Vector3d centre = Vector3d::Zero();
      for (const Vector3d& p : touch.points) centre += p / static_cast<double>(touch.points.size());
      const int surface = surfaces[name];
      out.J.push_back(out.X_WH.R *
                      hand_
                          ->jacobian(out.q,
                                     hand_->surfaces()[static_cast<std::size_t>(surface)].link,
                                     posed.surface_pose(surface).inverse() * centre)
                          .bottomRows<3>());
    }
    const auto motors = static_cast<std::size_t>((tau_.array() != 0).count());
    return out.touches.size() >= std::min<std::size_t>(2, motors);
  }

  /// Forces without friction, from J' f = tau. @returns whether they are unique and all push
  bool balances(Closed& out) const {
    const auto links = static_cast<Index>(out.touches.size());
    MatrixXd all(links, tau_.size());
    Index k = 0;
    for (const auto& [name, touch] : out.touches) {
      all.row(k) = touch.normal.transpose() * out.J[static_cast<std::size_t>(k)];
      ++k;
    }
    for (Index j = 0; j < tau_.size(); ++j)
      if (tau_[j] != 0 && all.col(j).cwiseAbs().maxCoeff() > 1e-6) out.pressing.push_back(j);
    if (static_cast<Index>(out.pressing.size()) != links) return false;
    out.normal.resize(links, links);
    VectorXd tau(links);
    for (Index j = 0; j < links; ++j) {
      out.normal.col(j) = all.col(out.pressing[static_cast<std::size_t>(j)]);
      tau[j] = tau_[out.pressing[static_cast<std::size_t>(j)]];
    }
    // The motors' efforts plus what the object pushes back are zero.
    const Eigen::FullPivLU<MatrixXd> lu(out.normal.transpose());
    if (!lu.isInvertible() || lu.rcond() < 1e-2) return false;
    const VectorXd f = lu.solve(tau);
    if (f.minCoeff() < kMinForce * kEffort / kArm) return false;
    k = 0;
    for (auto& [name, touch] : out.touches) touch.force = f[k++] * touch.normal;
    return true;
  }

  /// The same in motion, from the same start until long after all is still.
  Touches simulated(double friction) const {
    SceneSpec spec;
    spec.name = "limit";
    spec.gravity.setZero();
    SceneHandSpec hand;
    hand.placed.name = "hand";
    hand.placed.X_WH = closed_->X_WH;
    hand.joint.kind = JointKind::kWeld;
    spec.hands.push_back(hand);
    SceneBodySpec body;
    body.placed = object_;
    body.joint.kind = JointKind::kWeld;
    spec.bodies.push_back(body);
    spec.apart.push_back({{"hand", "hand"}});
    SceneFrictionSpec all;
    all.coefficient = friction;
    spec.frictions.push_back(all);
    double longest = 0;  // until the slowest motor has gone its whole way [s]
    for (const RobotDof& dof : robot_.dofs) {
      if (dof.speed == 0) continue;
      SceneDriveSpec drive;
      drive.coordinate = drive.name = "hand/" + dof.name;
      drive.turns = !slides(robot_, dof);
      drive.speed = kSpeed * dof.speed * (drive.turns ? 1 : kArm);
      const double effort = effort_of(dof, !drive.turns);
      drive.damping = effort / drive.speed;
      drive.max_effort = std::abs(effort);
      spec.drives.push_back(drive);
      longest = std::max(longest, (dof.upper - dof.lower) / std::abs(drive.speed));
    }
    spec.stepping.duration = longest + 1;
    spec.stepping.sample = longest + 1;
    const BuiltScene built = build_scene(spec, {robot_});
    const SceneRun run = simulate_scene(built.scene, built.options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    return touches_of(built, run.samples.back());
  }

  static Touches touches_of(const BuiltScene& built, const SceneSample& end) {
    const Mechanism& mechanism = built.scene.mechanism;
    const int object = body_named(mechanism, "object");
    EXPECT_LT(end.v.cwiseAbs().maxCoeff(), 1e-9);
    Touches out;
    for (const ContactSample& contact : end.contacts) {
      const int link = contact.a == object ? contact.b : contact.a;
      const double sense = contact.a == object ? 1 : -1;
      if (contact.force.norm() < 1e-6) continue;
      Touch& touch = out[mechanism.bodies[static_cast<std::size_t>(link)].name.substr(5)];
      touch.points.push_back(contact.point);
      touch.normal += sense * contact.normal;
      touch.force += sense * contact.force;
    }
    return out;
  }

  RobotSpec robot_;
  std::optional<RobotHand> hand_;
  CollisionHand touching_;
  GraspSetup scene_;
  PlacedBody object_;
  VectorXd tau_;  // of blocked motors [N m] or [N] (coordinates)
  std::optional<Closed> closed_;
};

/// Names of the links that touch.
std::vector<std::string> links_of(const Touches& touches) {
  std::vector<std::string> names;
  for (const auto& [name, touch] : touches) names.push_back(name);
  return names;
}

double nearest(const Vector3d& p, const std::vector<Vector3d>& points) {
  double least = 1e9;
  for (const Vector3d& each : points) least = std::min(least, (p - each).norm());
  return least;
}

TEST_P(StaticLimit, WithoutFrictionBodiesPointsAndForcesAreThoseOfStatics) {
  const Touches moved = simulated(0);
  ASSERT_EQ(links_of(moved), links_of(closed_->touches));
  for (const auto& [name, touch] : moved) {
    SCOPED_TRACE(name);
    const Touch& wanted = closed_->touches.at(name);
    for (const Vector3d& p : touch.points) EXPECT_LT(nearest(p, wanted.points), kSamePlace);
    EXPECT_GT(touch.normal.normalized().dot(wanted.normal), std::cos(kSameDirection));
    EXPECT_LT((touch.force - wanted.force).norm(), kSameForce * wanted.force.norm());
  }
}

// With friction the tangential forces depend on the way there; what is left is the balance of each
// motor.
TEST_P(StaticLimit, WithFrictionTheForcesBalanceTheMotors) {
  const double friction = 0.5;
  const Touches moved = simulated(friction);
  ASSERT_EQ(links_of(moved), links_of(closed_->touches));
  VectorXd balanced = VectorXd::Zero(tau_.size());
  std::size_t k = 0;
  for (const auto& [name, touch] : moved) {
    const Vector3d n = touch.normal.normalized();
    const double push = touch.force.dot(n);
    EXPECT_GT(push, 0) << name;
    EXPECT_LE((touch.force - push * n).norm(), friction * push * (1 + 1e-6)) << name;
    balanced += closed_->J[k++].transpose() * touch.force;
  }
  for (const Index j : closed_->pressing)
    EXPECT_NEAR(balanced[j], tau_[j], kSameForce * std::abs(tau_[j]));
}

INSTANTIATE_TEST_SUITE_P(
    Pairs, StaticLimit,
    testing::Values(
        LadderPair{"parallel_jaw", "sphere_70", {}}, LadderPair{"robotiq_2f85", "sphere_70", {}},
        LadderPair{"barrett", "sphere_70", kBarrett}, LadderPair{"barrett", "can", kBarrett},
        LadderPair{"barrett", "box", kBarrett},
        LadderPair{"barrett_bh8_280", "sphere_70", kBarrett},
        LadderPair{"allegro", "sphere_70", {"joint_1.0", "joint_5.0", "joint_9.0", "joint_14.0"}},
        LadderPair{"dlr", "sphere_70", {"thumb J1", "thumb J3", "index J1", "index J3"}},
        LadderPair{"dlr", "can", {"thumb J1", "thumb J3", "index J1", "index J3"}},
        LadderPair{"shadow", "sphere_70", {"FFJ3", "MFJ3", "RFJ3", "THJ4"}},
        LadderPair{"robotiq_3f", "sphere_70", kThreeFinger},
        LadderPair{"robotiq_3f", "can", kThreeFinger},
        LadderPair{"robotiq_3f", "jar_lid", kThreeFinger}, LadderPair{"parallel_jaw", "box", {}}));

}  // namespace
}  // namespace thenar
