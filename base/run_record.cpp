#include "base/run_record.h"

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/source_commit.h"  // written by the build

namespace thenar {
namespace {

/// Returns the seconds since 1970 that the environment states, else those of the clock.
std::time_t time_of_run() {
  const char* asked = std::getenv("SOURCE_DATE_EPOCH");
  if (asked == nullptr || *asked == '\0') return std::time(nullptr);
  constexpr std::size_t kMaxEpochDigits = 11;  // Most digits: some three thousand years
  const std::string text = asked;
  require(
      text.size() <= kMaxEpochDigits && text.find_first_not_of("0123456789") == std::string::npos,
      "SOURCE_DATE_EPOCH: wanted whole seconds since 1970, got '{}'", text);
  return static_cast<std::time_t>(std::stoll(text));
}

std::string utc(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  return fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}Z", parts.tm_year + 1900,
                     parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

}  // namespace

RunRecord record_of_run(const std::vector<std::string>& arguments) {
  std::error_code gone;  // set for a removed working directory, whose path stays empty
  const std::filesystem::path folder = std::filesystem::current_path(gone);
  return {arguments, folder.string(), source_commit(), utc(time_of_run())};
}

std::map<std::string, std::string> texts_of(const RunRecord& record) {
  if (record.arguments.empty() && record.request.empty()) return {};
  std::map<std::string, std::string> texts{
      {"folder", record.folder}, {"date", record.date}, {"commit", record.commit}};
  if (!record.arguments.empty()) texts["command"] = command_line(record);
  if (!record.request.empty()) texts["request"] = record.request;
  return texts;
}

RunRecord record_of_texts(const std::map<std::string, std::string>& texts) {
  const auto text = [&](const std::string& name) {
    const auto found = texts.find(name);
    return found == texts.end() ? "" : found->second;
  };
  return {arguments_of(text("command")), text("folder"), text("commit"), text("date"),
          text("request")};
}

std::string command_line(const RunRecord& record) {
  std::string line = "thenar";
  for (const std::string& argument : record.arguments) line += " " + shell_word(argument);
  return line;
}

std::string shell_word(const std::string& text) {
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> arguments_of(const std::string& command_line) {
  if (command_line.empty()) return {};
  // Words as a shell splits them: blanks part words but within single quotes, \' is a quote.
  std::vector<std::string> words;
  bool quoted = false, within = false;
  for (std::size_t i = 0; i < command_line.size(); ++i) {
    const char c = command_line[i];
    if (c == ' ' && !quoted) {
      within = false;
      continue;
    }
    if (!within) words.emplace_back();
    within = true;
    if (c == '\'')
      quoted = !quoted;
    else if (c == '\\' && !quoted && i + 1 < command_line.size())
      words.back() += command_line[++i];
    else
      words.back() += c;
  }
  require(!quoted && !words.empty() && words.front() == "thenar",
          "wanted a command line of thenar, got '{}'", command_line);
  words.erase(words.begin());
  return words;
}

std::string source_commit() { return kSourceCommit; }

}  // namespace thenar
