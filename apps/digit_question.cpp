#include "apps/digit_question.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "apps/path_option.h"
#include "api/posture.h"
#include "report/table.h"
#include "report/json.h"
#include "base/error.h"
#include "hand/tip_manipulability.h"
#include "tendons/forces/tip_map.h"
#include "tendons/linear_tendons.h"
#include "tendons/tendon_model.h"

namespace thenar {
namespace {

/// Digits with bones, then those with nothing but a tip map.
std::vector<std::string> digit_names(const Subject& subject) {
  std::vector<std::string> names;
  for (const Digit& digit : subject.digits) names.push_back(digit.name);
  for (const TipMap& map : subject.tip_maps)
    if (std::count(names.begin(), names.end(), map.digit) == 0) names.push_back(map.digit);
  return names;
}

bool has_bones(const Subject& subject, const std::string& digit) {
  return std::any_of(subject.digits.begin(), subject.digits.end(),
                     [&](const Digit& d) { return d.name == digit; });
}

DigitAtPosture digit_from_map(const Subject& subject, const std::string& digit,
                              const DigitQuestion& question) {
  const TipMap& map = find_tip_map(subject, digit, question.map);
  require(
      question.posture.empty() && question.frozen.empty() && question.path.empty(),
      "tip map '{}' stands for one posture of its own; leave out --posture, --frozen and --path",
      map.name);
  DigitAtPosture at{subject.name, digit, map.name, "", {"Fx", "Fy", "Fz"}, {}, {}, {}, {}, 1};
  at.built = fmt::format("published tip map '{}', in its own x, y, z", map.name);
  for (const std::string& moment : moment_rows(map)) at.rows.push_back(moment);
  at.statics = statics_from_tip_map(subject, map);
  return at;
}

/// Digits whose joints some muscle crosses.
std::vector<std::string> digits_with_tendons(const Subject& subject) {
  std::vector<std::string> names;
  for (const Digit& digit : subject.digits)
    if (!build_tendon_digit(subject, digit.name).names.muscles.empty()) names.push_back(digit.name);
  return names;
}

DigitAtPosture digit_from_bones(const Subject& subject, const std::string& name,
                                const DigitQuestion& question) {
  TendonOptions options;
  options.frozen = parse_frozen(subject, question.frozen);
  options.path = path_meant(question.path);
  const std::unique_ptr<DigitTendons> tendons = build_linear_tendons(subject, name, options);
  const TendonDigit& digit = tendons->digit();
  require(!digit.names.muscles.empty(),
          "no muscle of subject '{}' crosses a free joint of digit '{}'; digits with muscles: {}",
          subject.name, name, listed(digits_with_tendons(subject)));
  const Eigen::VectorXd q = parse_posture(digit.skeleton, question.posture);
  warn_of_limits(digit.skeleton, q);
  warn_of_collapse(*tendons, q);
  const TendonTorque pull = tendons->pull(
      q, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(digit.names.muscles.size())));
  require(trusted(pull.status), "tendon paths are not to be trusted here: {}", pull.warning);
  if (!pull.warning.empty()) fmt::print(stderr, "thenar: warning: {}\n", pull.warning);
  const TipStatics statics = tip_statics(*tendons, q);
  const TreeState<double> state = pose_tree(digit.model.tree, q);
  const int link = digit.model.tip_link;
  const Eigen::Matrix3d turned =
      link < 0 ? Eigen::Matrix3d::Identity() : state[static_cast<std::size_t>(link)].X.R;
  return {subject.name,
          name,
          "",
          describe(digit.fidelity),
          digit.names.coordinates,
          q,
          turned * digit.model.tip_axes,
          statics,
          statics_derivatives(*tendons, q),
          tip_manipulability(statics.J).condition};
}

}  // namespace

void add_options(CLI::App& command, DigitQuestion& question) {
  command.add_option("subject", question.subject, "Subject file (TOML)")->required();
  command.add_option("--digit", question.digit, "thumb, index, middle, ring or little");
  command.add_option("--posture", question.posture,
                     "JOINT=degrees ..., or degrees in joint order; others stay at 0");
  command.add_option("--frozen", question.frozen, "JOINT=degrees ...: joints welded there");
  add_path_option(command, question.path);
  command.add_option("--map", question.map, "A published tip map instead of bones and tendons");
}

std::string choose_digit(const Subject& subject, const std::string& asked) {
  const std::vector<std::string> names = digit_names(subject);
  require(!asked.empty() || names.size() == 1, "wanted --digit; subject '{}' has {}", subject.name,
          listed(names));
  if (asked.empty()) return names.front();
  require(std::count(names.begin(), names.end(), asked) > 0,
          "subject '{}' has no digit '{}'; there are {}", subject.name, asked, listed(names));
  return asked;
}

DigitAtPosture find_digit(const DigitQuestion& question) {
  const Subject subject = read_subject(question.subject);
  const std::string digit = choose_digit(subject, question.digit);
  const bool map = !question.map.empty() || !has_bones(subject, digit);
  return map ? digit_from_map(subject, digit, question)
             : digit_from_bones(subject, digit, question);
}

std::vector<std::string> unlimited_muscles(const TipStatics& statics) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < statics.muscles.size(); ++i)
    if (std::isinf(statics.max_tension[static_cast<Eigen::Index>(i)]))
      names.push_back(statics.muscles[i]);
  return names;
}

std::string posture_note(const DigitAtPosture& at, double condition,
                         const Eigen::VectorXd& change) {
  if (condition < kNearlyStraight || change.size() == 0) return "";
  Eigen::Index most = 0;
  change.cwiseAbs().maxCoeff(&most);
  const std::string& joint = at.rows[static_cast<std::size_t>(most)];
  if (!std::isfinite(condition) || !std::isfinite(change[most]))
    return "singular posture: forces along the bones have no limit, and change without limit as a "
           "joint leaves it";
  return fmt::format(
      "nearly singular posture (condition {:.3g}): one degree of {} changes the force by {:.3g} N, "
      "to first order; goniometers err by several",
      condition, joint, std::abs(change[most]) * kDegree);
}

std::string change_line(const DigitAtPosture& at, const Eigen::VectorXd& change) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(change.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::abs(change[a]) > std::abs(change[b]);
  });
  std::string line = "N per degree of posture:";
  for (const Eigen::Index i : order)
    line += fmt::format("{} {} {:.3g}", i == order.front() ? "" : ",",
                        at.rows[static_cast<std::size_t>(i)], change[i] * kDegree);
  return line;
}

nlohmann::ordered_json json_header(const DigitAtPosture& at) {
  nlohmann::ordered_json json{{"subject", at.subject}, {"digit", at.digit}};
  if (at.map.empty()) json["posture_deg"] = to_json(at.rows, at.q / kDegree);
  if (!at.map.empty()) json["map"] = at.map;
  json["fidelity"] = at.built;
  return json;
}

std::string text_header(const DigitAtPosture& at) {
  std::string posture;
  for (Eigen::Index i = 0; i < at.q.size(); ++i)
    posture += fmt::format(" {}={:.4g}", at.rows[static_cast<std::size_t>(i)], at.q[i] / kDegree);
  return fmt::format("{} of {}{}{}\nmodel: {}\n", at.digit, at.subject,
                     posture.empty() ? "" : " at", posture + (posture.empty() ? "" : " deg"),
                     at.built);
}

}  // namespace thenar
