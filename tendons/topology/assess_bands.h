#pragma once

/// Verdict of the data on each band, and topologies that they cannot tell apart.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/progress.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

enum class Verdict { kYes, kNo, kUndecided };
inline constexpr std::array kVerdictNames{EnumName{Verdict::kYes, "yes"},
                                          EnumName{Verdict::kNo, "no"},
                                          EnumName{Verdict::kUndecided, "undecided"}};
[[nodiscard]] inline std::string to_string(Verdict verdict) {
  return name_in(kVerdictNames, verdict);
}

/// Verdict on one candidate.
struct BandVerdict {
  std::string name;
  Verdict verdict = Verdict::kUndecided;
  double evidence = 0;  // least chi^2 without the band, less the least with it, per inflation^2:
                        // > 0 for it; infinite if no net without (or with) it carries the loads [1]
  bool converged = true;  // the fits that this rests on reached their tolerance
  double EA = 0;          // in the best net, 0 where it lacks the band [N]
  double EA_sd = 0;       // of log EA, alone: the others free [1]; infinite if the data do not tell
  bool EA_told = false;  // the data say more of EA than its bounds: EA_sd is below the sd of log EA
                         // spread evenly between them, log(most / least) / sqrt(12)
};

/// Bands whose verdicts hang on each other: the data want some of them, but not which.
struct BandGroup {
  std::vector<int> bands;              // candidates
  std::vector<std::vector<int>> ways;  // sets of them that the data allow together
};

/// Result of the inference of a net.
struct [[nodiscard]] InferredNet {
  bool found = false;      // some topology carries all loads; otherwise nothing else is meant
  Topology bands;          // the best
  double misfit = 0;       // its chi^2 [1]
  bool converged = false;  // its fit reached its tolerance
  double residual = 0;     // out of balance at worst in the nets that verdicts rest on [N]
  Eigen::Index rows = 0;   // numbers that were fitted
  double inflation = 1;    // of the noise, for errors of the model [1]
  std::vector<BandVerdict> verdicts;   // of each candidate
  std::vector<FittedNet> alike;        // within `doubt` of the best, best first
  std::vector<BandGroup> groups;       // of two undecided bands or more
  std::vector<Eigen::VectorXd> blind;  // directions of log EA in the best net that no reading
                                       // feels, unit (candidates)
  std::size_t tried = 0;               // topologies
  long solves = 0;                     // equilibria
};

struct AssessOptions {
  /// Evidence from which a band is decided. For Gaussian noise and a model that is linear in the
  /// band, a verdict is wrong with a chance of at most Phi(-sqrt(doubt)): 0.7 % at 6.
  double doubt = 6;
  double screen = 60;  // bands of less evidence are also tried in pairs [1]
  int max_pairs = 60;
  int max_open = 5;    // undecided bands of which all combinations are tried
  int max_rounds = 8;  // of changes around the best net
};

/// Assesses the bands by the topologies tried, after trying those that are missing: single changes
/// of the best net, pairs of them where the evidence is small, all combinations of undecided bands,
/// and other starts for the nets that the evidence rests on; repeated from every better net.
[[nodiscard]] InferredNet assess_bands(FittedNets& tried, const AssessOptions& options = {},
                                       const Progress& progress = {});

/// sqrt(chi^2 / (rows - bands)) of the best net, at least 1: by how much its errors exceed the
/// stated noise. Where no candidate explains the data this is the error of the model, and evidence
/// is weighed by it.
[[nodiscard]] double model_error(const FittedNets& tried);

}  // namespace thenar
