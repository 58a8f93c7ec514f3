#pragma once

/// Tendons whose joint torque is linear in their tensions: separate, or with fixed force fractions.

#include <memory>
#include <string>

#include "tendons/digit_tendons.h"

namespace thenar {

/// Builds one digit with  tau = R' t,  R = S' R_strands, where S distributes muscle tensions over
/// strands (strand_matrix) and R_strands are the strands' moment arms for the path model in
/// `options`.
/// @throws InputError if the digit, or an arm or path of a crossing strand, is missing, or if the
/// hood model is above fixed fractions.
[[nodiscard]] std::unique_ptr<DigitTendons> build_linear_tendons(const Subject& subject,
                                                                 const std::string& digit,
                                                                 const TendonOptions& options = {});

/// Builds a digit whose tendons run straight through the via points of its own model, or have
/// constant arms.
[[nodiscard]] std::unique_ptr<DigitTendons> straight_tendons(TendonDigit digit);

/// Computes the tensions in the slips of the hood for muscle tensions t (muscles) [N]; zero without
/// a hood.
[[nodiscard]] SlipTension slip_tension(const TendonModel<double>& model, const Eigen::VectorXd& q,
                                       const Eigen::VectorXd& t);

}  // namespace thenar
