#pragma once

/// Phrases of every answer about a fingertip.

#include <functional>
#include <string>
#include <vector>

#include "api/named/digit_result.h"
#include "report/fields.h"
#include "report/sweep_axes.h"

namespace thenar {

/// Returns a warning if the finger is nearly straight: its condition, and the joint on which the
/// force depends most. Empty below kNearlyStraight.
/// @param change  of the force by each joint [N/rad] (joints)
[[nodiscard]] std::string posture_note(const std::vector<std::string>& joints, double condition,
                                       const Eigen::VectorXd& change);

/// Returns "per degree of joint rotation [N/deg]: PIP2 0.31, DIP2 0.12", the most first.
/// @param change  in `unit` per radian
[[nodiscard]] std::string change_line(const std::vector<std::string>& joints,
                                      const Eigen::VectorXd& change, const std::string& unit = "N");

/// Returns digit, posture or how many of them, and fidelity: the first lines of a text.
[[nodiscard]] std::string text_header(const DigitResult& about);

/// Returns subject, digit, posture and fidelity, and what `add` adds of the one posture; of several
/// postures, what varies and a list "postures" with a member for each.
[[nodiscard]] Fields digit_fields(
    const DigitResult& about, const std::function<void(std::size_t point, Fields& fields)>& add);

/// Returns the joints that vary, over the postures that are done.
[[nodiscard]] SweepAxes axes_of(const DigitResult& about);

/// Returns "PIP3_deg" of all joints, and their angles at a posture.
[[nodiscard]] std::vector<std::string> joint_header(const DigitResult& about);
[[nodiscard]] std::vector<std::string> joint_cells(const Eigen::VectorXd& q);

/// Returns a table with a row for each posture of an answer about a digit: what varies, then a line
/// of its own; dashes where it failed. @param line  cells of one of the points, under `header`
template <typename Answer, typename Line>
[[nodiscard]] Table posture_table(const Answer& answer, const std::vector<std::string>& header,
                                  const Line& line) {
  const SweepAxes axes = axes_of(answer);
  const std::vector<std::string> none(header.size(), "-");
  Table table{row({header_of(axes), header})};
  for (std::size_t i = 0; i < answer.points.size(); ++i) {
    const auto& point = answer.points[i];
    table.rows.push_back(row({cells_of(axes, i), point.message.empty() ? line(point) : none}));
  }
  return table;
}

}  // namespace thenar
