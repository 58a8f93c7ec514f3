#include "api/named/recorded_run.h"

#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "api/named/digits.h"
#include "api/named/files.h"
#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/provenance.h"
#include "data/io/inference_file.h"
#include "data/io/json_node.h"
#include "data/io/result_file.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// The JSON of a page, between the tags of its script.
std::string page_data(const std::string& path) {
  const std::string text = read_source(path).text;
  const std::string begin = "id=\"thenar-report\">", end = "</script>";
  const std::size_t from = text.find(begin);
  if (from == std::string::npos) throw DataError(path, 1, "wanted a page of thenar");
  const std::size_t to = text.find(end, from);
  if (to == std::string::npos) throw DataError(path, 1, "the page is cut short");
  return text.substr(from + begin.size(), to - from - begin.size());
}

/// Provenance as pages and JSON answers have it: inputs by path, "sha256 0123..".
void add_json_record(const std::string& path, const std::string& text, RecordedRun& out) {
  const JsonNode file = parse_json(path, text);
  std::map<std::string, std::string> texts;  // not of the runs before it, which a comparison has
  if (const JsonNode* provenance = file.find("provenance"))
    for (std::size_t i = 0; i < provenance->names.size(); ++i)
      if (provenance->items[i].kind == JsonKind::kText)
        texts[provenance->names[i]] = provenance->items[i].text;
  // Read the command and its folder, which make the run repeatable; digests show whether its inputs
  // are still the same.
  out.run = record_of_texts(texts);
  out.version = texts["thenar"];
  const std::string start = "sha256 ";
  for (const auto& [name, value] : texts)
    if (value.compare(0, start.size(), start) == 0) out.inputs[name] = value.substr(start.size());
}

/// Adds inputs of results that store texts by key, with the content of an input beside its path.
/// @param ending  of keys: "/path" of HDF5, "_path" of netCDF
void add_inputs(const std::map<std::string, std::string>& texts, const std::string& slash,
                RecordedRun& out) {
  const std::string path = slash + "path", text = slash + "text";
  for (const auto& [key, value] : texts) {
    if (key.size() < path.size() || key.compare(key.size() - path.size(), path.size(), path) != 0)
      continue;
    const auto content = texts.find(key.substr(0, key.size() - path.size()) + text);
    if (content != texts.end()) out.inputs[value] = sha256(content->second);
  }
}

/// The record of texts whose names begin with `before`.
RunRecord record_with(const std::map<std::string, std::string>& texts, const std::string& before) {
  std::map<std::string, std::string> record;
  for (const auto& [name, text] : texts)
    if (name.rfind(before, 0) == 0) record[name.substr(before.size())] = text;
  return record_of_texts(record);
}

void add_result_record(const std::string& path, RecordedRun& out) {
  std::map<std::string, std::string> texts;
  for (const auto& [key, list] : read_result(path).texts)
    if (list.size() == 1) texts[key] = list.front();
  add_inputs(texts, "/", out);
  out.run = record_with(texts, "provenance/");
  out.version = texts["provenance/versions/thenar"];
}

void add_posterior_record(const std::string& path, RecordedRun& out) {
  std::map<std::string, std::string> texts = read_inference(path).attributes;
  add_inputs(texts, "_", out);
  out.run = record_with(texts, "run_");
  out.version = texts["version_thenar"];
}

/// Returns true if the name of a missing input names a file rather than built-in data. Older
/// runs record a built-in net as "NAME.toml".
bool was_file(const std::string& name) {
  const auto is_net = [&](const std::string& net) { return name == net + ".toml"; };
  return name.rfind("built-in ", 0) != 0 && name.find_first_of("/.") != std::string::npos &&
         !any_of(known_nets(), is_net);
}

/// A sentence for each input that is another file today; names that are no files are left out.
void compare_inputs_of(RecordedRun& out) {
  for (const auto& [name, digest] : out.inputs) {
    const std::string path = (fs::path(out.run.folder) / name).string();
    const bool there = is_file(path);
    if (!there && !was_file(name)) continue;
    // An input that is gone counts as changed.
    ++out.compared;
    if (there && digests_of({path}).begin()->second == digest) continue;
    ++out.changed;
    out.warnings.push_back(there ? fmt::format("input '{}' has changed since", name)
                                 : fmt::format("input '{}' is gone", name));
  }
}

void compare_commits(RecordedRun& out) {
  constexpr std::size_t kCommitDigits = 10;  // Digits of a commit that are shown
  const std::string now = source_commit();
  if (out.run.commit.empty() || now.empty() || out.run.commit == now) return;
  out.warnings.push_back(fmt::format("it was written by commit {}, this program is of commit {}",
                                     out.run.commit.substr(0, kCommitDigits),
                                     now.substr(0, kCommitDigits)));
}

/// Returns true if a version such as "0.1.0" is older than another; an unreadable version is older.
bool is_before(const std::string& version, int major, int minor) {
  int its_major = 0, its_minor = 0;
  char dot = 0;
  std::istringstream numbers(version);
  if (!(numbers >> its_major >> dot >> its_minor)) return true;
  return std::make_pair(its_major, its_minor) < std::make_pair(major, minor);
}

}  // namespace

RecordedRun read_recorded_run(const std::string& path) {
  // Pages and answers keep their provenance as JSON, results as texts of HDF5.
  const FileContents file = contents_of(path);
  RecordedRun out;
  out.file = path;
  if (file.format == "HTML") add_json_record(path, page_data(path), out);
  if (file.format == "JSON") add_json_record(path, read_source(path).text, out);
  if (file.kind == "fit" || file.kind == "motion" || file.kind == "scene run")
    add_result_record(path, out);
  if (file.kind == "posterior") add_posterior_record(path, out);
  require(!out.run.arguments.empty() || !out.run.request.empty(),
          "'{}' records no command: wanted a page, a JSON file of -o, a fit, a posterior, a motion "
          "or a run of a scene that a command of thenar wrote",
          path);
  // Compare inputs and program with those of today: the rerun may give other numbers.
  compare_inputs_of(out);
  compare_commits(out);
  return out;
}

void require_repeatable(const RecordedRun& recorded, const std::vector<std::string>& commands) {
  // Only commands that answer a question and end can be run again.
  const std::string& name = recorded.run.arguments.front();
  const bool known = contains(commands, name);
  // No file of a stranger opens a server.
  const bool answers = name != "rerun" && name != "view" && name != "serve";
  require(known && answers, "'{}' records '{}', which is not a command to run again", recorded.file,
          command_line(recorded.run));
  std::error_code none;
  require(fs::is_directory(recorded.run.folder, none),
          "the folder of the run, '{}', is gone; the command was: {}", recorded.run.folder,
          command_line(recorded.run));
}

bool ran_on_straight_paths(const RecordedRun& recorded) {
  return is_before(recorded.version, 0, 2);
}

}  // namespace thenar
