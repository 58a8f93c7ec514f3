#include "api/named/digits.h"

#include <cmath>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "api/named/digit_result.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "data/io/subject_doubts.h"
#include "hand/tip_manipulability.h"
#include "tendons/forces/tip_map.h"
#include "tendons/net/build_tendons.h"
#include "tendons/vanishing_arms.h"

namespace thenar {
namespace internal {
const std::map<std::string, std::string_view>& nets();  // data/nets, by file name
}

namespace {

/// Digits with bones, then those with nothing but a tip map.
std::vector<std::string> digit_names(const Subject& subject) {
  std::vector<std::string> names = names_of(subject.digits);
  for (const TipMap& map : subject.tip_maps)
    if (!contains(names, map.digit)) names.push_back(map.digit);
  return names;
}

bool has_bones(const Subject& subject, const std::string& digit) {
  return find_named(subject.digits, digit) != nullptr;
}

/// Digits whose joints some muscle crosses.
std::vector<std::string> digits_with_tendons(const Subject& subject) {
  std::vector<std::string> names;
  for (const Digit& digit : subject.digits)
    if (!build_tendon_digit(subject, digit.name).names.muscles.empty()) names.push_back(digit.name);
  return names;
}

/// Returns the model rungs of a request; the hood is that of the net if a net is named.
TendonOptions rungs_of(const DigitRequest& request, const Subject& subject, Hood hood) {
  TendonOptions rungs;
  rungs.hood = hood;
  rungs.path = request.path.value_or(default_path(subject));
  rungs.frozen = frozen_joints(subject, request.frozen);
  rungs.wrist_mode = request.wrist;
  return rungs;
}

bool can_run_straight(const DigitCase& at, const NetDescription* net) {
  TendonOptions rungs = at.rungs;
  rungs.path = Path::kViaPoint;
  try {
    (void)build_digit_tendons(at.subject, at.digit, rungs, net);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Builds the digit's tendons. Wrapped paths that were not requested may be impossible, for example
/// where a point is inside a surface; the message then suggests other paths.
std::shared_ptr<const DigitTendons> tendons_on_rungs(const DigitCase& at, bool path_asked,
                                                     const NetDescription* net) {
  try {
    return build_digit_tendons(at.subject, at.digit, at.rungs, net);
  } catch (const InputError& error) {
    if (path_asked || at.rungs.path != Path::kWrapped || !can_run_straight(at, net)) throw;
    throw InputError(fmt::format(
        "{}; paths wrap where tendons name surfaces: straight ones, 'via', leave them out",
        error.what()));
  }
}

/// Builds the tendons on the requested rungs; adds the text of a net to the sources.
void build_tendons_of(const DigitRequest& request, Hood default_hood, DigitCase& at) {
  // A net replaces the hood, so the default hood applies only if no net is named.
  const std::optional<Hood> hood =
      request.hood || !request.net.empty() ? request.hood : std::optional<Hood>(default_hood);
  const std::string name = requested_net(hood, request.net);
  // Without a net tendons are linear in their tensions: hood fractions or separate slips.
  if (name.empty()) {
    at.rungs = rungs_of(request, at.subject, *hood);
    at.tendons = tendons_on_rungs(at, request.path.has_value(), nullptr);
  } else {
    at.rungs = rungs_of(request, at.subject, Hood::kFloatingNet);
    // Keep the text of the net among the sources, so that the result can be repeated.
    at.sources.push_back(net_source(name));
    const NetDescription net = parse_net(at.sources.back().text, at.sources.back().path);
    at.tendons = tendons_on_rungs(at, request.path.has_value(), &net);
  }
  // Tell whether the tendons are those of a net, whose arms depend on tensions.
  at.net = dynamic_cast<const NetTendons*>(at.tendons.get());
  require_field(
      "digit", !at.bones().names.muscles.empty(),
      "no muscle of subject '{}' crosses a free joint of digit '{}'; digits with muscles: {}",
      at.subject.name, at.digit, listed(digits_with_tendons(at.subject)));
}

/// Limits of all postures, origins that do not ride, and arms that collapse where the joints that
/// vary are not moved yet.
void add_warnings(const DigitRequest& request, DigitCase& at) {
  at.warnings = subject_doubts(at.subject);
  append_all(at.warnings, at.grid.warnings);
  if (at.net != nullptr) append_all(at.warnings, ride_warnings(at.subject, *at.net));
  const DigitTendons& linear = at.net != nullptr ? at.net->linear() : *at.tendons;
  const Eigen::VectorXd q = posture_of(at.bones().skeleton, request.posture);
  append_all(at.warnings, collapse_warnings(linear, q));
  append_all(at.warnings, reversal_warnings(linear, at.grid));
}

DigitAtPosture at_map(const DigitCase& at) {
  const TipMap& map = find_tip_map(at.subject, at.digit, at.map);
  DigitAtPosture found{
      at.subject.name, at.digit, map.name, "", {"Fx", "Fy", "Fz"}, {}, {}, {}, {}, 1, {}};
  found.built = fmt::format("published tip map '{}', in its own x, y, z", map.name);
  append_all(found.rows, moment_rows(map));
  found.statics = statics_from_tip_map(at.subject, map);
  return found;
}

}  // namespace

SourceText subject_source(const std::string& name_or_path, const std::string& data,
                          const char* field) {
  // Leave folders, pipes and devices of that name to the reader, which reports them.
  return in_field(field, [&] {
    std::error_code none;
    if (is_file(name_or_path)) require_kind(name_or_path, {"subject"});
    return read_source(
        std::filesystem::exists(name_or_path, none)
            ? name_or_path
            : named_file("subject", name_or_path, "subjects", ".toml", data_folders(data)));
  });
}

DigitCase build_digit(const DigitRequest& request, Hood default_hood) {
  // Read the subject with passive moments or without them.
  DigitCase at;
  at.sources = {request.subject_text.empty() ? subject_source(request.subject, request.data)
                                             : SourceText{request.subject, request.subject_text}};
  at.passive = request.passive;
  at.subject = with_passive(parse_subject(at.sources.front().text, at.sources.front().path),
                            request.passive);
  at.digit = choose_digit(at.subject, request.digit);
  // Use the tip map of a digit without bones, which has a single posture.
  if (!request.map.empty() || !has_bones(at.subject, at.digit)) {
    at.map = in_field("map", [&] { return find_tip_map(at.subject, at.digit, request.map).name; });
    const bool straight = request.path.value_or(Path::kViaPoint) == Path::kViaPoint;
    const char* field = !request.posture.empty()  ? "posture"
                        : !request.frozen.empty() ? "frozen"
                        : !request.vary.empty()   ? "vary"
                                                  : "path";
    require_field(
        field, std::string_view(field) == "path" && straight,
        "tip map '{}' is for one posture of its own: it takes no posture, frozen joints, swept "
        "joints or paths",
        at.map);
    return at;
  }
  // Build the tendons first: the grid of postures needs the names of free joints.
  build_tendons_of(request, default_hood, at);
  at.grid = posture_grid(at.bones().skeleton, request.posture, request.vary);
  add_warnings(request, at);
  return at;
}

DigitAtPosture digit_at(const DigitCase& at, const Eigen::VectorXd& q) {
  // A map brings its statics along; a digit with bones computes them at q.
  if (!at.map.empty()) return at_map(at);
  require(at.net == nullptr, "wanted tendons whose torque is linear in tensions, got a net");
  const TendonDigit& digit = at.bones();
  // Moment arms at zero tension, since linear tendons have the same at any.
  const TendonTorque pull = at.tendons->evaluate(
      q, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(digit.names.muscles.size())));
  require(is_trusted(pull.status), "tendon paths are not to be trusted here: {}", pull.warning);
  // Compute the statics, and rotate the tip's axes with its link.
  const TipStatics statics = tip_statics(*at.tendons, q);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const int link = digit.model.tip_link;
  const Eigen::Matrix3d turned =
      link < 0 ? Eigen::Matrix3d::Identity() : state[static_cast<std::size_t>(link)].X.R;
  // Gather the result, with derivatives for the sensitivity to the posture.
  DigitAtPosture found{at.subject.name,
                       at.digit,
                       "",
                       describe(digit.fidelity),
                       digit.names.coordinates,
                       q,
                       turned * digit.model.tip_axes,
                       statics,
                       statics_derivatives(*at.tendons, q),
                       tip_manipulability(statics.J, statics.W).condition,
                       {}};
  if (!pull.warning.empty()) found.warnings.push_back(pull.warning);
  found.tip = moved(state, link, digit.model.tip);
  found.plane_normal = plane_normal(statics.J, statics.W);
  return found;
}

Eigen::VectorXd tensions(const DigitCase& at, const std::map<std::string, double>& named) {
  const std::vector<std::string> muscles =
      at.map.empty() ? at.bones().names.muscles : digit_at(at, {}).statics.muscles;
  // A muscle of the subject that passes the digit by is no misspelt one.
  for (const auto& [name, tension] : named)
    require_field("tension",
                  !at.map.empty() || contains(muscles, name) ||
                      find_named(at.subject.muscles, name) == nullptr,
                  "'{}' crosses no free joint of the digit", name);
  // Tensions in the order of the muscles, in newtons; muscles that are not named are slack.
  Eigen::VectorXd t = in_order(named, muscles, "muscle", "tension");
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    const std::string& muscle = muscles[static_cast<std::size_t>(i)];
    require_field("tension", t[i] >= 0, "wanted a tension >= 0 of '{}', got {} N", muscle, t[i]);
    require_field("tension", t[i] <= kMaxTension,
                  "wanted a tension of '{}' up to {} N, got {} N: no tendon withstands it", muscle,
                  kMaxTension, t[i]);
  }
  return t;
}

std::string choose_digit(const Subject& subject, const std::string& asked) {
  const std::vector<std::string> names = digit_names(subject);
  require_field("digit", !asked.empty() || names.size() == 1, "choose a digit; subject '{}' has {}",
                subject.name, listed(names));
  if (asked.empty()) return names.front();
  require_field("digit", contains(names, asked), "subject '{}' has no digit '{}'{} there are {}",
                subject.name, asked, hint_before_list(asked, names), listed(names));
  return asked;
}

std::vector<std::string> unlimited_muscles(const TipStatics& statics) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < statics.muscles.size(); ++i)
    if (std::isinf(statics.max_tension[static_cast<Eigen::Index>(i)]))
      names.push_back(statics.muscles[i]);
  return names;
}

