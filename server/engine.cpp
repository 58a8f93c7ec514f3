#include "server/engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <future>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/lists.h"
#include "base/progress_parts.h"
#include "live/live_abilities.h"
#include "server/replay.h"

namespace thenar {
namespace {

using EngineClock = Publisher::Clock;

constexpr double kTick = 1.0 / 60;                       // of a motion that plays [s]
constexpr double kMostBehind = 0.1;                      // of wall-clock time, made up for [s]
constexpr double kLeastStep = 1e-6;                      // of a motion [s]
constexpr std::chrono::milliseconds kProgressEvery{50};  // a client is told of progress
constexpr std::chrono::milliseconds kBusyAfter{250};     // others are told that it takes long
constexpr std::chrono::hours kLongest{1};                // that the thread sleeps
constexpr std::size_t kMostReplies = 32UL << 20U;        // of a batch; then no more is done [bytes]

constexpr const char* kHello = "session.hello";
constexpr const char* kStatus = "session.status";

double seconds_between(EngineClock::time_point from, EngineClock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

EngineClock::time_point later(EngineClock::time_point from, double seconds) {
  return from +
         std::chrono::duration_cast<EngineClock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Engine::Engine(MethodTable table, SessionFolders places, EngineOptions options)
    : table_(std::move(table)), options_(std::move(options)), session_(std::move(places)) {
  if (!options_.log.empty()) session_.log().open(options_.log);
  session_.jobs().set_end_callback([this](int) { enqueue(0, [this] { log_ended_jobs(); }); });
  thread_ = std::thread([this] { work(); });
}

Engine::~Engine() { shut_down("the server ends"); }

int Engine::add_client(std::shared_ptr<EngineClient> client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  require(clients_.size() < options_.clients, "there are {} clients already, the most there may be",
          options_.clients);
  clients_[++last_client_] = std::move(client);
  jobs_.push_back(
      {0, [this] { publisher_.request_full_update(); }});  // of nobody: it keeps none waiting
  wake_worker_.notify_one();
  return last_client_;
}

void Engine::remove_client(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  clients_.erase(client);
  erase_where(jobs_, [&](const Job& job) { return job.client == client; });
  if (running_client_ == client) stop_ = true;
  // The others are told that one is gone.
  jobs_.push_back({0, [] {}});
  wake_worker_.notify_one();
}

void Engine::enqueue(int client, std::function<void()> work) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (ending_) return;
  jobs_.push_back({client, std::move(work)});
  wake_worker_.notify_one();
}

void Engine::receive(int client, std::string message) {
  if (const auto request = short_request(message, "session.stop"))
    return stop_running(client, *request);
  for (const char* method : {kHello, kStatus}) {
    const auto request = short_request(message, method);
    if (!request || has_waiting_requests(client)) continue;
    const auto to = client_of(client);
    if (to == nullptr) return;
    return to->reply(request->notification
                         ? ""
                         : json_text(rpc_reply(request->id, answer_at_once(*request)), -1));
  }
  enqueue(client, [this, client, message = std::move(message)] { answer(client, message); });
}

void Engine::stop_running(int client, const RpcRequest& request) {
  bool asked = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked = running_client_ >= 0;
    if (asked) stop_ = true;
  }
  const auto to = client_of(client);
  if (to == nullptr) return;
  RpcAnswer answer{{{"asked", asked}}, request.failure};
  to->reply(request.notification ? "" : json_text(rpc_reply(request.id, answer), -1));
}

bool Engine::has_waiting_requests(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return hello_.is_null() || running_client_ == client ||
         any_of(jobs_, [&](const Job& job) { return job.client == client; });
}

RpcAnswer Engine::answer_at_once(const RpcRequest& request) {
  if (request.failure) return {{}, request.failure};
  try {
    (void)validated(table_.method_named(request.method).params, request.params, "params");
  } catch (const Error& error) {
    return {{}, RpcFailure{RpcCode::kInvalidParams, error.what()}};
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (request.method == kHello) return {hello_, std::nullopt};
  const bool busy = !running_request_.method.empty();
  const double seconds = busy ? seconds_between(running_request_.since, EngineClock::now()) : 0;
  return {status_json(running_request_.method, seconds, running_request_.fraction,
                      running_request_.text, jobs_.size()),
          std::nullopt};
}

void Engine::log_ended_jobs() {
  for (const EndedJob& job : session_.jobs().take_ended_jobs()) {
    add_to_log(log_entry(job));
    notify_watchers(clients(), rpc_notification("job", {{"job", job.id}}));
  }
}

void Engine::add_to_log(const LoggedRequest& request) {
  try {
    session_.log().add(request);
  } catch (const Error& error) {
    report_error(error.what());
  }
}

void Engine::set_running_request(const std::string& method) {
  const std::lock_guard<std::mutex> lock(mutex_);
  running_request_ = {method, EngineClock::now(), 0, ""};
}

void Engine::update_hello() {
  OrderedJson hello = table_.has_method(kHello)
                          ? table_.method_named(kHello).handler(session_, Json::object(), {})
                          : OrderedJson::object();
  const std::lock_guard<std::mutex> lock(mutex_);
  hello_ = std::move(hello);
  running_client_ = -1;
}

OrderedJson Engine::call(const std::string& method, const Json& params, const Progress& progress) {
  RpcRequest request;
  request.method = method;
  request.params = params;
  auto promise = std::make_shared<std::promise<RpcAnswer>>();
  std::future<RpcAnswer> answered = promise->get_future();
  Progress told = progress;
  told.stop_requested = [this, progress] { return stop_ || progress.stop(); };
  // The job alone holds the promise, so that an engine that ends without it breaks it.
  enqueue(0, [this, request, told, promise = std::move(promise)] {
    promise->set_value(execute_and_log(0, request, told));
  });
  try {
    const RpcAnswer answer = answered.get();
    if (!answer.failure) return answer.result;
    if (answer.failure->code == RpcCode::kStopped) throw Stopped(answer.failure->text);
    throw InputError(answer.failure->text);
  } catch (const std::future_error&) {
    throw Stopped("the server has ended");
  }
}

std::shared_ptr<const std::string> Engine::mesh(const std::string& id) {
  return session_.meshes().bytes(id);
}

void Engine::shut_down(const std::string& reason) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ending_)
      for (const auto& [number, client] : clients_)
        if (client->is_watching())
          client->notify(
              std::make_shared<const std::string>(rpc_notification("ended", {{"reason", reason}})));
    ending_ = true;
    stop_ = true;
    jobs_.clear();
    wake_worker_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  session_.jobs().stop_all();
}

void Engine::work() {
  auto wake = EngineClock::now();
  update_hello();
  while (true) {
    // Take the next request, or wake up for the next frame.
    Job job;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_worker_.wait_until(lock, wake, [this] { return ending_ || !jobs_.empty(); });
      if (ending_) return;
      if (!jobs_.empty()) {
        job = std::move(jobs_.front());
        jobs_.pop_front();
        running_client_ = job.client;
        stop_ = false;
      }
    }
    // Work without the lock, so that others can ask to stop.
    if (job.work) job.work();
    job = {};
    update_hello();
    const auto tick = play();
    wake = std::min({tick, publish(), EngineClock::now() + kLongest});
  }
}

