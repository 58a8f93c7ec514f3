// thenar validate FILE... [--json]
//
// What every file is and holds, or what is wrong with it and where.

#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/commands.h"
#include "apps/file_summary.h"
#include "base/error.h"
#include "base/file_io.h"
#include "report/json.h"

namespace thenar {
namespace {

struct ValidateArguments {
  std::vector<std::string> files;
  bool json = false;
};

/// A file's line: its summary, or its error, which starts with the path.
struct Line {
  std::string path;
  bool valid;
  std::string text;
};

constexpr const char* kOtherKinds =
    ":1: wanted TOML or HDF5; robots, objects, worlds and meshes of other formats are told by "
    "`thenar import`, lists of contacts (JSON) by `thenar quality`";

bool is_own_kind(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  return !is_file(path) || ending == ".toml" || ending == ".h5" || ending == ".hdf5";
}

Line check(const std::string& path) {
  try {
    return {path, true, summarise_file(path)};
  } catch (const Error& e) {
    if (!is_own_kind(path)) return {path, false, path + kOtherKinds};
    const std::string what = e.what();
    const bool placed = what.compare(0, path.size() + 1, path + ":") == 0;
    return {path, false, placed ? what : path + ": " + what};
  }
}

void run_validate(const ValidateArguments& options) {
  bool all_valid = true;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const std::string& path : options.files) {
    const Line line = check(path);
    all_valid = all_valid && line.valid;
    if (options.json)
      json.push_back(
          {{"file", path}, {"valid", line.valid}, {line.valid ? "holds" : "error", line.text}});
    else if (line.valid)
      fmt::print("{}: {}\n", path, line.text);
    else
      fmt::print("{}\n", line.text);
  }
  if (options.json) fmt::print("{}\n", json_text(json));
  if (!all_valid) throw CLI::RuntimeError(1);  // exits silently: all has been said
}

}  // namespace

void add_validate(CLI::App& app) {
  auto options = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand("validate", "Say what files are, or what is wrong");
  command->add_option("files", options->files, "Files to check (TOML, HDF5)")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_validate(*options); });
}

}  // namespace thenar
