#pragma once

/// Muscle excitations over time.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Piecewise linear excitations: linear between knots, constant before the first and after the
/// last. Two knots at the same time are a jump.
struct Excitation {
  Eigen::VectorXd time;   // nondecreasing [s] (knots)
  Eigen::MatrixXd value;  // 0..1 [1] (knots, muscles)
};

/// Linear piece of an excitation.
struct ExcitationPiece {
  double begin = 0, end = 0;    // time interval [s]
  Eigen::VectorXd first, last;  // values at its ends [1] (muscles)
  bool jumps = false;           // true: discontinuous with the piece before

  [[nodiscard]] Eigen::VectorXd value_at(double time) const;
};

/// Builds a constant excitation. @param value  0..1 [1] (muscles)
[[nodiscard]] Excitation constant_excitation(const Eigen::VectorXd& value);

/// Splits an excitation into linear pieces that cover 0 to `seconds` without gaps.
/// @throws InputError if shapes disagree, times fall, or a value is outside 0..1.
[[nodiscard]] std::vector<ExcitationPiece> excitation_pieces(const Excitation& excitation,
                                                             double seconds);

/// Reads a table:  a header  time_s,EDC,FDP,..,  then numbers. Muscles without a column have 0.
/// @param path       name of the table in messages
/// @param muscles    muscles in the order of the result's columns
/// @param max_value  largest allowed value: 1, or infinity for a table of tensions [N]
/// @throws DataError `path:line: what was wanted, what came`.
[[nodiscard]] Excitation parse_excitation(const std::string& text, const std::string& path,
                                          const std::vector<std::string>& muscles,
                                          double max_value = 1);

}  // namespace thenar
