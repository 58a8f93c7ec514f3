#include "api/tendon_infer.h"

#include <algorithm>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "api/fit.h"
#include "api/named/digits.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "kinematics_fit/bands/band_posterior.h"
#include "kinematics_fit/bands/band_problems.h"
#include "kinematics_fit/bands/net_records.h"
#include "kinematics_fit/fit_residuals.h"
#include "tendons/net/build_net.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net_tendons.h"
#include "tendons/topology/search_nets.h"
#include "tendons/topology/select_bands.h"

namespace thenar {
namespace {

/// Inputs of the inference.
struct InferenceCase {
  CandidateNet candidate;
  std::vector<TendonRecord> records;
  std::vector<TendonTest> pool;
  MeasurementNoise noise;
};

/// Ends of bands by their names.
std::vector<BandEnds> ends_of(const Net& net, const std::vector<std::string>& bands) {
  std::vector<BandEnds> ends;
  const std::vector<NetNode>& nodes = net.nodes;
  for (const std::string& name : bands) {
    const NetBand& band = net.bands[static_cast<std::size_t>(band_index(net, name))];
    ends.push_back({nodes[static_cast<std::size_t>(band.a)].name,
                    nodes[static_cast<std::size_t>(band.b)].name});
  }
  return ends;
}

/// Reads the three files, and records them in the result.
InferenceCase read_case(const InferNetRequest& request, InferNetResult& answer) {
  // Files.
  const SourceText forces =
                       read_source(experiment_file(request.experiment, request.data, "experiment")),
                   person = subject_source(request.subject, request.data),
                   bands = net_source(request.net);
  const Experiment experiment = parse_experiment(forces.text, forces.path);
  const Subject subject = parse_subject(person.text, person.path);
  const NetDescription net = parse_net(bands.text, bands.path);
  // The digit with all candidate bands.
  TendonOptions tendons;
  tendons.hood = Hood::kFloatingNet;
  tendons.path = request.path.value_or(default_path(subject));
  const auto built = build_digit_tendons(subject, experiment.digit, tendons, &net);
  const auto& netted = dynamic_cast<const NetTendons&>(*built);
  InferenceCase at{candidate_of(netted),
                   net_records(netted, experiment),
                   possible_tests(netted, experiment),
                   {experiment.sd_relative, experiment.sd_floor}};
  // Name the experiment, the subject and the net that the answer is about.
  answer.experiment = experiment.name;
  answer.subject = subject.name;
  answer.net = at.candidate.net.name;
  answer.fidelity = netted.digit().fidelity;
  answer.ends = ends_of(at.candidate.net, candidate_names(at.candidate));
  answer.sources = {forces, person, bands};
  return at;
}

/// Tests of the pool, in the order of their rank.
std::vector<ProposedTest> proposed(const std::vector<RankedTest>& ranked,
                                   const std::vector<TendonTest>& pool, int most) {
  std::vector<ProposedTest> tests;
  for (const RankedTest& rank : ranked) {
    if (static_cast<int>(tests.size()) >= most) break;
    tests.push_back({pool[static_cast<std::size_t>(rank.test)].name, rank.disagreement});
  }
  return tests;
}

void infer_by_selection(const InferenceCase& at, int propose, const Progress& progress,
                        InferNetResult& answer) {
  // Select bands by a price on their stiffness, then judge each by what its absence costs.
  BandFitter fitter(at.candidate, at.records);
  FittedNets tried(fitter);
  (void)select_bands(tried, {}, progress);
  answer.inferred = assess_bands(tried, {}, progress);
  if (!answer.inferred.found) return;
  // Models weigh, and readings differ, by the noise that the best of them leaves.
  const double inflation = answer.inferred.inflation;
  std::vector<FittedNet> nets = answer.inferred.alike;
  for (FittedNet& net : nets) net.fit.misfit /= inflation * inflation;
  MeasurementNoise noise = at.noise;
  noise.floor *= inflation;
  noise.relative *= inflation;
  // Rank the tests by how differently the remaining nets would answer.
  NetForwardModel forecast(at.candidate, at.pool);
  answer.next =
      proposed(rank_tests(forecast, at.pool, nets, fitter.typical_EA(), noise), at.pool, propose);
}

void infer_by_search(const InferenceCase& at, const InferNetRequest& request,
                     const Progress& progress, InferNetResult& answer) {
  std::mt19937 random(request.seed);
  NetSearchOptions options;
  options.noise = at.noise;
  NetSearchResult found =
      search_nets(at.candidate, at.records, {at.pool, {}}, random, options, progress);
  answer.inferred = std::move(found.net);
  answer.next = proposed(found.next, at.pool, request.propose);
  answer.stop = found.stop;
}

/// Returns settings that also free the requested parameters; parameters that a digit lacks are
/// ignored.
std::string with_freed(std::string settings, const std::vector<std::string>& globs) {
  for (const std::string& glob : globs)
    settings += fmt::format(
        "\n[[parameter]]\nmatch = \"{}\"\noptional = \"yes\"\nstate = \"free\"\n", glob);
  return settings;
}

/// The fit with all bands, and the bands in question.
BandProblems free_problems(const InferNetRequest& request, InferNetResult& answer) {
  // Inputs are those of a fit, with one experiment.
  FitSources sources;
  sources.experiments = {request.experiment};
  sources.subject = request.subject;
  sources.settings = request.settings;
  sources.net = request.net;
  sources.data = request.data;
  FitInputs inputs = read_fit_inputs(sources);
  answer.sources = sources_of(inputs);
  // Words become rows of the settings; globs must match, as in a fit.
  std::vector<std::string> words;
  for (const std::string& freed : request.free) {
    const std::vector<std::string> globs = parameter_globs(freed);
    std::vector<std::string>& to =
        globs.size() == 1 && globs[0] == freed ? inputs.also_free : words;
    append_all(to, globs);
  }
  inputs.settings.text = with_freed(std::move(inputs.settings.text), words);
  FitProblem all = build_problem(inputs);
  std::vector<std::string> bands = bands_matching(all.digit().net->net, request.bands);
  // Name the experiment, the subject and the net that the answer is about.
  answer.experiment = all.experiments().front().name;
  answer.subject = parse_subject(inputs.subject.text, inputs.subject.path).name;
  answer.net = all.digit().net->net.name;
  answer.fidelity = all.digit().fidelity;
  answer.ends = ends_of(all.digit().net->net, bands);
  answer.free = FreeInference{
      request.free, inputs.settings.path, all.size(), measured_numbers(all), {}, {}, 0, 0};
  return {std::move(all), parse_fit_settings(inputs.settings.text, inputs.settings.path),
          inputs.also_free, std::move(bands)};
}

/// Returns doubts about the probabilities of bands, a sentence each.
std::vector<std::string> doubts_of(const BandPosterior& posterior) {
  // Errors over the noise beyond which probabilities are too sure [1]
  constexpr double kMaxMisfitRatio = 1.3;
  std::vector<std::string> doubts, open;
  for (const BandBelief& band : posterior.bands)
    if (band.doubtful) open.push_back(band.name);
  if (posterior.noise > kMaxMisfitRatio)
    doubts.push_back(
        fmt::format("the best set's errors are {:.1f} times the stated noise: probabilities are "
                    "surer than they should be",
                    posterior.noise));
  if (!open.empty())
    doubts.push_back(fmt::format(
        "the integral behind these probabilities is doubtful (a parameter at its bound, too few "
        "draws that count, or a fit that did not converge): {}",
        listed(open)));
  return doubts;
}

void infer_free(const InferNetRequest& request, const Progress& progress, InferNetResult& answer) {
  require_field("method", request.method == InferMethod::kSparse,
                "the method explore holds slack lengths and paths, which were to be free");
  require_fit_path(request.path);
  const BandProblems problems = free_problems(request, answer);
  ProgressParts parts(progress, 1);
  // Bands and parameters are sampled together, from the seed.
  std::mt19937 random(request.seed);
  BandPosteriorOptions options = request.sets;
  options.evidence.seed = request.seed;
  FreeInference& free = *answer.free;
  free.posterior = band_posterior(problems, random, options, parts.next(0.95));
  if (!free.posterior.found) return;
  answer.outcome.warn(doubts_of(free.posterior));
  if (progress.stop()) return;
  // Rank the trials that could be measured next.
  const FitProblem& all = problems.full_problem();
  const std::vector<RankedTrial> ranked =
      rank_trials(problems, free.posterior, possible_trials(all.digit(), all.experiments().front()),
                  parts.next(0.05));
  // Compare each proposed trial with the mean of the pool.
  free.pool = ranked.size();
  for (const RankedTrial& trial : ranked)
    free.next_mean += trial.information / static_cast<double>(ranked.size());
  const auto most = static_cast<std::size_t>(std::max(request.propose, 0));
  free.next.assign(ranked.begin(),
                   ranked.begin() + static_cast<std::ptrdiff_t>(std::min(most, ranked.size())));
}

/// Returns doubts about the fits behind the verdicts, a sentence each.
std::vector<std::string> doubts_of(const InferredNet& inferred) {
  // Verdicts are as good as the fits behind them.
  std::vector<std::string> doubts, open;
  for (const BandVerdict& band : inferred.verdicts)
    if (!band.converged) open.push_back(band.name);
  if (!inferred.converged) doubts.emplace_back("the fit of the best net did not converge");
  if (!open.empty())
    doubts.push_back(fmt::format("verdicts rest on fits that did not converge: {}", listed(open)));
  if (inferred.residual > NetSolverOptions().tolerance)
    doubts.push_back(
        fmt::format("nets were brought to balance to {:.1g} N only", inferred.residual));
  return doubts;
}

}  // namespace

std::vector<std::string> parameter_globs(const std::string& word) {
  if (word == "slack") return {"net/*/slack"};
  if (word == "stiffness") return {"net/*stiffness"};
  if (word == "paths") return {"path/*", "net/*/radial"};
  require_field("free", word.find('/') != std::string::npos,
                "free must be slack, paths, stiffness, or a glob on names of parameters, got '{}'",
                word);
  return {word};
}

InferNetResult infer_net(const InferNetRequest& request, const Progress& progress) {
  InferNetResult answer;
  answer.request = request;
  progress(0, "tests");
  // With free parameters bands get probabilities, otherwise verdicts.
  if (!request.free.empty()) {
    infer_free(request, progress, answer);
  } else {
    require_field(request.bands.empty() ? "settings" : "bands",
                  request.bands.empty() && request.settings.empty(),
                  "bands in question and settings are of an inference that frees something");
    const InferenceCase at = read_case(request, answer);
    if (request.method == InferMethod::kSparse)
      infer_by_selection(at, request.propose, progress, answer);
    else
      infer_by_search(at, request, progress, answer);
    if (answer.inferred.found) answer.outcome.warn(doubts_of(answer.inferred));
  }
  // Without a net that explains the forces the answer is stalled.
  const bool found = answer.free ? answer.free->posterior.found : answer.inferred.found;
  if (!found) answer.outcome.status = Status::kStalled;
  if (progress.stop()) answer.outcome.status = Status::kStopped;
  return answer;
}

}  // namespace thenar
