#include "kinematics_fit/model/parameter.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/units.h"
#include "kinematics_fit/model/specimen_net.h"
#include "tendons/net/tangent_net.h"

namespace thenar {
namespace {

constexpr const char* kDirections[] = {"proximal", "dorsal", "radial"};

/// Unit of a kind in tables, and its default prior: sd of the population, sd between specimens, and
/// half the range of the bounds.
struct KindRow {
  ParameterKind kind;
  const char* unit;
  double sd, between_sd, range;
};
constexpr KindRow kKinds[] = {
    {ParameterKind::kAxisDirection, "deg", 8 * kDegree, 5 * kDegree, 45 * kDegree},
    {ParameterKind::kAxisPoint, "mm", 1.5 * kMm, 1 * kMm, 10 * kMm},
    {ParameterKind::kPathPoint, "mm", 1.5 * kMm, 1 * kMm, 10 * kMm},
    {ParameterKind::kArm, "mm", 1.5 * kMm, 1 * kMm, 10 * kMm},
    {ParameterKind::kHoodEntry, "1", 0.4, 0.3, 5},
    {ParameterKind::kHoodCentral, "1", 0.4, 0.3, 5},
    {ParameterKind::kHoodSlope, "1/rad", 0.4, 0.3, 5},
    {ParameterKind::kFriction, "1", 0.05, 0.02, 0.5},
    {ParameterKind::kLength, "mm", 3 * kMm, 2 * kMm, 15 * kMm},
    {ParameterKind::kTip, "mm", 1.5 * kMm, 1 * kMm, 10 * kMm},
    {ParameterKind::kSensorTilt, "deg", 8 * kDegree, 5 * kDegree, 45 * kDegree},
    {ParameterKind::kAngle, "deg", 5 * kDegree, 3 * kDegree, 20 * kDegree},
    {ParameterKind::kPostureAngle, "deg", 5 * kDegree, 3 * kDegree, 20 * kDegree},
    {ParameterKind::kOutOfPlane, "mm", 10 * kMm, 0, 200 * kMm},
    {ParameterKind::kGain, "1", 0.1, 0.05, 0.5},
    {ParameterKind::kTipForce, "1", 0.03, 0.03, 1},
    {ParameterKind::kPostureForce, "1", 0.03, 0.03, 1},
    {ParameterKind::kNetStiffness, "1", 0.4, 0.3, 3},
    {ParameterKind::kNetSlack, "1", 0.01, 0.01, 0.1},
    {ParameterKind::kNetPlace, "mm", 1.5 * kMm, 1 * kMm, 10 * kMm},
    {ParameterKind::kNetRadius, "mm", 0.7 * kMm, 0.5 * kMm, 2.5 * kMm},
    {ParameterKind::kNetEntry, "1", 0.4, 0.3, 5},
    {ParameterKind::kNetCentral, "1", 0.4, 0.3, 5},
    {ParameterKind::kNetSlope, "1/rad", 0.4, 0.3, 5}};

const KindRow& row_of(ParameterKind kind) {
  return *std::find_if(std::begin(kKinds), std::end(kKinds),
                       [&](const KindRow& row) { return row.kind == kind; });
}

/// Lists parameters with the default prior of their kind.
class Lister {
 public:
  Lister(const TendonDigit& digit, const std::vector<std::string>& postures)
      : digit_(digit), postures_(postures) {
    list_axes();
    list_strands();
    list_hood();
    if (digit.net) list_net(*digit.net);
    list_mounting();
  }
  std::vector<Parameter> parameters() { return std::move(list_); }

 private:
  void add(std::string name, ParameterKind kind, int item, int point, int component,
           double mean = 0) {
    const KindRow& b = row_of(kind);
    list_.push_back({std::move(name), kind, item, point, component, mean, b.sd, b.between_sd,
                     mean - b.range, mean + b.range});
  }

