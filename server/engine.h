#pragma once

/// Executes the requests of all clients on one thread, in order of arrival, and publishes changes
/// to watching clients. While a motion plays, the engine itself requests the steps. A few requests
/// that do not need the session are answered at once.

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

/// Options of an Engine.
struct EngineOptions {
  std::size_t clients = 64;  // largest number of clients
  RpcLimits limits;
  std::string log;  // file for the log of executed requests; empty: none
  std::function<void(const std::string& text)> on_error;  // called for errors outside of a request
};

/// Request that an engine is executing, for session.status.
struct RunningRequest {
  std::string method;  // "": none
  Publisher::Clock::time_point since;
  double fraction = 0;   // last reported progress [1]
  std::string activity;  // last reported
};

/// Session with a queue of requests. All functions are thread-safe.
class Engine {
 public:
  /// @throws InputError if the log cannot be written.
  Engine(MethodTable table, SessionFolders places, EngineOptions options = {});
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Adds a client. @return its number, from 1
  /// @throws InputError if there are already EngineOptions::clients
  int add_client(std::shared_ptr<EngineClient> client);
  /// Removes a client and its queued requests, and asks its running request to stop.
  void remove_client(int client);
  /// Queues a message of a client. Executes session.stop at once, as well as session.hello and
  /// session.status of a client without other requests in the queue.
  void receive(int client, std::string message);
  /// Calls a method on behalf of the program, and waits for the result.
  /// @throws InputError with the reason of a refusal, Stopped
  OrderedJson call(const std::string& method, const Json& params, const Progress& progress = {});
  /// Returns a mesh of a scene, encoded by mesh_bytes(); null if the id is unknown.
  [[nodiscard]] std::shared_ptr<const std::string> mesh(const std::string& id);
  /// Notifies watching clients of the reason, asks the running request to stop, and ends the
  /// thread.
  void shut_down(const std::string& reason);

 private:
  /// Entry of the queue.
  struct Job {
    int client = 0;
    std::function<void()> work;
  };

  void enqueue(int client, std::function<void()> work);
  void work();
  void answer(int client, const std::string& message);
  RpcAnswer execute_and_log(int client, const RpcRequest& request, const Progress& progress);
  [[nodiscard]] Progress progress_of(int client, const Json& id);
  void send_reply(int client, const RpcRequest& request, const RpcAnswer& answer);
  void stop_running(int client, const RpcRequest& request);
  [[nodiscard]] bool has_waiting_requests(int client);
  [[nodiscard]] RpcAnswer answer_at_once(const RpcRequest& request);
  void set_running_request(const std::string& method);
  void log_ended_jobs();
  void add_to_log(const LoggedRequest& request);
  void update_hello();
  Publisher::Clock::time_point play();
  Publisher::Clock::time_point publish();
  void report_error(const std::string& text);
  [[nodiscard]] EngineClients clients();
  [[nodiscard]] std::shared_ptr<EngineClient> client_of(int client);

  // Used by the worker thread only.
  const MethodTable table_;
  const EngineOptions options_;
  Session session_;
  Publisher publisher_;
  Publisher::Clock::time_point played_until_, next_tick_;
  double steps_due_ = 0;        // steps that playback still has to take, with a fraction [1]
  double seconds_of_step_ = 0;  // last measured computing time of one step [s]
  bool plays_ = false;

  // Protected by mutex_.
  std::mutex mutex_;
  std::condition_variable wake_worker_;
  std::deque<Job> jobs_;
  std::map<int, std::shared_ptr<EngineClient>> clients_;
  int last_client_ = 0;
  int running_client_ = -1;  // client whose request is running; 0: the program, -1: none
  RunningRequest running_request_;
  OrderedJson hello_;  // result of session.hello after the last request
  bool ending_ = false;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace thenar
