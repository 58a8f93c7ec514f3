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

constexpr double kTick = 1.0 / 60;    // period of playback [s]
constexpr double kMaxLag = 0.1;       // largest lag that playback makes up [s]
constexpr double kMinStep = 1e-6;     // smallest step size of a motion [s]
constexpr double kMaxTickUse = 0.75;  // part of a tick that steps may take [1]
constexpr std::chrono::milliseconds kProgressInterval{50};  // time between progress notifications
constexpr std::chrono::milliseconds kBusyAfter{250};        // time after which all clients see it
constexpr std::chrono::hours kMaxSleep{1};                  // longest sleep of the worker thread
constexpr std::size_t kMaxBatchReply = 32UL << 20U;         // largest reply to a batch [bytes]

constexpr const char* kHello = "session.hello";
constexpr const char* kStatus = "session.status";

double seconds_between(EngineClock::time_point from, EngineClock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// Returns the time that is some seconds after another.
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
  // Queue the update for the program (0), so that the client does not count as waiting.
  jobs_.push_back({0, [this] { publisher_.request_full_update(); }});
  wake_worker_.notify_one();
  return last_client_;
}

void Engine::remove_client(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  clients_.erase(client);
  erase_where(jobs_, [&](const Job& job) { return job.client == client; });
  if (running_client_ == client) stop_ = true;
  // Wake the worker, which publishes the new number of clients.
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
  // Execute session.stop at once.
  if (const auto request = short_request(message, "session.stop"))
    return stop_running(client, *request);
  // Execute session.hello and session.status at once if the client has no other request.
  for (const char* method : {kHello, kStatus}) {
    const auto request = short_request(message, method);
    if (!request || has_waiting_requests(client)) continue;
    return send_reply(client, *request, answer_at_once(*request));
  }
  // Queue all other messages.
  enqueue(client, [this, client, message = std::move(message)] { answer(client, message); });
}

void Engine::send_reply(int client, const RpcRequest& request, const RpcAnswer& answer) {
  if (const auto to = client_of(client))
    to->reply(request.notification ? "" : json_text(rpc_reply(request.id, answer), -1));
}

void Engine::stop_running(int client, const RpcRequest& request) {
  // Ask the running request to stop, and reply whether there was one.
  bool asked = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked = running_client_ >= 0;
    if (asked) stop_ = true;
  }
  send_reply(client, request, {{{"asked", asked}}, request.failure});
}

bool Engine::has_waiting_requests(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return hello_.is_null() || running_client_ == client ||
         any_of(jobs_, [&](const Job& job) { return job.client == client; });
}