std::vector<std::string> collapse_warnings(const DigitTendons& linear, const Eigen::VectorXd& q) {
  // List arms that nearly vanish here but not elsewhere in the joint's range.
  std::vector<std::string> arms;
  for (const VanishingArm& arm : vanishing_arms(linear, q))
    arms.push_back(fmt::format("{} at {}: {:.2g} mm, {:.2g} mm elsewhere in its range", arm.muscle,
                               arm.joint, 1e3 * arm.arm, 1e3 * arm.max_arm));
  if (arms.empty()) return {};
  // Straight runs between points cut through the joint when it flexes far; wrapped paths go round
  // it.
  const bool via = linear.digit().fidelity.path == Path::kViaPoint;
  return {fmt::format(
      "tendons run too close to a joint here: arms of {}; {}", fmt::join(arms, "; "),
      via ? "straight runs cut through it, and wrapped paths help where the subject has a surface"
          : "they bend over no surface there")};
}

std::vector<std::string> reversal_warnings(const DigitTendons& linear, const PostureGrid& grid) {
  const TendonDigit& digit = linear.digit();
  constexpr std::size_t kLookedAt = 1000;  // postures of a grid, evenly spaced
  const std::size_t stride = 1 + (grid.postures.size() - 1) / kLookedAt;
  // Look at evenly spaced postures of a large grid, and count those with arms of the wrong sign.
  std::vector<std::string> first;
  Eigen::VectorXd where;
  std::size_t count = 0, of = 0;
  for (std::size_t i = 0; i < grid.postures.size(); i += stride, ++of) {
    const Eigen::VectorXd& q = grid.postures[i];
    const TendonTorque pull = linear.evaluate(
        q, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(digit.names.muscles.size())));
    const std::vector<ReversedArm> arms = reversed_arms(digit, pull.R);
    if (!is_trusted(pull.status) || arms.empty() || count++ > 0) continue;
    // Describe the first posture in full.
    where = q;
    for (const ReversedArm& arm : arms)
      first.push_back(fmt::format("{} at {} ({:.2g} mm)", arm.muscle, arm.joint, 1e3 * arm.arm));
  }
  if (count == 0) return {};
  const std::string place = grid.varied.empty()
                                ? "here"
                                : fmt::format("at {} of {} postures{}, first at {}", count, of,
                                              stride > 1 ? " looked at" : "",
                                              varied_angles(digit.names.coordinates, grid, where));
  return {
      fmt::format("moment arms have an unexpected sign {}: {}; the subject's arms_mm or the muscle "
                  "names imply the opposite sign",
                  place, fmt::join(first, ", "))};
}

