#include "api/explain.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "api/fit.h"
#include "api/named/data_folders.h"
#include "api/named/digits.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/result_file.h"
#include "tendons/forces/feasible_force_set.h"
#include "tendons/forces/max_tip_force.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/forces/tip_force.h"
#include "tendons/forces/tip_wrench.h"

namespace thenar {
namespace {

/// Median wall time of a call [s], over 21 batches of about 1 ms each; long calls are made thrice.
template <typename Call>
double median_seconds(Call call) {
  using Clock = std::chrono::steady_clock;
  const auto time = [&](int calls) {
    const auto begin = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    return std::chrono::duration<double>(Clock::now() - begin).count() / calls;
  };
  constexpr double kBatchTime = 1e-3;      // Time of a batch of calls [s]
  constexpr double kLongCallTime = 20e-3;  // Time beyond which a call is timed only thrice [s]
  // Choose the batch so that the clock's resolution does not matter.
  const double first = std::min(time(1), time(1));  // the first call of all warms up
  const int calls = std::max(1, static_cast<int>(kBatchTime / std::max(first, 1e-9)));
  std::vector<double> seconds(first > kLongCallTime ? 3 : 21);
  for (double& s : seconds) s = time(calls);
  // The median ignores batches that another process interrupted.
  std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
  return seconds[seconds.size() / 2];
}

/// Prevents the compiler from optimising an unused result away.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// The middle of every joint's range: no joint is straight there by chance.
Eigen::VectorXd middle_posture(const TendonDigit& digit) {
  Eigen::VectorXd q(digit.model.coordinates);
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const CoordinateLimits& limits = digit.skeleton.limits[static_cast<std::size_t>(i)];
    q[i] = 0.5 * (limits.lower + limits.upper);
  }
  return q;
}

/// Statics by the rung of paths and hood; rungs that the subject has no data for are left out.
void add_rung_costs(const Subject& subject, const std::string& name,
                    std::vector<QuestionCost>& costs) {
  // Try each rung of paths with each rung of hoods, from the cheapest.
  std::vector<Path> paths{Path::kConstant, Path::kViaPoint};
  if (default_path(subject) == Path::kWrapped) paths.push_back(Path::kWrapped);
  for (const Path path : paths)
    for (const Hood hood : {Hood::kSeparate, Hood::kFractions}) try {
        // A subject without data for a rung falls back to a lower one, which was timed already.
        const auto tendons = build_linear_tendons(subject, name, {path, hood, {}});
        const TendonDigit& digit = tendons->digit();
        const bool asked = digit.fidelity.path == path && digit.fidelity.hood == hood;
        if (!asked || digit.names.muscles.empty()) continue;
        const Eigen::VectorXd q = middle_posture(digit);
        const std::vector<RungWords> rungs = explain(digit.fidelity);
        costs.push_back(
            {"Jacobians and moment arms", rungs[2].rung + ", " + rungs[3].rung, median_seconds([&] {
               keep(path == Path::kWrapped ? tip_statics(*tendons, q) : tip_statics(digit, q));
             })});
      } catch (const InputError&) {
        continue;  // the subject lacks what this rung needs
      }
}

std::vector<QuestionCost> measure_costs(const Subject& subject, const std::string& name,
                                        const TendonDigit& built) {
  // Time the kinematics first: every other question contains it.
  const Eigen::VectorXd q = middle_posture(built);
  std::vector<QuestionCost> costs;
  costs.push_back({"pose of every link", "posed",
                   median_seconds([&] { keep(pose_tree(built.model.tree, q)); })});
  add_rung_costs(subject, name, costs);
  if (built.names.muscles.empty()) return costs;

  // Time statics at the middle of the ranges of motion, with 1 N on each muscle.
  const TipStatics statics = tip_statics(built, q);
  const Eigen::VectorXd t = Eigen::VectorXd::Ones(statics.R.rows());  // [N]
  const auto add = [&](const char* question, const char* rung, auto call) {
    costs.push_back({question, rung, median_seconds(call)});
  };
  add("tip force, pinned", "static", [&] { keep(tip_force(statics, t)); });
  add("tip wrench, rigid", "static", [&] { keep(tip_wrench(statics, t)); });
  // Feasible forces need the maximum isometric force of every muscle.
  if (statics.max_tension.allFinite()) {
    add("largest force in one direction", "static, force bounds",
        [&] { keep(max_tip_force(statics, Eigen::Vector3d::UnitX())); });
    add("all feasible forces", "static, force bounds", [&] { keep(feasible_force_set(statics)); });
  }
  add("building the digit", "as above", [&] { keep(build_tendon_digit(subject, name)); });
  return costs;
}

/// Parameters under the settings; with all fixed where the settings do not suit the digit.
void add_parameters(const TendonDigit& built, const SourceText& settings, DigitExplained& to) {
  to.settings = settings.path;
  try {
    to.parameters =
        choose_parameters(built, {kEachPosture}, parse_fit_settings(settings.text, settings.path));
  } catch (const InputError& error) {
    to.settings_message = error.what();
    to.parameters = choose_parameters(built, {kEachPosture}, {});
  }
}

DigitExplained explain_digit_of(const Subject& subject, const ExplainRequest& request) {
  DigitExplained out;
  out.digit = choose_digit(subject, request.digit);
  const SourceText settings = fit_settings_source(request.settings, out.digit, request.data);
  // A digit that has tip maps alone has neither joints nor parameters to explain.
  const bool bones = find_named(subject.digits, out.digit) != nullptr;
  if (!bones) return out;
  TendonOptions options;
  options.path = request.path.value_or(default_path(subject));
  // Build the tendons on the rungs that a fit would use.
  out.tendons = build_linear_tendons(subject, out.digit, options);
  const TendonDigit& built = out.tendons->digit();
  out.parts = explain_digit(subject, out.digit, options, built);
  out.costs = measure_costs(subject, out.digit, built);
  add_parameters(built, settings, out);
  return out;
}

FitExplained explain_fit_of(const Fit& fit, const std::string& path) {
  FitExplained out;
  // Show how well the fit predicts its own experiments.
  for (std::size_t e = 0; e < fit.problem.experiments().size(); ++e)
    out.predictions.push_back(predict_fitted(fit.problem, fit.solution.z, static_cast<int>(e)));
  const int specimens = static_cast<int>(fit.problem.specimens().size());
  // Values of the population come first, then those of each specimen.
  for (int s = kPopulation; s < specimens; ++s) out.values.push_back(fitted_values(fit, s));
  const std::string prefix = "provenance/versions/";
  // Collect the versions of thenar and its libraries that wrote the file.
  for (const auto& [key, texts] : read_result(path).texts)
    if (key.compare(0, prefix.size(), prefix) == 0)
      out.written_by[key.substr(prefix.size())] = listed(texts);
  return out;
}

}  // namespace

ThingExplained explain_thing(const ExplainRequest& request) {
  const std::string path = named_thing(request.thing, request.data);
  const std::string kind = contents_of(path).kind;
  if (kind == "fit") require_fit_path(request.path);
  // Options that only subjects understand are refused for every other kind, rather than ignored.
  const bool straight = request.path.value_or(Path::kViaPoint) == Path::kViaPoint;
  require(kind == "subject" || (request.digit.empty() && request.settings.empty() && straight),
          "a digit, settings and paths explain subjects; '{}' is of kind: {}", path, kind);
  if (kind == "posterior" || kind == "motion" || kind == "scene run")
    throw WrongKindError(fmt::format("'{}' is a {}", path, kind), kind, path);
  ThingExplained out{request, {}, path, read_thing(path), {}, {}};
  // Verify the checksum of a result, which detects changes by hand.
  out.outcome.warn(checksum_warnings(path));
  if (const auto* subject = std::get_if<Subject>(&out.thing))
    out.digit = explain_digit_of(*subject, request);
  if (const auto* fit = std::get_if<Fit>(&out.thing)) out.fit = explain_fit_of(*fit, path);
  return out;
}

}  // namespace thenar