RpcAnswer Engine::answer_at_once(const RpcRequest& request) {
  // Check the parameters.
  if (request.failure) return {{}, request.failure};
  try {
    (void)validated(table_.method_named(request.method).params, request.params, "params");
  } catch (const Error& error) {
    return {{}, RpcFailure{RpcCode::kInvalidParams, error.what()}};
  }
  // Return the stored result of session.hello, or the status of the running request.
  const std::lock_guard<std::mutex> lock(mutex_);
  if (request.method == kHello) return {hello_, std::nullopt};
  const bool busy = !running_request_.method.empty();
  const double seconds = busy ? seconds_between(running_request_.since, EngineClock::now()) : 0;
  return {status_json(running_request_.method, seconds, running_request_.fraction,
                      running_request_.activity, jobs_.size()),
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
  // Make a request that stops with the engine or with the caller.
  RpcRequest request;
  request.method = method;
  request.params = params;
  auto promise = std::make_shared<std::promise<RpcAnswer>>();
  std::future<RpcAnswer> answered = promise->get_future();
  Progress stoppable = progress;
  stoppable.stop_requested = [this, progress] { return stop_ || progress.stop(); };
  // Queue it. Only the job holds the promise: it is broken if the engine ends before the job runs.
  enqueue(0, [this, request, stoppable, promise = std::move(promise)] {
    promise->set_value(execute_and_log(0, request, stoppable));
  });
  // Wait for the result.
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
  // Notify watching clients once, and clear the queue.
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
  // Wait for the worker thread and the background jobs.
  if (thread_.joinable()) thread_.join();
  session_.jobs().stop_all();
}

void Engine::work() {
  auto wake = EngineClock::now();
  update_hello();
  while (true) {
    // Wait for the next request or the next frame.
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
    // Execute it without the lock, so that other threads can request a stop.
    if (job.work) job.work();
    job = {};
    update_hello();
    // Advance playback, and publish changes.
    const auto tick = play();
    wake = std::min({tick, publish(), EngineClock::now() + kMaxSleep});
  }
}

void Engine::answer(int client, const std::string& message) {
  const RpcMessage read = read_rpc(message, options_.limits);
  std::string replies;
  for (const RpcRequest& request : read.requests) {
    // Execute the request, unless the replies of the batch have become too large.
    const RpcAnswer answer = replies.size() <= kMaxBatchReply
                                 ? execute_and_log(client, request, progress_of(client, request.id))
                                 : RpcAnswer{{},
                                             RpcFailure{RpcCode::kTooLarge,
                                                        "the replies before it in its batch "
                                                        "hold too much: send it by itself"}};
    if (request.notification) continue;
    if (!replies.empty()) replies += ",";
    replies += json_text(rpc_reply(request.id, answer), -1);
  }
  // Send the reply, or the list of replies to a batch.
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
  // All copies of the callback share the times of the start and of the last notification.
  struct Times {
    EngineClock::time_point begin = EngineClock::now(), last = begin;
    std::mutex mutex;
  };
  const auto times = std::make_shared<Times>();
  Progress progress;
  progress.stop_requested = [this] { return stop_.load(); };
  progress.report = [this, client, id, times](double fraction, const std::string& what) {
    // Limit the rate of notifications.
    const std::lock_guard<std::mutex> lock(times->mutex);
    const auto now = EngineClock::now();
    if (now - times->last < kProgressInterval) return;
    times->last = now;
    // Store the progress for session.status.
    {
      const std::lock_guard<std::mutex> running(mutex_);
      running_request_.fraction = fraction;
      running_request_.activity = what;
    }
    // Notify the client, and after a while all clients.
    const auto to = client_of(client);
    if (to != nullptr && to->is_watching())
      to->notify(std::make_shared<const std::string>(rpc_notification(
          "progress", {{"id", id}, {"fraction", number_or_null(fraction)}, {"text", what}})));
    if (now - times->begin > kBusyAfter) publisher_.publish_busy(clients(), what);
  };
  return progress;
}

/// Advances a motion that plays. @return time of the next call
Publisher::Clock::time_point Engine::play() {
  // Without playback, or at its start, set the clock.
  const auto* clock = dynamic_cast<const LiveClock*>(session_.shown_model());
  const LiveTime time = clock == nullptr ? LiveTime() : clock->live_time();
  const auto now = EngineClock::now();
  if (!std::exchange(plays_, time.playing) || !time.playing) {
    played_until_ = now;
    next_tick_ = later(now, kTick);
    return time.playing ? next_tick_ : EngineClock::time_point::max();
  }
  if (now < next_tick_) return next_tick_;
  // Compute the number of steps for the elapsed time, limited to what fits into a tick.
  steps_due_ += std::min(seconds_between(played_until_, now), kMaxLag) * time.speed /
                std::max(time.step, kMinStep);
  double steps = std::floor(steps_due_);
  if (seconds_of_step_ > 0)
    steps = std::min(steps, std::max(1.0, std::floor(kMaxTickUse * kTick / seconds_of_step_)));
  steps_due_ = std::min(steps_due_ - std::min(steps, steps_due_), 1.0);
  played_until_ = now;
  next_tick_ = later(now, kTick);
  if (steps < 1) return next_tick_;
  // Execute them as a request, which session.stop and shut_down() can stop.
  RpcRequest request;
  request.method = "motion.step";
  request.params = {{"steps", static_cast<long>(steps)}, {"want", Json::array()}};
  Progress progress;
  progress.stop_requested = [this] { return stop_.load(); };
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_client_ = 0;
    stop_ = ending_;
  }
  const RpcAnswer answer = execute_and_log(0, request, progress);
  const bool stopped = stop_;
  update_hello();
  // Measure the time of a step; pause the motion if it failed or was stopped.
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
  return transformed(clients_, [](const auto& each) { return each.second; });
}

std::shared_ptr<EngineClient> Engine::client_of(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = clients_.find(client);
  return found == clients_.end() ? nullptr : found->second;
}

}  // namespace thenar
