#pragma once

/// Questions that are answered beside the session: each runs on a thread of its own, after those
/// before it, while the session serves its clients.

#include <array>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
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

/// What a client hears of a job.
struct JobState {
  int id = 0;
  std::string question;
  JobStage stage = JobStage::kWaiting;
  double fraction = 0;  // as it told last
  std::string text;     // what it does, or why it failed
  double seconds = 0;   // since it began, or that it took
};

/// A job that has ended, for the log of the session.
struct EndedJob {
  int id = 0;
  std::string reply;               // SHA-256 of its result or its error
  std::optional<long> stopped_at;  // which question "am I to stop?" was the first to be told yes
};

/// Most jobs that are kept, and of them that run at a time.
inline constexpr std::size_t kMaxJobs = 100;
inline constexpr std::size_t kMaxRunningJobs = 2;

/// The jobs of a session. All functions may be called from any thread.
class Jobs {
 public:
  Jobs() = default;
  ~Jobs() { end(); }
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  /// Begins a job, or lets it wait for those before it.
  /// @param request  checked;  @param data  as of Question::ask
  /// @return its id, from 1  @throws InputError if there are kMaxJobs that have not ended
  int start(const Question& question, const Json& request, const std::string& data);
  /// @throws InputError if there is no such job, here and below
  [[nodiscard]] JobState state(int id);
  [[nodiscard]] std::vector<JobState> all();
  /// Asks a job to stop and keep its best so far. @return whether it had not ended
  bool stop(int id);
  /// The answer of a job that has ended, as JSON in SI. @throws InputError if it has not, or failed
  [[nodiscard]] OrderedJson result(int id);
  /// Jobs that have ended since the last call.
  [[nodiscard]] std::vector<EndedJob> take_ended();

  /// Is told, on the thread of a job, that it has ended.
  void on_end(std::function<void(int id)> told);
  /// Asks all jobs to stop, and waits for them; none begins any more.
  void end();
  /// Lets jobs wait until run_held() runs them, as a replay does.
  void hold() { held_ = true; }
  /// Returns whether a job writes a file.
  [[nodiscard]] bool writes(int id);
  /// Runs a job that waits, on this thread. @param stopped_at  as of EndedJob
  EndedJob run_held(int id, const std::optional<long>& stopped_at);

 private:
  struct Job;

  [[nodiscard]] std::shared_ptr<Job> job(int id);
  [[nodiscard]] static JobState state_of(const Job& job);
  void start_waiting();
  void run(const std::shared_ptr<Job>& job);
  void answer(Job& job, const std::function<bool(long)>& stop);

  std::mutex mutex_;
  std::condition_variable ended_;
  std::map<int, std::shared_ptr<Job>> jobs_;
  std::function<void(int id)> told_;
  std::vector<EndedJob> untold_;
  std::size_t running_ = 0;
  int last_ = 0;
  bool held_ = false, ending_ = false;
};

}  // namespace thenar
