#include "server/jobs.h"

#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/progress_parts.h"
#include "base/stop_scope.h"
#include "questions/question.h"
#include "server/session_log.h"

namespace thenar {
namespace {

using JobClock = std::chrono::steady_clock;

constexpr int kJobNice = 10;  // nice value of job threads, below the session's thread
constexpr std::size_t kMaxResultBytes = 32UL << 20U;  // largest result as JSON [bytes]

bool has_ended(JobStage stage) {
  return stage != JobStage::kWaiting && stage != JobStage::kRunning;
}

/// Lowers the priority of this thread, and of threads that it starts.
void yield_to_clients() { (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kJobNice); }

}  // namespace

struct Jobs::Job {
  int id = 0;
  const Question* question = nullptr;
  Json request;
  std::string data;
  std::atomic<bool> stop{false};
  std::atomic<long> stop_checks{0}, stopped_at{-1};
  // Protected by Jobs::mutex_.
  JobStage stage = JobStage::kWaiting;
  double fraction = 0;
  std::string text;
  JobClock::time_point begin, end;
  OrderedJson result;
};

void Jobs::stop_all() {
  std::unique_lock<std::mutex> lock(mutex_);
  ending_ = true;
  for (const auto& [id, job] : jobs_) job->stop = true;
  ended_.wait(lock, [this] { return running_ == 0; });
}

int Jobs::start(const Question& question, const Json& request, const std::string& data) {
  const std::lock_guard<std::mutex> lock(mutex_);
  // If there are too many jobs, remove the oldest that has ended.
  if (jobs_.size() >= kMaxJobs) {
    const auto oldest = std::find_if(
        jobs_.begin(), jobs_.end(), [](const auto& each) { return has_ended(each.second->stage); });
    require(oldest != jobs_.end(), "{} jobs have not ended, the most there may be", kMaxJobs);
    jobs_.erase(oldest);
  }
  // Queue the job.
  auto job = std::make_shared<Job>();
  job->id = ++last_;
  job->question = &question;
  job->request = request;
  job->data = data;
  jobs_[job->id] = job;
  start_waiting();
  return job->id;
}

/// Starts waiting jobs in order, up to kMaxRunningJobs. The caller holds the mutex.
void Jobs::start_waiting() {
  for (const auto& [id, job] : jobs_) {
    if (deferred_ || ending_ || running_ >= kMaxRunningJobs) return;
    if (job->stage != JobStage::kWaiting) continue;
    job->stage = JobStage::kRunning;
    job->begin = JobClock::now();
    ++running_;
    std::thread([this, job = job] { run(job); }).detach();
  }
}

void Jobs::run(const std::shared_ptr<Job>& job) {
  yield_to_clients();
  answer(*job, [&](long) { return job->stop.load(); });
  // Call the callback before running_ decreases: stop_all() waits for that, so the session exists.
  std::function<void(int)> callback;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ending_) callback = end_callback_;
  }
  if (callback) callback(job->id);
  // Start the next job.
  const std::lock_guard<std::mutex> lock(mutex_);
  --running_;
  start_waiting();
  ended_.notify_all();
}

/// Answers the question of a job, and stores the result or the error.
/// @param stop  returns true if the stop check of a number is to request the stop
void Jobs::answer(Job& job, const std::function<bool(long)>& stop) {
  // Count the stop checks: a replay stops at the same one.
  Progress progress;
  progress.stop_requested = [&] {
    const long number = job.stop_checks++;
    if (!stop(number)) return false;
    long none = -1;
    job.stopped_at.compare_exchange_strong(none, number);
    return true;
  };
  progress.report = [&](double fraction, const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    job.fraction = fraction;
    job.text = text;
  };
  // Answer the question; refuse results that are too large for a reply.
  JobStage stage = JobStage::kFailed;
  OrderedJson result;
  std::string text;
  try {
    const StopScope scope(progress);
    const Answer answer = job.question->ask(job.request, job.data, progress);
    const Outcome& outcome = answer.outcome;
    if (outcome.stopped() && outcome.done == 0 && outcome.asked > 0)
      throw Stopped(fmt::format("stopped before the first {} was done", outcome.part));
    result = {{"request", answer.request},
              {"status", name_of(answer.outcome.status)},
              {"warnings", answer.outcome.warnings},
              {"answer", answer.json(UnitSystem::kSi)}};
    if (!answer.refusal.empty()) result["refusal"] = answer.refusal;
    require(json_text(result, -1).size() <= kMaxResultBytes,
            "the answer holds more than {} MB, which no reply does", kMaxResultBytes >> 20U);
    stage = answer.outcome.status == Status::kStopped ? JobStage::kStopped : JobStage::kDone;
  } catch (const Stopped& stopped) {
    stage = JobStage::kStopped;
    text = stopped.what();
  } catch (const std::exception& error) {
    text = error.what();
  }
  // Compute the hash of the result or the error.
  OrderedJson reply = result;
  if (stage == JobStage::kFailed || result.is_null()) reply = {{"failed", text}};
  EndedJob ended{job.id, reply_hash(reply), std::nullopt};
  if (job.stopped_at >= 0) ended.stopped_at = job.stopped_at;
  // Store the final state.
  const std::lock_guard<std::mutex> lock(mutex_);
  job.stage = stage;
  job.end = JobClock::now();
  if (!text.empty() || stage == JobStage::kDone) job.text = text;
  if (stage == JobStage::kDone) job.fraction = 1;
  job.result = std::move(result);
  ended_jobs_.push_back(ended);
}

std::shared_ptr<Jobs::Job> Jobs::find_job(int id) {
  const auto found = jobs_.find(id);
  require_field("job", found != jobs_.end(), "there is no job {}", id);
  return found->second;
}

JobState Jobs::state_of(const Job& job) {
  JobState state{job.id, job.question->name, job.stage, job.fraction, job.text, 0};
  if (job.stage != JobStage::kWaiting)
    state.seconds = std::chrono::duration<double>(
                        (has_ended(job.stage) ? job.end : JobClock::now()) - job.begin)
                        .count();
  return state;
}

JobState Jobs::state(int id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_of(*find_job(id));
}

std::vector<JobState> Jobs::states() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<JobState> states;
  for (const auto& [id, job] : jobs_) states.push_back(state_of(*job));
  return states;
}

bool Jobs::stop(int id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::shared_ptr<Job> job = find_job(id);
  if (has_ended(job->stage)) return false;
  job->stop = true;
  return true;
}

OrderedJson Jobs::result(int id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::shared_ptr<Job> job = find_job(id);
  require(has_ended(job->stage), "job {} has not ended: it is {}", id, name_of(job->stage));
  require(!job->result.is_null(), "job {} has no result: {}", id, job->text);
  return job->result;
}

std::vector<EndedJob> Jobs::take_ended_jobs() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(ended_jobs_, {});
}

void Jobs::set_end_callback(std::function<void(int id)> callback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  end_callback_ = std::move(callback);
}

bool Jobs::writes_file(int id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return find_job(id)->request.contains("output");
}

EndedJob Jobs::run_deferred(int id, const std::optional<long>& stopped_at) {
  std::shared_ptr<Job> job;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    job = find_job(id);
    require(job->stage == JobStage::kWaiting, "job {} has run already", id);
    job->stage = JobStage::kRunning;
    job->begin = JobClock::now();
  }
  answer(*job, [&](long number) { return stopped_at && number >= *stopped_at; });
  return take_ended_jobs().back();
}

}  // namespace thenar
