// The queue behind which a session stands, with clients that are plain objects.

#include "server/engine.h"

#include <condition_variable>
#include <cstring>
#include <fstream>
#include <functional>
#include <mutex>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "base/progress_parts.h"
#include "server/replay.h"
#include "tests/message_of.h"
#include "tests/patience.h"
#include "tests/server/small_model.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

/// Keeps what it is told.
class Listener final : public EngineClient {
 public:
  explicit Listener(bool watching) : watching_(watching) {}

  void reply(std::string text) override {
    keep([&] { replies_.push_back(text.empty() ? Json() : Json::parse(text)); });
  }
  void notify(std::shared_ptr<const std::string> text) override {
    keep([&] { told_.push_back(Json::parse(*text)); });
  }
  void send_frame(std::shared_ptr<const std::string> frame) override {
    keep([&] { frames_.push_back(*frame); });
  }
  [[nodiscard]] bool is_watching() const override { return watching_; }

  /// The reply of this number, from 0, when it has come.
  Json reply_of(std::size_t number) {
    return wait([&] { return replies_.size() > number; }, [&] { return replies_[number]; });
  }
  /// The params of the first notification of a method that `wanted` takes.
  Json notification(
      const std::string& method,
      const std::function<bool(const Json&)>& wanted = [](const Json&) { return true; }) {
    const auto found = [&]() -> const Json* {
      for (const Json& message : told_)
        if (message["method"] == method && wanted(message["params"])) return &message["params"];
      return nullptr;
    };
    return wait([&] { return found() != nullptr; }, [&] { return *found(); });
  }
  /// The state that was told last before the first scene with bodies; null: none was.
  Json state_before_bodies() {
    (void)notification("scene", [](const Json& s) { return !s["bodies"].empty(); });
    const std::lock_guard<std::mutex> lock(mutex_);
    Json state;
    for (const Json& message : told_) {
      if (message["method"] == "state") state = message["params"];
      if (message["method"] == "scene" && !message["params"]["bodies"].empty()) break;
    }
    return state;
  }
  /// The last frame, when there are this many.
  std::string frame(std::size_t count) {
    return wait([&] { return frames_.size() >= count; }, [&] { return frames_.back(); });
  }
  std::size_t frames() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return frames_.size();
  }

 private:
  template <typename Change>
  void keep(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change();
    changed_.notify_all();
  }
  template <typename Ready, typename Get>
  std::invoke_result_t<Get> wait(const Ready& ready, const Get& get) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!changed_.wait_for(lock, kHang, ready)) throw std::runtime_error("waited too long");
    return get();
  }

  bool watching_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Json> replies_, told_;
  std::vector<std::string> frames_;
};

std::string request(const std::string& method, const Json& params = Json::object(), int id = 1) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump();
}

TEST(Engine, AnswersAndShowsWhatHasChanged) {
  Engine engine(small_table(), {});
  const auto watcher = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  EXPECT_TRUE(watcher->notification("scene")["bodies"].empty());
  engine.receive(number, request("small.open"));
  EXPECT_EQ(watcher->reply_of(0)["result"], Json::object());
  const Json scene =
      watcher->notification("scene", [](const Json& s) { return !s["bodies"].empty(); });
  EXPECT_EQ(scene["mode"], "motion");
  EXPECT_NE(engine.mesh(scene["bodies"][0]["mesh"]), nullptr);
  const std::string first = watcher->frame(1);
  std::uint32_t revision = 0;
  std::memcpy(&revision, first.data() + 4, 4);
  EXPECT_EQ(revision, scene["revision"].get<std::uint32_t>());
  engine.receive(number, request("small.lift", {{"height", 0.25}}));
  float joint = 0;
  std::memcpy(&joint, watcher->frame(2).data() + 108, 4);
  EXPECT_EQ(joint, 0.25F);
}

// A page that hears of a scene asks what its motion takes: it has to know which motion it is.
TEST(Engine, TellsTheStateBeforeTheSceneThatItIsOf) {
  Engine engine(small_table(), {});
  const auto watcher = std::make_shared<Listener>(true), late = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  EXPECT_TRUE(watcher->notification("state")["motion"].is_null());
  engine.receive(number, request("small.open"));
  // Both who was there and who comes later.
  for (const auto& one : {watcher, late}) {
    if (one == late) (void)engine.add_client(late);
    const Json state = one->state_before_bodies();
    ASSERT_TRUE(state.is_object());
    EXPECT_EQ(state["mode"], "motion");
    ASSERT_TRUE(state["motion"].is_object());
    EXPECT_TRUE(state["motion"]["shown"]);
  }
}

