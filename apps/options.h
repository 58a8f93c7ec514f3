#pragma once

/// Numbers as people type them: `FDP=10 FDS=5`.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// A plain number. @param what  how messages call it: "an angle [deg]"
/// @throws InputError if the whole text is not one finite number.
[[nodiscard]] double parse_number(const std::string& text, const std::string& what);

/// `NAME=number` pairs. @param what  how messages call one: "JOINT=degrees"
/// @throws InputError if a text is no such pair, or a name comes twice.
[[nodiscard]] std::map<std::string, double> parse_named_numbers(
    const std::vector<std::string>& texts, const std::string& what);

/// The numbers in the order of `names`, zero where not given (names).
/// @param kind  how messages call a name: "muscle"
/// @throws InputError for a name that is not among `names`, listing them.
[[nodiscard]] Eigen::VectorXd in_order(const std::map<std::string, double>& named,
                                       const std::vector<std::string>& names,
                                       const std::string& kind);

}  // namespace thenar
