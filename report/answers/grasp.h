#pragma once

/// A grasp, or a hand that closed, as text, fields and a table.

#include <string>
#include <vector>

#include "api/close.h"
#include "report/fields.h"

namespace thenar {

/// Final value of a coordinate, and the reason why it went no farther.
struct JointRow {
  std::string name;
  bool slides;             // rather than turns
  double value;            // [rad] or [m]
  std::string shown;       // value in degrees or millimetres
  std::string stopped_by;  // name_of(StoppedBy)
  std::string reason;      // obstacle or limit that stopped it, in words
};

/// Returns every coordinate; none where nothing was closed.
[[nodiscard]] std::vector<JointRow> joint_rows(const GraspResult& result);

/// Returns outcome_words(), and what to do where a hand closed on nothing because it stayed where
/// it is.
[[nodiscard]] std::string explanation(const GraspResult& result);

/// Returns "hard point" or "soft finger".
[[nodiscard]] std::string contact_model_of(const GraspResult& result);

/// Returns one line for all warnings of a kind, those that begin alike up to the first comma or
/// colon: the first of them, with how many more there are.
[[nodiscard]] std::vector<std::string> folded(const std::vector<std::string>& warnings);

/// Returns a text with quality, measures, robustness, joints, contacts, warnings.
[[nodiscard]] std::string text_of(const GraspResult& result);
[[nodiscard]] std::string text_of(const CloseResult& result);

[[nodiscard]] Fields fields_of(const GraspResult& result);
[[nodiscard]] Fields fields_of(const CloseResult& result);

/// Returns the contacts: surface, digit, position, normal and friction, in the object's frame.
[[nodiscard]] Table table_of(const GraspResult& result);
/// Returns the coordinates: value, and what stopped each.
[[nodiscard]] Table table_of(const CloseResult& result);

}  // namespace thenar
