// thenar quality CONTACTS ...|- [--json] [--csv] [-o FILE] [--edges m] [--first-edge degrees]
// [--norm l1|linf] [--gap g] [--no-volume]
//
// Grasp quality (epsilon, volume, task margin) of a set of contacts.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "api/quality.h"
#include "apps/commands.h"
#include "apps/options.h"
#include "apps/outputs.h"
#include "apps/request_options.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "questions/question_params.h"
#include "report/answers/quality.h"

namespace thenar {
namespace {

struct QualityArguments : TypedQuestion {
  std::vector<std::string> contacts;
};

std::string json_line(const OrderedJson& json) { return json_text(json, -1) + "\n"; }

/// Prints the last answer, so that each is there as soon as it is known.
void print_last(const std::vector<ContactQualityResult>& answers, const Outputs& outputs) {
  if (outputs.json)
    print_answer(json_line(json_of(answers.back())));
  else if (outputs.csv) {
    const std::string rows = csv(table_of(std::vector<ContactQualityResult>{answers.back()}));
    print_answer(answers.size() == 1 ? rows : rows.substr(rows.find('\n') + 1));
  } else
    print_answer(text_of(answers.back()));
  std::fflush(stdout);
}

/// Writes all results so far, so that Ctrl-C leaves them complete.
void write_answers(const std::vector<ContactQualityResult>& answers, const Outputs& outputs) {
  std::string lines;
  for (const ContactQualityResult& answer : answers) lines += json_line(json_of(answer));
  for (const std::string& path : outputs.with_ending({".jsonl"})) write_file(path, lines);
  for (const std::string& path : outputs.with_ending({".json"}))
    write_json_file(json_of(answers), path, files_of(answers));
  for (const std::string& path : outputs.with_ending({".csv"}))
    write_csv_file(table_of(answers), path);
}

/// Answers lines of standard input as they come, a line of JSON each; a broken one with its error,
/// so that answers stay beside their questions. @return whether all could be answered
bool answer_stream(ContactQualityRequest request) {
  bool all = true;
  request.contacts = "stdin";
  // Blank lines are skipped, but counted, so that answers name their line.
  for (request.line = 1; std::getline(std::cin, request.text); ++request.line) {
    if (request.text.find_first_not_of(" \t\r") == std::string::npos) continue;
    OrderedJson line;
    try {
      line = json_of(measure_contacts(request));
    } catch (const Error& error) {
      line = {{"error", error.what()}};
      fmt::print(stderr, "thenar: {}\n", error.what());
      all = false;
    }
    line["line"] = request.line;
    print_answer(json_line(line));
    std::fflush(stdout);
  }
  return all;
}

/// Measures file by file, so that a wrong one does not affect others. @return true if all succeeded
bool answer_files(const QualityArguments& options, ContactQualityRequest request) {
  bool all = true;
  std::vector<ContactQualityResult> answers;
  for (const std::string& contacts : options.contacts) {
    // Print and write after each set, so that results are kept if a later one fails.
    request.contacts = contacts;
    try {
      answers.push_back(measure_contacts(request));
      print_last(answers, options.outputs);
      write_answers(answers, options.outputs);
    } catch (const Error& error) {
      fmt::print(stderr, "thenar: {}\n", error.what());
      all = false;
    }
  }
  if (!answers.empty()) print_written(options.outputs);
  return all;
}

void run_quality(QualityArguments options) {
  // Words for norms are accepted in capitals, too: L1, Linf.
  if (options.request.contains("norm")) {
    std::string norm = options.request["norm"].get<std::string>();
    std::transform(norm.begin(), norm.end(), norm.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    options.request["norm"] = norm;
  }
  const ContactQualityRequest request = read_typed(contact_params(), options.request);
  require_valid(request);
  // A stream answers each line as it comes, and so writes no files.
  const bool stream = contains(options.contacts, "-");
  require(!stream || (options.contacts.size() == 1 && options.outputs.files.empty() &&
                      !options.outputs.csv),
          "'-' reads a stream and answers in lines of JSON: give no other {}",
          "contacts, and neither -o nor --csv");
  const bool all = stream ? answer_stream(request) : answer_files(options, request);
  if (!all) throw CLI::RuntimeError(1);
}

const char* const kFormat =
    "CONTACTS.json: {\"centre_of_mass\": [x, y, z], \"torque_scale\": s, \"contacts\": [\n"
    "  {\"position\": [x, y, z], \"normal\": [x, y, z], \"friction\": mu, \"torsion\": t},\n"
    "  {\"wrenches\": [[fx, fy, fz, tx, ty, tz], ..]}, ..]}\n"
    "Lengths in metres. Normals point into the object. torque_scale has no default: torques are\n"
    "divided by it; the largest distance of the surface from the centre of mass is customary.\n"
    "torsion, of soft fingers, is a torque about the normal per normal force [m]. wrenches\n"
    "replace the cone; their torques must already be divided, and --edges does not change them.\n"
    "Points with one \"patch\": n are one face, with one limit under linf. \"task\": {\"loads\":\n"
    "[[fx, fy, fz, tx, ty, tz], ..]} [N, N m], a box of two or an ellipsoid of semi-axes, asks "
    "for\n"
    "the least squeeze that resists them. With a two-component centre_of_mass the problem is\n"
    "planar. '-' reads one contact set per line from standard input and prints one JSON line per\n"
    "contact set, as do --json and -o x.jsonl. See docs/data_format.md.";

}  // namespace

void add_quality(CLI::App& app) {
  auto options = std::make_shared<QualityArguments>();  // lives as long as the callback
  CLI::App* command = app.add_subcommand(
      "quality", "Compute the quality (epsilon, volume, task margin) of a set of contacts");
  command
      ->add_option("contacts", options->contacts,
                   "Contact sets: files (JSON), or names in the data folder's contacts/; one "
                   "answer for each; -: read from standard input")
      ->required();
  add_request_options(*command, without(contact_params().params(), {"contacts"}), options->request);
  add_output_options(*command, options->outputs, {true, true, false, {".jsonl"}});
  command->footer(kFormat);
  add_examples(*command, {"quality two_soft_fingers",
                          "quality data/contacts/two_soft_fingers.json --norm linf --edges 8"});
  command->callback([options] { run_quality(*options); });
}

}  // namespace thenar