TEST(Engine, SendsTheLatestFrameAndFewOfThem) {
  Engine engine(small_table(), {});
  const auto watcher = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  engine.receive(number, request("small.open"));
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 2000; ++i)
    engine.receive(number, request("small.lift", {{"height", 0.5 * (i + 1) / 2000}}));
  (void)watcher->reply_of(2000);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  float joint = 0;
  std::memcpy(&joint, watcher->frame(1).data() + 108, 4);
  EXPECT_EQ(joint, 0.5F);
  EXPECT_LE(static_cast<double>(watcher->frames()), 60 * seconds + 2);
}

TEST(Engine, StopsWhatRunsAndOnlyThat) {
  Engine engine(small_table(), {});
  const auto one = std::make_shared<Listener>(true), other = std::make_shared<Listener>(false);
  const int first = engine.add_client(one), second = engine.add_client(other);
  engine.receive(second, request("session.stop"));
  EXPECT_EQ(other->reply_of(0)["result"]["asked"], false);
  engine.receive(first, request("small.wait", Json::object(), 5));
  EXPECT_EQ(one->notification("progress")["id"], 5);
  EXPECT_EQ(one->notification("state", [](const Json& s) { return !s["busy"].is_null(); })["busy"],
            "waiting");
  engine.receive(first, request("small.open"));
  engine.receive(second, request("session.stop"));
  EXPECT_EQ(other->reply_of(1)["result"]["asked"], true);
  EXPECT_GT(one->reply_of(0)["result"]["asked"].get<long>(), 1);
  EXPECT_EQ(one->reply_of(1)["result"], Json::object());  // what came behind it is done
  (void)one->notification(
      "state", [](const Json& s) { return s["busy"].is_null() && s["mode"] == "motion"; });
}

/// The small table, and what a session says of itself.
MethodTable greeting_table() {
  MethodTable table = small_table();
  for (const char* name : {"session.hello", "session.status"})
    table.add({name, "Says.", object_schema({}), "something", "{}",
               [](Session& session, const Json&, const Progress&) -> OrderedJson {
                 return {{"mode", session.shown_model() == nullptr ? "" : session.mode_name()}};
               }});
  return table;
}

// Nobody has to wait for others to learn who is there and what runs.
TEST(Engine, SaysWhatRunsWhileItRuns) {
  Engine engine(greeting_table(), {});
  const auto one = std::make_shared<Listener>(true), other = std::make_shared<Listener>(false);
  const int first = engine.add_client(one), second = engine.add_client(other);
  engine.receive(first, request("small.open"));
  EXPECT_EQ(one->reply_of(0)["result"], Json::object());
  engine.receive(first, request("small.wait", Json::object(), 5));
  (void)one->notification("progress");
  engine.receive(second, request("session.hello"));
  engine.receive(second, request("session.status"));
  engine.receive(second, request("session.status", {{"more", 1}}));
  EXPECT_EQ(other->reply_of(0)["result"]["mode"], "motion");
  const Json status = other->reply_of(1)["result"];
  EXPECT_EQ(status["runs"], "small.wait");
  EXPECT_EQ(status["text"], "waiting");
  EXPECT_EQ(status["fraction"], 0.5);
  EXPECT_EQ(other->reply_of(2)["error"]["code"], -32602);
  // Replies of one client keep the order of its requests.
  engine.receive(first, request("session.hello", Json::object(), 6));
  engine.receive(second, request("session.stop"));
  EXPECT_EQ(one->reply_of(1)["id"], 5);
  EXPECT_EQ(one->reply_of(2)["id"], 6);
}

// Of a batch whose replies would take more memory than there is, the last are refused.
TEST(Engine, BoundsTheRepliesOfABatch) {
  MethodTable table;
  int done = 0;
  table.add({"small.tell", "Tells much.", object_schema({}), "text", "{}",
             [&done](Session&, const Json&, const Progress&) -> OrderedJson {
               ++done;
               return {{"text", std::string(10UL << 20U, 'a')}};
             }});
  Engine engine(std::move(table), {});
  const auto client = std::make_shared<Listener>(false);
  const int number = engine.add_client(client);
  Json batch = Json::array();
  for (int i = 0; i < 100; ++i)
    batch.push_back({{"jsonrpc", "2.0"}, {"id", i}, {"method", "small.tell"}});
  engine.receive(number, batch.dump());
  const Json replies = client->reply_of(0);
  ASSERT_EQ(replies.size(), 100U);
  EXPECT_EQ(done, 4);  // of 10 MB each, beyond 32 MB
  EXPECT_EQ(replies[3]["result"]["text"].get<std::string>().size(), 10UL << 20U);
  EXPECT_EQ(replies[4]["error"]["code"], -32002);
  EXPECT_EQ(replies[99]["id"], 99);
}

