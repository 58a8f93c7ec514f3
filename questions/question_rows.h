#pragma once

/// Rows of the table of questions; each group stands in a file of its name.

#include <vector>

#include "questions/question.h"

namespace thenar::internal {

/// Moment arms, forces of fingertips, tendons of hoods.
void add_digit_questions(std::vector<Question>& all);

}  // namespace thenar::internal
