// thenar feasible-force SUBJECT --digit D --posture ... [--direction x y z] [--tolerance-deg a]
//
// The largest force of a fingertip along a direction, or all the forces it can make.

#include "tendons/forces/max_tip_force.h"

#include <memory>

#include "api/posture.h"
#include "apps/commands.h"
#include "apps/feasible_report.h"
#include "apps/options.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "report/json.h"
#include "report/table.h"

namespace thenar {
namespace {

struct FeasibleForceArguments {
  DigitRequest question;
  std::vector<double> direction;
  double tolerance_deg = 0;
  std::string axes = "world";
  bool set = false;
  bool json = false;
};

/// Axes that directions are given in and forces shown in.
ForceAxes force_axes(const DigitAtPosture& at, const std::string& asked) {
  if (!at.map.empty()) {
    require(asked == "world", "tip map '{}' knows only its own x, y, z; leave out --axes tip",
            at.map);
    return {"map", {"x", "y", "z"}, Eigen::Matrix3d::Identity()};
  }
  if (asked == "world") return {"world", {"x", "y", "z"}, Eigen::Matrix3d::Identity()};
  return {"tip", {"proximal", "dorsal", "radial"}, *at.tip_axes};
}

void require_limits(const DigitAtPosture& at, const std::string& path) {
  const std::vector<std::string> unknown = unlimited_muscles(at.statics);
  require(
      unknown.empty(),
      "feasible forces need the largest force of every muscle; unknown: {}. Give each [[muscle]] "
      "max_force_N, or pcsa_cm2 and specific_tension_N_cm2, in {}",
      listed(unknown), path);
}

void run_feasible_force(const FeasibleForceArguments& options) {
  require(options.direction.empty() || options.direction.size() == 3,
          "wanted --direction x y z, got {} numbers", options.direction.size());
  const DigitAtPosture at = find_digit(options.question);
  const ForceAxes axes = force_axes(at, options.axes);
  require_limits(at, options.question.subject);

  nlohmann::ordered_json json = json_header(at);
  if (at.map.empty()) json["condition"] = at.condition;
  std::string text = text_header(at) + "\n";
  if (!options.direction.empty()) {
    const Eigen::Vector3d d(options.direction.data());
    const MaxTipForce largest =
        max_tip_force(at.statics, axes.to_world * d, {options.tolerance_deg * kDegree});
    json.update(json_of(at, axes, largest));
    text += text_of(at, axes, largest);
  }
  if (options.direction.empty() || options.set) {
    const WholeSet whole = whole_set(at, axes);
    json.update(json_of(axes, whole));
    text += text_of(axes, whole);
    if (at.map.empty() && at.condition >= kNearlyStraight) {
      const std::string note = fmt::format(
          "nearly singular posture (condition {:.3g}): the set changes much within a degree",
          at.condition);
      if (!json.contains("note")) json["note"] = note;
      text += "note: " + note + "\n";
    }
  }
  fmt::print("{}\n", options.json ? json_text(json) : text);
}

}  // namespace

void add_feasible_force(CLI::App& app) {
  auto options = std::make_shared<FeasibleForceArguments>();
  CLI::App* command =
      app.add_subcommand("feasible-force", "The largest force of a fingertip, or all of them");
  add_digit_options(*command, options->question);
  command->add_option("--direction", options->direction, "x y z of the wanted force")->expected(3);
  command->add_option("--tolerance-deg", options->tolerance_deg,
                      "Half angle of the cone the force may lie in [deg]");
  command
      ->add_option("--axes", options->axes,
                   "world: the subject's frame; tip: proximal, dorsal, radial")
      ->check(CLI::IsMember({"world", "tip"}));
  command->add_flag("--set", options->set, "The whole set, also beside a direction");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_feasible_force(*options); });
}

}  // namespace thenar
