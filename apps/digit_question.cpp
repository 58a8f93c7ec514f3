#include "apps/digit_question.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "apps/terminal.h"
#include "base/units.h"

namespace thenar {
DigitAtPosture find_digit(const DigitRequest& request) {
  const DigitCase digit = build_digit(request, TendonOptions().hood);
  print_warnings(digit.warnings);
  DigitAtPosture at =
      digit_at(digit, digit.map.empty() ? digit.grid.postures.front() : Eigen::VectorXd());
  print_warnings(at.warnings);
  return at;
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

OrderedJson json_header(const DigitAtPosture& at) {
  OrderedJson json{{"subject", at.subject}, {"digit", at.digit}};
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