std::vector<std::string> overload_warnings(const std::vector<std::string>& muscles,
                                           const Eigen::VectorXd& max_tension,
                                           const Eigen::VectorXd& t) {
  std::vector<std::string> over;
  for (Eigen::Index m = 0; m < t.size(); ++m)
    if (t[m] > max_tension[m] * (1 + 1e-9))
      over.push_back(fmt::format("{} is pulled with {:.4g} N, but can make {:.4g} N",
                                 muscles[static_cast<std::size_t>(m)], t[m], max_tension[m]));
  return over;
}

std::vector<std::string> known_nets() {
  std::vector<std::string> names;
  for (const auto& [file, text] : internal::nets())
    names.push_back(std::filesystem::path(file).stem());
  return names;
}

SourceText net_source(const std::string& name_or_path) {
  if (is_file(name_or_path)) return read_source(name_or_path);
  const auto found = internal::nets().find(name_or_path + ".toml");
  require_field("net", found != internal::nets().end(),
                "there is no net '{}', nor a file of that name{} nets: {}", name_or_path,
                hint_before_list(name_or_path, known_nets()), listed(known_nets()));
  return {"built-in " + std::string(found->first), std::string(found->second)};
}

std::string requested_net(const std::optional<Hood>& hood, const std::string& net) {
  if (net.empty()) return hood == Hood::kFloatingNet ? "extensor_hood" : "";
  require_field("net", !hood || hood == Hood::kFloatingNet,
                "net '{}' needs a hood that is a net, got the hood '{}'", net,
                hood == Hood::kSeparate ? "separate" : "fractions");
  return net;
}

NetDescription find_net(const std::string& name_or_path) {
  const SourceText source = net_source(name_or_path);
  return parse_net(source.text, source.path);
}

}  // namespace thenar
