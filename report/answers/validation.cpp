#include "report/answers/validation.h"

#include <fmt/format.h>

#include "report/summary.h"

namespace thenar {
namespace {

/// The error with the path before it, unless it names the path itself.
std::string placed_error(const FileVerdict& file) {
  const bool placed = file.error.find(file.path) != std::string::npos;
  return placed ? file.error : file.path + ": " + file.error;
}

std::string verdict_words(const FileVerdict& file) {
  return file.thing ? summary_of(*file.thing) : placed_error(file);
}

/// Returns whether an experiment suits the subject, in sentences.
std::string check_text(const FileVerdict& file, const std::string& subject) {
  std::string text;
  for (const std::string& misfit : file.check.misfits) text += misfit + "\n";
  for (const std::string& doubt : file.check.doubts) text += "warning: " + doubt + "\n";
  if (subject.empty() || !file.thing || !std::holds_alternative<Experiment>(*file.thing))
    return text;
  return text + fmt::format("{}: {} the subject of {}\n", file.path,
                            file.check.misfits.empty() ? "suits" : "does not suit", subject);
}

}  // namespace

std::string text_of(const Validation& validation) {
  std::string text;
  for (const FileVerdict& file : validation.files) {
    text += file.thing ? file.path + ": " + verdict_words(file) : verdict_words(file);
    for (const std::string& warning : file.warnings) text += "\n  warning: " + warning;
    text += "\n" + check_text(file, validation.subject);
  }
  return text;
}

OrderedJson json_of(const Validation& validation) {
  OrderedJson list = OrderedJson::array();
  for (const FileVerdict& file : validation.files) {
    OrderedJson entry{{"file", file.path},
                      {"valid", file.valid()},
                      {file.thing ? "holds" : "error", verdict_words(file)}};
    if (!file.warnings.empty()) entry["warnings"] = file.warnings;
    if (!validation.subject.empty() && file.thing &&
        std::holds_alternative<Experiment>(*file.thing))
      entry.update({{"subject", validation.subject},
                    {"misfits", file.check.misfits},
                    {"doubts", file.check.doubts}});
    list.push_back(std::move(entry));
  }
  return list;
}

Table table_of(const Validation& validation) {
  Table table{{"file", "valid", "holds_or_error"}};
  for (const FileVerdict& file : validation.files)
    table.add({file.path, file.valid() ? "1" : "0", verdict_words(file)});
  return table;
}

}  // namespace thenar
