// thenar quality CONTACTS.json ... [--json] [--edges m] [--norm l1|linf] [--gap g] [--out FILE]
//
// How large a wrench, from whatever direction, the contacts of a file withstand.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/commands.h"
#include "apps/contact_file.h"
#include "apps/print_table.h"
#include "apps/to_json.h"
#include "base/error.h"
#include "base/write_file.h"
#include "grasp/quality/epsilon.h"
#include "grasp/quality/pyramid.h"
#include "grasp/quality/volume.h"

namespace thenar {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  std::string norm = "l1", out;
  double gap = 1e-3;
  int edges = 0;
  bool json = false;
};

struct Answer {
  Epsilon epsilon;
  Volume volume;
  double cpu;  // [s]
};

constexpr double kPolytopeGap = 1e-10;  // of the largest wrench: exact at little cost [1]
constexpr int kMostEdges = 1000;        // of a pyramid: finer ones take minutes and change nothing

bool is_polytope(const WrenchSet& set) {
  return std::all_of(set.caps.begin(), set.caps.end(),
                     [](const WrenchCap& cap) { return cap.A.cols() == 0; });
}

double largest_wrench(const WrenchSet& set) {
  double largest = 0;
  for (const WrenchCap& cap : set.caps) largest = std::max(largest, cap.c.norm());
  return largest;
}

/// Wrenches of a file: its cones or their pyramids, and generators where they are given.
WrenchSet wrenches_of(const ContactFile& file, int edges) {
  std::vector<Contact> cones;
  for (const FileContact& contact : file.contacts)
    if (contact.wrenches.empty()) cones.push_back(contact.contact);
  WrenchSet set = wrench_set(cones, file.centre_of_mass, file.torque_scale);
  if (edges > 0) set = pyramids(set, edges);
  int number = static_cast<int>(file.contacts.size());  // apart from those of pyramids
  for (const FileContact& contact : file.contacts) {
    for (const Wrench& wrench : contact.wrenches) set.caps.push_back({wrench, {}, number});
    ++number;
  }
  return set;
}

Answer answer(const ContactFile& file, const Options& options) {
  const std::clock_t start = std::clock();
  const ForceLimit limit = options.norm == "l1" ? ForceLimit::kL1 : ForceLimit::kLinf;
  const WrenchSet set = wrenches_of(file, options.edges);
  EpsilonOptions wanted;
  wanted.limit = limit;
  wanted.gap = options.gap;
  const double sharp = kPolytopeGap * largest_wrench(set);
  if (is_polytope(set) && sharp > 0) wanted.gap = std::min(options.gap, sharp);
  VolumeOptions of_volume;
  of_volume.limit = limit;
  Answer result{epsilon(set, wanted), volume(set, of_volume), 0};
  result.epsilon.converged = result.epsilon.upper - result.epsilon.lower <= options.gap;
  result.cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
}

Json json_of(const Answer& answer) {
  const Epsilon& e = answer.epsilon;
  Json missing;
  if (e.has_missing_direction) missing = to_json(e.missing_direction);
  return {{"epsilon", {{"lower", e.lower}, {"upper", e.upper}}},
          {"volume", answer.volume.complete ? Json(answer.volume.estimate) : Json(nullptr)},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"worst_wrench", to_json(e.worst_wrench)},
          {"cpu_s", answer.cpu},
          {"volume_bounds", {{"lower", answer.volume.lower}, {"upper", answer.volume.upper}}},
          {"volume_complete", answer.volume.complete},
          {"converged", e.converged}};
}

std::string words(const Wrench& w) {
  return fmt::format("force ({}), torque / scale ({})", fmt::join(cells(w.head<3>(), 4), ", "),
                     fmt::join(cells(w.tail<3>(), 4), ", "));
}

std::string enclosed(double lower, double upper) {
  return fmt::format("between {:.6g} and {:.6g}", lower, upper);
}

std::string volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.6g}: a hull had too many facets", v.lower);
  if (v.lower == v.upper) return fmt::format("{:.6g}", v.estimate);
  return fmt::format("about {:.6g}, {}", v.estimate, enclosed(v.lower, v.upper));
}

std::string text_of(const std::string& path, const ContactFile& file, const Answer& answer) {
  const Epsilon& e = answer.epsilon;
  std::string text = fmt::format("{}: {} contacts, torques divided by {} m\n", path,
                                 file.contacts.size(), shown(file.torque_scale));
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<18}{}\n", name, value);
  };
  line("force closure", e.force_closure ? "yes" : "no");
  line("epsilon", enclosed(e.lower, e.upper) + (e.converged ? "" : " (gave up early)"));
  line("volume", volume_words(answer.volume));
  line("rank", fmt::format("{} of 6", e.rank));
  if (e.has_missing_direction) line("cannot make", words(e.missing_direction));
  line(e.has_missing_direction ? "not withstood" : "withstood least", words(e.worst_wrench));
  return text;
}

void run(const Options& options) {
  require(options.gap > 0, "wanted --gap above 0, got {}", options.gap);
  require(options.edges == 0 || (options.edges >= 3 && options.edges <= kMostEdges),
          "wanted --edges of 3 to {}, got {}", kMostEdges, options.edges);
  std::vector<ContactFile> files;
  for (const std::string& path : options.files) files.push_back(read_contact_file(path));
  std::string lines;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Answer found = answer(files[i], options);
    const std::string line = json_of(found).dump() + "\n";
    lines += line;
    fmt::print("{}", options.json ? line : text_of(options.files[i], files[i], found));
    std::fflush(stdout);
  }
  if (!options.out.empty()) write_file(options.out, lines);
}

}  // namespace

void add_quality(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("quality", "How large a wrench, from whatever direction, contacts bear");
  command->add_option("contacts", options->files, "Contacts as JSON; several give a line each")
      ->required();
  command->add_option("--edges", options->edges,
                      "Friction pyramids of so many edges, 3 to 1000, in place of cones; 0: cones");
  command
      ->add_option("--norm", options->norm,
                   "l1: normal forces sum up to 1; linf: each of them is at most 1")
      ->check(CLI::IsMember({"l1", "linf"}));
  command->add_option("--gap", options->gap, "Largest upper - lower of epsilon");
  command->add_option("-o,--out", options->out, "Also write the JSON lines to this file");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace thenar
