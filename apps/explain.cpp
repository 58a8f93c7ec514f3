// thenar explain FILE [--digit D] [--settings FITS.toml] [--json]
//
// What a file makes thenar do: what is built and dropped, assumed and spent, fitted and found.

#include <memory>

#include <fmt/format.h>

#include "api/digits.h"
#include "api/files.h"
#include "apps/commands.h"
#include "apps/explanation.h"
#include "apps/file_summary.h"
#include "apps/options.h"
#include "apps/terminal.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "data/io/file_kind.h"
#include "data/io/result_file.h"
#include "data/io/toml_node.h"
#include "report/json.h"

namespace thenar {
namespace {

struct ExplainArguments {
  std::string file, digit, settings;
  std::optional<Path> path;
  bool json = false;
};

Explanation explain_subject_file(const ExplainArguments& options) {
  const Subject subject = read_subject(options.file);
  const std::string digit = choose_digit(subject, options.digit);
  const SourceText settings = options.settings.empty()
                                  ? built_in_settings(digit)
                                  : SourceText{options.settings, read_text_file(options.settings)};
  return explain(subject, digit, settings, options.path.value_or(Path::kViaPoint));
}

Explanation explain_fit_file(const std::string& path) {
  Explanation explanation = explain(read_fit(path));
  print_warnings(checksum_warnings(path));
  Section section{"versions", "Written by", {}, {{"program", "version"}, {}}};
  const std::string prefix = "provenance/versions/";
  for (const auto& [key, texts] : read_result(path).texts)
    if (key.compare(0, prefix.size(), prefix) == 0)
      section.table.rows.push_back({key.substr(prefix.size()), listed(texts)});
  explanation.push_back(section);
  return explanation;
}

Explanation explain_file(const ExplainArguments& options) {
  (void)contents_of(options.file);  // says what is not there
  const FileKind kind = find_file_kind(options.file);
  if (kind == FileKind::kSubject) return explain_subject_file(options);
  require(options.digit.empty() && options.settings.empty() && !options.path,
          "--digit, --settings and --path explain subjects; '{}' is of kind: {}", options.file,
          name_of(kind));
  if (kind == FileKind::kExperiment) return explain(read_experiment(options.file));
  if (kind == FileKind::kResult) return explain_fit_file(options.file);
  if (kind == FileKind::kNet) return explain(read_net(options.file));
  if (kind == FileKind::kObject) return explain(read_object(options.file));
  if (kind == FileKind::kWorld) return explain(read_world(options.file));
  if (kind == FileKind::kRobot) return explain(read_robot(options.file));
  if (kind == FileKind::kMaterials)
    return explain(read_materials(options.file, built_in_materials()));
  // Settings and proportions do nothing by themselves.
  Section section{"file", summarise_file(options.file), {}, {}};
  if (kind == FileKind::kFitSettings)
    section.lines.push_back("see what they do: thenar explain SUBJECT --settings " + options.file);
  return {section};
}

void run_explain(const ExplainArguments& options) {
  const Explanation explanation = explain_file(options);
  if (options.json)
    fmt::print("{}\n", json_text(json_of(explanation)));
  else
    fmt::print("{}", text_of(explanation));
}

}  // namespace

void add_explain(CLI::App& app) {
  auto options = std::make_shared<ExplainArguments>();
  CLI::App* command =
      app.add_subcommand("explain", "What a file makes thenar build, assume, spend and fit");
  command
      ->add_option("file", options->file,
                   "Subject, experiment, net, fit, robot, object, world or materials")
      ->required();
  command->add_option("--digit", options->digit, "Digit of a subject to explain");
  add_path_option(*command, options->path);
  command->add_option("--settings", options->settings, "Fit settings instead of the built-in ones");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run_explain(*options); });
}

}  // namespace thenar
