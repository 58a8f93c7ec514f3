// Tests for server/replay.cpp: logs of a small model, repeated.

#include "server/replay.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/progress_parts.h"
#include "tests/server/small_model.h"

namespace thenar {
namespace {

RpcRequest request_of(const std::string& method, const Json& params) {
  RpcRequest request;
  request.method = method;
  request.params = params;
  return request;
}

/// The log of a session that opens a model and lifts it to some heights.
std::vector<LoggedRequest> lifts(const std::vector<double>& heights) {
  Session session({});
  const MethodTable table = small_table();
  std::vector<LoggedRequest> log;
  const auto add = [&](const RpcRequest& request) {
    log.push_back(log_entry(1, request, execute(request, table, session, {})));
  };
  add(request_of("small.open", Json::object()));
  for (const double height : heights) add(request_of("small.lift", {{"height", height}}));
  return log;
}

TEST(ReplayedLog, RepeatsALogToTheSameState) {
  Session session({});
  const ReplayResult result =
      replay(lifts({0.1, 0.4, 0.3}), small_table(), session, ReplayWrites::kSkipped);
  EXPECT_EQ(result.requests, 4U);
  EXPECT_EQ(result.skipped, 0U);
  EXPECT_FALSE(result.first_difference.has_value());
  EXPECT_EQ(session.shown_model()->instant().joints.at(0), 0.3);
}

// Refusals are replies as well: the same request is refused again.
TEST(ReplayedLog, RepeatsRefusals) {
  Session session({});
  const std::vector<LoggedRequest> log = lifts({0.1, 9});  // beyond its range
  EXPECT_FALSE(
      replay(log, small_table(), session, ReplayWrites::kSkipped).first_difference.has_value());
  EXPECT_EQ(session.shown_model()->instant().joints.at(0), 0.1);
}

// It ends at the first reply that is another one, and does nothing after.
TEST(ReplayedLog, EndsAtTheFirstReplyThatDiffers) {
  std::vector<LoggedRequest> log = lifts({0.1, 0.2, 0.3});
  log[2].params["height"] = 0.25;  // the reply is that of 0.2
  Session session({});
  const ReplayResult result = replay(log, small_table(), session, ReplayWrites::kSkipped);
  EXPECT_EQ(result.first_difference, 3U);
  EXPECT_EQ(result.requests, 3U);
  EXPECT_EQ(session.shown_model()->instant().joints.at(0), 0.25);
}

// A request that was stopped at its n-th question is stopped there again.
TEST(ReplayedLog, StopsWhereItWasStopped) {
  Session session({});
  const MethodTable table = small_table();
  const RpcRequest wait = request_of("small.wait", Json::object());
  long left = 5;
  Progress progress;
  progress.stop_requested = [&] { return left-- == 0; };
  const Execution then = execute(wait, table, session, progress);
  EXPECT_EQ(then.stopped_at, 5);
  EXPECT_EQ(then.answer.result["asked"], 6);
  Session again({});
  const ReplayResult result =
      replay({log_entry(1, wait, then)}, table, again, ReplayWrites::kSkipped);
  EXPECT_FALSE(result.first_difference.has_value());
}

// Methods that write files are passed over, unless somebody asks for them.
TEST(ReplayedLog, WritesFilesOnlyWhereItIsAskedTo) {
  MethodTable table = small_table();
  int written = 0;
  RpcMethod save{"small.save",
                 "Saves.",
                 object_schema({}),
                 "nothing",
                 "{}",
                 [&](Session&, const Json&, const Progress&) -> OrderedJson {
                   ++written;
                   return OrderedJson::object();
                 }};
  save.writes = MethodWrites::kFiles;
  table.add(save);
  std::vector<LoggedRequest> log = lifts({0.1});
  Session first({});
  const RpcRequest request = request_of("small.save", Json::object());
  log.push_back(log_entry(1, request, execute(request, table, first, {})));
  ASSERT_EQ(written, 1);
  Session session({});
  const ReplayResult skipped = replay(log, table, session, ReplayWrites::kSkipped);
  EXPECT_EQ(skipped.skipped, 1U);
  EXPECT_EQ(skipped.requests, 2U);
  EXPECT_EQ(written, 1);
  Session other({});
  EXPECT_EQ(replay(log, table, other, ReplayWrites::kDone).requests, 3U);
  EXPECT_EQ(written, 2);
}

// Somebody who wants it to end ends it between two requests.
TEST(ReplayedLog, EndsWhenItIsAskedTo) {
  Session session({});
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_THROW((void)replay(lifts({0.1}), small_table(), session, ReplayWrites::kSkipped, progress),
               Stopped);
}

}  // namespace
}  // namespace thenar
