#pragma once

/// Inference of an extensor net from measured fingertip forces: bands that the forces require,
/// exclude or leave open, and the best next measurements.
///
///     InferNetRequest request;
///     request.experiment = "synek2019_H01";
///     request.subject = "synek2019_middle";
///     const InferNetResult bands = infer_net(request);

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "base/fidelity.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "kinematics_fit/bands/rank_trials.h"
#include "solvers/status.h"
#include "tendons/topology/net_search_stop.h"

namespace thenar {

/// Search method for topologies.
enum class InferMethod {
  kSparse,  // fits all candidate bands at once, with a penalty on each: select_bands()
  kExplore  // evolves a population of nets by changes of single bands: search_nets()
};
inline constexpr std::array kInferMethodNames{EnumName{InferMethod::kSparse, "sparse"},
                                              EnumName{InferMethod::kExplore, "explore"}};
/// Returns the method of a name. @throws InputError unless it is "sparse" or "explore".
[[nodiscard]] inline InferMethod infer_method_named(const std::string& name) {
  return value_in(kInferMethodNames, name, "method");
}
[[nodiscard]] inline std::string name_of(InferMethod method) {
  return name_in(kInferMethodNames, method);
}

/// Options of an inference: the forces, the subject and the candidate bands.
struct InferNetRequest {
  std::string experiment;       // a file, or the name of one of experiments/; required
  std::string subject;          // a file, or the name of one of subjects/; required
  std::string data;             // folder with subjects/ ..; empty: the usual ones
  std::string net = "winslow";  // net of all candidate bands: name or file
  std::optional<Path> path;     // tendon paths outside of the net; absent: default_path()
  InferMethod method = InferMethod::kSparse;  // search for bands
  unsigned seed = 1;  // seed of kExplore, and of draws and sampled sets with `free`
  int propose = 3;    // largest number of proposed tests
  // Further free parameters besides those that the settings of a fit free: "slack", "paths",
  // "stiffness", or globs on names of parameters as FitSources::also_free. If not empty, bands get
  // probabilities by band_posterior(); `method` must be kSparse and `path` absent.
  std::vector<std::string> free = {};
  std::string settings = {};  // settings for `free`: file, or name of fits/; empty: the digit's
  std::vector<std::string> bands = {};  // globs on the bands in question for `free`; empty: all
  BandPosteriorOptions sets = {};       // options for `free`
};

/// Returns the globs on parameter names for a word of InferNetRequest::free; the word itself if it
/// is a glob. @throws InputError if it is neither.
[[nodiscard]] std::vector<std::string> parameter_globs(const std::string& word);

/// End nodes of a candidate band.
struct BandEnds {
  std::string from, to;  // names of nodes
};

/// Measurement that would distinguish the remaining nets.
struct ProposedTest {
  std::string name;         // posture and tensions [N]: "MinorFlex EDC=3.28 RI=5.32"
  double disagreement = 0;  // mean squared difference of equally good nets, in sds of a reading [1]
};

/// Result of an inference in which slack lengths, paths or other parameters are free.
struct FreeInference {
  std::vector<std::string> freed;  // requested globs
  std::string settings;            // path of the settings
  int parameters = 0;              // free parameters with all bands
  int numbers = 0;                 // measured force components
  BandPosterior posterior;         // probabilities of bands
  std::vector<RankedTrial> next;   // most informative first, at most `propose`
  double next_mean = 0;            // mean information of the trials of the pool [bit]
  std::size_t pool = 0;            // ranked trials
};

/// Result of an inference.
struct [[nodiscard]] InferNetResult {
  InferNetRequest request;  // request that was answered
  Outcome outcome;          // stopped: verdicts of the nets tried so far; stalled: no net was found
  std::string experiment, subject, net;    // names
  Fidelity fidelity;                       // fidelity of the digit
  InferredNet inferred;                    // verdict on each band; not if parameters are free
  std::vector<BandEnds> ends;              // end nodes of each of inferred.verdicts
  std::vector<ProposedTest> next;          // most informative first
  std::optional<NetSearchStop> stop;       // why the search ended; absent: kSparse does not search
  std::vector<SourceText> sources;         // experiment, subject, net; with `free` settings, too
  std::optional<FreeInference> free = {};  // for free parameters; `inferred`, `next` and `stop` are
                                           // then empty, `ends` those of its bands
};

/// Fits the nets that candidate bands can form to all trials in which a muscle pulls the net, and
/// judges every band by the increase of the misfit without it. With `free` every band in question
/// gets a probability, marginalised over all free parameters, and trials are ranked by their
/// expected information.
/// @throws InputError or DataError saying what is unknown, missing or wrong.
[[nodiscard]] InferNetResult infer_net(const InferNetRequest& request,
                                       const Progress& progress = {});

}  // namespace thenar
