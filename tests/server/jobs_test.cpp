// Questions beside the session: stages, stops, results, and their lines in a log.

#include "server/jobs.h"

#include <chrono>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "questions/question.h"
#include "server/methods/method_table.h"
#include "server/replay.h"
#include "tests/message_of.h"
#include "tests/patience.h"

namespace thenar {
namespace {

/// Waits until something holds. @return whether it does
bool wait_until(const std::function<bool()>& holds) {
  constexpr std::chrono::milliseconds kPause{10};
  for (std::chrono::milliseconds waited{0}; waited < kHang && !holds(); waited += kPause)
    std::this_thread::sleep_for(kPause);
  return holds();
}

bool has_ended(Jobs& jobs, int id) {
  const JobStage stage = jobs.state(id).stage;
  return stage != JobStage::kWaiting && stage != JobStage::kRunning;
}

/// A question that reports, and goes on until it is told to stop.
Question endless() {
  Question question;
  question.name = "endless";
  question.ask = [](const Json& request, const std::string&, const Progress& progress) {
    int turns = 0;
    while (!progress.stop()) {
      progress(0.25, "turning");
      ++turns;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    Answer answer;
    answer.request = request;
    answer.outcome.status = Status::kStopped;
    answer.json = [](UnitSystem) { return OrderedJson{{"kept", true}}; };
    return answer;
  };
  return question;
}

Question failing() {
  Question question;
  question.name = "failing";
  question.ask = [](const Json&, const std::string&, const Progress&) -> Answer {
    throw InputError("wanted more");
  };
  return question;
}

const char* const kTipForce =
    R"({"subject": "synek2019_middle", "posture_deg": {"MCP3_FE": 40}, "tension_N": {"FDP": 10}})";

TEST(Jobs, GiveTheAnswerThatTheQuestionHas) {
  Jobs jobs;
  const Question& question = question_named("tip_force");
  const int id = jobs.start(question, Json::parse(kTipForce), THENAR_DATA_DIR);
  ASSERT_TRUE(wait_until([&] { return has_ended(jobs, id); }));
  EXPECT_EQ(jobs.state(id).stage, JobStage::kDone);
  const Answer answer = question.ask(Json::parse(kTipForce), THENAR_DATA_DIR, {});
  EXPECT_EQ(jobs.result(id)["answer"], answer.json(UnitSystem::kSi));
  EXPECT_EQ(jobs.result(id)["request"], answer.request);
}

TEST(Jobs, KeepTheirBestWhenTheyAreStopped) {
  const Question question = endless();
  Jobs jobs;
  const int id = jobs.start(question, Json::object(), "");
  ASSERT_TRUE(wait_until([&] { return jobs.state(id).fraction == 0.25; }));
  EXPECT_EQ(jobs.state(id).stage, JobStage::kRunning);
  EXPECT_EQ(message_of([&] { (void)jobs.result(id); }), "job 1 has not ended: it is running");
  EXPECT_TRUE(jobs.stop(id));
  ASSERT_TRUE(wait_until([&] { return has_ended(jobs, id); }));
  EXPECT_EQ(jobs.state(id).stage, JobStage::kStopped);
  EXPECT_EQ(jobs.result(id)["answer"]["kept"], true);
  EXPECT_FALSE(jobs.stop(id));
}

TEST(Jobs, ThatAreStoppedBeforeAnythingWasDoneHaveNoResult) {
  Jobs jobs;
  jobs.defer();
  const int id = jobs.start(question_named("tip_force"), Json::parse(kTipForce), THENAR_DATA_DIR);
  EXPECT_EQ(jobs.run_deferred(id, 0).stopped_at, 0);
  EXPECT_EQ(jobs.state(id).stage, JobStage::kStopped);
  EXPECT_EQ(message_of([&] { (void)jobs.result(id); }),
            "job 1 has no result: stopped before the first posture was done");
}

TEST(Jobs, WaitForThoseBeforeThem) {
  const Question question = endless();
  Jobs jobs;
  const int first = jobs.start(question, Json::object(), "");
  const int second = jobs.start(question, Json::object(), "");
  const int third = jobs.start(question, Json::object(), "");
  EXPECT_EQ(jobs.state(third).stage, JobStage::kWaiting);
  jobs.stop(first);
  ASSERT_TRUE(wait_until([&] { return jobs.state(third).stage == JobStage::kRunning; }));
  EXPECT_EQ(jobs.state(second).stage, JobStage::kRunning);
}  // the others are stopped with the jobs

TEST(Jobs, SayWhyTheyFailed) {
  const Question question = failing();
  Jobs jobs;
  const int id = jobs.start(question, Json::object(), "");
  ASSERT_TRUE(wait_until([&] { return has_ended(jobs, id); }));
  EXPECT_EQ(jobs.state(id).stage, JobStage::kFailed);
  EXPECT_EQ(jobs.state(id).text, "wanted more");
  EXPECT_EQ(message_of([&] { (void)jobs.result(id); }), "job 1 has no result: wanted more");
  EXPECT_EQ(message_of([&] { (void)jobs.state(7); }), "there is no job 7");
}

TEST(Jobs, MakeRoomOfTheOldestThatHaveEnded) {
  const Question question = failing();
  Jobs jobs;
  for (std::size_t i = 0; i < kMaxJobs; ++i) {
    const int id = jobs.start(question, Json::object(), "");
    ASSERT_TRUE(wait_until([&] { return has_ended(jobs, id); }));
  }
  (void)jobs.start(question, Json::object(), "");
  EXPECT_EQ(message_of([&] { (void)jobs.state(1); }), "there is no job 1");
  EXPECT_EQ(jobs.states().size(), kMaxJobs);
}

TEST(Jobs, AreRepeatedWhereTheyEnded) {
  const MethodTable table = method_table();
  const SessionFolders places{THENAR_DATA_DIR, "."};
  const Json params{{"question", "tip_force"}, {"request", Json::parse(kTipForce)}};
  // A session in which a job is started, and ends.
  Session session(places);
  RpcRequest start;
  start.method = "job.start";
  start.params = params;
  std::vector<LoggedRequest> log{log_entry(1, start, execute(start, table, session, {}))};
  ASSERT_TRUE(wait_until([&] { return has_ended(session.jobs(), 1); }));
  const std::vector<EndedJob> ended = session.jobs().take_ended_jobs();
  ASSERT_EQ(ended.size(), 1U);
  log.push_back(log_entry(ended.front()));
  // The same again; then with another result.
  Session again(places);
  const ReplayResult same = replay(log, table, again, ReplayWrites::kSkipped);
  EXPECT_EQ(same.requests, 2U);
  EXPECT_FALSE(same.first_difference);
  log.back().reply[0] = log.back().reply[0] == 'a' ? 'b' : 'a';
  Session other(places);
  EXPECT_EQ(replay(log, table, other, ReplayWrites::kSkipped).first_difference, 2U);
}

TEST(Jobs, OfUnknownParametersAreRefusedBeforeTheyWait) {
  const MethodTable table = method_table();
  Session session({THENAR_DATA_DIR, "."});
  RpcRequest start;
  start.method = "job.start";
  const auto refusal = [&](const Json& request) {
    start.params = {{"question", "tip_force"}, {"request", request}};
    return execute(start, table, session, {}).answer.failure.value_or(RpcFailure{}).text;
  };
  EXPECT_EQ(refusal({{"subjekt", "x"}}).substr(0, 23), "no parameter 'subjekt',");
  EXPECT_EQ(refusal({{"data", "/etc"}}), "'data' is for programs of the server's own machine");
  EXPECT_TRUE(session.jobs().states().empty());
}

}  // namespace
}  // namespace thenar
