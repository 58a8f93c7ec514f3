#pragma once

/// Executes the requests of all clients on one thread, in order of arrival, and publishes changes
/// to watching clients. While a motion plays, the engine requests the steps itself. Requests that
/// need nothing of the session are answered at once, however long the request before them takes.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "base/progress.h"
#include "server/method.h"
#include "server/publisher.h"
#include "server/rpc.h"
#include "server/session.h"

namespace thenar {

struct EngineOptions {
  std::size_t clients = 64;  // at once
  RpcLimits limits;
  std::string log;  // file that requests are written to as they are executed; empty: none
  std::function<void(const std::string& text)> on_trouble;  // what no client is told of
};

/// Request that an engine is executing, for session.status.
struct RunningRequest {
  std::string method;  // "": nothing runs
  Publisher::Clock::time_point since;
  double fraction = 0;  // as it told last
  std::string text;
};

/// A session behind a queue. All functions may be called from any thread.
class Engine {
 public:
  /// @throws InputError if the log cannot be written.
  Engine(MethodTable table, SessionPlaces places, EngineOptions options = {});
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Lets a client in. @returns its number, from 1
  /// @throws InputError if there are as many as may be.
  int join(std::shared_ptr<EngineClient> client);
  /// Forgets a client and what it has asked for, and asks what it waits for to stop.
  void leave(int client);
  /// Puts a message of a client into the queue. session.stop does not wait there; nor do
  /// session.hello and session.status of a client that waits for nothing else.
  void receive(int client, std::string message);
  /// Asks in the name of the program, and waits.
  /// @returns the result  @throws InputError with what was refused, Stopped
  OrderedJson ask(const std::string& method, const Json& params, const Progress& progress = {});
  /// A mesh of a scene, as mesh_bytes(); null if there is none of that id.
  [[nodiscard]] std::shared_ptr<const std::string> mesh(const std::string& id);
  /// Tells all that watch why it ends, asks the running request to stop, and ends the thread.
  void end(const std::string& reason);

 private:
  struct Job {
    int client = 0;
    std::function<void()> work;
  };

  void put(int client, std::function<void()> work);
  void work();
  void answer(int client, const std::string& message);
  RpcAnswer run(int client, const RpcRequest& request, const Progress& progress);
  [[nodiscard]] Progress progress_of(int client, const Json& id);
  void stop_running(int client, const RpcRequest& request);
  [[nodiscard]] bool waits(int client);
  [[nodiscard]] RpcAnswer answer_at_once(const RpcRequest& request);
  void note_running(const std::string& method);
  void note_ended_jobs();
  void add_to_log(const LoggedRequest& request);
  void note_session();
  Publisher::Clock::time_point play();
  Publisher::Clock::time_point publish();
  void tell_trouble(const std::string& text);
  [[nodiscard]] EngineClients clients();
  [[nodiscard]] std::shared_ptr<EngineClient> client_of(int client);

  // Of the worker's thread.
  const MethodTable table_;
  const EngineOptions options_;
  Session session_;
  Publisher publisher_;
  Publisher::Clock::time_point played_at_, tick_at_;
  double steps_due_ = 0;        // of a motion that plays; the part of a step that is left over
  double seconds_of_step_ = 0;  // that one took when it was measured last [s]
  bool plays_ = false;

  // Of all threads.
  std::mutex mutex_;
  std::condition_variable called_;
  std::deque<Job> jobs_;
  std::map<int, std::shared_ptr<EngineClient>> clients_;
  int last_client_ = 0;
  int running_ = -1;  // client whose request runs; -1: none
  RunningRequest runs_;
  OrderedJson hello_;  // what session.hello said when the last request had ended
  bool ending_ = false;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace thenar
