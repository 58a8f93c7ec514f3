#include "apps/robot_pose.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "apps/options.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "data/io/robot/link_poses.h"
#include "grasp/robot/infer_hand.h"
#include "grasp/robot/robot_tips.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {
namespace {

constexpr double kSameAngle = 1e-9;  // of limits and of values stated twice [rad] or [m]

/// [rad] or [m] in what people type.
double unit_of(bool sliding) { return sliding ? kMm : kDegree; }

const RobotDof* dof_named(const RobotSpec& robot, const std::string& name) {
  for (const RobotDof& dof : robot.dofs)
    if (dof.name == name) return &dof;
  return nullptr;
}

/// Values as typed, by names of degrees of freedom and joints.
std::map<std::string, double> typed(const RobotSpec& robot, const std::vector<std::string>& texts) {
  const bool named = texts.empty() || std::any_of(texts.begin(), texts.end(), [](const auto& text) {
                       return text.find('=') != std::string::npos;
                     });
  if (named) return parse_named_numbers(texts, "NAME=degrees, of slides millimetres");
  std::vector<std::string> names;
  for (const RobotDof& dof : robot.dofs) names.push_back(dof.name);
  require(texts.size() == names.size(), "wanted {} values [deg or mm], of {}, got {}", names.size(),
          listed(names), texts.size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < texts.size(); ++i)
    values[names[i]] = parse_number(texts[i], "a value [deg or mm]");
  return values;
}

/// Where a rigid motor stands whose joint is at a value: found between its limits along a curve.
double motor_of(const RobotJoint& joint, const RobotDof& dof, double value) {
  if (joint.curve.empty()) return (value - joint.offset) / joint.ratio;
  double a = dof.lower, b = dof.upper;
  const bool rises = joint_value(joint, b) > joint_value(joint, a);
  for (int i = 0; i < 60; ++i) {
    const double middle = (a + b) / 2;
    ((joint_value(joint, middle) < value) == rises ? a : b) = middle;
  }
  require(std::abs(joint_value(joint, a) - value) < 1e-6,
          "joint '{}' does not come to {:.6g} (rad or m) along the curve on which it follows '{}'",
          joint.name, value, dof.name);
  return a;
}

/// Values of all joints.
class Posture {
 public:
  Posture(const RobotSpec& robot, const std::vector<std::string>& texts) : robot_(robot) {
    for (const auto& [name, value] : typed(robot, texts)) set(name, value);
  }

  [[nodiscard]] double value(const RobotJoint& joint) const {
    if (const auto own = joints_.find(joint.name); own != joints_.end()) return own->second;
    return joint_value(joint, dofs_);
  }

 private:
  void set(const std::string& name, double value) {
    if (const RobotDof* dof = dof_named(robot_, name)) {
      move(*dof, value * unit_of(slides(robot_, *dof)));
      return;
    }
    std::vector<std::string> known;
    for (const RobotDof& dof : robot_.dofs) known.push_back(dof.name);
    for (const RobotJoint& joint : robot_.joints) {
      if (joint.kind == RobotJointKind::kFixed) continue;
      known.push_back(joint.name);
      if (joint.name == name) return set(joint, value * unit_of(slides(joint)));
    }
    throw InputError(
        fmt::format("robot '{}' has no degree of freedom or moving joint '{}'{}; it has {}",
                    robot_.name, name, did_you_mean(name, known), listed(known)));
  }

  void set(const RobotJoint& joint, double value) {
    const RobotDof* dof = dof_named(robot_, joint.dof);
    if (dof == nullptr || dof->kind != RobotDofKind::kRigid)
      joints_[joint.name] = value;  // it may part from the others of its motor
    else
      move(*dof, motor_of(joint, *dof, value));
  }

  void move(const RobotDof& dof, double value) {
    const auto [at, is_new] = dofs_.emplace(dof.name, value);
    require(
        is_new || std::abs(at->second - value) < kSameAngle,
        "'{}' cannot stand at {:.6g} and at {:.6g} (rad or m) at once: joints of one motor move "
        "together",
        dof.name, at->second, value);
  }

