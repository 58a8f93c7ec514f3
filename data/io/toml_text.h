#pragma once

/// Values as TOML that reads back without loss.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// As few digits as bring every bit back, signs of zero included: 0.1, -0.0, 1e-07.
/// @throws InputError if it is not finite.
[[nodiscard]] std::string toml_number(double value);

/// In quotes, with escapes.
[[nodiscard]] std::string toml_quoted(const std::string& text);

[[nodiscard]] std::string toml_list(const std::vector<double>& values);
[[nodiscard]] std::string toml_list(const std::vector<std::string>& values);  // quoted
[[nodiscard]] std::string toml_list(const Eigen::Vector3d& values);
[[nodiscard]] std::string toml_rows(const Eigen::Matrix3d& matrix);  // a list of its rows

/// The citation keys in "A, B".
[[nodiscard]] std::vector<std::string> keys_in(const std::string& keys);

/// "A, B" as a list: ["A", "B"].
[[nodiscard]] std::string toml_keys(const std::string& keys);

// The citation keys that data files may name.

/// The keys of the entries of a BibTeX text, in its order.
[[nodiscard]] std::vector<std::string> citation_keys(const std::string& bibtex);

/// The keys of data/sources.bib, as it was when the program was built.
[[nodiscard]] const std::vector<std::string>& known_sources();

}  // namespace thenar
