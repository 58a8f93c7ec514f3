#pragma once

/// What every question about the forces of one fingertip starts from.

#include <string>

#include "api/digits.h"
#include "report/json.h"

namespace thenar {

/// Builds the digit; says on stderr what to doubt.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] DigitAtPosture find_digit(const DigitRequest& request);

/// What to beware of where the finger is nearly straight: its condition, and the joint on which the
/// force hangs most. Empty below kNearlyStraight.
/// @param change  of the force by each joint [N/rad] (n)
[[nodiscard]] std::string posture_note(const DigitAtPosture& at, double condition,
                                       const Eigen::VectorXd& change);

/// "N per degree of posture: PIP2 0.31, DIP2 0.12", the most first.
[[nodiscard]] std::string change_line(const DigitAtPosture& at, const Eigen::VectorXd& change);

/// Subject, digit, posture and fidelity, as they open every JSON answer.
[[nodiscard]] OrderedJson json_header(const DigitAtPosture& at);

/// The same as a line of text.
[[nodiscard]] std::string text_header(const DigitAtPosture& at);

}  // namespace thenar
