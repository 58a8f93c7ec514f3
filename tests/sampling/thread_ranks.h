#pragma once

/// Communicator that are threads of this process: what several processes do, without MPI.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "base/error.h"
#include "sampling/run/communicator.h"

namespace thenar::sample {

class ThreadRanks {
 public:
  /// Every rank does `work`; returns when all are done.
  static void run(int size, const std::function<void(const Communicator&)>& work) {
    Meeting meeting(size);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < size; ++rank)
      threads.emplace_back([&, rank] { work(Member(meeting, rank)); });
    for (std::thread& thread : threads) thread.join();
  }

 private:
  struct Meeting {
    explicit Meeting(int n) : size(n), brought(static_cast<std::size_t>(n)) {}

    /// Returns when all have come.
    void meet() {
      std::unique_lock<std::mutex> guard(mutex);
      const long mine = round;
      if (++come == size) {
        come = 0;
        ++round;
        all_come.notify_all();
      } else {
        all_come.wait(guard, [&] { return round > mine; });
      }
    }

    int size, come = 0;
    long round = 0;
    std::mutex mutex;
    std::condition_variable all_come;
    std::vector<Eigen::VectorXd> brought;
  };

  class Member : public Communicator {
   public:
    Member(Meeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}

    [[nodiscard]] int rank() const override { return rank_; }
    [[nodiscard]] int size() const override { return meeting_.size; }
    [[nodiscard]] Eigen::VectorXd all_gather(const Eigen::VectorXd& mine) const override {
      meeting_.brought[static_cast<std::size_t>(rank_)] = mine;
      meeting_.meet();
      Eigen::VectorXd all(0);
      for (const Eigen::VectorXd& part : meeting_.brought) {
        all.conservativeResize(all.size() + part.size());
        all.tail(part.size()) = part;
      }
      meeting_.meet();
      return all;
    }
    void barrier() const override { meeting_.meet(); }
    [[noreturn]] void abort(const std::string& why) const override { throw InputError(why); }

   private:
    Meeting& meeting_;
    int rank_;
  };
};

}  // namespace thenar::sample
