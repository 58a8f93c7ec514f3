#pragma once

/// Rows of the table of questions; each group stands in a file of its name.

#include <vector>

#include "questions/question.h"

namespace thenar::internal {

/// Moment arms, forces of fingertips, tendons of hoods.
void add_digit_questions(std::vector<Question>& all);
/// Fits, predictions, posteriors, bands of hoods.
void add_fit_questions(std::vector<Question>& all);
/// Contact sets, grasps, hands compared.
void add_contact_questions(std::vector<Question>& all);
/// Motions of digits and scenes, presses of pads.
void add_motion_questions(std::vector<Question>& all);

}  // namespace thenar::internal
