#include "session/output/final_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <thread>

#include "session/job/progress.h"

namespace ajar {

namespace {

namespace fs = std::filesystem;

/// Where a file goes if it cannot go to `path`: never onto a file that exists.
std::vector<std::string> rescue_paths(const std::string& path) {
  const fs::path wanted(path);
  const std::string name =
      fmt::format("{}-rescued-{}{}", wanted.stem().string(), getpid(), wanted.extension().string());
  std::error_code error;
  std::vector<std::string> paths = {name};
  const fs::path temporary = fs::temp_directory_path(error);
  if (!error) paths.push_back((temporary / name).string());
  std::erase_if(paths, [](const std::string& candidate) {
    std::error_code ignored;
    return fs::exists(candidate, ignored);
  });
  return paths;
}

WrittenFile write_or_rescue(const FinalFile& file) {
  WrittenFile result{file.what, file.path, file.path, {}};
  try {
    file.write(file.path);
    return result;
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  for (const std::string& rescue : rescue_paths(file.path)) {
    try {
      file.write(rescue);
      result.path = rescue;
      return result;
    } catch (const std::exception&) {
      // The first reason is the one to tell; the next place may still work.
      continue;
    }
  }
  result.path.clear();
  return result;
}

}  // namespace

bool Patience::wait(const WrittenFile& file) {
  constexpr double kSecondsUntilRetry = 1.0;
  constexpr double kSecondsBetweenWords = 30.0;
  if (!interrupts_before_) {
    interrupts_before_ = interrupts_.load();
    clock_ = {};
    next_word_ = kSecondsBetweenWords;
    say_(file.error + ", nor elsewhere; " + file.what +
         " waits until there is room, Ctrl-C gives it up");
  } else if (clock_.seconds() >= next_word_) {
    next_word_ += kSecondsBetweenWords;
    say_(fmt::format("{} still waits after {}: {}", file.what, clock_text(clock_.seconds()),
                     file.error));
  }
  const Stopwatch pause;
  while (pause.seconds() < kSecondsUntilRetry) {
    if (interrupts_.load() > *interrupts_before_) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

std::vector<WrittenFile> write_final_files(const std::vector<FinalFile>& files,
                                           Patience* patience) {
  std::vector<WrittenFile> written;
  written.reserve(files.size());
  for (const FinalFile& file : files) written.push_back(write_or_rescue(file));
  const auto is_nowhere = [](const WrittenFile& file) { return file.path.empty(); };
  while (patience != nullptr) {
    const auto first = std::find_if(written.begin(), written.end(), is_nowhere);
    if (first == written.end() || !patience->wait(*first)) break;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (is_nowhere(written[i])) written[i] = write_or_rescue(files[i]);
    }
  }
  return written;
}

}  // namespace ajar
