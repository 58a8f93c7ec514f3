#include "server/replay.h"

#include <atomic>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"

namespace thenar {

Execution execute(const RpcRequest& request, const MethodTable& table, Session& session,
                  const Progress& progress) {
  // Several threads of one request may ask at a time.
  std::atomic<long> asked{0}, stopped_at{-1};
  Progress counting = progress;
  counting.stop_requested = [&] {
    const long number = asked++;
    if (!progress.stop()) return false;
    long none = -1;
    stopped_at.compare_exchange_strong(none, number);
    return true;
  };
  Execution execution{answer_request(request, table, session, counting), std::nullopt};
  if (stopped_at >= 0) execution.stopped_at = stopped_at;
  return execution;
}

LoggedRequest logged(int client, const RpcRequest& request, const Execution& execution) {
  const OrderedJson reply = rpc_reply(nullptr, execution.answer);
  return {client, request.method, request.params, reply_hash(reply), execution.stopped_at};
}

ReplayResult replay(const std::vector<LoggedRequest>& log, const MethodTable& table,
                    Session& session, const Progress& progress) {
  ReplayResult result;
  for (const LoggedRequest& then : log) {
    RpcRequest request;
    request.method = then.method;
    request.params = then.params;
    // It is told to stop when it was, not when somebody wants the repetition to end.
    long asked = 0;
    Progress same;
    same.stop_requested = [&] { return then.stopped_at && asked++ >= *then.stopped_at; };
    const Execution now = execute(request, table, session, same);
    session.log().add(logged(then.client, request, now));
    ++result.requests;
    if (logged(then.client, request, now).reply != then.reply)
      result.differ.push_back(result.requests);
    report_or_stop(progress, static_cast<double>(result.requests) / static_cast<double>(log.size()),
                   fmt::format("{} of {} requests", result.requests, log.size()));
  }
  return result;
}

}  // namespace thenar