TEST(Engine, ForgetsWhoLeavesAndStopsWhatHeWaitedFor) {
  Engine engine(small_table(), {});
  const auto gone = std::make_shared<Listener>(true), other = std::make_shared<Listener>(false);
  const int first = engine.add_client(gone), second = engine.add_client(other);
  engine.receive(first, request("small.wait"));
  (void)gone->notification("progress");
  engine.receive(first, request("small.wait"));  // never begun
  engine.receive(second, request("small.open"));
  engine.remove_client(first);
  EXPECT_EQ(other->reply_of(0)["result"], Json::object());
  EXPECT_EQ(gone.use_count(), 1);
}

TEST(Engine, PlaysNoFasterThanTheClock) {
  Engine engine(small_table(), {});
  const auto watcher = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  const auto begin = std::chrono::steady_clock::now();
  engine.receive(number, request("small.open", {{"playing", true}}));
  double played = 0;
  while (played < 0.5) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::memcpy(&played, watcher->frame(1).data() + 16, 8);
  }
  // A machine that is busy with other things may lose some; none goes faster.
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(played, passed.count());
  engine.receive(number, request("motion.pause"));
  (void)watcher->reply_of(1);
}

// A step of a motion that plays may take for ever: it hears session.stop, and the motion pauses.
TEST(Engine, StopsAMotionThatPlays) {
  MethodTable table;
  const MethodTable small = small_table();
  for (RpcMethod method : small.methods()) {
    if (method.name == "motion.step")
      method.handler = [](Session&, const Json&, const Progress& progress) -> OrderedJson {
        while (!progress.stop()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return {{"stopped", progress.stop()}};
      };
    table.add(method);
  }
  Engine engine(table, {});
  const auto watcher = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  engine.receive(number, request("small.open", {{"playing", true}}));
  (void)watcher->reply_of(0);
  // The first tick comes soon; until then nothing runs that could be stopped.
  for (std::size_t asked = 1;; ++asked) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    engine.receive(number, request("session.stop"));
    if (watcher->reply_of(asked)["result"]["asked"] == true) break;
  }
  (void)watcher->notification("state", [](const Json& state) {
    return state["motion"].is_object() && state["motion"]["playing"] == false;
  });
}

TEST(Engine, LetsNoMoreClientsInThanItMay) {
  EngineOptions options;
  options.clients = 2;
  Engine engine(small_table(), {}, options);
  const int first = engine.add_client(std::make_shared<Listener>(false));
  (void)engine.add_client(std::make_shared<Listener>(false));
  EXPECT_THROW((void)engine.add_client(std::make_shared<Listener>(false)), InputError);
  engine.remove_client(first);
  EXPECT_NO_THROW((void)engine.add_client(std::make_shared<Listener>(false)));
}

TEST(Engine, AsksInItsOwnName) {
  Engine engine(small_table(), {});
  EXPECT_EQ(engine.call("small.open", Json::object()), OrderedJson::object());
  EXPECT_THROW((void)engine.call("small.lift", {{"height", 3}}), InputError);
  EXPECT_THROW((void)engine.call("small.lif", {{"height", 0.1}}), InputError);
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_EQ(engine.call("small.wait", Json::object(), progress)["asked"], 1);
  engine.shut_down("it is over");
  EXPECT_THROW((void)engine.call("small.open", Json::object()), Stopped);
}

TEST(Engine, TellsItsEndAndEndsWhatRuns) {
  Engine engine(small_table(), {});
  const auto watcher = std::make_shared<Listener>(true);
  const int number = engine.add_client(watcher);
  engine.receive(number, request("small.wait"));
  (void)watcher->notification("progress");
  engine.shut_down("it is over");
  EXPECT_EQ(watcher->notification("ended")["reason"], "it is over");
}

class Replay : public TemporaryFolder {};
class SessionLogFile : public TemporaryFolder {};

// A log repeats what happened, a stop at the same question included.
TEST_F(Replay, GivesTheSameRepliesAndFindsThoseThatDiffer) {
  const std::string file = path("log.jsonl");
  {
    EngineOptions options;
    options.log = file;
    Engine engine(small_table(), {}, options);
    const auto client = std::make_shared<Listener>(true);
    const int number = engine.add_client(client);
    engine.receive(number, request("small.open"));
    engine.receive(number, request("small.lift", {{"height", 0.125}}));
    engine.receive(number, request("small.lift", {{"height", 3}}));  // refused
    engine.receive(number, request("small.wait"));
    (void)client->notification("progress");
    engine.receive(number, request("session.stop"));
    engine.receive(number, request("motion.step", {{"steps", 7}}));
    (void)client->reply_of(5);
  }
  std::vector<LoggedRequest> log = read_log(file);
  ASSERT_EQ(log.size(), 5U);
  EXPECT_EQ(log[0].client, 1);
  EXPECT_GT(log[3].stopped_at.value(), 0);
  Session again({});
  const MethodTable table = small_table();
  const ReplayResult same = replay(log, table, again, ReplayWrites::kSkipped);
  EXPECT_EQ(same.requests, 5U);
  EXPECT_FALSE(same.first_difference);
  EXPECT_NEAR(again.model<SmallModel>(LiveMode::kMotion).live_time().t, 7e-3, 1e-15);
  EXPECT_EQ(again.log().text(), read_file(file, 1 << 20));
  log[1].params["height"] = 0.25;
  Session other({});
  const ReplayResult another = replay(log, table, other, ReplayWrites::kSkipped);
  EXPECT_EQ(another.first_difference, 2U);
  EXPECT_EQ(another.requests, 2U);  // none behind it
}

