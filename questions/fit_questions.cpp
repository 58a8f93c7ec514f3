// Questions about measured forces: fits, predictions, posteriors, bands of a hood.

#include "api/fit.h"
#include "api/posterior.h"
#include "api/predict.h"
#include "api/tendon_infer.h"
#include "base/error.h"
#include "questions/digit_params.h"
#include "questions/make_question.h"
#include "questions/question_params.h"
#include "questions/question_rows.h"
#include "report/answers/answer_files.h"
#include "report/answers/fit.h"
#include "report/answers/posterior.h"
#include "report/answers/prediction.h"
#include "report/answers/tendon_infer.h"
#include "report/pages/fit.h"
#include "report/pages/posterior.h"
#include "report/pages/prediction.h"
#include "report/pages/tendons.h"

namespace thenar {
namespace {

constexpr std::size_t kMaxNames = 1000;  // Entries of a list of names in a request

Schema names_schema() { return list_schema(text_schema(), 0, kMaxNames); }

/// Adds the tendon paths of a fit; its force model supports only straight paths between via points.
template <typename Request>
void add_fit_path(RequestTable<Request>& table, std::optional<Path> Request::*member) {
  table.add_word("path", kPathNames, member,
                 "Tendon paths: via, straight between via points; fits support no other paths.");
}

template <typename Request>
void add_experiments(RequestTable<Request>& table, std::vector<std::string> Request::*member) {
  table.add_argument("experiments", member, "Experiments: names, or files (TOML).", names_schema());
}

RequestTable<FitSources> source_params() {
  RequestTable<FitSources> table;
  // Data first: experiments, and the subject whose parameters are fitted.
  add_experiments(table, &FitSources::experiments);
  table
      .add("subject", text_schema(), &FitSources::subject,
           "Subject to start from: its name, or its file (TOML).")
      .member.required = true;
  // Select the free parameters and their priors.
  table.add("settings", text_schema(), &FitSources::settings,
            "Which parameters are fitted: name or file; default: built in for the digit.");
  // A net replaces the fractions of the hood.
  table.add("net", text_schema(), &FitSources::net,
            "Extensor net in place of the subject's hood: name or file.");
  table.add("also_free", names_schema(), &FitSources::also_free,
            "Also free the parameters that match these globs.", "free");
  table.add_word("scale", kScalingNames, &FitSources::scale,
                 "Size of the digit before the fit: the subject's own, or scaled to the "
                 "lengths in the [outside] of each experiment.");
  add_fit_path(table, &FitSources::path);
  add_data(table, &FitSources::data);
  return table;
}

template <typename Request>
void add_output(RequestTable<Request>& table, std::string Request::*member,
                const std::string& about) {
  table.add("output", saved_file_schema(), member, about, "");
}

RequestTable<PredictRequest> predict_params() {
  using Request = PredictRequest;
  RequestTable<Request> table;
  table.add_argument("fit", &Request::fit, "File of a fit (.h5).");
  add_experiments(table, &Request::experiments);
  // A fitted specimen is predicted by its own parameters, or by those of the population.
  table.add("population", flag_schema(), &Request::population,
            "Predict a fitted specimen as if it had never been seen.");
  add_fit_path(table, &Request::path);
  add_data(table, &Request::data);
  return table;
}

RequestTable<InferNetRequest> infer_params() {
  using Request = InferNetRequest;
  RequestTable<Request> table;
  table.add_argument("experiment", &Request::experiment,
                     "An experiment: its name, or its file (TOML).");
  table.add("subject", text_schema(), &Request::subject, "A subject: its name, or its file (TOML).")
      .member.required = true;
  // The net holds all candidate bands, of which the inference keeps some.
  table.add("net", text_schema(), &Request::net,
            "Net of all bands that may exist: name or file (TOML).");
  add_path(table, &Request::path);
  // Method of the search, and tests that would tell the remaining nets apart.
  table.add_word("method", kInferMethodNames, &Request::method,
                 "Method: sparse: one fit of all bands with a sparsity penalty; explore: search "
                 "over topologies.");
  table.add("propose", integer_schema(0, 1e9), &Request::propose, "Tests to propose, at most.");
  table.add("seed", integer_schema(0, 4294967295.0), &Request::seed,
            "Seed of the search, and of the draws that `free` asks for.");
  // Free parameters are alternatives to bands; bands then get probabilities.
  table.add("free", names_schema(), &Request::free,
            "Alternatives that may explain the forces instead of a band: slack, paths, stiffness "
            "or globs of parameters; bands then get probabilities.");
  table.add("bands", names_schema(), &Request::bands,
            "Bands in question, with `free`, as globs; default: all.");
  table.add("settings", text_schema(), &Request::settings,
            "Settings with all priors, with `free`: name or file.");
  RequestTable<BandPosteriorOptions> sets;
  sets.add("sweeps", integer_schema(1, 1e9), &BandPosteriorOptions::sweeps,
           "Number of sweeps over the bands, with `free` and more than 7 of them.");
  table.include(sets, &Request::sets);
  add_data(table, &Request::data);
  return table;
}

PredictResult predict(const PredictRequest& request, const Progress& /*progress*/) {
  return predict_forces(request);
}

/// Infers a net. @throws InputError if there is no answer
InferNetResult infer(const InferNetRequest& request, const Progress& progress) {
  InferNetResult result = infer_net(request, progress);
  const std::string refusal = refusal_of(result);
  require(refusal.empty(), "{}", refusal);
  return result;
}

/// Samples a posterior; a single process always has the result.
PosteriorResult sample(const SampleRequest& request, const Progress& progress) {
  require_field("output", !request.output.empty(), "wanted a file for the draws (.nc), got none");
  return sample_fit(request, progress).value();
}

}  // namespace

RequestTable<FitRequest> fit_params() {
  using Request = FitRequest;
  RequestTable<Request> table;
  // Add the inputs, the same as for a posterior.
  table.include(source_params(), &Request::sources);
  table.add_word("method", kLeastSquaresMethodNames, &Request::method,
                 "Method of the fit: ceres, ipopt: by derivatives; nlopt, nlopt-global: without.");
  // Each kind of leaving out fits anew without some of the data.
  table.add_words("leave_out", list_schema(word_schema(names_in(kLeaveOutNames)), 0, 3),
                  "part to leave out", kLeaveOutNames, &Request::leave_out,
                  "Also leave out one posture, tendon or specimen at a time.", "cross-validate");
  // Choosing settings by left-out data, and the optimiser's own limits.
  table.add("choose_settings", flag_schema(), &Request::choose_settings,
            "Choose among the [[choose]] rows of the settings by left-out postures and specimens; "
            "the choice is repeated within each cross-validation fold.");
  table.add("seed", integer_schema(0, 4294967295.0), &Request::seed, "Seed of the global search.");
  table.add("max_evaluations", integer_schema(0, 1e9), &Request::max_evaluations,
            "Limit on evaluations (0: the method's default).");
  add_output(table, &Request::output, "File of the result (.h5).");
  return table;
}

RequestTable<SampleRequest> posterior_params() {
  using Request = SampleRequest;
  RequestTable<Request> table;
  // Add the inputs, the same as for a fit.
  table.include(source_params(), &Request::sources);
  table.add_word("method", kSamplingMethodNames, &Request::method, "Sampler.", "sampler");
  table.add("seed", integer_schema(0, 4294967295.0), &Request::seed, "Seed of the chains.");
  table.add("chains", integer_schema(1, 1e9), &Request::chains,
            "Independent chains, or ensembles.");
  table.add("walkers", integer_schema(0, 1e9), &Request::walkers,
            "Chains of one ensemble; 0: as the sampler needs.");
  // Step size and length of trajectories of Hamiltonian samplers.
  table.add("target_acceptance", number_schema("", 0.05, 0.999), &Request::target_acceptance,
            "Target acceptance of nuts and hmc; a higher value gives smaller steps and fewer "
            "divergences.");
  table.add("max_depth", integer_schema(1, 30), &Request::max_depth,
            "Largest depth of the trees of nuts: 2^depth steps at most.");
  // Warm-up adapts the sampler; draws are kept, thinned where neighbours are alike.
  table.add("warm_up", integer_schema(0, 1e9), &Request::warm_up,
            "Warm-up steps, which are discarded.");
  table.add(
      "draws", integer_schema(0, 1e9), &Request::draws,
      "Draws per chain; 0: 1000, or 100 for stretch, doubled at most twice if the chains have "
      "not converged and more draws may help.");
  table.add("thin", integer_schema(0, 1e9), &Request::thin,
            "Steps per draw; 0: 1, or 10 with stretch.");
  // Parallel tempering lets chains pass between modes.
  table.add("temperatures", integer_schema(1, 1e9), &Request::temperatures,
            "Temperatures of parallel tempering; 1: none.");
  table.add("min_beta", number_schema("", 0, 1), &Request::min_beta,
            "Power of the likelihood at the highest temperature.", "least-temper");
  table.add("swap_every", integer_schema(1, 1e9), &Request::swap_every,
            "Steps between swaps of temperatures.");
  table.add("mode_starts", integer_schema(0, 1e9), &Request::mode_starts,
            "Starts of the search for modes; 0: 16, or 4 among more than 1000 coordinates.");
  table.add("checkpoint_every", units::kSecond, number_schema("", 0), &Request::checkpoint_every,
            "Time between checkpoints; at most this much work is lost if the run is killed.",
            "checkpoint-every-s");
  table.add("threads", integer_schema(0, 1e9), &Request::threads,
            "Number of threads; 0: as many as there are processors.");
  table.add("fixed_noise", flag_schema(), &Request::fixed_noise,
            "Keep the stated noise level fixed.");
  table.add("fresh", flag_schema(), &Request::fresh, "Discard an interrupted run of this output.");
  table.add("retry_acceptances", list_schema(number_schema("", 0.05, 0.999), 0, 10),
            &Request::retry_acceptances,
            "Target acceptances at which chains start over whose trajectories diverge.", "");
  add_output(table, &Request::output, "File of the draws (.nc).");
  return table;
}

void internal::add_fit_questions(std::vector<Question>& all) {
  add_question(all, "fit", "Fit a digit to measured fingertip forces.", fit_params(), fit_digit,
               R"({"experiments": ["synek2019_H01"], "subject": "synek2019_middle"})", "fit",
               QuestionPace::kLasts);
  add_question(all, "predict", "Predict the forces of an experiment from a fit.", predict_params(),
               predict, R"({"fit": "fit.h5", "experiments": ["synek2019_B01"]})", "predict");
  add_question(all, "posterior", "Sample all parameters that priors and measured forces allow.",
               posterior_params(), sample,
               R"({"experiments": ["synek2019_H01"], "subject": "synek2019_middle", "chains": 2,
          "warm_up": 50, "draws": 50, "output": "posterior.nc"})",
               "fit", QuestionPace::kLasts);
  add_question(
      all, "bands", "Infer which bands of the extensor hood the measured fingertip forces support.",
      infer_params(), infer, R"({"experiment": "synek2019_H01", "subject": "synek2019_middle"})",
      "tendon infer", QuestionPace::kLasts);
}

}  // namespace thenar
