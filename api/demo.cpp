#include "api/demo.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "api/named/data_folders.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/units.h"
#include "hand/skin/skin_landmarks.h"
#include "posterior/run/posterior_file.h"
#include "posterior/run/predict_draws.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

/// How long chains run.
struct ChainLengths {
  long warm_up, draws;       // of each chain [1]
  int thin;                  // steps a draw [1]
  double target_acceptance;  // [1]
};
constexpr ChainLengths kAlone{1000, 1000, 1, 0.9};
// Factors on the spread between specimens are learnt with what they spread: steps are cheap there,
// but short, and forget slowly. Metrics want two draws an entry.
constexpr ChainLengths kTogether{1200, 600, 6, 0.95};

StudyInputs inputs_of(const std::string& data) {
  const auto read = [&](const std::string& file) { return read_source(data + "/" + file); };
  StudyInputs inputs;
  inputs.specimen.subject = read("subjects/an_chao_middle.toml");
  inputs.specimen.settings = read("fits/finger.toml");
  inputs.specimen.experiments = {read("experiments/synek2019_H01.toml"),
                                 read("experiments/synek2019_H02.toml")};
  inputs.population_subject = read("subjects/synek2019_middle.toml");
  inputs.unseen = {read("experiments/synek2019_B01.toml")};
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
  const auto index = [](const std::vector<std::string>& list, const char* name) {
    return std::find(list.begin(), list.end(), name) - list.begin();
  };

  // Bent at PIP and DIP under constant tensions.
  const Eigen::Index pip = index(names.coordinates, "PIP3"), dip = index(names.coordinates, "DIP3");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(loaded.bones().model.coordinates), bent = q;
  bent[pip] = radians(60);
  bent[dip] = radians(40);
  loaded.t = Eigen::VectorXd::Zero(loaded.bones().max_tension.size());
  loaded.t[index(names.muscles, "EDC")] = 2.9;
  loaded.t[index(names.muscles, "LU")] = 0.4;
  loaded.t[index(names.muscles, "UI")] = 0.4;
  loaded.grid.postures = postures_between(q, bent, 24);
  loaded.grid.varied = {static_cast<int>(pip)};
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

void sample_all(const DemoRequest& request, const Progress& progress, DemoResult& demo) {
  std::vector<Experiment> unseen;
  for (const SourceText& source : demo.inputs.unseen)
    unseen.push_back(parse_experiment(source.text, source.path));
  const auto add = [&](const std::string& name, const FitInputs& of, const ChainLengths& lengths) {
    if (progress.stop()) return;
    progress(0, "posterior of " + name);
    DemoPosterior posterior{name, sampled(of, lengths, progress), {}, {}, {}};
    if (!posterior.run.draws.complete) return;
    posterior.run.run = request.run;
    demo.files.push_back(fmt::format("{}/{}.nc", request.output, name));
    write_posterior(posterior.run, demo.files.back());
    judge(unseen, posterior);
    demo.posteriors.push_back(std::move(posterior));
  };
  for (const SourceText& experiment : demo.inputs.specimen.experiments) {
    FitInputs alone = demo.inputs.specimen;
    alone.experiments = {experiment};
    add(parse_experiment(experiment.text, experiment.path).name, alone, kAlone);
  }
  FitInputs together = demo.inputs.specimen;
  together.subject = demo.inputs.population_subject;
  add("population", together, kTogether);
}

std::vector<PadState> thumb_pad_on_mug(const SimulatedScene& scene) {
  const Mechanism& mechanism = scene.built->scene.mechanism;
  const Subject& subject = default_human();
  const Eigen::Vector3d pad =
      pad_normal(subject, build_skeleton(subject, {{"thumb"}, {}}), "thumb");
  return pad_angles(scene.run, scene.measures, body_named(mechanism, "human:skewed/DP1"),
                    body_named(mechanism, "mug"), pad);
}

/// Both steppers on a ball that rolls off another, over a wide range of settings.
std::vector<WorkPoint> roll_ball(const std::string& data) {
  const std::string file =
      named_file("scene", "ball_on_ball", "scenes", ".toml", data_folders(data));
  const BuiltScene built = open_scene(read_scene(file), data).built;
  const auto ball = static_cast<std::size_t>(body_named(built.scene.mechanism, "ball"));
  // The exact end, from where it starts.
  ContactStep step(built.scene);
  std::vector<Pose<double>> X;
  step.poses(step.start(), X);
  const Eigen::Vector3d p = X[ball].p;
  const double angle = rolled_angle(std::atan2(p.x(), p.z()), built.options.seconds, p.norm());
  const Eigen::Vector3d end = p.norm() * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
  WorkSettings settings;
  settings.tolerances = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  settings.steps = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5};
  return work_precision(built.scene, built.options, settings, [&](const SceneSample& sample) {
    step.poses({sample.t, sample.q, sample.v, sample.z}, X);
    return (X[ball].p - end).norm();
  });
}

/// Fits are kept once all is done.
void write_fits(const DemoRequest& request, DemoResult& demo) {
  const auto write = [&](Fit& fit, const std::string& name) {
    fit.run = request.run;
    demo.files.push_back(fmt::format("{}/{}.h5", request.output, name));
    write_fit(fit, demo.files.back());
  };
  for (SpecimenStudy& study : demo.specimens) write(study.fit, study.in_sample.experiment);
  write(demo.population.fit, "population");
}

}  // namespace

DemoMotion move_demo_scenes(const std::string& data, const Progress& progress,
                            const std::optional<Path>& path) {
  SceneRequest glass, thumb;
  glass.data = thumb.data = data;
  glass.path = thumb.path = path;
  glass.scene = "wine_glass";
  thumb.scene = "thumb_mug";
  DemoMotion motion;
  motion.glass = run_scene(glass, progress);
  motion.thumb = run_scene(thumb, progress);
  thumb.on_pins = true;
  motion.thumb_on_pins = run_scene(thumb, progress);
  if (progress.stop()) return motion;
  motion.pad = thumb_pad_on_mug(motion.thumb);
  motion.pad_on_pins = thumb_pad_on_mug(motion.thumb_on_pins);
  motion.work = roll_ball(data);
  return motion;
}

DemoResult run_demo_study(const DemoRequest& request, const Progress& progress) {
  const StudyInputs inputs = inputs_of(request.data);
  std::vector<SpecimenStudy> specimens = study_specimens(inputs, progress);
  DemoResult demo{
      inputs, std::move(specimens), study_population(inputs, progress), {}, {}, {}, {}, {}, {}, {}};
  sample_all(request, progress, demo);
  ThumbStudyRequest thumb;
  thumb.data = request.data;
  thumb.quick = true;
  demo.thumb_study = ask_thumb_study(thumb, progress);
  ThumbRecoveryRequest recovery;
  recovery.data = request.data;
  if (!progress.stop()) demo.thumb_recovery = ask_thumb_recovery(recovery, progress);
  demo.motion = move_demo_scenes(request.data, progress, request.path);
  demo.stopped = progress.stop();
  if (demo.stopped) return demo;
  write_fits(request, demo);
  demo.hood = bend_hood(inputs);
  demo.thumbs = thumbs_of(request.data);
  return demo;
}

}  // namespace thenar