// A method that writes is left out, whatever comes of it; told to, it is done.
TEST_F(Replay, WritesNothingUnlessToldTo) {
  int written = 0;
  MethodTable table;
  const auto count = [&](Session&, const Json&, const Progress&) -> OrderedJson {
    return {{"written", ++written}};
  };
  table.add({"small.save", "Counts.", object_schema({}), "", "{}", count, MethodWrites::kFiles});
  const std::string reply = reply_hash(rpc_reply(nullptr, {{{"written", 1}}, std::nullopt}));
  const std::vector<LoggedRequest> log{{1, "small.save", Json::object(), reply, std::nullopt}};
  Session session({});
  const ReplayResult skipped = replay(log, table, session, ReplayWrites::kSkipped);
  EXPECT_EQ(skipped.skipped, 1U);
  EXPECT_EQ(skipped.requests, 0U);
  EXPECT_EQ(written, 0);
  EXPECT_FALSE(replay(log, table, session, ReplayWrites::kDone).first_difference);
  EXPECT_EQ(written, 1);
}

// Lines are the same in a temporary file, in a named one, and where it is named in between.
TEST_F(SessionLogFile, ReadsWhatWasWrittenAndGoesOn) {
  SessionLog temporary, named;
  named.open(path("named.jsonl"));
  EXPECT_EQ(temporary.text(), "");
  for (int i = 0; i < 2000; ++i) {
    LoggedRequest request{i, "motion.step", {{"steps", i}}, std::string(64, 'a'), {}};
    temporary.add(request);
    named.add(request);
    if (i == 1000) temporary.open(path("later.jsonl"));
    if (i % 500 == 0) {
      EXPECT_EQ(temporary.text(), named.text());
    }
  }
  EXPECT_EQ(temporary.text(), named.text());
  EXPECT_EQ(read_file(path("later.jsonl"), 1 << 20), named.text());
  EXPECT_EQ(read_log(path("named.jsonl")).size(), 2000U);
}

// A full log can be repeated as far as it goes, and says so once.
TEST_F(SessionLogFile, EndsWhereItIsFull) {
  SessionLog log(1000);
  log.open(path("log.jsonl"));
  const LoggedRequest request{1, "motion.step", {{"steps", 1}}, std::string(64, 'a'), {}};
  int added = 0, refused = 0;
  for (int i = 0; i < 20; ++i) {
    try {
      log.add(request);
      ++added;
    } catch (const InputError&) {
      refused += 1;
    }
  }
  EXPECT_EQ(refused, 1);
  EXPECT_EQ(added, 19);  // without a word after the first
  const std::string text = read_file(path("log.jsonl"), 2000);
  EXPECT_LE(text.size(), 1000U);
  EXPECT_GT(text.size(), 800U);
  EXPECT_EQ(log.text(), text);
  EXPECT_GT(read_log(path("log.jsonl")).size(), 3U);
}

// One without a name holds no more than a reply does; the disk that it lies on may be memory.
TEST_F(SessionLogFile, WithoutANameIsLetGoWhereItGrowsTooLong) {
  SessionLog log;
  const LoggedRequest request{
      1, "world.import", {{"bytes", std::string(1UL << 20U, 'a')}}, std::string(64, 'a'), {}};
  for (int i = 0; i < 31; ++i) log.add(request);
  EXPECT_GT(log.text().size(), 31UL << 20U);
  for (int i = 0; i < 5; ++i) log.add(request);
  EXPECT_NE(message_of([&] { (void)log.text(); }).find("start with --log FILE"), std::string::npos);
}

TEST_F(SessionLogFile, RefusesLinesThatAreNone) {
  const std::string file = path("log.jsonl");
  for (const char* line : {"nonsense", "{}", "[]", R"({"client": "x"})", "\xff",
                           R"({"client": 1, "request": {}, "reply": ""})"}) {
    std::ofstream(file) << R"({"client":1,"request":{"method":"a","params":{}},"reply":""})"
                        << "\n"
                        << line << "\n";
    try {
      (void)read_log(file);
      FAIL() << line;
    } catch (const DataError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("log.jsonl:2: ")) << line;
    }
  }
}

}  // namespace
}  // namespace thenar
