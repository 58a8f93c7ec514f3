#pragma once

/// Phrases in all results about a fingertip.

#include <functional>
#include <string>
#include <vector>

#include "api/named/digit_result.h"
#include "report/fields.h"
#include "report/sweep_axes.h"

namespace thenar {

/// Returns a warning if the finger is nearly straight: its condition, and the joint on which the
/// force depends most. Empty below kNearlyStraight.
/// @param change  derivative of the force by each joint angle [N/rad] (joints)
[[nodiscard]] std::string posture_note(const std::vector<std::string>& joints, double condition,
                                       const Eigen::VectorXd& change);

/// Returns the sensitivity to each joint, the largest first: "per degree of joint rotation [N/deg]:
/// PIP2 0.31, DIP2 0.12".
/// @param change  derivative in `unit` per radian (joints)
[[nodiscard]] std::string change_line(const std::vector<std::string>& joints,
                                      const Eigen::VectorXd& change, const std::string& unit = "N");

/// Returns the first lines of a text: digit, posture or number of postures, and fidelity.
[[nodiscard]] std::string text_header(const DigitResult& about);

/// Returns subject, digit, posture and fidelity, and the fields that `add` adds for a single
/// posture; for several postures, the joints that vary and a list "postures" with an entry for
/// each.
[[nodiscard]] Fields digit_fields(
    const DigitResult& about, const std::function<void(std::size_t point, Fields& fields)>& add);

/// Returns the joints that vary, with their values at the completed postures.
[[nodiscard]] SweepAxes axes_of(const DigitResult& about);

/// Return the column names of all joints, "PIP3_deg", and their angles at a posture.
[[nodiscard]] std::vector<std::string> joint_header(const DigitResult& about);
[[nodiscard]] std::vector<std::string> joint_cells(const Eigen::VectorXd& q);

/// Returns a table with a row for each posture: the joints that vary, then the cells of `line`;
/// dashes where there is no result. @param line  returns the cells of one point, under `header`
template <typename Result, typename Line>
[[nodiscard]] Table posture_table(const Result& result, const std::vector<std::string>& header,
                                  const Line& line) {
  const SweepAxes axes = axes_of(result);
  const std::vector<std::string> none(header.size(), "-");
  Table table{row({header_of(axes), header})};
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const auto& point = result.points[i];
    table.rows.push_back(row({cells_of(axes, i), point.message.empty() ? line(point) : none}));
  }
  return table;
}

}  // namespace thenar
