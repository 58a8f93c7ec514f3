// thenar quality CONTACTS.json ...|- [--json] [--edges m] [--first-edge degrees] [--norm l1|linf]
// [--gap g] [--no-volume] [--out FILE]
//
// How large a wrench, from whatever direction, the contacts of a file withstand.

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "api/files.h"
#include "apps/commands.h"
#include "apps/contact_answer.h"
#include "base/error.h"
#include "base/file_io.h"
#include "report/json.h"

namespace thenar {
namespace {

struct QualityArguments {
  std::vector<std::string> files;
  ContactQuestion question;
  std::string norm = "l1", out;
  bool json = false;
};

constexpr int kMostEdges = 1000;  // of a pyramid: finer ones take minutes and change nothing

/// Prints the answer about a file. @return it as a line of JSON
std::string answer_file(const std::string& path, const QualityArguments& options) {
  require_kind(path, {"contacts"});
  const ContactFile file = read_contact_file(path);
  const ContactAnswer found = answer(file, options.question);
  std::string line = json_text(json_of(path, file, found), -1) + "\n";
  fmt::print("{}", options.json ? line : text_of(path, file, found));
  std::fflush(stdout);
  return line;
}

/// Answers lines of standard input as they come, a line of JSON each; a broken one with its error,
/// so that answers stay beside their questions. @return whether all could be answered
bool answer_stream(const ContactQuestion& question) {
  bool all = true;
  std::string text;
  for (int number = 1; std::getline(std::cin, text); ++number) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    OrderedJson line;
    try {
      const ContactFile file = parse_contacts("stdin", text, number);
      line = json_of("stdin", file, answer(file, question));
    } catch (const Error& error) {
      line = {{"error", error.what()}};
      fmt::print(stderr, "thenar: {}\n", error.what());
      all = false;
    }
    line["line"] = number;
    fmt::print("{}\n", json_text(line, -1));
    std::fflush(stdout);
  }
  return all;
}

void check(const QualityArguments& options) {
  const ContactQuestion& question = options.question;
  require(question.gap > 0, "wanted --gap above 0, got {}", question.gap);
  require(question.edges == 0 || (question.edges >= 3 && question.edges <= kMostEdges),
          "wanted --edges of 3 to {}, got {}", kMostEdges, question.edges);
  require(question.edges > 0 || question.first_edge == 0,
          "--first-edge is of pyramids: give --edges");
  const bool stream = std::count(options.files.begin(), options.files.end(), "-") > 0;
  require(!stream || (options.files.size() == 1 && options.out.empty()),
          "'-' reads a stream: give no other file, and no {}", "--out");
}

/// File by file, so that Ctrl-C leaves what is done, and a broken file does not hinder others.
void run_quality(QualityArguments options) {
  check(options);
  options.question.limit = options.norm == "l1" ? ForceNorm::kL1 : ForceNorm::kLinf;
  bool all = true;
  if (options.files[0] == "-") {
    all = answer_stream(options.question);
    options.files.clear();
  }
  std::string lines;
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
  auto options = std::make_shared<QualityArguments>();
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
      "Points with one \"patch\": n are one face, with one limit under linf. \"task\": "
      "{\"loads\":\n"
      "[[fx, fy, fz, tx, ty, tz], ..]} [N, N m], a box of two or an ellipsoid of semi-axes, asks "
      "for\n"
      "the least squeeze that withstands them. A centre_of_mass of two numbers makes all planar.\n"
      "'-' reads a file a line from standard input. JSON answers are lines, one a file.\n"
      "docs/data_format.md says all.");
  command
      ->add_option("contacts", options->files,
                   "Contacts as JSON; several give an answer each; -: a stream")
      ->required();
  command->add_option(
      "--edges", options->question.edges,
      "Friction pyramids of so many edges, 3 to 1000, in place of cones; 0: the true "
      "cones. Soft fingers get double pyramids with poles at their torsion");
  command->add_option("--first-edge", options->question.first_edge,
                      "Angle of the pyramids' first edges about the normals [degrees]");
  command
      ->add_option("--norm", options->norm,
                   "l1: normal forces sum up to 1; linf: those of each patch sum up to 1 at most")
      ->check(CLI::IsMember({"l1", "linf"}, CLI::ignore_case));
  command->add_option("--gap", options->question.gap,
                      "Largest certified upper - lower of epsilon, in units of normal force");
  command->add_option("-o,--out", options->out, "Also write the JSON lines to this file");
  command->add_flag("!--no-volume", options->question.volume,
                    "Leave out the volume, which takes 80 to 5,000 times as long as epsilon");
  command->add_flag("--json", options->json, "Print JSON");
  for (CLI::Option* option : command->get_options()) option->capture_default_str();
  command->callback([options] { run_quality(*options); });
}

}  // namespace thenar
