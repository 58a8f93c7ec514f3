#pragma once

/// Background jobs of a session: questions that run on their own threads, in order, while the
/// session serves its clients.

#include <array>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.h"
#include "report/json.h"

namespace thenar {

struct Question;

/// Stages of a job.
enum class JobStage { kWaiting, kRunning, kDone, kStopped, kFailed };
inline constexpr std::array kJobStageNames{
    EnumName{JobStage::kWaiting, "waiting"}, EnumName{JobStage::kRunning, "running"},
    EnumName{JobStage::kDone, "done"}, EnumName{JobStage::kStopped, "stopped"},
    EnumName{JobStage::kFailed, "failed"}};
[[nodiscard]] inline std::string name_of(JobStage stage) { return name_in(kJobStageNames, stage); }

/// State of a job, for clients.
struct JobState {
  int id = 0;
  std::string question;
  JobStage stage = JobStage::kWaiting;
  double fraction = 0;  // last reported progress [1]
  std::string text;     // last reported activity, or the error
  double seconds = 0;   // elapsed time since its start, until its end [s]
};

/// Job that has ended, for the log of the session.
struct EndedJob {
  int id = 0;
  std::string reply;               // SHA-256 of its result or its error
  std::optional<long> stopped_at;  // number of the stop check that requested the stop, from 0
};

/// Largest number of jobs that are kept, and of jobs that run at a time.
inline constexpr std::size_t kMaxJobs = 100;
inline constexpr std::size_t kMaxRunningJobs = 2;

/// Jobs of a session. All functions are thread-safe.
class Jobs {
 public:
  Jobs() = default;
  ~Jobs() { stop_all(); }
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Queues a job, and starts it when fewer than kMaxRunningJobs are running.
  /// @param request  checked request;  @param data  as for Question::ask
  /// @return id of the job, from 1
  /// @throws InputError if kMaxJobs jobs have not ended
  int start(const Question& question, const Json& request, const std::string& data);
  /// Returns the state of a job. @throws InputError if there is no such job, as all functions below
  [[nodiscard]] JobState state(int id);
  [[nodiscard]] std::vector<JobState> states();
  /// Asks a job to stop and keep its best result so far. @return false if it had already ended
  bool stop(int id);
  /// Returns the answer of a job as JSON in SI. @throws InputError if it has not ended, or failed
  [[nodiscard]] OrderedJson result(int id);
  /// Returns the jobs that have ended since the last call.
  [[nodiscard]] std::vector<EndedJob> take_ended_jobs();

  /// Sets a function that is called on the thread of a job when it ends.
  void set_end_callback(std::function<void(int id)> callback);
  /// Asks all jobs to stop, and waits for them; no other job starts.
  void stop_all();
  /// Makes new jobs wait for run_deferred(), as in a replay.
  void defer() {
    const std::lock_guard<std::mutex> lock(mutex_);
    deferred_ = true;
  }
  /// Returns true if the request of a job names an output file.
  [[nodiscard]] bool writes_file(int id);
  /// Runs a waiting job on this thread. @param stopped_at  as EndedJob::stopped_at
  EndedJob run_deferred(int id, const std::optional<long>& stopped_at);

 private:
  struct Job;

  [[nodiscard]] std::shared_ptr<Job> find_job(int id);
  [[nodiscard]] static JobState state_of(const Job& job);
  void start_waiting();
  void run(const std::shared_ptr<Job>& job);
  void answer(Job& job, const std::function<bool(long)>& stop);

  std::mutex mutex_;
  std::condition_variable ended_;
  std::map<int, std::shared_ptr<Job>> jobs_;
  std::function<void(int id)> end_callback_;
  std::vector<EndedJob> ended_jobs_;
  std::size_t running_ = 0;
  int last_ = 0;
  bool deferred_ = false, ending_ = false;
};

}  // namespace thenar
