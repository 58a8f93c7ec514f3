#pragma once

/// Grasp, or closed hand, as text, fields and a table.

#include <string>
#include <vector>

#include "api/close.h"
#include "report/fields.h"

namespace thenar {

/// Final value of a coordinate, and the reason why it stopped.
struct JointRow {
  std::string name;
  bool slides;             // true: a sliding joint
  double value;            // [rad] or [m]
  std::string shown;       // value in degrees or millimetres
  std::string stopped_by;  // name_of(StoppedBy)
  std::string reason;      // obstacle or limit that stopped it, in words
};

/// Returns a row for every coordinate; none if the hand did not close.
[[nodiscard]] std::vector<JointRow> joint_rows(const GraspResult& result);

/// Returns describe_outcome(), and advice if a hand closed on nothing because it did not approach.
[[nodiscard]] std::string explanation(const GraspResult& result);

/// Returns the contact model: "hard point" or "soft finger".
[[nodiscard]] std::string contact_model_of(const GraspResult& result);

/// Returns one line for all warnings with the same text up to the first comma or colon: the first
/// of them, and the number of further ones.
[[nodiscard]] std::vector<std::string> folded(const std::vector<std::string>& warnings);

/// Returns a text with quality, measures, robustness, joints, contacts, warnings.
[[nodiscard]] std::string text_of(const GraspResult& result);
[[nodiscard]] std::string text_of(const CloseResult& result);

[[nodiscard]] Fields fields_of(const GraspResult& result);
[[nodiscard]] Fields fields_of(const CloseResult& result);

/// Returns a table of contacts: surface, digit, position, normal and friction, in the object's
/// frame.
[[nodiscard]] Table table_of(const GraspResult& result);
/// Returns a table of coordinates: value, and what stopped each.
[[nodiscard]] Table table_of(const CloseResult& result);

}  // namespace thenar
