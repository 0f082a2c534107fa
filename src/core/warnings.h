#pragma once
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

#include "core/error.h"

namespace ajar {

/// Counted, located remarks about input that is unusual but usable. Thread-safe. Equal messages at
/// different places are kept apart; at most `kMaxKept` texts are kept, all are counted.
class Warnings {
 public:
  static constexpr std::size_t kMaxKept = 200;
  void add(const SourceLocation& where, const std::string& message);
  void add(const std::string& message);
  std::size_t count() const;
  std::vector<std::string> messages() const;

 private:
  mutable std::mutex mutex_;
  std::size_t count_ = 0;
  std::vector<std::string> messages_;
};

}  // namespace ajar
