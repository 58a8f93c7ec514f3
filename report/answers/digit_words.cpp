#include "report/answers/digit_words.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/units.h"
#include "base/words.h"
#include "report/table.h"
#include "tendons/forces/posture_sensitivity.h"

namespace thenar {
namespace {

constexpr double kNoChange = 1e-9;  // rounding error, over the largest change [1]

/// " MCP3_FE=10 PIP3=45" of the joints that stay as they are.
std::string standing_angles(const DigitResult& about) {
  std::string text;
  if (about.grid.postures.empty()) return text;
  const Eigen::VectorXd& q = about.grid.postures.front();
  for (int i = 0; i < static_cast<int>(q.size()); ++i)
    if (!contains(about.grid.varied, i))
      text += fmt::format(" {}={:.4g}", nth(about.rows, i), q[i] / kDegree);
  return text;
}

}  // namespace

std::string posture_note(const std::vector<std::string>& joints, double condition,
                         const Eigen::VectorXd& change) {
  if (condition < kNearlyStraight || change.size() == 0) return "";
  Eigen::Index most = 0;
  change.cwiseAbs().maxCoeff(&most);
  if (!std::isfinite(condition) || !std::isfinite(change[most]))
    return "singular posture: forces along the bones have no limit, and change without limit as a "
           "joint leaves it";
  return fmt::format(
      "nearly singular posture (condition {:.3g}): one degree of {} changes the force by {:.3g} N, "
      "to first order; goniometers err by several",
      condition, nth(joints, most), std::abs(change[most]) * kDegree);
}

std::string change_line(const std::vector<std::string>& joints, const Eigen::VectorXd& change,
                        const std::string& unit) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(change.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::abs(change[a]) > std::abs(change[b]);
  });
  std::string line = "per degree of joint rotation [" + unit + "/deg]:";
  if (change.size() == 0) return line;
  const double largest = change.array().isFinite().select(change.array().abs(), 0).maxCoeff();
  for (const Eigen::Index i : order) {
    // Infinite where the posture is singular; rounding errors are shown as 0.
    const bool changes = std::abs(change[i]) > kNoChange * largest;
    line += fmt::format("{} {} {}", i == order.front() ? "" : ",", nth(joints, i),
                        std::isfinite(change[i])
                            ? fmt::format("{:.3g}", changes ? change[i] * kDegree : 0)
                            : "unknown");
  }
  return line;
}

std::string text_header(const DigitResult& about) {
  const std::string standing = standing_angles(about);
  const std::string at = standing.empty() ? "" : standing + " deg";
  if (about.single())
    return fmt::format("{} of {}{}{}\nmodel: {}\n", about.digit, about.subject,
                       at.empty() ? "" : " at", at, about.built);
  return fmt::format("{} of {}, {}{}{}\nmodel: {}\n", about.digit, about.subject,
                     counted(about.outcome.done, "posture"), at.empty() ? "" : "; others at", at,
                     about.built);
}

Fields digit_fields(const DigitResult& about,
                    const std::function<void(std::size_t point, Fields& fields)>& add) {
  Fields fields{{"subject", about.subject}, {"digit", about.digit}};
  // A single posture has its fields at the top, a sweep in a list.
  const auto add_posture = [&](std::size_t i, Fields& to) {
    to.add("posture", units::kDegree, about.rows, about.grid.postures[i]);
  };
  if (about.single()) {
    if (about.map.empty())
      add_posture(0, fields);
    else
      fields.add("map", about.map);
    fields.add("fidelity", about.built);
    if (about.outcome.done > 0) add(0, fields);
  } else {
    fields.add("fidelity", about.built);
    fields.add("varied", axes_of(about).names);
    std::vector<Fields> postures(about.outcome.done);
    for (std::size_t i = 0; i < about.outcome.done; ++i) {
      add_posture(i, postures[i]);
      add(i, postures[i]);
    }
    fields.add("postures", std::move(postures));
    if (about.outcome.done < about.outcome.asked) fields.add("stopped_before", about.outcome.asked);
  }
  fields.add("warnings", about.outcome.warnings);
  return fields;
}

SweepAxes axes_of(const DigitResult& about) {
  return axes_of(about.grid, about.rows, about.outcome.done);
}

std::vector<std::string> joint_header(const DigitResult& about) {
  return about.map.empty() ? with_ending(about.rows, "_deg") : std::vector<std::string>{};
}

std::vector<std::string> joint_cells(const Eigen::VectorXd& q) {
  return transformed(q, [](double angle) {
    const double degrees_now = angle / kDegree;
    return fmt::format("{:.10g}", std::abs(degrees_now) < 1e-9 ? 0 : degrees_now);
  });
}

}  // namespace thenar
