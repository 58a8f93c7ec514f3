#include "tendons/net/build_tendons.h"

#include "base/error.h"
#include "base/lists.h"
#include "tendons/linear_tendons.h"
#include "tendons/net/free_digit.h"
#include "tendons/net/net_tendons.h"

namespace thenar {
namespace {

/// Maps the coordinates of a digit with all joints free to the same digit with frozen joints; empty
/// if a joint is frozen there without the joint that it follows.
std::vector<PostureAngle> angles_of(const TendonDigit& whole, const TendonDigit& digit) {
  for (std::size_t i = 0; i < whole.names.hinges.size(); ++i) {
    const std::string& leader = whole.names.coordinates[whole.model.tree[i].coordinate];
    if (digit.skeleton.frozen.count(whole.names.hinges[i]) > 0 &&
        digit.skeleton.frozen.count(leader) == 0)
      return {};
  }
  std::vector<PostureAngle> angles;
  for (const std::string& joint : whole.names.coordinates) {
    const auto frozen = digit.skeleton.frozen.find(joint);
    angles.push_back(frozen != digit.skeleton.frozen.end()
                         ? PostureAngle{-1, 0, frozen->second}
                         : PostureAngle{place_in(digit.names.coordinates, joint), 1, 0});
  }
  return angles;
}

/// Returns the muscles of the digit that have a role in the net.
std::vector<std::string> pulling_muscles(const TendonDigit& digit,
                                         const NetDescription& description) {
  std::vector<std::string> pulling;
  for (const NetMusclePlan& role : description.muscles)
    append_all(pulling, muscles_of(digit, role));
  return pulling;
}

/// Builds the digit with all joints free, if a joint of the digit is frozen.
FreeFinger free_finger(const Subject& subject, const TendonDigit& digit,
                       const NetDescription& description, const NetBuildOptions& net) {
  TendonDigit whole = free_digit(subject, digit);
  if (whole.model.coordinates == digit.model.coordinates) return {};
  FreeFinger free;
  free.angles = angles_of(whole, digit);
  if (free.angles.empty()) return {};
  // Match the muscles by name.
  for (const std::string& muscle : whole.names.muscles)
    free.muscles.push_back(place_in(digit.names.muscles, muscle));
  BuiltNet built = build_net(subject, whole, description, net);
  free.tendons = std::make_shared<NetTendons>(straight_tendons(std::move(whole)), std::move(built));
  return free;
}

}  // namespace

std::unique_ptr<DigitTendons> build_digit_tendons(const Subject& subject, const std::string& digit,
                                                  const TendonOptions& options,
                                                  const NetDescription* description,
                                                  const NetBuildOptions& net) {
  if (options.hood != Hood::kFloatingNet) {
    require(description == nullptr, "net '{}' is given, but the hood asked for is not a net",
            description == nullptr ? "" : description->name);
    return build_linear_tendons(subject, digit, options);
  }
  require(description != nullptr, "a hood that floats needs the description of a net");
  return build_net_tendons(subject, digit, options, *description, net);
}

std::unique_ptr<DigitTendons> build_net_tendons(const Subject& subject, const std::string& digit,
                                                const TendonOptions& options,
                                                const NetDescription& description,
                                                const NetBuildOptions& net) {
  TendonOptions separate = options;
  separate.hood = Hood::kSeparate;
  std::unique_ptr<DigitTendons> linear = build_linear_tendons(subject, digit, separate);
  // Keep the muscles that pull the net even if all joints that they cross are frozen.
  separate.kept = pulling_muscles(free_digit(subject, linear->digit()), description);
  const auto& names = linear->digit().names.muscles;
  if (any_of(separate.kept, [&](const std::string& muscle) { return !contains(names, muscle); }))
    linear = build_linear_tendons(subject, digit, separate);
  BuiltNet built = build_net(subject, linear->digit(), description, net);
  FreeFinger free = free_finger(subject, linear->digit(), description, net);
  return std::make_unique<NetTendons>(std::move(linear), std::move(built), NetSolverOptions{},
                                      std::move(free));
}

std::vector<std::string> ride_warnings(const Subject& subject, const NetTendons& tendons) {
  std::vector<std::string> warnings;
  const TendonDigit& digit = tendons.digit();
  if (digit.fidelity.path <= Path::kViaPoint) return warnings;
  for (const NetMuscle& m : tendons.net().muscles) {
    const std::string& muscle = digit.names.muscles[m.muscle];
    const std::vector<PathPoint>& path = pulled_strand(subject, muscle).path;
    if (!path.empty() && !path.back().rides_on.empty())
      warnings.push_back(fmt::format("{}: its origin rides on {} only without a net", muscle,
                                     path.back().rides_on));
  }
  return warnings;
}

TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                       const TendonTorque& pull) {
  TipStatics statics = tip_statics(digit, q);
  statics.R = pull.R;
  statics.tau_0 += pull.tau - pull.R.transpose() * t;
  return statics;
}

TendonTip tip_force(const DigitTendons& tendons, const Eigen::VectorXd& q,
                    const Eigen::VectorXd& t) {
  const TendonTorque pull = tendons.evaluate(q, t);
  return {tip_force(tip_statics(tendons.digit(), q, t, pull), t), pull.warning};
}

}  // namespace thenar
