#pragma once

/// Reproducible execution of requests, and replay of a log.

#include <optional>
#include <vector>

#include "base/progress.h"
#include "server/method.h"
#include "server/rpc.h"
#include "server/session.h"
#include "server/session_log.h"

namespace thenar {

/// Result of an executed request.
struct Execution {
  RpcAnswer answer;
  std::optional<long> stopped_at;  // number of the stop check that requested the stop, from 0
};

/// Executes a request, and counts its stop checks.
[[nodiscard]] Execution execute(const RpcRequest& request, const MethodTable& table,
                                Session& session, const Progress& progress);

/// Returns the log entry of an executed request. @param client  number of the client
[[nodiscard]] LoggedRequest log_entry(int client, const RpcRequest& request,
                                      const Execution& execution);

/// Returns the log entry of a job that has ended.
[[nodiscard]] LoggedRequest log_entry(const EndedJob& job);

/// Treatment of requests that write files in a replay; a log may come from an untrusted source.
enum class ReplayWrites { kSkipped, kDone };

/// Result of a replay.
struct ReplayResult {
  std::size_t requests = 0;                     // number of repeated requests
  std::size_t skipped = 0;                      // number of skipped requests, which write files
  std::optional<std::size_t> first_difference;  // line of the log, from 1, with another reply
};

/// Executes the requests of a log in order, up to the first with another reply. A request that was
/// stopped is stopped at the same stop check. Jobs run at the line where they ended.
/// @throws Stopped
[[nodiscard]] ReplayResult replay(const std::vector<LoggedRequest>& log, const MethodTable& table,
                                  Session& session, ReplayWrites writes,
                                  const Progress& progress = {});

}  // namespace thenar