  void list_axes() {
    constexpr const char* kAlong[] = {"1", "2", "along"};
    for (int i = 0; i < static_cast<int>(digit_.names.hinges.size()); ++i) {
      // Add two tilts, two shifts and one along the axis, and the length of the bone beyond it.
      const std::string& joint = digit_.names.hinges[i];
      for (int c = 0; c < 2; ++c)
        add(fmt::format("axis/{}/direction/{}", joint, c + 1), ParameterKind::kAxisDirection, i, 0,
            c);
      for (int c = 0; c < 3; ++c)
        add(fmt::format("axis/{}/point/{}", joint, kAlong[c]), ParameterKind::kAxisPoint, i, 0, c);
      add(fmt::format("length/{}", joint), ParameterKind::kLength, i, 0, 0);
    }
  }

  void list_strands() {
    for (int s = 0; s < static_cast<int>(digit_.names.strands.size()); ++s) {
      // Add friction of the sheath, then points of the path, or moment arms if there is no path.
      const std::string& strand = digit_.names.strands[s];
      add(fmt::format("friction/{}", strand), ParameterKind::kFriction, s, 0, 0,
          digit_.model.friction[s]);
      for (int k = 0; k < static_cast<int>(digit_.model.paths[s].size()); ++k)
        for (int c = 0; c < 3; ++c)
          add(fmt::format("path/{}/{}/{}", strand, k + 1, kDirections[c]),
              ParameterKind::kPathPoint, s, k, c);
      if (!digit_.model.paths[s].empty()) continue;
      for (int j = 0; j < digit_.model.coordinates; ++j)
        add(fmt::format("arm/{}/{}", strand, digit_.names.coordinates[j]), ParameterKind::kArm, s,
            0, j, digit_.model.constant_arms(s, j));
    }
  }

  void list_hood() {
    for (int b = 0; b < static_cast<int>(digit_.model.hood_shares.size()); ++b) {
      // Add the fractions of each muscle's tension in the hood.
      const std::string& muscle = digit_.names.muscles[digit_.model.hood_shares[b].muscle];
      add(fmt::format("hood/{}/into", muscle), ParameterKind::kHoodEntry, b, 0, 0);
      add(fmt::format("hood/{}/central", muscle), ParameterKind::kHoodCentral, b, 0, 0);
      add(fmt::format("hood/{}/slope", muscle), ParameterKind::kHoodSlope, b, 0, 0);
    }
  }

  /// Returns whether a node is a point of a tendon's path.
  [[nodiscard]] bool on_path(const NetNode& node) const {
    for (const TendonPath<double>& path : digit_.model.paths)
      for (const PathNode<double>& point : path)
        if (lies_at(point, node.link, node.p)) return true;
    return false;
  }

  void list_net(const BuiltNet& built) {
    // Add stiffnesses of passive bands, first one for all, then one for each, and slack lengths.
    const Net& net = built.net;
    add("net/stiffness", ParameterKind::kNetStiffness, -1, 0, 0);
    for (int b = 0; b < static_cast<int>(net.bands.size()); ++b) {
      if (net.bands[b].muscle >= 0) continue;
      const std::string& band = net.bands[b].name;
      add(fmt::format("net/{}/stiffness", band), ParameterKind::kNetStiffness, b, 0, 0);
      add(fmt::format("net/{}/slack", band), ParameterKind::kNetSlack, b, 0, 0);
    }
    // Add insertions and exits, and the radii of bones that bands wrap.
    for (int i = 0; i < static_cast<int>(net.nodes.size()); ++i)
      for (int c = 0; c < 3 && !net.nodes[i].free && !on_path(net.nodes[i]); ++c)
        add(fmt::format("net/{}/{}", net.nodes[i].name, kDirections[c]), ParameterKind::kNetPlace,
            i, 0, c);
    for (int s = 0; s < static_cast<int>(net.surfaces.size()); ++s)
      if (internal::has_radius(net.surfaces[s]))
        add(fmt::format("net/{}/radius", net.surfaces[s].name), ParameterKind::kNetRadius, s, 0, 0);
    // Add muscles of which a part inserts on bone.
    for (int m = 0; m < static_cast<int>(built.muscles.size()); ++m) {
      const std::string& muscle = digit_.names.muscles[built.muscles[m].muscle];
      if (built.muscles[m].to_net < 1)
        add(fmt::format("net/{}/into", muscle), ParameterKind::kNetEntry, m, 0, 0);
      // Add muscles that divide between two pulls.
      if (!first_share(built, m)) continue;
      add(fmt::format("net/{}/central", muscle), ParameterKind::kNetCentral, m, 0, 0);
      add(fmt::format("net/{}/slope", muscle), ParameterKind::kNetSlope, m, 0, 0);
    }
  }

