#pragma once

/// Record of the run of the command that wrote a file: its arguments, folder, sources and time.

#include <map>
#include <string>
#include <vector>

namespace thenar {

/// One run of the command; a library that no command called leaves `arguments` empty.
struct RunRecord {
  std::vector<std::string>
      arguments;             // arguments as typed, without the program: "fit", "H01.toml", ..
  std::string folder;        // working directory, absolute
  std::string commit;        // commit of the sources, 40 hexadecimal digits; "": not known
  std::string date;          // start of the run, UTC: "2026-01-31T12:00:00Z"
  std::string request = {};  // answered request as JSON: {"question": "tip_force", ..}
};

/// Returns the record of a run that begins now. The environment's SOURCE_DATE_EPOCH, whole seconds
/// since 1970, stands in for the clock, so that two builds of one document are the same to the
/// byte.
/// @param arguments  of the command, without the program's name
/// @throws InputError if SOURCE_DATE_EPOCH is no whole number of seconds.
/// Source: reproducible-builds.org/specs/source-date-epoch.
[[nodiscard]] RunRecord record_of_run(const std::vector<std::string>& arguments);

/// Returns the record as files hold it, texts by name: command, folder, date, commit, request. A
/// record of nothing has none.
[[nodiscard]] std::map<std::string, std::string> texts_of(const RunRecord& record);
/// Returns the record of such texts; those that are not there are empty.
/// @throws InputError as arguments_of()
[[nodiscard]] RunRecord record_of_texts(const std::map<std::string, std::string>& texts);

/// Returns the arguments as a line for a shell: "thenar fit 'my hand.toml'".
[[nodiscard]] std::string command_line(const RunRecord& record);

/// Returns a word as a POSIX shell reads it back: plain, or between single quotes.
[[nodiscard]] std::string shell_word(const std::string& text);

/// Returns the arguments of such a line; "" gives none. The inverse of command_line().
/// @throws InputError if the line does not begin with "thenar", or a quote is left open.
[[nodiscard]] std::vector<std::string> arguments_of(const std::string& command_line);

/// Returns the commit of the sources that this was built from; "" outside of a repository.
[[nodiscard]] std::string source_commit();

}  // namespace thenar
