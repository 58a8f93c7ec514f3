#pragma once

/// What every question about the tendons of one digit starts from.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "data/io/subject.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {

/// Rungs of the hood by their names on the command line.
inline const std::map<std::string, Hood> kHoods{
    {"separate", Hood::kSeparate}, {"fractions", Hood::kFractions}, {"net", Hood::kFloatingNet}};

/// The options, as typed.
struct TendonQuestion {
  std::string subject;               // path of the subject file
  std::string digit;                 // empty: the only one that the subject has
  std::string hood;                  // separate, fractions or net; empty: net
  std::string path;                  // of tendons outside of the net: via, fitted or wrapped
  std::string net;                   // name or path; empty: winslow if the hood is a net
  std::vector<std::string> posture;  // JOINT=degrees, or degrees in joint order
  std::vector<std::string> frozen;   // JOINT=degrees
  std::vector<std::string> tension;  // MUSCLE=newton
};

void add_options(CLI::App& command, TendonQuestion& question);

/// A digit with its tendons, ready to be asked.
struct TendonCase {
  std::string subject;
  std::string digit;
  std::unique_ptr<DigitTendons> tendons;
  const NetTendons* net;  // the same, if its hood is a net; else null
  Eigen::VectorXd q;      // the posture asked for [rad] (coordinates)
  Eigen::VectorXd t;      // tension of each muscle [N] (muscles)

  [[nodiscard]] const TendonDigit& bones() const { return tendons->digit(); }
};

/// Reads the subject and builds the digit; warns on stderr of angles outside their limits.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] TendonCase find_tendons(const TendonQuestion& question);

/// Subject, digit, fidelity, net and tensions, as they open every JSON answer.
[[nodiscard]] nlohmann::ordered_json json_header(const TendonCase& at);

/// The same as text.
[[nodiscard]] std::string text_header(const TendonCase& at);

/// "balanced", "unstable", "drawn in" or "stalled".
[[nodiscard]] std::string name_of(NetStatus status);

/// "sound", "rough", .. "unbalanced".
[[nodiscard]] std::string name_of(TendonStatus status);

}  // namespace thenar
