// Scenes in MuJoCo.

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>

#include "base/error.h"
#include "bench/peers/mujoco_model.h"
#include "bench/peers/peer_machine.h"
#include "bench/peers/peer_scene.h"

namespace thenar::bench {
namespace {

using Eigen::Vector3d;

std::string three(const Vector3d& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string placed(const Pose<double>& X) {
  const Eigen::Quaterniond turn(X.R);
  return fmt::format("pos=\"{}\" quat=\"{:.17g} {:.17g} {:.17g} {:.17g}\"", three(X.p), turn.w(),
                     turn.x(), turn.y(), turn.z());
}

/// A scene as MJCF; bodies are named by their index.
class SceneWriter {
 public:
  explicit SceneWriter(const MovingScene& scene) : scene_(scene) {}

  /// @param option  attributes of <option>;  @param geom  attributes of every shape
  [[nodiscard]] std::string text(const std::string& option, const std::string& geom) const {
    std::string apart;
    const std::size_t n = scene_.mechanism.bodies.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        if (!may_touch(scene_, i, j))
          apart += fmt::format("<exclude body1=\"b{}\" body2=\"b{}\"/>", i, j);
    return fmt::format(
        "<mujoco><compiler angle=\"radian\" boundmass=\"0\" boundinertia=\"0\"/>"
        "<option gravity=\"{}\" {}/><size njmax=\"2000\" nconmax=\"400\"/>"
        "<default><geom friction=\"{:.17g} 0 0\" {}/></default>"
        "<worldbody>{}</worldbody><contact>{}</contact></mujoco>",
        three(scene_.gravity), option, scene_.friction.coefficient, geom, children(-1), apart);
  }

 private:
  [[nodiscard]] std::string children(int parent) const {
    std::string text;
    for (std::size_t i = 0; i < scene_.mechanism.bodies.size(); ++i)
      if (scene_.mechanism.joints[i].parent == parent) text += body(i);
    return text;
  }

  [[nodiscard]] std::string body(std::size_t i) const {
    const MechanismBody& body = scene_.mechanism.bodies[i];
    const MechanismJoint& joint = scene_.mechanism.joints[i];
    std::string text =
        fmt::format("<body name=\"b{}\" {}>", i, placed(joint.X_PF * joint.X_BM.inverse()));
    if (joint.kind != JointKind::kWeld) text += inertial(body.mass);
    if (joint.kind == JointKind::kFree) text += fmt::format("<freejoint name=\"j{}\"/>", i);
    if (is_scalar(joint.kind))
      text += fmt::format(
          "<joint name=\"j{}\" type=\"{}\" pos=\"{}\" axis=\"{}\" damping=\"{:.17g}\"/>", i,
          name_in(kJointKindNames, joint.kind), three(joint.X_BM.p), three(joint.X_BM.R.col(2)),
          joint.damping);
    for (const ShapeSpec& shape : shapes_of(body)) text += geom(shape);
    return text + children(static_cast<int>(i)) + "</body>";
  }

  static std::string inertial(const BodyMass& mass) {
    const Eigen::Matrix3d& I = mass.inertia;
    return fmt::format(
        "<inertial pos=\"{}\" mass=\"{:.17g}\" fullinertia=\"{:.17g} {:.17g} {:.17g} {:.17g} "
        "{:.17g} {:.17g}\"/>",
        three(mass.com), mass.mass, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  }

  static std::string geom(const ShapeSpec& shape) {
    Vector3d size = shape.size;
    if (shape.kind == ShapeKind::kBox) size *= 0.5;
    if (shape.kind == ShapeKind::kCapsule) size[1] *= 0.5;
    return fmt::format("<geom type=\"{}\" size=\"{}\" {}/>", name_of(shape.kind), three(size),
                       placed(shape.X_BS));
  }

  const MovingScene& scene_;
};

class MujocoWorld final : public PeerWorld {
 public:
  MujocoWorld(const PeerScene& peer, double step, const std::string& option,
              const std::string& geom)
      : scene_(peer.scene),
        model_(mujoco_model(
            SceneWriter(scene_).text(fmt::format("timestep=\"{:.17g}\" {}", step, option), geom))),
        data_(mj_makeData(model_.get()), mj_deleteData) {
    const std::size_t n = scene_.mechanism.bodies.size();
    for (std::size_t i = 0; i < n; ++i)
      body_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("b{}", i).c_str()));
    start(motion_at(scene_, peer.rival_q(), scene_.v));
    mj_forward(model_.get(), data_.get());
  }

  void step() override {
    for (const Motor& motor : motors_)
      if (motor.varies) data_->qfrc_applied[motor.v] = effort(motor);
    mj_step(model_.get(), data_.get());
  }

  [[nodiscard]] std::vector<BodyMotion> motion() const override {
    // Velocities of bodies follow the state after a step only when they are asked for.
    mj_fwdPosition(model_.get(), data_.get());
    mj_fwdVelocity(model_.get(), data_.get());
    std::vector<BodyMotion> out(body_.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
      out[i].X_WB.R = Eigen::Map<const Rows>(data_->xmat + 9 * body_[i]);
      out[i].X_WB.p = Eigen::Map<const Vector3d>(data_->xpos + 3 * body_[i]);
      double velocity[6];  // angular, then of the body's inertial frame, in the world
      mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, body_[i], velocity, 0);
      out[i].angular = Vector3d(velocity[0], velocity[1], velocity[2]);
      out[i].linear = Vector3d(velocity[3], velocity[4], velocity[5]);
    }
    return out;
  }

