// thenar quality CONTACTS.json ... [--json] [--edges m] [--first-edge degrees] [--norm l1|linf]
// [--gap g] [--out FILE]
//
// How large a wrench, from whatever direction, the contacts of a file withstand.

#include <algorithm>
#include <cmath>
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
#include "base/angles.h"
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
  double first_edge = 0;  // about the normal, from the first tangent [deg]
  bool json = false;
};

struct Answer {
  Epsilon epsilon;
  Volume volume;
  double epsilon_cpu, volume_cpu;  // the first with the making of the wrenches [s]
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

/// Caps with their friction axes turned about the normals: other first edges of pyramids.
void turn(WrenchSet& set, double angle) {
  for (WrenchCap& cap : set.caps) {
    if (cap.A.cols() < 2) continue;
    const Wrench a = cap.A.col(0), b = cap.A.col(1);
    cap.A.col(0) = std::cos(angle) * a + std::sin(angle) * b;
    cap.A.col(1) = std::cos(angle) * b - std::sin(angle) * a;
  }
}

/// Wrenches of a file: its cones or their pyramids, and generators where they are given.
WrenchSet wrenches_of(const ContactFile& file, const Options& options) {
  std::vector<Contact> cones;
  for (const FileContact& contact : file.contacts)
    if (contact.wrenches.empty()) cones.push_back(contact.contact);
  WrenchSet set = wrench_set(cones, file.centre_of_mass, file.torque_scale);
  if (options.edges > 0) {
    turn(set, options.first_edge * kDegree);
    set = pyramids(set, options.edges);
  }
  int number = static_cast<int>(file.contacts.size());  // apart from those of pyramids
  for (const FileContact& contact : file.contacts) {
    for (const Wrench& wrench : contact.wrenches) set.caps.push_back({wrench, {}, number});
    ++number;
  }
  return set;
}

double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Answer answer(const ContactFile& file, const Options& options) {
  const std::clock_t start = std::clock();
  const ForceLimit limit = options.norm == "l1" ? ForceLimit::kL1 : ForceLimit::kLinf;
  const WrenchSet set = wrenches_of(file, options);
  EpsilonOptions wanted;
  wanted.limit = limit;
  wanted.gap = options.gap;
  const double sharp = kPolytopeGap * largest_wrench(set);
  if (is_polytope(set) && sharp > 0) wanted.gap = std::min(options.gap, sharp);
  Epsilon found = epsilon(set, wanted);
  found.converged = found.upper - found.lower <= options.gap;
  const double epsilon_cpu = seconds_since(start);
  const std::clock_t middle = std::clock();
  VolumeOptions of_volume;
  of_volume.limit = limit;
  const Volume size = volume(set, of_volume);
  return {found, size, epsilon_cpu, seconds_since(middle)};
}

/// Without minus zeros.
Json plain(const Wrench& w) { return to_json(Wrench((w.array() + 0.0).matrix())); }

Json json_of(const std::string& path, const ContactFile& file, const Answer& answer) {
  const Epsilon& e = answer.epsilon;
  Json missing;
  if (e.has_missing_direction) missing = plain(e.missing_direction);
  return {{"epsilon", {{"lower", e.lower + 0.0}, {"upper", e.upper + 0.0}}},
          {"volume", answer.volume.complete ? Json(answer.volume.estimate) : Json(nullptr)},
          {"force_closure", e.force_closure},
          {"rank", e.rank},
          {"missing_direction", missing},
          {"worst_wrench", plain(e.worst_wrench)},
          {"cpu_s", answer.epsilon_cpu + answer.volume_cpu},
          {"epsilon_cpu_s", answer.epsilon_cpu},
          {"volume_bounds", {{"lower", answer.volume.lower}, {"upper", answer.volume.upper}}},
          {"volume_complete", answer.volume.complete},
          {"converged", e.converged},
          {"file", path},
          {"warnings", file.warnings}};
}

std::string words(const Wrench& w) {
  return fmt::format("force ({}), torque / scale ({})", fmt::join(cells(w.head<3>(), 4), ", "),
                     fmt::join(cells(w.tail<3>(), 4), ", "));
}

std::string enclosed(double lower, double upper) {
  return fmt::format("between {:.6g} and {:.6g}", lower, upper);
}

std::string volume_words(const Volume& v) {
  if (!v.complete) return fmt::format("at least {:.6g}: too many facets or faces", v.lower);
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
  for (const std::string& warning : file.warnings) line("warning", warning);
  return text;
}

/// Prints the answer about a file. @return it as a line of JSON
std::string answer_file(const std::string& path, const Options& options) {
  const ContactFile file = read_contact_file(path);
  const Answer found = answer(file, options);
  std::string line = json_of(path, file, found).dump() + "\n";
  fmt::print("{}", options.json ? line : text_of(path, file, found));
  std::fflush(stdout);
  return line;
}

/// File by file, so that Ctrl-C leaves what is done, and a broken file does not hinder others.
void run(const Options& options) {
  require(options.gap > 0, "wanted --gap above 0, got {}", options.gap);
  require(options.edges == 0 || (options.edges >= 3 && options.edges <= kMostEdges),
          "wanted --edges of 3 to {}, got {}", kMostEdges, options.edges);
  require(options.edges > 0 || options.first_edge == 0,
          "--first-edge is of pyramids: give --edges");
  std::string lines;
  bool all = true;
  for (const std::string& path : options.files) {
    try {
      lines += answer_file(path, options);
      if (!options.out.empty()) write_file(options.out, lines);
    } catch (const Error& error) {
      fmt::print(stderr, "thenar: {}\n", error.what());
      all = false;
    }
  }
  if (!all) throw CLI::RuntimeError(1);
}

}  // namespace

void add_quality(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("quality", "How large a wrench, from whatever direction, contacts bear");
  command->footer(
      "CONTACTS.json: {\"centre_of_mass\": [x, y, z], \"torque_scale\": s, \"contacts\": [\n"
      "  {\"position\": [x, y, z], \"normal\": [x, y, z], \"friction\": mu, \"torsion\": t},\n"
      "  {\"wrenches\": [[fx, fy, fz, tx, ty, tz], ..]}, ..]}\n"
      "Lengths in metres. Normals point into the object. torque_scale has no default: torques are\n"
      "divided by it; the largest distance of the surface from the centre of mass is customary.\n"
      "torsion, of soft fingers, is a torque about the normal per normal force [m]. wrenches\n"
      "stand in place of the cone, torques already divided; --edges leaves them as they are.\n"
      "JSON answers are lines, one a file. docs/data_format.md says all.");
  command->add_option("contacts", options->files, "Contacts as JSON; several give an answer each")
      ->required();
  command->add_option(
      "--edges", options->edges,
      "Friction pyramids of so many edges, 3 to 1000, in place of cones; 0: the true "
      "cones. Soft fingers get double pyramids with poles at their torsion");
  command->add_option("--first-edge", options->first_edge,
                      "Angle of the pyramids' first edges about the normals [degrees]");
  command
      ->add_option("--norm", options->norm,
                   "l1: normal forces sum up to 1; linf: each of them is at most 1")
      ->check(CLI::IsMember({"l1", "linf"}, CLI::ignore_case));
  command->add_option("--gap", options->gap,
                      "Largest certified upper - lower of epsilon, in units of normal force");
  command->add_option("-o,--out", options->out, "Also write the JSON lines to this file");
  command->add_flag("--json", options->json, "Print JSON");
  for (CLI::Option* option : command->get_options()) option->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace thenar
