// thenar tendon infer EXPERIMENT.toml --subject SUBJECT.toml [--net NET] [--method sparse|explore]
// ...
//
// Which bands of an extensor net measured fingertip forces ask for, which they deny, which they
// leave open, and what to measure next.

#include <cmath>
#include <memory>
#include <random>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "api/digits.h"
#include "api/files.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/tendon_commands.h"
#include "apps/terminal.h"
#include "base/file_io.h"
#include "base/interrupt.h"
#include "base/nearest_name.h"
#include "base/progress_parts.h"
#include "kinematics_fit/net_records.h"
#include "report/blocks.h"
#include "report/json.h"
#include "report/page.h"
#include "report/provenance.h"
#include "report/table.h"
#include "tendons/net/build_tendons.h"
#include "tendons/net/net_tendons.h"
#include "tendons/topology/search_nets.h"
#include "tendons/topology/select_bands.h"

namespace thenar {
namespace {

struct TendonInferArguments {
  std::string experiment, subject, output;
  std::string net = "winslow";
  std::optional<Path> path;
  std::string method = "sparse";
  int propose = 3;
  unsigned seed = 1;
  bool json = false;
};

/// What was inferred, and the tests that would tell most now.
struct NetAnswer {
  InferredNet net;
  std::vector<RankedTest> next;
  std::string stop;  // why the search for nets ended; empty: it is no search
};

/// Everything the inference starts from.
struct Case {
  Experiment experiment;
  CandidateNet candidate;
  std::vector<TendonRecord> records;
  std::vector<TendonTest> pool;
  MeasurementNoise noise;
  Json provenance;
};

Case read_case(const TendonInferArguments& options) {
  Case at;
  const SourceText experiment = read_source(options.experiment),
                   person = read_source(options.subject), bands = net_source(options.net);
  at.experiment = parse_experiment(experiment.text, experiment.path);
  const Subject subject = parse_subject(person.text, person.path);
  TendonOptions tendons;
  tendons.hood = Hood::kFloatingNet;
  tendons.path = options.path.value_or(Path::kViaPoint);
  const NetDescription net = parse_net(bands.text, bands.path);
  const auto built = build_digit_tendons(subject, at.experiment.digit, tendons, &net);
  const auto& netted = dynamic_cast<const NetTendons&>(*built);
  at.candidate = candidate_of(netted);
  at.records = net_records(netted, at.experiment);
  at.pool = possible_tests(netted, at.experiment);
  at.noise = {at.experiment.sd_relative, at.experiment.sd_floor};
  at.provenance = provenance_json({experiment, person, bands}, netted.digit().fidelity);
  at.provenance["method"] = options.method == "sparse"
                                ? options.method
                                : fmt::format("{}, seed {}", options.method, options.seed);
  return at;
}

NetAnswer by_selection(const Case& at, const Progress& progress) {
  BandFitter fitter(at.candidate, at.records);
  FittedNets tried(fitter);
  (void)select_bands(tried, {}, progress);
  NetAnswer out{assess_bands(tried, {}, progress), {}, ""};
  if (!out.net.found) return out;
  // Models weigh, and readings differ, by the noise that the best of them leaves.
  std::vector<FittedNet> nets = out.net.alike;
  for (FittedNet& net : nets) net.fit.misfit /= out.net.inflation * out.net.inflation;
  MeasurementNoise noise = at.noise;
  noise.floor *= out.net.inflation;
  noise.relative *= out.net.inflation;
  NetForwardModel forecast(at.candidate, at.pool);
  out.next = rank_tests(forecast, at.pool, nets, fitter.typical(), noise);
  return out;
}

NetAnswer by_search(const Case& at, unsigned seed, const Progress& progress) {
  std::mt19937 random(seed);
  NetSearchOptions options;
  options.noise = at.noise;
  NetSearchResult found =
      search_nets(at.candidate, at.records, at.pool, {}, random, options, progress);
  return {std::move(found.net), std::move(found.next), to_string(found.stop)};
}

nlohmann::ordered_json infer_json(const Case& at, const NetAnswer& answer,
                                  const TendonInferArguments& options) {
  nlohmann::ordered_json bands = nlohmann::ordered_json::array(), next = bands, groups = bands;
  for (const BandVerdict& band : answer.net.verdicts)
    bands.push_back(
        {{"band", band.name},
         {"verdict", to_string(band.verdict)},
         {"evidence", number_or_null(band.evidence)},
         {"converged", band.converged},
         {"EA_N", band.EA_told || band.EA == 0 ? nlohmann::json(band.EA) : nlohmann::json()},
         {"sd_of_log_EA", number_or_null(band.EA_sd)}});
  for (const BandGroup& group : answer.net.groups) {
    nlohmann::json names = nlohmann::json::array();
    for (int c : group.bands) names.push_back(answer.net.verdicts[c].name);
    groups.push_back({{"bands", names}, {"ways", group.ways.size()}});
  }
  for (int i = 0; i < std::min<int>(options.propose, static_cast<int>(answer.next.size())); ++i)
    next.push_back({{"test", at.pool[answer.next[i].test].name},
                    {"disagreement", answer.next[i].disagreement}});
  return {{"experiment", at.experiment.name},
          {"net", at.candidate.net.name},
          {"method", options.method},
          {"search_ended", answer.stop.empty() ? nlohmann::json() : nlohmann::json(answer.stop)},
          {"best_fit_converged", answer.net.converged},
          {"out_of_balance_N", answer.net.residual},
          {"readings", answer.net.rows},
          {"chi2", answer.net.misfit},
          {"noise_inflated_by", answer.net.inflation},
          {"topologies_alike", answer.net.alike.size()},
          {"topologies_tried", answer.net.tried},
          {"blind_directions", answer.net.blind.size()},
          {"bands", bands},
          {"groups", groups},
          {"next_tests", next}};
}

/// The band's stiffness, if the data decide it.
std::string stiffness(const BandVerdict& band) {
  if (band.EA == 0) return "-";
  return band.EA_told ? shown(band.EA, 1) : "not decided by the data";
}

Table table_of(const InferredNet& net) {
  Table table{{"band", "verdict", "evidence", "EA_N", "sd_log_EA"}, {}};
  for (const BandVerdict& band : net.verdicts)
    table.rows.push_back({band.name, to_string(band.verdict), shown(band.evidence, 1),
                          stiffness(band), band.EA == 0 ? "-" : shown(band.EA_sd, 2)});
  return table;
}

/// What not to trust of the fits behind the verdicts, a sentence each.
std::vector<std::string> doubts_of(const NetAnswer& answer) {
  std::vector<std::string> doubts, open;
  for (const BandVerdict& band : answer.net.verdicts)
    if (!band.converged) open.push_back(band.name);
  if (!answer.net.converged) doubts.push_back("The fit of the best net did not converge.");
  if (!open.empty())
    doubts.push_back(fmt::format("Verdicts rest on fits that did not converge: {}.", listed(open)));
  if (answer.net.residual > NetSolverOptions().tolerance)
    doubts.push_back(fmt::format("Nets were balanced to {:.1g} N only.", answer.net.residual));
  return doubts;
}

void print_text(const Case& at, const NetAnswer& answer, const TendonInferArguments& options) {
  const InferredNet& net = answer.net;
  fmt::print("{}: {} readings of muscles that pull net {}\n", at.experiment.name, net.rows,
             at.candidate.net.name);
  fmt::print(
      "best topology: chi^2 {:.1f} by the stated noise; evidence weighed by {:.2f} times it\n",
      net.misfit, net.inflation);
  fmt::print("{} topologies tried, {} fit alike, {} directions of stiffness are not felt\n\n",
             net.tried, net.alike.size(), net.blind.size());
  if (!answer.stop.empty()) fmt::print("the search ended: {}\n\n", answer.stop);
  fmt::print("{}", titled("Bands", table_of(net)));
  for (const std::string& doubt : doubts_of(answer)) fmt::print("{}\n", doubt);
  for (const BandGroup& group : net.groups) {
    std::vector<std::string> names;
    for (int c : group.bands) names.push_back(net.verdicts[c].name);
    fmt::print("the data cannot tell apart: {} ({} ways)\n", listed(names), group.ways.size());
  }
  Table next{{"test", "disagreement"}, {}};
  for (int i = 0; i < std::min<int>(options.propose, static_cast<int>(answer.next.size())); ++i)
    next.rows.push_back({at.pool[answer.next[i].test].name, shown(answer.next[i].disagreement, 2)});
  fmt::print("{}", titled("Measure next (tensions in N)", next));
}

void write_page(const Case& at, const NetAnswer& answer, const TendonInferArguments& options) {
  Json bands = Json::array();
  for (const auto& row : table_of(answer.net).rows) bands.push_back(row);
  Json next = Json::array();
  for (int i = 0; i < std::min<int>(options.propose, static_cast<int>(answer.next.size())); ++i)
    next.push_back({at.pool[answer.next[i].test].name, answer.next[i].disagreement});
  std::string what = fmt::format(
      "chi^2 {:.1f} for {} readings; evidence is weighed by {:.2f} times the stated noise. {} "
      "topologies fit alike; {} directions of stiffness are not felt.",
      answer.net.misfit, answer.net.rows, answer.net.inflation, answer.net.alike.size(),
      answer.net.blind.size());
  if (!answer.stop.empty()) what += fmt::format(" The search ended: {}.", answer.stop);
  for (const std::string& doubt : doubts_of(answer)) what += " " + doubt;
  Json blocks = Json::array(
      {table_block(
           "Bands: evidence above 6 decides",
           {{"band", ""}, {"verdict", ""}, {"evidence", ""}, {"EA", "N"}, {"sd log EA", ""}},
           bands),
       table_block("Tests that would tell most, tensions in N",
                   {{"test", ""}, {"disagreement", ""}}, next)});
  write_report({{"title", "Bands of net " + at.candidate.net.name},
                {"subtitle", "from " + at.experiment.name},
                {"provenance", at.provenance},
                {"sections", Json::array({section("bands", "Which bands exist", what, blocks)})}},
               options.output);
}

void run_tendon_infer(const TendonInferArguments& options) {
  require(options.method == "sparse" || options.method == "explore",
          "method must be sparse or explore, got '{}'", options.method);
  require_ending(options.output, {".html"});
  if (!options.output.empty()) require_writable(options.output);
  Case at;
  NetAnswer answer;
  {
    const Progress progress = terminal_progress();
    progress(0, "tests");
    at = read_case(options);
    answer = options.method == "sparse" ? by_selection(at, progress)
                                        : by_search(at, options.seed, progress);
  }
  require(answer.net.found, "no topology of net {} carries the loads of {}", at.candidate.net.name,
          at.experiment.name);
  if (options.json)
    fmt::print("{}\n", json_text(infer_json(at, answer, options)));
  else
    print_text(at, answer, options);
  if (!options.output.empty()) write_page(at, answer, options);
  if (interrupted()) throw Stopped("stopped: these are the verdicts of what was tried so far");
}

}  // namespace

void add_tendon_infer(CLI::App& tendon) {
  auto options = std::make_shared<TendonInferArguments>();  // lives as long as the callback
  CLI::App* command =
      tendon.add_subcommand("infer", "Which bands of a net measured forces ask for");
  command->add_option("experiment", options->experiment, "Experiment file")->required();
  command->add_option("--subject", options->subject, "Subject file")->required();
  command->add_option("--net", options->net, "Net of all candidate bands: name or file");
  add_path_option(*command, options->path);
  command->add_option("--method", options->method, "sparse or explore");
  command->add_option("--propose", options->propose, "Tests to propose");
  command->add_option("--seed", options->seed, "Of the search");
  command->add_option("-o,--output", options->output, "Page to write (.html)");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_tendon_infer(*options); });
}

}  // namespace thenar
