#pragma once

/// Verdict of the data on each band, and topologies that the data cannot distinguish.

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/progress.h"
#include "tendons/topology/fitted_nets.h"

namespace thenar {

/// Verdict on the existence of a band.
enum class Verdict { kYes, kNo, kUndecided };
inline constexpr std::array kVerdictNames{EnumName{Verdict::kYes, "yes"},
                                          EnumName{Verdict::kNo, "no"},
                                          EnumName{Verdict::kUndecided, "undecided"}};
[[nodiscard]] inline std::string to_string(Verdict verdict) {
  return name_in(kVerdictNames, verdict);
}

/// Verdict on one candidate band.
struct BandVerdict {
  std::string name;
  Verdict verdict = Verdict::kUndecided;
  /// Smallest chi^2 without the band minus the smallest with it, over inflation^2: > 0 supports the
  /// band; infinite if no net without (or with) it carries the loads [1].
  double evidence = 0;
  bool converged = true;  // true: the fits behind the verdict reached their tolerance
  double EA = 0;          // stiffness in the best net, 0 where it lacks the band [N]
  double EA_sd = 0;  // standard deviation of log EA with the others free [1]; infinite if the data
                     // do not determine it
  /// True: the data constrain EA more than its bounds: EA_sd is below that of log EA uniform
  /// between them, log(max_EA / min_EA) / sqrt(12).
  bool EA_determined = false;
};

/// Bands with dependent verdicts: the data require some of them, but not which.
struct BandGroup {
  std::vector<int> bands;              // candidates
  std::vector<std::vector<int>> ways;  // subsets of them that agree with the data
};

/// Result of the inference of a net.
struct [[nodiscard]] InferredNet {
  /// True: some topology carries all loads; false: other members are meaningless.
  bool found = false;
  Topology bands;          // best topology
  double misfit = 0;       // chi^2 of the best topology [1]
  bool converged = false;  // true: its fit reached its tolerance
  double residual = 0;     // largest out-of-balance force in the nets behind the verdicts [N]
  Eigen::Index rows = 0;   // number of fitted values
  double inflation = 1;    // factor of the noise that accounts for model errors [1]
  std::vector<BandVerdict> verdicts;  // verdict on each candidate
  std::vector<FittedNet> alike;       // topologies within `doubt` of the best, best first
  std::vector<BandGroup> groups;      // groups of two or more undecided bands
  /// Directions of log EA in the best net that no reading depends on, unit (candidates).
  std::vector<Eigen::VectorXd> blind;
  std::size_t tried = 0;  // number of topologies tried
  long solves = 0;        // number of equilibria solved
};

/// Options of assess_bands().
struct AssessOptions {
  /// Evidence above which a band is decided [1]. For Gaussian noise and a model that is linear in
  /// the band, a verdict is wrong with a probability of at most Phi(-sqrt(doubt)): 0.7 % at 6.
  double doubt = 6;
  double screen = 60;  // evidence below which bands are also tried in pairs [1]
  int max_pairs = 60;  // largest number of pairs
  int max_open = 5;    // largest number of undecided bands of which all combinations are tried
  int max_rounds = 8;  // rounds of changes around the best net
};

/// Assesses the bands by the topologies tried, after trying those that are missing: single changes
/// of the best net, pairs of them where the evidence is small, all combinations of undecided bands,
/// and other starts for the nets behind the evidence; repeated from every better net.
[[nodiscard]] InferredNet assess_bands(FittedNets& tried, const AssessOptions& options = {},
                                       const Progress& progress = {});

/// Computes sqrt(chi^2 / (rows - bands)) of the best net, at least 1: the factor by which its
/// errors exceed the stated noise. Where no candidate explains the data this is the error of the
/// model, and evidence is weighted by it.
[[nodiscard]] double model_error(const FittedNets& tried);

}  // namespace thenar
