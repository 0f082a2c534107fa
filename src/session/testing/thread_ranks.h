#pragma once
#include <algorithm>
#include <barrier>
#include <cstring>
#include <limits>
#include <vector>

#include "session/job/ranks.h"

namespace ajar {

/// Ranks that are threads of one process, for tests without MPI.
class ThreadRanks {
 public:
  explicit ThreadRanks(int count) : count_(count), barrier_(count) {
    for (int rank = 0; rank < count; ++rank) members_.push_back(Member(*this, rank));
  }
  Ranks& member(int rank) { return members_[static_cast<std::size_t>(rank)]; }

 private:
  class Member final : public Ranks {
   public:
    Member(ThreadRanks& all, int rank) : all_(&all), rank_(rank) {}
    int rank() const override { return rank_; }
    int count() const override { return all_->count_; }
    void broadcast(int from, std::span<std::byte> bytes) override {
      if (rank_ == from) all_->shared_ = bytes.data();
      all_->barrier_.arrive_and_wait();
      if (rank_ != from && !bytes.empty()) std::memcpy(bytes.data(), all_->shared_, bytes.size());
      all_->barrier_.arrive_and_wait();
    }
    void sum_to_root(std::span<const std::int64_t> own, std::span<std::int64_t> whole) override {
      sum(own, whole);
    }
    void sum_to_root(std::span<const double> own, std::span<double> whole) override {
      sum(own, whole);
    }
    std::uint64_t maximum(std::uint64_t own) override {
      std::uint64_t largest = 0;
      one_by_one([&] { all_->maximum_ = rank_ == 0 ? own : std::max(all_->maximum_, own); });
      largest = all_->maximum_;
      all_->barrier_.arrive_and_wait();
      return largest;
    }

   private:
    template <typename Action>
    void one_by_one(const Action& action) {
      for (int turn = 0; turn < all_->count_; ++turn) {
        if (turn == rank_) action();
        all_->barrier_.arrive_and_wait();
      }
    }
    template <typename Number>
    void sum(std::span<const Number> own, std::span<Number> whole) {
      if (rank_ == 0) {
        std::copy(own.begin(), own.end(), whole.begin());
        all_->target_ = whole.data();
      }
      one_by_one([&] {
        auto* const target = static_cast<Number*>(all_->target_);
        for (std::size_t i = 0; rank_ != 0 && i < own.size(); ++i) target[i] += own[i];
      });
    }

    ThreadRanks* all_;
    int rank_;
  };

  int count_;
  std::barrier<> barrier_;
  const void* shared_ = nullptr;
  void* target_ = nullptr;
  std::uint64_t maximum_ = 0;
  std::vector<Member> members_;
};

}  // namespace ajar
