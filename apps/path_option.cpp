#include "apps/path_option.h"

#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "tendons/vanishing_arms.h"

namespace thenar {
namespace {

const std::map<std::string, Path> kPaths{
    {"via", Path::kViaPoint}, {"fitted", Path::kFitted}, {"wrapped", Path::kWrapped}};

}  // namespace

void add_path_option(CLI::App& command, std::string& path) {
  command
      .add_option("--path", path,
                  "Tendon paths: straight between via points (default), wrapped over the subject's "
                  "surfaces, or polynomials fitted to these")
      ->check(CLI::IsMember({"via", "fitted", "wrapped"}));
}

Path path_meant(const std::string& name) {
  if (name.empty()) return Path::kViaPoint;
  const auto found = kPaths.find(name);
  require(found != kPaths.end(), "there is no path '{}'; there are via, fitted, wrapped", name);
  return found->second;
}

void warn_of_collapse(const DigitTendons& linear, const Eigen::VectorXd& q) {
  std::vector<std::string> arms;
  for (const VanishingArm& arm : vanishing_arms(linear, q))
    arms.push_back(fmt::format("{} at {}: {:.2g} mm, {:.2g} mm elsewhere in its range", arm.muscle,
                               arm.joint, 1e3 * arm.arm, 1e3 * arm.most));
  if (arms.empty()) return;
  const bool via = linear.digit().fidelity.path == Path::kViaPoint;
  fmt::print(
      stderr, "thenar: warning: tendons run too close to a joint here: arms of {}; {}\n",
      fmt::join(arms, "; "),
      via ? "straight runs cut through it, and --path wrapped helps where the subject has a surface"
          : "the subject has no surface there");
}

}  // namespace thenar
