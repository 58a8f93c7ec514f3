#pragma once

/// What every question about the tendons of one digit starts from.

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "api/digits.h"
#include "report/json.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {

/// What `thenar tendon solve` and `sweep` are asked.
struct TendonQuestion {
  DigitRequest digit;
  std::vector<std::string> tension;  // MUSCLE=newton, as typed
};

void add_options(CLI::App& command, TendonQuestion& question);

/// A digit with its tendons, ready to be asked.
struct TendonCase {
  std::string subject;
  std::string digit;
  std::shared_ptr<const DigitTendons> tendons;
  const NetTendons* net;  // the same, if its hood is a net; else null
  PostureGrid grid;       // the postures asked for
  Eigen::VectorXd t;      // tension of each muscle [N] (muscles)
  std::vector<SourceText> sources;

  [[nodiscard]] const TendonDigit& bones() const { return tendons->digit(); }
};

/// Builds the digit; says on stderr what to doubt.
/// @throws InputError or DataError saying what is unknown or missing.
[[nodiscard]] TendonCase find_tendons(const TendonQuestion& question);

/// "MCP3_FE=10 PIP3=45 deg" of the joints that vary.
[[nodiscard]] std::string angles_in_words(const TendonCase& at, const Eigen::VectorXd& q);

/// Subject, digit, fidelity, net and tensions, as they open every JSON answer.
[[nodiscard]] OrderedJson json_header(const TendonCase& at);

/// The same as text.
[[nodiscard]] std::string text_header(const TendonCase& at);

/// "balanced", "unstable", "drawn in" or "stalled".
[[nodiscard]] std::string name_of(NetStatus status);

/// "sound", "rough", .. "unbalanced".
[[nodiscard]] std::string name_of(TendonStatus status);

}  // namespace thenar