  const RobotSpec& robot_;
  DofValues dofs_;
  std::map<std::string, double> joints_;
};

std::string value_text(const RobotJointNow& joint) {
  return fmt::format("{} {}", shown(joint.value / unit_of(joint.slides), 2),
                     joint.slides ? "mm" : "deg");
}

/// The same robot with every joint held at its value.
RobotSpec held(RobotSpec robot, const Posture& posture) {
  for (RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    joint.offset = posture.value(joint);
    joint.dof.clear();
    joint.curve.clear();
  }
  return robot;
}

void warn_of_limits(const RobotJoint& joint, double value, std::vector<std::string>& warnings) {
  if (value >= joint.lower - kSameAngle && value <= joint.upper + kSameAngle) return;
  const double unit = unit_of(slides(joint));
  warnings.push_back(fmt::format("joint '{}' at {:.4g} is outside {:.4g} .. {:.4g} {}", joint.name,
                                 value / unit, joint.lower / unit, joint.upper / unit,
                                 slides(joint) ? "mm" : "deg"));
}

}  // namespace

RobotPose pose_robot(const RobotSpec& robot, const std::vector<std::string>& texts) {
  const Posture posture(robot, texts);
  RobotSpec at = held(robot, posture);
  const std::vector<Pose<double>> X = link_poses(at, {});
  RobotPose pose;
  pose.robot = robot.name;
  std::map<std::string, Pose<double>> placed;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    placed[robot.links[i].name] = X[i];
    pose.links.push_back({robot.links[i].name, X[i]});
  }
  for (const RobotJoint& joint : robot.joints) {
    if (joint.kind == RobotJointKind::kFixed) continue;
    const Pose<double> X_BJ = placed.at(joint.parent) * joint.X_PJ;
    const double value = posture.value(joint);
    pose.joints.push_back(
        {joint.name, joint.dof, slides(joint), value, X_BJ.R * joint.axis, X_BJ.p});
    warn_of_limits(joint, value, pose.warnings);
  }
  if (std::all_of(at.links.begin(), at.links.end(),
                  [](const RobotLink& link) { return link.digit.empty(); }))
    (void)infer_digits(at);
  for (const RobotTip& tip : find_tips(at, X))
    pose.tips.push_back({tip.digit, at.links[static_cast<std::size_t>(tip.link)].name, tip.p});
  return pose;
}

void print_text(const RobotPose& pose) {
  Table joints{
      {"joint", "value", "axis_x", "axis_y", "axis_z", "point_x_mm", "point_y_mm", "point_z_mm"},
      {}};
  for (const RobotJointNow& joint : pose.joints) {
    const std::string name = joint.dof.empty() || joint.dof == joint.name
                                 ? joint.name
                                 : fmt::format("{} (driven by {})", joint.name, joint.dof);
    joints.rows.push_back(
        row({{name, value_text(joint)}, cells(joint.axis, 4), cells(joint.point / kMm, 2)}));
  }
  fmt::print("{}", titled("Joints, axes in directions of the base link", joints));
  Table links{{"link", "x_mm", "y_mm", "z_mm", "qw", "qx", "qy", "qz"}, {}};
  for (const RobotLinkNow& link : pose.links) {
    const Eigen::Quaterniond q(link.X_BL.R);
    links.rows.push_back(row({{link.name},
                              cells(link.X_BL.p / kMm, 2),
                              {shown(q.w(), 5)},
                              cells(Eigen::Vector3d(q.vec()), 5)}));
  }
  fmt::print("{}", titled("Links, frames in the base link", links));
  Table tips{{"digit", "link", "tip_x_mm", "tip_y_mm", "tip_z_mm"}, {}};
  for (const RobotTipNow& tip : pose.tips)
    tips.rows.push_back(row({{tip.digit, tip.link}, cells(tip.p / kMm, 2)}));
  if (!pose.tips.empty()) fmt::print("{}", titled("Tips", tips));
}

void print_json(const RobotPose& pose) {
  nlohmann::ordered_json json{{"robot", pose.robot}};
  json["joints"] = json["links"] = json["tips"] = nlohmann::ordered_json::array();
  for (const RobotJointNow& joint : pose.joints) {
    nlohmann::ordered_json entry{{"name", joint.name}, {"dof", joint.dof}};
    entry[joint.slides ? "value_mm" : "value_deg"] = joint.value / unit_of(joint.slides);
    entry["axis"] = to_json(joint.axis);
    entry["point_mm"] = to_json(joint.point / kMm);
    json["joints"].push_back(std::move(entry));
  }
  for (const RobotLinkNow& link : pose.links)
    json["links"].push_back({{"name", link.name},
                             {"rotation", to_json(link.X_BL.R)},
                             {"position_mm", to_json(link.X_BL.p / kMm)}});
  for (const RobotTipNow& tip : pose.tips)
    json["tips"].push_back(
        {{"digit", tip.digit}, {"link", tip.link}, {"position_mm", to_json(tip.p / kMm)}});
  json["warnings"] = pose.warnings;
  fmt::print("{}\n", json_text(json));
}

}  // namespace thenar
