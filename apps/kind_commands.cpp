#include "apps/kind_commands.h"

#include <map>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "api/named/data_folders.h"
#include "base/file_io.h"
#include "base/run_record.h"

namespace thenar {
namespace {

/// Commands that accept what is of a kind, by that kind; @ is replaced by the file or the name.
using CommandsByKind = std::map<std::string, std::vector<std::string>>;

const CommandsByKind& commands_of_files() {
  static const CommandsByKind table{
      {"subject", {"thenar explain @", "thenar pose @", "thenar fit EXPERIMENT (subject: @)"}},
      {"experiment", {"thenar explain @", "thenar fit @"}},
      {"fit settings", {"thenar explain SUBJECT (settings: @)"}},
      {"proportions", {"thenar validate @"}},
      {"net", {"thenar explain @", "thenar tendon solve SUBJECT (net: @)"}},
      {"materials", {"thenar explain @"}},
      {"robot", {"thenar pose @", "thenar explain @", "thenar import @"}},
      {"object", {"thenar explain @", "thenar import @"}},
      {"world", {"thenar grasp @", "thenar close @", "thenar explain @"}},
      {"scene", {"thenar simulate @", "thenar validate @"}},
      {"pad", {"thenar pad press (pad: @)", "thenar pad laws (pad: @)", "thenar validate @"}},
      {"presses of a pad", {"thenar pad fit @", "thenar validate @"}},
      {"mesh", {"thenar import @"}},
      {"fit", {"thenar predict @ EXPERIMENT", "thenar explain @"}},
      {"posterior",
       {"thenar posterior summary @", "thenar posterior predict @ EXPERIMENT",
        "thenar posterior plot @"}},
      {"motion", {"thenar validate @", "thenar rerun @"}},
      {"scene run", {"thenar validate @", "thenar rerun @"}},
      {"page", {"thenar rerun @"}},
      {"answer", {"thenar rerun @"}},
      {"contacts", {"thenar quality @"}},
      {"comparison", {"thenar compare (output: @)"}},
  };
  return table;
}

const CommandsByKind& commands_of_names() {
  static const CommandsByKind table{{"subject", {"thenar pose @"}},
                                    {"hand", {"thenar pose @"}},
                                    {"world", {"thenar grasp @"}},
                                    {"scene", {"thenar simulate @"}},
                                    {"pad", {"thenar pad press (pad: @)"}},
                                    {"file of measured presses", {"thenar pad fit @"}},
                                    {"object", {"thenar explain @"}},
                                    {"experiment", {"thenar fit @"}},
                                    {"file of contacts", {"thenar quality @"}}};
  return table;
}

}  // namespace

std::string text_with_commands(const Error& error) {
  std::string text = error.what();
  const auto* wrong = dynamic_cast<const WrongKindError*>(&error);
  if (wrong == nullptr) return text;
  const bool file = is_file(wrong->name);
  const CommandsByKind& table = file ? commands_of_files() : commands_of_names();
  const auto known = table.find(wrong->kind);
  if (known == table.end()) return text;
  // Put the commands before the advice at the end of the message.
  std::vector<std::string> lines = known->second;
  for (std::string& line : lines)
    line.replace(line.find('@'), 1, file ? shell_word(wrong->name) : wrong->name);
  const char* const before = !file               ? ": "
                             : lines.size() == 1 ? "; try: "
                                                 : "; commands that take it: ";
  text.insert(text.size() - wrong->advice.size(),
              fmt::format("{}{}", before, fmt::join(lines, ", ")));
  return text;
}

}  // namespace thenar
