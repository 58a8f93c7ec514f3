#pragma once

/// Values as TOML text that reads back without loss.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Returns a number with as few digits as restore every bit, including the sign of zero: 0.1, -0.0,
/// 1e-07.
/// @throws InputError if it is not finite.
[[nodiscard]] std::string toml_number(double value);

/// Returns a text in quotes, with escapes.
[[nodiscard]] std::string toml_quoted(const std::string& text);

/// Lists: of numbers, of quoted texts, of the components of a vector.
[[nodiscard]] std::string toml_list(const std::vector<double>& values);
[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);  // quoted
[[nodiscard]] std::string toml_list(const Eigen::Vector3d& values);
[[nodiscard]] std::string toml_rows(const Eigen::Matrix3d& matrix);  // a list of its rows

/// Splits citation keys "A, B".
[[nodiscard]] std::vector<std::string> keys_in(const std::string& keys);

/// Returns the citation keys "A, B" as a list: ["A", "B"].
[[nodiscard]] std::string toml_keys(const std::string& keys);

/// Returns the keys of the entries of a BibTeX text, in its order.
[[nodiscard]] std::vector<std::string> citation_keys(const std::string& bibtex);

/// Returns the keys of data/sources.bib at build time.
[[nodiscard]] const std::vector<std::string>& known_sources();

}  // namespace thenar
