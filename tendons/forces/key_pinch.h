#pragma once

/// Key pinch under nerve blocks: what people lose of it, and what a model of the thumb does.

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/experiment.h"
#include "tendons/tendon_model.h"

namespace thenar {

/// A nerve block, and the measured loss of pinch.
struct NerveBlock {
  std::string nerve;                   // "ulnar"
  std::map<std::string, double> left;  // muscle -> share of its F0 that it keeps, 0..1; muscles not
                                       // named keep all [1]
  double loss = 0;                     // measured share of pinch that is lost, 0..1 [1]
  double sd = 0;                       // of the measured loss about that of a model [1]
  std::string source;                  // citation keys
  std::vector<std::string> assumed;    // keys of the file whose numbers are nobody's measurements
  int line = 0;                        // of its table in the file [1]
};

/// Measured losses of one pinch.
struct PinchLosses {
  std::string name, description;
  std::string digit;                    // "thumb"
  PostureRecord posture;                // [rad]
  Eigen::Vector3d direction{0, -1, 0};  // of the force, along proximal, dorsal, radial (3) [1]
  double tolerance = 0;                 // half angle of the cone about it [rad]
  std::vector<NerveBlock> blocks;
  std::string path;            // of the file; empty: made in code
  int line = 0, of_pinch = 0;  // of `digit`'s table and of [pinch] in it [1]
};

/// Reads data/studies/key_pinch_blocks.toml; the format is in docs/data_format.md.
/// @throws DataError  `path:line: what was wanted, what came`.
[[nodiscard]] PinchLosses parse_pinch_losses(const std::string& text, const std::string& path);

[[nodiscard]] PinchLosses read_pinch_losses(const std::string& path);

/// Pinch of a model.
struct PinchStrength {
  double intact = 0;     // with all muscles [N]; NaN: its program is undecided
  Eigen::VectorXd loss;  // 1 - blocked / intact, 0..1, to 1e-9 [1] (blocks); NaN: `intact` is below
                         // kNoPinch, or a program is undecided
  int undecided = 0;     // programs, of the intact digit and of blocks, whose force is unbounded or
                         // was not found [1]
};

/// Least force of an intact pinch whose loss is measured [N].
inline constexpr double kNoPinch = 1e-6;

/// The largest component of the pinned tip's force along the pinch, within its cone and with every
/// joint in balance (max_tip_load()), with all muscles and under every block. It is 0 where no
/// force is in balance.
/// @param digit  with every F0 finite
/// @throws DataError at the file's line, or InputError if losses are of no file: they are of
/// another digit, their posture names a joint, or a block a muscle, that the digit has not.
[[nodiscard]] PinchStrength measure_pinch(const TendonDigit& digit, const PinchLosses& losses);

}  // namespace thenar
