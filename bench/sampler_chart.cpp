// sampler_chart PAGE.html
//
// Error of the posterior mean over time for every sampler, on the thumb of sampler_task.h.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/chart_main.h"
#include "bench/ratios.h"
#include "bench/sampler_task.h"
#include "report/blocks.h"
#include "report/pages/posterior.h"

namespace thenar::bench {
namespace {

constexpr int kSeeds = 3;        // runs of each sampler: the median is drawn
constexpr double kSeconds = 2;   // of each run, after the search for modes [s]
constexpr double kFirst = 0.02;  // where lines begin [s]
constexpr int kPoints = 40;      // of a line

/// How a sampler is run.
struct Contender {
  std::string name;
  SamplingMethod method;
  int groups, walkers, temperatures;
  long warm_up;  // steps, as few as do no harm here: all are told modes and their covariance
  int thin;      // steps a draw, so that memory lasts
};

const std::vector<Contender>& contenders() {
  static const std::vector<Contender> all{
      {"adaptive Metropolis", SamplingMethod::kAdaptiveMetropolis, 8, 1, 1, 2000, 20},
      {"DREAM(ZS)", SamplingMethod::kDreamZs, 4, 4, 1, 5000, 20},
      {"stretch move", SamplingMethod::kStretchMove, 2, 48, 1, 1000, 20},
      {"HMC", SamplingMethod::kHmc, 8, 1, 1, 300, 1},
      {"NUTS", SamplingMethod::kNuts, 8, 1, 1, 300, 1},
      {"NUTS, 4 temperatures", SamplingMethod::kNuts, 8, 1, 4, 300, 1}};
  return all;
}

/// What is right, as far as a much longer run knows.
struct Reference {
  Eigen::VectorXd mean, sd;  // of the entries (n)
  double error;              // of the mean, Monte Carlo [sds]
};

Reference reference(const HandPosterior& posterior) {
  RunOptions options;
  options.groups = 8;
  options.draws = 40000;
  options.thin = 2;
  options.sampler.seed = 99;
  const TimedRun run = run_ours(posterior, options);
  return {run.mean, run.sd, 1 / std::sqrt(run.ess)};
}

double rms_error(const Eigen::VectorXd& mean, const Reference& right) {
  const Eigen::VectorXd off = (mean - right.mean).cwiseQuotient(right.sd);
  return off.norm() / std::sqrt(static_cast<double>(off.size()));
}

/// Error of the mean of all draws so far, after each draw.
struct Trace {
  double first = 0, per_draw = 0;  // time of the first draw; between draws [s]
  std::vector<double> error;       // [sds]

  /// At a time [s]; NaN before the first draw and after the last.
  [[nodiscard]] double at(double seconds) const {
    const double k = (seconds - first) / per_draw;
    if (k < 0 || k >= static_cast<double>(error.size())) return std::nan("");
    return error[static_cast<std::size_t>(k)];
  }
};

Trace run(const HandPosterior& posterior, const Contender& who, unsigned seed,
          const Reference& right) {
  const Prepared prepared = prepare(posterior, who.groups * who.walkers, seed);
  RunOptions options;
  options.method = who.method;
  options.groups = who.groups;
  options.walkers = who.walkers;
  options.temperatures = who.temperatures;
  options.min_beta = 0.2;
  options.thin = who.thin;
  options.threads = 1;
  options.draws = 10000000;  // the clock ends it
  options.sampler.seed = seed;
  options.sampler.warm_up = who.warm_up;
  options.sampler.covariance = prepared.covariance;
  const double start = processor_seconds();
  double warm = 0;
  options.progress.report = [&](double, const std::string& what) {
    if (warm == 0 && what.rfind("sampling, draw 0", 0) == 0) warm = processor_seconds() - start;
  };
  options.progress.stop_requested = [&] { return processor_seconds() - start > kSeconds; };
  const Draws draws = run_chains(posterior, prepared.starts, options);
  const double took = processor_seconds() - start;

  Trace trace{warm, (took - warm) / double(draws.draws()), {}};
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(posterior.size());
  for (long k = 0; k < draws.draws(); ++k) {
    for (const Eigen::MatrixXd& chain : draws.x) sum += chain.col(k);
    trace.error.push_back(rms_error(sum / double((k + 1) * draws.chains()), right));
  }
  return trace;
}

/// Medians over seeds, at times that all runs reached.
SamplerCourse course(const HandPosterior& posterior, const Contender& who, const Reference& right) {
  std::vector<Trace> traces;
  for (unsigned seed = 1; seed <= kSeeds; ++seed)
    traces.push_back(run(posterior, who, seed, right));
  SamplerCourse out{who.name, {}, {}};
  for (int k = 0; k < kPoints; ++k) {
    const double seconds = kFirst * std::pow(kSeconds / kFirst, double(k) / (kPoints - 1));
    std::vector<double> errors;
    for (const Trace& trace : traces) errors.push_back(trace.at(seconds));
    if (std::any_of(errors.begin(), errors.end(), [](double e) { return std::isnan(e); })) continue;
    out.seconds.push_back(seconds);
    out.error.push_back(median(errors));
  }
  return out;
}

Json page() {
  const HandPosterior posterior = thumb_posterior();
  const Reference right = reference(posterior);
  std::vector<SamplerCourse> courses;
  for (const Contender& who : contenders()) courses.push_back(course(posterior, who, right));
  courses.push_back({"error of the reference", {kFirst, kSeconds}, {right.error, right.error}});
  Json chart = sampler_chart(courses);
  chart["height"] = 460;
  const std::string about = fmt::format(
      "A thumb of five skewed axes, {} numbers sought from 54 forces. All samplers start about the "
      "modes and know the covariance there; the search for them, {:.1f} s, is not counted. One "
      "core, "
      "median of {} seeds. The reference is a run of NUTS of 640,000 steps.",
      posterior.size(), prepare(posterior, 8, 1).seconds, kSeeds);
  return {{"title", "Samplers on a thumb"},
          {"sections", {section("samplers", "Error over time", about, {chart})}}};
}

}  // namespace
}  // namespace thenar::bench

int main(int argc, char** argv) {
  return thenar::bench::write_chart("sampler_chart", argc, argv, thenar::bench::page);
}
