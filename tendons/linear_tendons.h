#pragma once

/// Tendons whose joint torque is linear in their tensions: separate, or shared by fixed fractions.

#include <memory>
#include <string>

#include "tendons/digit_tendons.h"

namespace thenar {

/// Builds one digit with  tau = R' t,  R = S' R_strands, where S shares tensions between strands
/// (strand_matrix) and R_strands are the strands' moment arms on the rung of paths in `options`.
/// @throws InputError if the digit, or an arm or path of a crossing strand, is missing, or if the
/// rung of the hood is above fixed fractions.
[[nodiscard]] std::unique_ptr<DigitTendons> build_linear_tendons(const Subject& subject,
                                                                 const std::string& digit,
                                                                 const TendonOptions& options = {});

/// A digit whose tendons run straight through the points of its own model, or have constant arms.
[[nodiscard]] std::unique_ptr<DigitTendons> straight_tendons(TendonDigit digit);

/// Tension in the slips of the hood when muscles pull with t (muscles) [N]; zero without a hood.
[[nodiscard]] SlipTension slip_tension(const TendonModel<double>& model, const Eigen::VectorXd& q,
                                       const Eigen::VectorXd& t);

}  // namespace thenar
