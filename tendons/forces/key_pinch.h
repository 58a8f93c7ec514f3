#pragma once

/// Key pinch under nerve blocks: measured losses of strength, and those of a model of the thumb.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// Nerve block with the measured loss of pinch strength.
struct NerveBlock {
  std::string nerve;  // "ulnar"
  /// Muscle -> remaining share of its F0, 0..1; muscles not named keep all [1].
  std::map<std::string, double> left;
  double loss = 0;     // measured share of pinch strength that is lost, 0..1 [1]
  double sd = 0;       // standard deviation of the measured loss from that of a model [1]
  std::string source;  // citation keys
  std::vector<std::string> assumed;  // keys of the file whose numbers are assumed, not measured
  int line = 0;                      // line of its table in the file [1]
};

/// Measured losses of one pinch.
struct PinchLosses {
  std::string name, description;
  std::string digit;      // "thumb"
  PostureRecord posture;  // [rad]
  /// Direction of the force, components along proximal, dorsal, radial (3) [1].
  Eigen::Vector3d direction{0, -1, 0};
  double tolerance = 0;  // half angle of the cone about the direction [rad]
  std::vector<NerveBlock> blocks;
  std::string path;            // path of the file; empty: made in code
  int line = 0, of_pinch = 0;  // lines of `digit`'s table and of [pinch] in the file [1]
};

/// Parses data/studies/key_pinch_blocks.toml; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] PinchLosses parse_pinch_losses(const std::string& text, const std::string& path);

/// Reads such a file. @throws DataError as parse_pinch_losses().
[[nodiscard]] PinchLosses read_pinch_losses(const std::string& path);

/// Pinch strength of a model.
struct PinchStrength {
  double intact = 0;     // force with all muscles [N]; NaN: its program is undecided
  Eigen::VectorXd loss;  // 1 - blocked / intact, 0..1, to 1e-9 [1] (blocks); NaN: `intact` is below
                         // kMinPinchForce, or a program is undecided
  /// Number of programs, intact or blocked, whose force is unbounded or was not found [1].
  int undecided = 0;
};

/// Smallest force of an intact pinch for which losses are computed [N].
inline constexpr double kMinPinchForce = 1e-6;

/// Computes the largest component of the pinned tip's force along the pinch, within its cone and
/// with every joint in balance (max_tip_load()), with all muscles and under every block. It is 0
/// where no force is in balance.
/// @param digit  with every F0 finite
/// @throws DataError at the file's line, or InputError if losses have no file: they are of another
/// digit, their posture names a joint, or a block a muscle, that the digit lacks.
[[nodiscard]] PinchStrength measure_pinch(const TendonDigit& digit, const PinchLosses& losses);

}  // namespace thenar