 private:
  struct Motor {
    std::size_t joint;
    int q, v;  // entries of positions and speeds
    bool varies;
  };

  void start(const std::vector<BodyMotion>& bodies) {
    const Mechanism& mechanism = scene_.mechanism;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, fmt::format("j{}", i).c_str());
      if (joint < 0) continue;
      const int q = model_->jnt_qposadr[joint], v = model_->jnt_dofadr[joint];
      const BodyMotion& body = bodies[i];
      if (mechanism.joints[i].kind == JointKind::kFree) {
        const Eigen::Quaterniond turn(body.X_WB.R);
        const Vector3d arm = body.X_WB.R * mechanism.bodies[i].mass.com;
        Eigen::Map<Vector3d>(data_->qpos + q) = body.X_WB.p;
        Eigen::Map<Eigen::Vector4d>(data_->qpos + q + 3) << turn.w(), turn.x(), turn.y(), turn.z();
        Eigen::Map<Vector3d>(data_->qvel + v) = body.linear - body.angular.cross(arm);
        Eigen::Map<Vector3d>(data_->qvel + v + 3) = body.X_WB.R.transpose() * body.angular;
        continue;
      }
      const JointMotion motion = joint_motion(mechanism, i, bodies);
      data_->qpos[q] = motion.value;
      data_->qvel[v] = motion.rate;
      motors_.push_back({i, q, v, varies(i)});
      data_->qfrc_applied[v] = effort(motors_.back());
    }
  }

  /// Dampers of joints are MuJoCo's own.
  [[nodiscard]] bool varies(std::size_t joint) const { return effort_varies(scene_, joint); }
  [[nodiscard]] double effort(const Motor& motor) const {
    const JointMotion motion{data_->qpos[motor.q], data_->qvel[motor.v]};
    return joint_effort(scene_, motor.joint, data_->time, motion) +
           scene_.mechanism.joints[motor.joint].damping * motion.rate;
  }

  MovingScene scene_;
  MujocoModel model_;
  MujocoData data_;
  std::vector<int> body_;  // MuJoCo's index of each
  std::vector<Motor> motors_;
};

/// A tree of hinges, for its accelerations.
struct MujocoMachine {
  explicit MujocoMachine(const MovingScene& scene)
      : model(mujoco_model(SceneWriter(scene).text("", ""))),
        data(mj_makeData(model.get()), mj_deleteData),
        accelerations(model->nv) {
    // Children stand behind their parents on both sides, but not in the same order.
    for (std::size_t i = 0; i < scene.mechanism.bodies.size(); ++i)
      q_of.push_back(
          model->jnt_qposadr[mj_name2id(model.get(), mjOBJ_JOINT, fmt::format("j{}", i).c_str())]);
  }

  const Eigen::VectorXd& operator()(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    for (std::size_t i = 0; i < q_of.size(); ++i) {
      data->qpos[q_of[i]] = q[static_cast<Eigen::Index>(i)];
      data->qvel[q_of[i]] = v[static_cast<Eigen::Index>(i)];
    }
    mj_forward(model.get(), data.get());
    for (std::size_t i = 0; i < q_of.size(); ++i)
      accelerations[static_cast<Eigen::Index>(i)] = data->qacc[q_of[i]];
    return accelerations;
  }

  MujocoModel model;
  MujocoData data;
  Eigen::VectorXd accelerations;
  std::vector<int> q_of;
};

PeerSetting setting(const std::string& name, PeerUse use, const std::string& option,
                    const std::string& geom) {
  return stepped<MujocoWorld>("MuJoCo", name, use, option, geom);
}

}  // namespace

std::vector<PeerSetting> mujoco_settings() {
  const std::string elliptic = "cone=\"elliptic\" impratio=\"10\"";
  const std::string stiff = "solref=\"0.002 1\"";
  const std::string noslip = elliptic + " noslip_iterations=\"10\"";
  const std::string rk4 = " integrator=\"RK4\"";
  return {setting("default", PeerUse::kAll, "", ""),
          setting("RK4", PeerUse::kFree, rk4, ""),
          setting("grasp recipe", PeerUse::kContacts, elliptic, ""),
          setting("recipe, noslip 10", PeerUse::kContacts, noslip, ""),
          setting("recipe, noslip 10, stiff", PeerUse::kContacts, noslip, stiff),
          setting("recipe, noslip 10, stiff, RK4", PeerUse::kContacts, noslip + rk4, stiff)};
}

PeerMachine mujoco_machine(const MovingScene& scene) {
  auto machine = std::make_shared<MujocoMachine>(scene);
  return {"MuJoCo",
          [machine](const Eigen::VectorXd& q, const Eigen::VectorXd& v) -> const Eigen::VectorXd& {
            return (*machine)(q, v);
          }};
}

}  // namespace thenar::bench
