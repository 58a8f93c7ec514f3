#include "apps/outputs.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/options.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "report/page.h"

namespace thenar {
namespace {

std::string ending_of(const std::string& path) { return std::filesystem::path(path).extension(); }

/// All endings that a command can write.
std::vector<std::string> endings_of(const OutputKinds& kinds) {
  std::vector<std::string> endings = kinds.own;
  if (kinds.page) endings.emplace_back(".html");
  if (kinds.csv) endings.emplace_back(".csv");
  if (kinds.json) endings.emplace_back(".json");
  return endings;
}

/// Refuses a file of another ending, and one that cannot be written.
CLI::Validator writable_with(const std::vector<std::string>& endings) {
  const auto complaint = [endings](const std::string& path) -> std::string {
    try {
      require_ending(path, endings);
      require_writable(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  return {complaint, ""};
}

RunRecord& run_of_process() {
  static RunRecord run;  // a process is one run; begin_run() alone writes it
  return run;
}

/// Adds the run and its files to what a page or a file says of its origin.
template <typename AnyJson>
void add_run(AnyJson& json, const FileDigests& files) {
  const RunRecord& run = this_run();
  if (run.arguments.empty() || !json.is_object()) return;
  AnyJson& provenance = json["provenance"];
  for (const auto& [name, text] : texts_of(run))
    if (!text.empty()) provenance[name] = text;
  provenance["thenar"] = versions().at("thenar");
  for (const auto& [path, digest] : files) provenance[path] = "sha256 " + digest;
}

}  // namespace

std::vector<std::string> Outputs::with_ending(const std::vector<std::string>& endings) const {
  std::vector<std::string> found = files;
  erase_where(found, [&](const std::string& path) { return !contains(endings, ending_of(path)); });
  return found;
}

std::string Outputs::only_file(const std::string& ending) const {
  const std::vector<std::string> found = with_ending({ending});
  require(found.size() < 2, "wanted one output that ends in {}, got {}", ending,
          fmt::join(found, ", "));
  return found.empty() ? "" : found.front();
}

void add_output_options(CLI::App& command, Outputs& outputs, const OutputKinds& kinds) {
  if (kinds.json) command.add_flag("--json", outputs.json, "Print JSON");
  if (kinds.csv) command.add_flag("--csv", outputs.csv, "Print a table (CSV)");
  // Several outputs may be named; each option adds one file.
  const auto add_file_option = [&](const std::string& names, const std::string& about,
                                   const std::vector<std::string>& endings) {
    const auto add_file = [&outputs](const std::string& path) { outputs.files.push_back(path); };
    command.add_option_function<std::string>(names, add_file, about)
        ->check(writable_with(endings))
        ->trigger_on_parse()
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  };
  const std::vector<std::string> endings = endings_of(kinds);
  if (!endings.empty())
    add_file_option(
        "-o,--out,--output",
        fmt::format("Output file; the extension selects the format: {}", fmt::join(endings, ", ")),
        endings);
  if (kinds.page) add_file_option("--report", "Page to write (.html)", {".html"});
}

void begin_run(int argc, char** argv) {
  run_of_process() = record_of_run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
}

const RunRecord& this_run() { return run_of_process(); }

void set_request(const std::string& question, const OrderedJson& request) {
  run_of_process().request = request_record(question, request);
}

void print_answer(const std::string& text) { fmt::print("{}", text); }

void print_written(const Outputs& outputs) {
  if (outputs.json || outputs.csv) return;
  for (const std::string& path : outputs.files) fmt::print("wrote {}\n", path);
}

void write_page(Json page, const std::string& path, const FileDigests& files) {
  add_run(page, files);
  write_report(page, path);
}

void write_json_file(OrderedJson json, const std::string& path, const FileDigests& files) {
  add_run(json, files);
  write_file(path, json_text(json) + "\n");
}

void write_csv_file(const Table& table, const std::string& path) { write_file(path, csv(table)); }

void deliver(const Outputs& outputs, const Answer& answer) {
  const Outcome& outcome = answer.outcome;
  const bool stopped = outcome.stopped();
  if (stopped && outcome.done == 0) throw_if_stopped(0, outcome.asked, outcome.part);
  print_warnings(outcome.warnings);
  // Write files first, so that they are complete when a reader closes the pipe.
  const FileDigests files = answer.files && !outputs.files.empty() ? answer.files() : FileDigests();
  for (const std::string& path : outputs.with_ending({".json"}))
    write_json_file(answer.json(UnitSystem::kPrinted), path, files);
  if (answer.table)
    for (const std::string& path : outputs.with_ending({".csv"}))
      write_csv_file(answer.table(), path);
  if (answer.page)
    for (const std::string& path : outputs.with_ending({".html"}))
      write_page(answer.page(), path, files);
  // Print the answer.
  if (outputs.json) {
    print_answer(json_text(answer.json(UnitSystem::kPrinted)) + "\n");
  } else if (outputs.csv && answer.table) {
    print_answer(csv(answer.table()));
  } else {
    print_answer(answer.text());
    print_written(outputs);
  }
  require(answer.refusal.empty(), "{}", answer.refusal);
  if (!stopped) return;
  throw_if_stopped(outcome.done, outcome.asked, outcome.part);
  throw Stopped("stopped: this is what was found by then");
}

}  // namespace thenar
