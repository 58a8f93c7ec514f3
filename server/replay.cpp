#include "server/replay.h"

#include <atomic>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"

namespace thenar {

Execution execute(const RpcRequest& request, const MethodTable& table, Session& session,
                  const Progress& progress) {
  // Count the stop checks; several threads of one request may check at a time.
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

LoggedRequest log_entry(int client, const RpcRequest& request, const Execution& execution) {
  const OrderedJson reply = rpc_reply(nullptr, execution.answer);
  return {client, request.method, request.params, reply_hash(reply), execution.stopped_at};
}

LoggedRequest log_entry(const EndedJob& job) {
  return {0, kJobEnd, {{"job", job.id}}, job.reply, job.stopped_at};
}

namespace {

/// Returns the job of a "job.end" line. @throws InputError if the line has no job
int ended_job(const LoggedRequest& line) {
  const bool has_id = line.params.is_object() && line.params.contains("job") &&
                      line.params["job"].is_number_integer();
  require(has_id, "wanted the id of a job that ended, got none");
  return line.params["job"].get<int>();
}

/// Returns true if executing a line would write a file.
bool would_write(const LoggedRequest& line, const MethodTable& table, Session& session) {
  if (line.method == kJobEnd) return session.jobs().writes_file(ended_job(line));
  return table.has_method(line.method) &&
         table.method_named(line.method).writes == MethodWrites::kFiles;
}

/// Executes a line of a log again. @throws InputError for a job that was not started
LoggedRequest execute_again(const LoggedRequest& then, const MethodTable& table, Session& session) {
  if (then.method == kJobEnd)
    return log_entry(session.jobs().run_deferred(ended_job(then), then.stopped_at));
  RpcRequest request;
  request.method = then.method;
  request.params = then.params;
  // Stop at the same stop check, and not when the replay is stopped.
  long asked = 0;
  Progress same;
  same.stop_requested = [&] { return then.stopped_at && asked++ >= *then.stopped_at; };
  return log_entry(then.client, request, execute(request, table, session, same));
}

}  // namespace

ReplayResult replay(const std::vector<LoggedRequest>& log, const MethodTable& table,
                    Session& session, ReplayWrites writes, const Progress& progress) {
  ReplayResult result;
  session.jobs().defer();
  for (std::size_t line = 1; line <= log.size() && !result.first_difference; ++line) {
    const LoggedRequest& then = log[line - 1];
    // Skip lines that write files, unless that is allowed.
    if (writes == ReplayWrites::kSkipped && would_write(then, table, session)) {
      ++result.skipped;
      continue;
    }
    // Execute the line, and compare the replies.
    const LoggedRequest now = execute_again(then, table, session);
    session.log().add(now);
    ++result.requests;
    if (now.reply != then.reply) result.first_difference = line;
    report_or_stop(progress, static_cast<double>(line) / static_cast<double>(log.size()),
                   fmt::format("{} of {} requests", line, log.size()));
  }
  return result;
}

}  // namespace thenar