  void list_mounting() {
    for (int c = 0; c < 3; ++c) {
      // Add the point of the tip force, and the tilt of the load cell.
      add(fmt::format("tip/{}", kDirections[c]), ParameterKind::kTip, 0, 0, c);
      add(fmt::format("sensor/{}", kDirections[c]), ParameterKind::kSensorTilt, 0, 0, c);
    }
    for (int j = 0; j < digit_.model.coordinates; ++j) {
      // Add errors of joint angles, in all postures and in single ones.
      const std::string& joint = digit_.names.coordinates[j];
      add(fmt::format("angle/{}", joint), ParameterKind::kAngle, j, 0, 0);
      for (int k = 0; k < static_cast<int>(postures_.size()); ++k)
        add(fmt::format("angle/{}/{}", joint, postures_[k]), ParameterKind::kPostureAngle, j, k, 0);
    }
    // Add the weight of out-of-plane moments; then each muscle's gain and unexplained force.
    add("hold/out_of_plane", ParameterKind::kOutOfPlane, 0, 0, 0);
    for (int m = 0; m < static_cast<int>(digit_.names.muscles.size()); ++m) {
      const std::string& muscle = digit_.names.muscles[m];
      add(fmt::format("gain/{}", muscle), ParameterKind::kGain, m, 0, 0, 1);
      for (int c = 0; c < 3; ++c) {
        const std::string force = fmt::format("force/{}/{}", muscle, kDirections[c]);
        add(force, ParameterKind::kTipForce, m, 0, c);
        for (int k = 0; k < static_cast<int>(postures_.size()); ++k)
          add(force + "/" + postures_[k], ParameterKind::kPostureForce, m, k, c);
      }
    }
  }

  const TendonDigit& digit_;
  const std::vector<std::string>& postures_;
  std::vector<Parameter> list_;
};

}  // namespace

std::string display_unit(const Parameter& parameter) { return row_of(parameter.kind).unit; }

double display_scale(const Parameter& parameter) {
  const std::string unit = display_unit(parameter);
  return unit == "deg" ? 1 / kDegree : unit == "mm" ? 1 / kMm : 1;
}

std::vector<Parameter> list_parameters(const TendonDigit& digit,
                                       const std::vector<std::string>& postures) {
  return Lister(digit, postures).parameters();
}

bool matches_glob(const std::string& glob, const std::string& name) {
  // Backtrack to the last star only, whose match grows by one character; linear in practice.
  std::size_t g = 0, n = 0, star = std::string::npos, swallowed = 0;
  while (n < name.size()) {
    if (g < glob.size() && (glob[g] == '?' || glob[g] == name[n])) {
      ++g, ++n;
    } else if (g < glob.size() && glob[g] == '*') {
      // Let a star match nothing at first.
      star = g++;
      swallowed = n;
    } else if (star != std::string::npos) {
      // Let the last star match one more character.
      g = star + 1;
      n = ++swallowed;
    } else {
      return false;
    }
  }
  while (g < glob.size() && glob[g] == '*') ++g;
  return g == glob.size();
}

}  // namespace thenar