void Engine::answer(int client, const std::string& message) {
  const RpcMessage read = read_rpc(message, options_.limits);
  std::string replies;
  for (const RpcRequest& request : read.requests) {
    // Replies of a batch travel together: their memory is bounded.
    const RpcAnswer answer = replies.size() <= kMostReplies
                                 ? execute_and_log(client, request, progress_of(client, request.id))
                                 : RpcAnswer{{},
                                             RpcFailure{RpcCode::kTooLarge,
                                                        "the replies before it in its batch "
                                                        "hold too much: send it by itself"}};
    if (request.notification) continue;
    if (!replies.empty()) replies += ",";
    replies += json_text(rpc_reply(request.id, answer), -1);
  }
  const auto to = client_of(client);
  if (to == nullptr) return;
  to->reply(read.batch && !replies.empty() ? "[" + replies + "]" : replies);
}

RpcAnswer Engine::execute_and_log(int client, const RpcRequest& request, const Progress& progress) {
  set_running_request(request.method);
  const Execution execution = execute(request, table_, session_, progress);
  set_running_request("");
  if (request.failure || !is_logged(request.method)) return execution.answer;
  add_to_log(log_entry(client, request, execution));
  return execution.answer;
}

Progress Engine::progress_of(int client, const Json& id) {
  // Shared by the copies of the callback: when the request began, and when it was told of last.
  struct Told {
    EngineClock::time_point begin = EngineClock::now(), last = begin;
    std::mutex mutex;
  };
  const auto told = std::make_shared<Told>();
  Progress progress;
  progress.stop_requested = [this] { return stop_.load(); };
  progress.report = [this, client, id, told](double fraction, const std::string& what) {
    const std::lock_guard<std::mutex> lock(told->mutex);
    const auto now = EngineClock::now();
    if (now - told->last < kProgressEvery) return;
    told->last = now;
    {
      const std::lock_guard<std::mutex> running(mutex_);
      running_request_.fraction = fraction;
      running_request_.text = what;
    }
    const auto to = client_of(client);
    if (to != nullptr && to->is_watching())
      to->notify(std::make_shared<const std::string>(rpc_notification(
          "progress", {{"id", id}, {"fraction", number_or_null(fraction)}, {"text", what}})));
    if (now - told->begin > kBusyAfter) publisher_.publish_busy(clients(), what);
  };
  return progress;
}

