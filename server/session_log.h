#pragma once

/// Log of the requests of a session, in order of execution, one line of JSON each. A replay repeats
/// them and compares the replies.
///
/// A line is {"client": 2, "request": {..}, "reply": SHA-256 of the result or the error}. Client 0
/// is the program itself, which plays motions. "stopped_at" of a stopped request is the number of
/// stop checks before the one that stopped it. A job has two lines: its start, and "job.end" of
/// client 0 with its id and the hash of its result. Not logged are session.hello, session.stop,
/// session.status, session.log, job.state, job.list, job.stop and job.result, which change nothing
/// or depend on time.

#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "report/json.h"

namespace thenar {

/// Largest log that is written or read [bytes].
inline constexpr std::size_t kMaxLogBytes = 1UL << 30U;

/// Line of a log.
struct LoggedRequest {
  int client = 0;
  std::string method;
  Json params;                     // parameters as the client sent them
  std::string reply;               // SHA-256 of the result or the error, hexadecimal
  std::optional<long> stopped_at;  // number of the stop check that requested the stop, from 0
};

/// Method name in the line of a job that has ended.
inline constexpr const char* kJobEnd = "job.end";

/// Computes the hash of a reply for the log, from its result or its error.
[[nodiscard]] std::string reply_hash(const OrderedJson& result_or_error);

/// Returns true if requests of a method are logged.
[[nodiscard]] bool is_logged(const std::string& method);

/// Reads a log. @throws DataError `path:line: ..` for an invalid line
[[nodiscard]] std::vector<LoggedRequest> read_log(const std::string& path);

/// Log of a session in a file. The default size holds about a day of playback. Without open() the
/// log is an unnamed temporary file of at most 32 MB, the limit of a reply.
class SessionLog {
 public:
  /// @param max_bytes  largest size of a named file [bytes]
  explicit SessionLog(std::size_t max_bytes = kMaxLogBytes) : max_bytes_(max_bytes) {}

  /// Writes all previous and future lines to a file; each line is flushed.
  /// @throws InputError if the file cannot be written
  void open(const std::string& path);
  /// Adds a line. @throws InputError once, when a named file or its disk becomes full; the log then
  /// ends with the previous request
  void add(const LoggedRequest& request);
  /// Returns all lines. @throws InputError if the log exceeds or exceeded 32 MB, or could not be
  /// stored
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::string read_all() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  static bool write(std::FILE& file, const std::string& lines);

  std::size_t max_bytes_;                   // largest size of a named file [bytes]
  std::string path_;                        // path of a named file; "": temporary file
  std::size_t bytes_ = 0;                   // size of the log [bytes]
  bool is_incomplete_ = false;              // true: lines were lost, nothing more is logged
  std::unique_ptr<std::FILE, Close> file_;  // null: nothing was added
};

}  // namespace thenar
