#pragma once

/// The requests of a session in the order in which they were executed, one JSON line each, from
/// which it can be repeated and held against what it was.
///
/// A line is {"client": 2, "request": {..}, "reply": SHA-256 of the result or the error}. Client 0
/// is the program itself, as it plays a motion. Of a request that was asked to stop, "stopped_at"
/// counts how often it had asked before. A job stands in it twice: where it was started, and as
/// "job.end" of client 0, with its id and the hash of its result, where it ended. Not in a log:
/// session.hello, session.stop, session.status, session.log, job.state, job.list, job.stop and
/// job.result, which change nothing or depend on time.

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/json.h"

namespace thenar {

/// Longest log that is written or read [bytes].
inline constexpr std::size_t kLongestLog = 1UL << 30U;

/// A line of a log.
struct LoggedRequest {
  int client = 0;
  std::string method;
  Json params;                     // as the client sent them
  std::string reply;               // SHA-256, hexadecimal
  std::optional<long> stopped_at;  // which question "am I to stop?" was the first to be told yes
};

/// Method of the line of a job that has ended.
inline constexpr const char* kJobEnd = "job.end";

/// Computes the hash of a reply for the log, from its result or its error.
[[nodiscard]] std::string reply_hash(const OrderedJson& result_or_error);

/// Returns true if logs hold requests of this method.
[[nodiscard]] bool is_logged(const std::string& method);

/// A log as text. @throws DataError `path:line: ..` if a line is none of a log.
[[nodiscard]] std::vector<LoggedRequest> read_log(const std::string& path);

/// The requests so far, in a file: a session that plays for a day writes a gigabyte, which is the
/// most that is kept. Where none was named it is a temporary one without a name, which goes with
/// the program, and holds no more than a reply does.
class SessionLog {
 public:
  /// @param most  that a named file holds [bytes]
  explicit SessionLog(std::size_t most = kLongestLog) : most_(most) {}

  /// Writes what was added so far and all that follows to a file, each line at once.
  /// @throws InputError if it cannot be written.
  void open(const std::string& path);
  /// @throws InputError once, where a named file has become full, or its disk has: it then ends
  /// with the request before this one.
  void add(const LoggedRequest& request);
  /// All lines. @throws InputError if there are or were more than 32 MB, which no reply holds, or
  /// there was no room for them.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::string all() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  static bool write(std::FILE& file, const std::string& lines);

  std::size_t most_;  // [bytes]
  std::string path_;  // "" of a temporary file
  std::size_t bytes_ = 0;
  bool lost_ = false;                       // it had become too long, or there was no room
  std::unique_ptr<std::FILE, Close> file_;  // null: nothing was added
};

}  // namespace thenar
