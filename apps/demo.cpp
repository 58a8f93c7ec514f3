// thenar demo --data data -o out
//
// The main job on real data: fits the middle fingers of two hands to measured forces by every
// solver, cross-validates, predicts what was not seen, samples their posteriors, asks
// what forces tell of a thumb's axes, compares two thumbs, lets robot hands grasp, and writes it
// all as one page, the grasps as another.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "api/data_folders.h"
#include "api/digits.h"
#include "api/files.h"
#include "apps/commands.h"
#include "apps/demo_hands.h"
#include "apps/demo_posteriors.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/progress_parts.h"
#include "base/units.h"
#include "report/page.h"
#include "report/pages/fit.h"
#include "report/pages/hood.h"
#include "report/pages/thumb_study.h"
#include "report/pages/thumbs.h"
#include "report/provenance.h"
#include "tendons/net/build_tendons.h"

namespace thenar {
namespace {

struct DemoArguments {
  std::string data;
  std::string output = "out";
};

StudyInputs inputs_of(const DemoArguments& options) {
  const auto read = [&](const std::string& file) { return read_source(options.data + "/" + file); };
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
std::vector<ThumbCase> thumb_cases(const DemoArguments& options) {
  const double bent = radians(30);
  const std::map<std::string, double> pinch{{"MCP1_FE", bent}, {"IP1", bent}};
  const auto read = [&](const char* file) {
    return read_subject(options.data + "/subjects/" + file);
  };
  return {{"Orthogonal axes", read("graspit_orthogonal_thumb.toml"), pinch},
          {"Skewed axes", read("graspit_skewed_thumb.toml"), pinch},
          {"Measured axes and tendons", read("mirakhorlo2016.toml"), {}}};
}

/// The hood of the middle finger while it bends, DIP by two thirds of PIP, and all rungs of hood
/// beside the measured forces.
Json hood_section(const StudyInputs& inputs) {
  const Subject subject =
      parse_subject(inputs.population_subject.text, inputs.population_subject.path);
  const NetDescription net = find_net("winslow");
  TendonOptions options;
  options.hood = Hood::kFloatingNet;
  const auto tendons = build_digit_tendons(subject, "middle", options, &net);
  const TendonNames& names = tendons->digit().names;
  const auto index = [](const std::vector<std::string>& list, const char* name) {
    return std::find(list.begin(), list.end(), name) - list.begin();
  };
  const Eigen::Index pip = index(names.coordinates, "PIP3"), dip = index(names.coordinates, "DIP3");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(tendons->digit().model.coordinates), bent = q;
  bent[pip] = radians(60);
  bent[dip] = radians(40);
  Eigen::VectorXd t = Eigen::VectorXd::Zero(tendons->digit().max_tension.size());
  t[index(names.muscles, "EDC")] = 2.9;
  t[index(names.muscles, "LU")] = 0.4;
  t[index(names.muscles, "UI")] = 0.4;
  const std::vector<Eigen::VectorXd> postures = postures_between(q, bent, 24);

  std::vector<HoodComparison> comparisons;
  for (const SourceText& source : inputs.specimen.experiments)
    comparisons.push_back(
        compare_hoods(subject, parse_experiment(source.text, source.path), {net}));
  return hood_page(
      {*tendons, t, sweep_digit(*tendons, postures, t), {static_cast<int>(pip)}, postures.size()},
      comparisons);
}

Json provenance(const StudyInputs& inputs, const Fidelity& fidelity, double seconds) {
  std::vector<SourceText> sources{inputs.specimen.subject, inputs.specimen.settings,
                                  inputs.population_subject};
  for (const auto* experiments : {&inputs.specimen.experiments, &inputs.unseen})
    sources.insert(sources.end(), experiments->begin(), experiments->end());
  Json out = provenance_json(sources, fidelity);
  out["seed"] = fmt::format("{}", SolveOptions{}.seed);
  out["wall time of the whole"] = fmt::format("{:.1f} s", seconds);
  return out;
}

void run_demo(const DemoArguments& options) {
  const auto begin = std::chrono::steady_clock::now();
  const Progress progress = terminal_progress();
  const StudyInputs inputs = inputs_of(options);
  const std::string path = options.output + "/report.html";
  require_writable(path);
  const std::vector<SpecimenStudy> studies = study_specimens(inputs, progress);
  const PopulationStudy population = study_population(inputs, progress);
  const Json posteriors = posterior_pages(inputs, options.output, progress);
  ThumbStudySettings thumbs = quick_thumb_study();
  thumbs.progress = progress;
  const ThumbStudy thumb_study = study_thumb(thumb_study_inputs(options.data), thumbs);
  const Json hands = compare_hands(options.data, options.output, progress);
  if (interrupted()) throw Stopped("stopped before the report was complete");
  for (const SpecimenStudy& study : studies)
    write_fit(study.fit, fmt::format("{}/{}.h5", options.output, study.in_sample.experiment));
  write_fit(population.fit, options.output + "/population.h5");

  Json sections = Json::array({accuracy_page(studies), force_page(studies), solver_page(studies),
                               parameter_page(studies), finger_page(studies),
                               population_page(population, studies), hood_section(inputs),
                               thumb_page(thumb_cases(options))});
  sections.insert(sections.end(), posteriors.begin(), posteriors.end());
  sections.push_back(thumb_study_section(thumb_study));
  sections.push_back(hands);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  write_report(
      {{"title", "thenar: a finger fitted to its forces"},
       {"subtitle", "Middle fingers of two human hands [Synek2019], and two thumbs"},
       {"provenance", provenance(inputs, studies.front().fit.problem.digit().fidelity, seconds)},
       {"sections", sections}},
      path);
  for (const SpecimenStudy& study : studies)
    fmt::print("{}: relative error {:.3f} in sample, {:.3f} with one posture left out\n",
               study.in_sample.experiment, study.in_sample.error.relative,
               study.postures.experiments.front().error.relative);
  fmt::print("wrote {} in {:.1f} s\n", std::filesystem::absolute(path).string(), seconds);
}

}  // namespace

void add_demo(CLI::App& app) {
  auto options = std::make_shared<DemoArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand("demo", "Fit real data and write a report");
  add_data_option(*command, options->data);
  command->add_option("-o,--output", options->output, "Folder for the report");
  command->callback([options] {
    options->data = data_with("fits", options->data);
    run_demo(*options);
  });
}

}  // namespace thenar
