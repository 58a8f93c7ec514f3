#pragma once

/// Excitations of muscles over time.

#include <string>
#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Piecewise linear excitations: straight between knots, constant before the first and after the
/// last. Two knots of one time are a jump.
struct Excitation {
  Eigen::VectorXd time;   // never falling [s] (knots)
  Eigen::MatrixXd value;  // 0..1 [1] (knots, muscles)
};

/// One linear piece of an excitation.
struct ExcitationPiece {
  double begin, end;            // [s]
  Eigen::VectorXd first, last;  // [1] (muscles)
  bool jumps;                   // from the piece before

  [[nodiscard]] Eigen::VectorXd at(double time) const;
};

/// Constant excitation. @param value  (muscles)
[[nodiscard]] Excitation constant_excitation(const Eigen::VectorXd& value);

/// Linear pieces from 0 to `seconds`, without gaps.
/// @throws InputError if shapes disagree, times fall, or a value is outside 0..1.
[[nodiscard]] std::vector<ExcitationPiece> excitation_pieces(const Excitation& excitation,
                                                             double seconds);

/// Reads a table:  a header  time_s,EDC,FDP,..,  then numbers. Muscles without a column stay at 0.
/// @param path     names the table in messages
/// @param muscles  in the order of the columns of the result
/// @param most     largest value: 1, or infinity for a table of tensions [N]
/// @throws DataError `path:line: what was wanted, what came`.
[[nodiscard]] Excitation parse_excitation(const std::string& text, const std::string& path,
                                          const std::vector<std::string>& muscles, double most = 1);

}  // namespace thenar
