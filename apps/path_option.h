#pragma once

/// --path: on which model of tendon paths a question is answered.

#include <string>

#include <CLI/CLI.hpp>

#include "tendons/digit_tendons.h"

namespace thenar {

/// Adds --path via|fitted|wrapped.
void add_path_option(CLI::App& command, std::string& path);

/// The rung of that name; "" is that of via points.
/// @throws InputError listing the names.
[[nodiscard]] Path path_meant(const std::string& name);

/// Warns on stderr where an arm collapses at this posture, see vanishing_arms(), with what may
/// help.
/// @param linear  tendons of the digit without a net
void warn_of_collapse(const DigitTendons& linear, const Eigen::VectorXd& q);

}  // namespace thenar
