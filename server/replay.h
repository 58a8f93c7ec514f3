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

/// Does what a request asks for, and counts how often it asks whether it is to stop.
[[nodiscard]] Execution execute(const RpcRequest& request, const MethodTable& table,
                                Session& session, const Progress& progress);

/// What a log holds of it. @param client  number of who asked
[[nodiscard]] LoggedRequest logged(int client, const RpcRequest& request,
                                   const Execution& execution);

/// How a repetition went.
struct ReplayResult {
  std::size_t requests = 0;         // repeated
  std::vector<std::size_t> differ;  // lines of the log, from 1, whose replies are others now
};

/// Executes the requests of a log in order; one that was stopped is stopped at the same question.
/// @throws Stopped if progress says so
[[nodiscard]] ReplayResult replay(const std::vector<LoggedRequest>& log, const MethodTable& table,
                                  Session& session, const Progress& progress = {});

}  // namespace thenar