Publisher::Clock::time_point Engine::play() {
  const auto* clock = dynamic_cast<const LiveClock*>(session_.shown_model());
  const LiveTime time = clock == nullptr ? LiveTime() : clock->live_time();
  const auto now = EngineClock::now();
  if (!std::exchange(plays_, time.playing) || !time.playing) {
    played_until_ = now;
    next_tick_ = later(now, kTick);
    return time.playing ? next_tick_ : EngineClock::time_point::max();
  }
  if (now < next_tick_) return next_tick_;
  // As many steps as wall-clock time wants, but no more than can be done in most of a tick.
  steps_due_ += std::min(seconds_between(played_until_, now), kMostBehind) * time.speed /
                std::max(time.step, kLeastStep);
  double steps = std::floor(steps_due_);
  if (seconds_of_step_ > 0)
    steps = std::min(steps, std::max(1.0, std::floor(0.75 * kTick / seconds_of_step_)));
  steps_due_ = std::min(steps_due_ - std::min(steps, steps_due_), 1.0);
  played_until_ = now;
  next_tick_ = later(now, kTick);
  if (steps < 1) return next_tick_;
  RpcRequest request;
  request.method = "motion.step";
  request.params = {{"steps", static_cast<long>(steps)}, {"want", Json::array()}};
  Progress progress;
  progress.stop_requested = [this] { return stop_.load(); };
  {
    // session.stop and the end reach it as they reach a request.
    const std::lock_guard<std::mutex> lock(mutex_);
    running_client_ = 0;
    stop_ = ending_;
  }
  const RpcAnswer answer = execute_and_log(0, request, progress);
  const bool stopped = stop_;
  update_hello();
  seconds_of_step_ = seconds_between(now, EngineClock::now()) / steps;
  if (answer.failure || stopped) {
    if (answer.failure)
      report_error(fmt::format("the motion was paused: {}", answer.failure->text));
    request.method = "motion.pause";
    request.params = Json::object();
    (void)execute_and_log(0, request, {});
  }
  return next_tick_;
}

Publisher::Clock::time_point Engine::publish() {
  try {
    return publisher_.publish(session_, clients());
  } catch (const std::exception& error) {
    report_error(fmt::format("cannot be shown: {}", error.what()));
    return EngineClock::time_point::max();
  }
}

void Engine::report_error(const std::string& text) {
  notify_watchers(clients(), rpc_notification("failed", {{"text", text}}));
  if (options_.on_error) options_.on_error(text);
}

EngineClients Engine::clients() {
  const std::lock_guard<std::mutex> lock(mutex_);
  EngineClients all;
  for (const auto& [number, client] : clients_) all.push_back(client);
  return all;
}

std::shared_ptr<EngineClient> Engine::client_of(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = clients_.find(client);
  return found == clients_.end() ? nullptr : found->second;
}

}  // namespace thenar
