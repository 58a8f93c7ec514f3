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

/// Returns the record of a run that starts now. If the environment has SOURCE_DATE_EPOCH, in whole
/// seconds since 1970, it replaces the clock, so that two builds of a document are identical.
/// @param arguments  arguments of the command, without the program's name
/// @throws InputError if SOURCE_DATE_EPOCH is no whole number of seconds.
/// Source: reproducible-builds.org/specs/source-date-epoch.
[[nodiscard]] RunRecord record_of_run(const std::vector<std::string>& arguments);

/// Returns the record as texts by name, for files: command, folder, date, commit, request. An empty
/// record gives none.
[[nodiscard]] std::map<std::string, std::string> texts_of(const RunRecord& record);
/// Returns the record of such texts; missing ones are empty.
/// @throws InputError as arguments_of()
[[nodiscard]] RunRecord record_of_texts(const std::map<std::string, std::string>& texts);

/// Returns the run as a command line for a shell: "thenar fit 'my hand.toml'".
[[nodiscard]] std::string command_line(const RunRecord& record);

/// Returns a word quoted for a POSIX shell: plain if possible, else between single quotes.
[[nodiscard]] std::string shell_word(const std::string& text);

/// Returns the arguments of a command line, the inverse of command_line(); none for "".
/// @throws InputError if the line does not begin with "thenar", or a quote is left open.
[[nodiscard]] std::vector<std::string> arguments_of(const std::string& command_line);

/// Returns the commit of the sources that this was built from; "" outside of a repository.
[[nodiscard]] std::string source_commit();

}  // namespace thenar
