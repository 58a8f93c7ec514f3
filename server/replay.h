#pragma once

/// Requests executed so that they can be repeated, and the repetition of a log.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "server/method.h"
#include "server/rpc.h"
#include "server/session.h"
#include "server/session_log.h"

namespace thenar {

/// A request that was executed.
struct Execution {
  RpcAnswer answer;
  std::optional<long> stopped_at;  // which question "am I to stop?" was the first to be told yes
};

/// Executes a request, and counts how often it asks whether it is to stop.
[[nodiscard]] Execution execute(const RpcRequest& request, const MethodTable& table,
                                Session& session, const Progress& progress);

/// Returns the log entry of an executed request. @param client  number of the client that asked
[[nodiscard]] LoggedRequest logged(int client, const RpcRequest& request,
                                   const Execution& execution);

/// Returns the log entry of a job that has ended.
[[nodiscard]] LoggedRequest logged(const EndedJob& job);

/// Handling of requests that write files in a replay: a log may be a stranger's.
enum class ReplayWrites { kSkipped, kDone };

/// Result of a replay.
struct ReplayResult {
  std::size_t requests = 0;            // repeated
  std::size_t skipped = 0;             // that write files
  std::optional<std::size_t> differs;  // line of the log, from 1, whose reply is another one now
};

/// Executes the requests of a log in order, up to the first whose reply is another one now; one
/// that was stopped is stopped at the same question. Jobs run where they ended.
/// @throws Stopped if progress says so
[[nodiscard]] ReplayResult replay(const std::vector<LoggedRequest>& log, const MethodTable& table,
                                  Session& session, ReplayWrites writes,
                                  const Progress& progress = {});

}  // namespace thenar
