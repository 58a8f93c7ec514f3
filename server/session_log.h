#pragma once

/// The requests of a session in the order in which they were executed, one JSON line each, from
/// which it can be repeated and held against what it was.
///
/// A line is {"client": 2, "request": {..}, "reply": SHA-256 of the result or the error}. Client 0
/// is the program itself, as it plays a motion. Of a request that was asked to stop, "stopped_at"
/// counts how often it had asked before. Not in a log: session.hello, session.stop and session.log,
/// which change nothing.

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/json.h"

namespace thenar {

/// A line of a log.
struct LoggedRequest {
  int client = 0;
  std::string method;
  Json params;                     // as the client sent them
  std::string reply;               // SHA-256, hexadecimal
  std::optional<long> stopped_at;  // which question "am I to stop?" was the first to be told yes
};

/// What the log holds of a reply: the hash of its result, or of its error.
[[nodiscard]] std::string reply_hash(const OrderedJson& result_or_error);

/// Whether requests of this method stand in logs.
[[nodiscard]] bool is_logged(const std::string& method);

/// A log as text. @throws DataError `path:line: ..` if a line is none of a log.
[[nodiscard]] std::vector<LoggedRequest> read_log(const std::string& path);

/// The requests so far, in memory and, where a file was named, on the disk.
class SessionLog {
 public:
  /// Writes what was added so far and all that follows to a file, each line at once.
  /// @throws InputError if it cannot be written.
  void open(const std::string& path);
  /// @throws InputError if the disk is full.
  void add(const LoggedRequest& request);
  /// All lines. @throws InputError if there were more than 32 MB, which are not kept.
  [[nodiscard]] const std::string& text() const;

 private:
  void write(const std::string& lines);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::string text_;
  bool too_long_ = false;
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace thenar
