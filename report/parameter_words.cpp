#include "report/parameter_words.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/lists.h"
#include "base/spatial.h"

namespace thenar {
namespace {

using Parts = std::vector<std::string>;

Parts split_path(const std::string& path) {
  Parts parts(1);
  for (const char c : path)
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// "proximally" of "proximal".
std::string adverb(const std::string& direction) { return direction + "ly"; }

/// Axis and tangents of a hinge at the straight digit, in the digit's directions.
struct HingeFrame {
  Eigen::Vector3d d;  // proximal, dorsal, radial (3)
  Eigen::Vector3d e;  // the tangent that the parameter moves along (3)
};

std::optional<HingeFrame> hinge_frame(const Parts& parts, const TendonDigit* digit) {
  if (digit == nullptr || (parts[3] != "1" && parts[3] != "2")) return {};
  const auto& hinges = digit->names.hinges;
  const auto found = std::find(hinges.begin(), hinges.end(), parts[1]);
  if (found == hinges.end()) return {};
  const Eigen::Vector3d& d =
      digit->model.tree[static_cast<std::size_t>(found - hinges.begin())].direction;
  const Tangents at = tangents(d);
  const Eigen::Matrix3d to_digit = digit->model.tip_axes.transpose();
  return HingeFrame{to_digit * d, to_digit * (parts[3] == "1" ? at.e1 : at.e2)};
}

/// Index of the component that is largest by size, and its sign.
std::pair<int, bool> nearest_direction(const Eigen::Vector3d& v) {
  Eigen::Index i = 0;
  v.cwiseAbs().maxCoeff(&i);
  return {static_cast<int>(i), v[i] < 0};
}

/// Returns "(0.71 proximal, 0.71 dorsal, 0.00 radial)" of a direction that is more than 20 degrees
/// off all three, or "" where one of them names it.
std::string oblique_words(const Eigen::Vector3d& v) {
  constexpr double kAlongCosine = 0.9396926207859084;  // Cosine of 20 degrees [1]
  const Eigen::Vector3d u = v.normalized();
  if (u.cwiseAbs().maxCoeff() >= kAlongCosine) return "";
  const Eigen::Array3d shown = (100 * u.array()).round() / 100 + 0.0;  // without a -0
  return fmt::format("({:.2f} proximal, {:.2f} dorsal, {:.2f} radial)", shown.x(), shown.y(),
                     shown.z());
}

std::string axis_words(const Parts& parts, const TendonDigit* digit) {
  if (parts.size() != 4) return "";
  // Describe a tilt by the axis of its rotation, a shift by its direction.
  const std::string axis = joint_words(parts[1]) + " axis";
  const std::optional<HingeFrame> frame = hinge_frame(parts, digit);
  if (parts[2] == "direction") {
    constexpr const char* kAbout[] = {"the digit's length", "the dorsal direction",
                                      "the radial direction"};
    if (!frame) return fmt::format("{}: tilt {} of 2", axis, parts[3]);
    const Eigen::Vector3d about = frame->d.cross(frame->e);
    if (const std::string oblique = oblique_words(about); !oblique.empty())
      return fmt::format("{}: tilt about {}", axis, oblique);
    return fmt::format("{}: tilt about {}", axis, kAbout[nearest_direction(about).first]);
  }
  constexpr const char* kTowards[] = {"proximally", "dorsally", "radially"};
  constexpr const char* kAway[] = {"distally", "palmarly", "ulnarly"};
  if (parts[3] == "along") return axis + ": shift along itself (no effect)";
  if (!frame) return fmt::format("{}: shift {} of 2", axis, parts[3]);
  if (const std::string oblique = oblique_words(frame->e); !oblique.empty())
    return fmt::format("{}: shift along {}", axis, oblique);
  const auto [direction, away] = nearest_direction(frame->e);
  return fmt::format("{}: shift {}", axis, (away ? kAway : kTowards)[direction]);
}

/// The bone beyond a joint.
std::string bone_words(const std::string& joint) {
  const std::string name = joint_words(joint).substr(0, 3);
  if (name == "DIP" || name.substr(0, 2) == "IP") return "distal phalanx";
  if (name == "PIP") return "middle phalanx";
  if (name == "MCP") return "proximal phalanx";
  return name == "CMC" ? "metacarpal" : "bone beyond " + joint;
}

std::string hood_words(const Parts& parts) {
  if (parts.size() != 3) return "";
  if (parts[2] == "into") return fmt::format("share of {} that enters the hood", parts[1]);
  if (parts[2] == "central") return fmt::format("share of {} in the hood's central slip", parts[1]);
  if (parts[2] == "slope")
    return fmt::format("how {}'s share in the central slip changes as the MCP joint flexes",
                       parts[1]);
  return "";
}

std::string net_words(const Parts& parts) {
  if (parts.size() == 2) return "stiffness of all bands of the net: log of a factor";
  if (parts.size() != 3) return "";
  const std::string& of = parts[1];
  if (parts[2] == "stiffness") return fmt::format("stiffness of band {}: log of a factor", of);
  if (parts[2] == "slack") return fmt::format("slack length of band {}: log of a factor", of);
  if (parts[2] == "radius") return fmt::format("radius of {}, over which bands bend: shift", of);
  if (parts[2] == "into") return fmt::format("share of {} that enters the net", of);
  if (parts[2] == "central")
    return fmt::format("share of {} in its first pull on the net, to the central slip", of);
  if (parts[2] == "slope")
    return fmt::format("how {}'s share in the first pull changes as the MCP joint flexes", of);
  return fmt::format("{} of the net: shift {}", of, adverb(parts[2]));
}

std::string angle_words(const Parts& parts) {
  const std::string error = "goniometer error at " + joint_words(parts[1]);
  return parts.size() > 2 ? error + " in posture " + parts[2] : error + ", all postures";
}

/// Kinds of parameters between specimens.
std::string scatter_words(const Parts& parts) {
  // Spreads between specimens are named by the kind of parameter.
  static const std::map<std::string, std::string> kinds{
      {"axis/direction", "tilts of axes"},
      {"axis/point", "places of axes"},
      {"path", "tendon paths"},
      {"arm", "moment arms"},
      {"hood/into", "shares into the hood"},
      {"hood/central", "shares in the central slip"},
      {"hood/slope", "slopes of the shares"},
      {"friction", "friction"},
      {"length", "bone lengths"},
      {"tip", "places of the force"},
      {"sensor", "tilts of load cells"},
      {"angle", "goniometer errors"},
      {"angle/posture", "goniometer errors of single postures"},
      {"gain", "tension gains"},
      {"force", "unexplained forces"},
      {"force/posture", "unexplained forces of single postures"},
      {"net/stiffness", "stiffnesses of the net"},
      {"net/slack", "slack lengths of the net"},
      {"net/place", "insertions of the net"},
      {"net/radius", "radii under the net"},
      {"net/into", "shares into the net"},
      {"net/central", "shares of muscles among their pulls on the net"},
      {"net/slope", "slopes of these shares"}};
  std::string kind = parts.size() > 1 ? parts[1] : "";
  for (std::size_t i = 2; i < parts.size(); ++i) kind += "/" + parts[i];
  const auto found = kinds.find(kind);
  return fmt::format("scatter between specimens of {} over that assumed",
                     found == kinds.end() ? kind : found->second);
}

std::string words_of(const Parts& parts, const TendonDigit* digit) {
  // Kinds with words of their own first, then those that one sentence describes.
  const std::string& first = parts[0];
  if (parts.size() < 2) return "";
  const std::string& second = parts[1];
  if (first == "axis") return axis_words(parts, digit);
  if (first == "hood") return hood_words(parts);
  if (first == "net") return net_words(parts);
  if (first == "angle") return angle_words(parts);
  if (first == "spread") return scatter_words(parts);
  if (first == "length") return "length of the " + bone_words(second);
  if (first == "path" && parts.size() == 4)
    return fmt::format("{}, path point {}: shift {}", second, parts[2], adverb(parts[3]));
  if (first == "arm" && parts.size() == 3)
    return fmt::format("moment arm of {} at {}", second, joint_words(parts[2]));
  if (first == "friction") return fmt::format("friction of {} in its sheath", second);
  if (first == "tip") return "where the force acts on the pulp: shift " + adverb(second);
  if (first == "sensor") return fmt::format("load cell turned about the {} direction", second);
  if (first == "gain") return fmt::format("share of the load on {} that reaches the digit", second);
  if (first == "force" && (parts.size() == 3 || parts.size() == 4))
    return fmt::format("tip force of {} that its geometry does not explain, {}{}", second,
                       parts.size() == 4 ? "in posture " + parts[3] + " alone, " : "",
                       adverb(parts[2]));
  if (first == "noise") return fmt::format("noise of {} over the stated noise", second);
  if (first == "hold") return "how stiff the clamp is sideways";
  return "";
}

std::string meaning(const std::string& name, const TendonDigit* digit) {
  // "H01: path/..": of one specimen.
  const std::size_t colon = name.find(": ");
  if (colon == std::string::npos) return words_of(split_path(name), digit);
  const std::string words = words_of(split_path(name.substr(colon + 2)), digit);
  return words.empty() ? "" : name.substr(0, colon + 2) + words;
}

}  // namespace

std::string joint_words(const std::string& joint) {
  static const std::map<std::string, std::string> motions{
      {"", ""}, {"_FE", " flexion"}, {"_AA", " abduction"}, {"_PS", " pronation"}};
  std::size_t end = 0;
  while (end < joint.size() && std::isupper(static_cast<unsigned char>(joint[end])) != 0) ++end;
  std::size_t rest = end;
  while (rest < joint.size() && std::isdigit(static_cast<unsigned char>(joint[rest])) != 0) ++rest;
  // The number is that of the digit in names of anatomy alone.
  const std::string place = joint.substr(0, end);
  const bool known = contains(std::vector<std::string>{"CMC", "MCP", "PIP", "DIP", "IP"}, place);
  const auto motion = motions.find(joint.substr(rest));
  if (!known || rest == end || motion == motions.end()) return joint;
  return place + motion->second;
}

std::string meaning_of(const std::string& name) { return meaning(name, nullptr); }

std::string meaning_of(const std::string& name, const TendonDigit& digit) {
  return meaning(name, &digit);
}

}  // namespace thenar
