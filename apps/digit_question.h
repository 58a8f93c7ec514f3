#pragma once

/// What every question about the forces of one fingertip starts from.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "data/io/subject.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// The options, as typed.
struct DigitQuestion {
  std::string subject;               // path of the subject file
  std::string digit;                 // empty: the only one that the subject has
  std::vector<std::string> posture;  // JOINT=degrees, or degrees in joint order
  std::vector<std::string> frozen;   // JOINT=degrees
  std::string path;                  // of tendons: via, fitted or wrapped; empty: via
  std::string map;                   // a published tip map; empty: the bones, or the first map
};

void add_options(CLI::App& command, DigitQuestion& question);

/// One digit in balance at one posture, with the names that its numbers go by.
struct DigitAtPosture {
  std::string subject;
  std::string digit;
  std::string map;                          // empty: built from bones and tendons
  std::string built;                        // fidelity, or which map, in words
  std::vector<std::string> rows;            // of the balance: joints, or Fx Fy Fz tx ..
  Eigen::VectorXd q;                        // [rad] (joints); empty for a map
  std::optional<Eigen::Matrix3d> tip_axes;  // proximal, dorsal, radial now, in world axes (3, 3)
  TipStatics statics;
  std::vector<StaticsDerivative> slopes;  // by each joint; empty for a map
  double condition;                       // of the tip's Jacobian [1]
};

/// Reads the subject and builds the digit; warns on stderr of angles outside their limits.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] DigitAtPosture find_digit(const DigitQuestion& question);

/// The name itself if the subject has such a digit, the only digit if the name is empty.
/// @throws InputError listing the digits there are.
[[nodiscard]] std::string choose_digit(const Subject& subject, const std::string& asked);

/// "FDP", "FDS": muscles whose largest force the subject does not say.
[[nodiscard]] std::vector<std::string> unlimited_muscles(const TipStatics& statics);

/// What to beware of where the finger is nearly straight: its condition, and the joint on which the
/// force hangs most. Empty below kNearlyStraight.
/// @param change  of the force by each joint [N/rad] (n)
[[nodiscard]] std::string posture_note(const DigitAtPosture& at, double condition,
                                       const Eigen::VectorXd& change);

/// "N per degree of posture: PIP2 0.31, DIP2 0.12", the most first.
[[nodiscard]] std::string change_line(const DigitAtPosture& at, const Eigen::VectorXd& change);

/// Subject, digit, posture and fidelity, as they open every JSON answer.
[[nodiscard]] nlohmann::ordered_json json_header(const DigitAtPosture& at);

/// The same as a line of text.
[[nodiscard]] std::string text_header(const DigitAtPosture& at);

}  // namespace thenar
