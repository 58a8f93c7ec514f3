#include "studies/questions/demo.h"

#include <fmt/format.h>

#include "api/named/files.h"
#include "base/error.h"
#include "base/lists.h"
#include "base/units.h"
#include "data/io/scene/scene_pad.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/posture_sweep.h"

namespace thenar {
namespace {

// Times of the parts on one core of 2.5 GHz [s]
constexpr double kSpecimenTime = 14, kPopulationTime = 0.5, kPosteriorAloneTime = 5.5,
                 kPosteriorTogetherTime = 120, kHoodTime = 0.3, kThumbStudyTime = 4.5,
                 kThumbRecoveryTime = 18, kHandsTime = 8, kPadTime = 5.5, kPencilTime = 14;

/// Lengths of chains.
struct ChainLengths {
  long warm_up, draws;       // of each chain [1]
  int thin;                  // steps a draw [1]
  double target_acceptance;  // [1]
};
// Chains of one specimen
constexpr ChainLengths kSpecimenChains{1000, 1000, 1, 0.9};
// Chains of the population. Factors on the spread between specimens are learnt with what they
// spread: steps are cheap there, but short, and forget slowly. Metrics want two draws an entry.
constexpr ChainLengths kPopulationChains{1200, 600, 6, 0.95};

StudyInputs inputs_of(const std::string& data) {
  // Two specimens are fitted, one of another species is only predicted.
  const auto read = [&](const std::string& file) { return read_source(data + "/" + file); };
  StudyInputs inputs;
  inputs.specimen.subject = read("subjects/an_chao_middle.toml");
  inputs.specimen.settings = read("fits/finger.toml");
  inputs.specimen.experiments = {read("experiments/synek2019_H01.toml"),
                                 read("experiments/synek2019_H02.toml")};
  inputs.population_subject = read("subjects/synek2019_middle.toml");
  inputs.unseen = {read("experiments/synek2019_B01.toml")};
  // Published subjects predict as they are, as a bar that the fits must pass.
  inputs.baselines = {{"Published calibrated model", inputs.population_subject},
                      {"Normative finger", inputs.specimen.subject}};
  inputs.methods = {LeastSquaresMethod::kCeres, LeastSquaresMethod::kIpopt,
                    LeastSquaresMethod::kNloptLocal, LeastSquaresMethod::kNloptGlobal};
  return inputs;
}

/// Thumbs that differ in their axes, bent alike, and a measured one as it was digitised.
std::vector<DemoThumb> thumbs_of(const std::string& data) {
  const double bent = radians(30);
  const std::map<std::string, double> pinch{{"MCP1_FE", bent}, {"IP1", bent}};
  const auto read = [&](const char* file) { return read_subject(data + "/subjects/" + file); };
  return {{"Orthogonal axes", read("graspit_orthogonal_thumb.toml"), pinch},
          {"Skewed axes", read("graspit_skewed_thumb.toml"), pinch},
          {"Measured axes and tendons", read("mirakhorlo2016.toml"), {}, {0, 0, 1}}};
}

DemoHood bend_hood(const StudyInputs& inputs) {
  // The finger with the default net.
  const Subject subject =
      parse_subject(inputs.population_subject.text, inputs.population_subject.path);
  const NetDescription net = find_net("extensor_hood");
  TendonOptions options;
  options.hood = Hood::kFloatingNet;
  DemoHood hood;
  LoadedDigit& loaded = hood.sweep.loaded;
  loaded.subject = subject.name;
  loaded.digit = "middle";
  loaded.tendons = build_digit_tendons(subject, loaded.digit, options, &net);
  const TendonNames& names = loaded.bones().names;
  // Bent at PIP and DIP under constant tensions.
  const int pip = place_in(names.coordinates, "PIP3"), dip = place_in(names.coordinates, "DIP3");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(loaded.bones().model.coordinates), bent = q;
  bent[pip] = radians(60);
  bent[dip] = radians(40);
  loaded.t = Eigen::VectorXd::Zero(loaded.bones().max_tension.size());
  loaded.t[place_in(names.muscles, "EDC")] = 2.9;
  loaded.t[place_in(names.muscles, "LU")] = 0.4;
  loaded.t[place_in(names.muscles, "UI")] = 0.4;
  loaded.grid.postures = postures_between(q, bent, 24);
  loaded.grid.varied = {pip};
  loaded.grid.row = loaded.grid.postures.size();
  loaded.sources = {inputs.population_subject};
  hood.sweep.points = sweep_digit(*loaded.tendons, loaded.grid.postures, loaded.t);

  // All rungs of hood beside the measured forces.
  for (const SourceText& source : inputs.specimen.experiments)
    hood.rungs.push_back(compare_hoods(subject, parse_experiment(source.text, source.path), {net}));
  return hood;
}

PosteriorRun sampled(const FitInputs& inputs, const ChainLengths& lengths,
                     const Progress& progress) {
  // Lengths of the chains are those that this posterior needs to converge.
  PosteriorSettings settings;
  settings.posterior = posterior_options(inputs.settings);
  settings.mode_starts = 8;
  settings.run.sampler.warm_up = lengths.warm_up;
  settings.run.sampler.target_acceptance = lengths.target_acceptance;
  settings.run.draws = lengths.draws;
  settings.run.thin = lengths.thin;
  settings.run.progress = progress;
  return sample_posterior(inputs, settings);
}

/// Errors on every experiment, seen or not.
void judge(const std::vector<Experiment>& unseen, DemoPosterior& posterior) {
  // Predict fitted and unseen experiments, then leave out one trial at a time.
  const FitProblem& problem = posterior.run.posterior->problem();
  const auto predict = [&](const Experiment& experiment) {
    return summarise(
        predict_draws(posterior.run, experiment, find_specimen(problem, experiment.specimen)));
  };
  for (const Experiment& experiment : problem.experiments())
    posterior.fitted.push_back(predict(experiment));
  for (const Experiment& experiment : unseen) posterior.unseen.push_back(predict(experiment));
  auto left_out = leave_out_observations(posterior.run);
  require(left_out.has_value(), "a likelihood of the posterior of '{}' is not finite",
          posterior.name);
  posterior.left_out = std::move(*left_out);
}

/// The three posteriors that the demo samples: each specimen alone, and both together.
struct SampledPosterior {
  std::string name;
  FitInputs inputs;
  ChainLengths lengths;
  double seconds;  // that it takes, roughly [s]
};

std::vector<SampledPosterior> posteriors_of(const StudyInputs& inputs) {
  // A posterior of each specimen alone, then of both as a population.
  std::vector<SampledPosterior> all;
  for (const SourceText& experiment : inputs.specimen.experiments) {
    FitInputs alone = inputs.specimen;
    alone.experiments = {experiment};
    all.push_back({parse_experiment(experiment.text, experiment.path).name, alone, kSpecimenChains,
                   kPosteriorAloneTime});
  }
  FitInputs together = inputs.specimen;
  together.subject = inputs.population_subject;
  all.push_back({"population", together, kPopulationChains, kPosteriorTogetherTime});
  return all;
}

/// Draws of a posterior, judged; none where it was stopped.
std::optional<DemoPosterior> sample_one(const SampledPosterior& of, const StudyInputs& inputs,
                                        const RunRecord& run, const Progress& progress) {
  progress(0, "posterior of " + of.name);
  DemoPosterior posterior{of.name, sampled(of.inputs, of.lengths, progress), {}, {}, {}};
  if (!posterior.run.draws.complete) return {};
  posterior.run.run = run;
  const auto parse = [](const SourceText& source) {
    return parse_experiment(source.text, source.path);
  };
  judge(transformed(inputs.unseen, parse), posterior);
  return posterior;
}

/// Hands that grasp.
CompareResult compare_some_hands(const DemoRequest& request, const Progress& progress) {
  CompareRequest compare;
  compare.hands = {"human:skewed", "barrett", "shadow", "parallel_jaw"};
  compare.objects = {"sphere_70", "cube_50"};
  compare.approaches = 8;
  compare.path = request.path;
  compare.data = request.data;
  return compare_hands(compare, progress);
}

/// The default finger pad under a ball, by elements and by every cheaper model.
PressResult press_some_pad(const DemoRequest& request, const Progress& progress) {
  PressRequest press;
  press.object.name = "sphere";
  press.pad.data = request.data;
  press.depth = 1 * kMm;
  press.points = 6;
  press.force_error = 0.1;
  press.rungs = true;
  return press_pad(press, progress);
}

/// A pencil that pads pinch, on every rung.
RungComparison pinch_pencil(const DemoRequest& request, const Progress& progress) {
  SceneRequest scene;
  scene.scene = "pencil_pinch";
  scene.data = request.data;
  scene.path = request.path;
  return compare_rungs(scene, pad_rung_names(), progress);
}

/// Results that tasks fill in, each in a place of its own.
struct Places {
  std::vector<std::optional<SpecimenStudy>> specimens;
  std::vector<std::optional<DemoPosterior>> posteriors;
};

/// Fits, posteriors and hoods of fingers.
std::vector<ParallelTask> finger_tasks(const DemoRequest& request, DemoResult& demo,
                                       Places& places) {
  // Each task writes to a place of its own, so that no lock is needed.
  std::vector<ParallelTask> tasks;
  const StudyInputs& inputs = demo.inputs;
  const std::vector<SourceText>& experiments = inputs.specimen.experiments;
  places.specimens.resize(experiments.size());
  for (std::size_t i = 0; i < experiments.size(); ++i)
    tasks.push_back({kSpecimenTime, [&, i](const Progress& progress) {
                       places.specimens[i] = study_specimen(inputs, experiments[i], progress);
                     }});
  tasks.push_back({kPopulationTime, [&](const Progress& progress) {
                     demo.population = study_population(inputs, progress);
                   }});
  const std::vector<SampledPosterior> posteriors = posteriors_of(inputs);
  places.posteriors.resize(posteriors.size());
  for (std::size_t i = 0; i < posteriors.size(); ++i)
    tasks.push_back({posteriors[i].seconds, [&, i, of = posteriors[i]](const Progress& progress) {
                       places.posteriors[i] = sample_one(of, inputs, request.run, progress);
                     }});
  tasks.push_back({kHoodTime, [&](const Progress&) { demo.hood = bend_hood(inputs); }});
  return tasks;
}

/// Thumbs, hands that grasp and pads that are pressed.
std::vector<ParallelTask> other_tasks(const DemoRequest& request, DemoResult& demo) {
  // Settings are those of the commands, shortened to fit into the demo.
  const auto study = [&](const Progress& progress) {
    ThumbStudyRequest thumb;
    thumb.data = request.data;
    thumb.quick = true;
    demo.thumb_study = compute_thumb_study(thumb, progress);
  };
  const auto recover = [&](const Progress& progress) {
    ThumbRecoveryRequest recovery;
    recovery.data = request.data;
    demo.thumb_recovery = compute_thumb_recovery(recovery, progress);
  };
  return {
      {kThumbStudyTime, study},
      {kThumbRecoveryTime, recover},
      {kHandsTime, [&](const Progress& told) { demo.hands = compare_some_hands(request, told); }},
      {kPadTime, [&](const Progress& told) { demo.pad = press_some_pad(request, told); }},
      {kPencilTime, [&](const Progress& told) { demo.pencil = pinch_pencil(request, told); }}};
}

/// Keeps posteriors that are whole. HDF5 is for one thread at a time.
void write_posteriors(const DemoRequest& request, Places& places, DemoResult& demo) {
  for (std::optional<DemoPosterior>& posterior : places.posteriors) {
    if (!posterior) continue;
    demo.files.push_back(fmt::format("{}/{}.nc", request.output, posterior->name));
    write_posterior(posterior->run, demo.files.back());
    demo.posteriors.push_back(std::move(*posterior));
  }
}

/// Fits are kept once all is done.
void write_fits(const DemoRequest& request, DemoResult& demo) {
  const auto write = [&](Fit& fit, const std::string& name) {
    fit.run = request.run;
    demo.files.push_back(fmt::format("{}/{}.h5", request.output, name));
    write_fit(fit, demo.files.back());
  };
  for (SpecimenStudy& study : demo.specimens) write(study.fit, study.in_sample.experiment);
  write(demo.population->fit, "population");
}

}  // namespace

DemoResult run_demo_study(const DemoRequest& request, const Progress& progress) {
  DemoResult demo;
  demo.inputs = inputs_of(request.data);
  demo.thumbs = thumbs_of(request.data);
  // All that needs nothing of the others, side by side.
  Places places;
  std::vector<ParallelTask> tasks = finger_tasks(request, demo, places);
  for (const std::vector<ParallelTask>& more :
       {other_tasks(request, demo), demo_scene_tasks(request.data, request.path, demo.motion)})
    tasks.insert(tasks.end(), more.begin(), more.end());
  run_tasks(std::move(tasks), progress);
  // Files, one by one.
  write_posteriors(request, places, demo);
  if (progress.stop()) demo.outcome.status = Status::kStopped;
  if (demo.outcome.stopped()) return demo;
  for (std::optional<SpecimenStudy>& specimen : places.specimens)
    demo.specimens.push_back(std::move(specimen.value()));
  write_fits(request, demo);
  return demo;
}

}  // namespace thenar
