#pragma once

/// Rows of the table of questions, one source file for each group.

#include <vector>

#include "questions/question.h"

namespace thenar::internal {

/// Adds poses, moment arms, fingertip forces and tendon solutions.
void add_digit_questions(std::vector<Question>& all);
/// Adds fits, predictions, posteriors and the inference of hood bands.
void add_fit_questions(std::vector<Question>& all);
/// Adds contact sets, grasps and comparisons of hands.
void add_contact_questions(std::vector<Question>& all);
/// Adds motions of digits and scenes, and presses of pads.
void add_motion_questions(std::vector<Question>& all);

}  // namespace thenar::internal
