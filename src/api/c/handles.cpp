#include "api/c/handles.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "core/printable_text.h"

namespace ajar::c {

namespace {

std::string& last_error() {
  thread_local std::string text;
  return text;
}

int code_of(v0::Error::Kind kind) {
  switch (kind) {
    case v0::Error::Kind::Usage:
      return AJAR_USAGE;
    case v0::Error::Kind::Scene:
      return AJAR_SCENE;
    case v0::Error::Kind::File:
      return AJAR_FILE;
    case v0::Error::Kind::Stopped:
      return AJAR_STOPPED;
  }
  return AJAR_OTHER;
}

}  // namespace

v0::Callbacks BackgroundRender::listeners() {
  const auto keep = [this](std::vector<std::string> Messages::*kind) {
    return [this, kind](const std::string& text) {
      const std::lock_guard lock(mutex_);
      (messages_.*kind).push_back(text);
    };
  };
  v0::Callbacks callbacks;
  callbacks.warning = keep(&Messages::warnings);
  callbacks.trouble = keep(&Messages::troubles);
  callbacks.note = keep(&Messages::notes);
  return callbacks;
}

BackgroundRender::BackgroundRender(const v0::Scene& scene, const v0::Settings& settings)
    : render_(scene, settings, listeners()), thread_([this] { run(); }) {}

BackgroundRender::~BackgroundRender() {
  // Twice: at once, whatever comes of it.
  render_.stop();
  render_.stop();
  thread_.join();
}

void BackgroundRender::run() {
  std::optional<v0::Picture> picture;
  std::exception_ptr error;
  try {
    picture = render_.run();
  } catch (...) {
    error = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  result_ = std::move(picture);
  error_ = std::move(error);
  is_done_ = true;
  ended_.notify_all();
}

bool BackgroundRender::wait(double seconds) {
  if (std::isnan(seconds)) throw UsageError("seconds: must be a number, not nan");
  std::unique_lock lock(mutex_);
  const auto ended = [this] { return is_done_; };
  // A year is more than the clock can be asked for without overflow.
  constexpr double kLongest = 3e7;
  if (seconds < 0.0) {
    ended_.wait(lock, ended);
  } else {
    ended_.wait_for(lock, std::chrono::duration<double>(std::min(seconds, kLongest)), ended);
  }
  if (error_) std::rethrow_exception(error_);
  return is_done_;
}

bool BackgroundRender::is_done() const {
  const std::lock_guard lock(mutex_);
  return is_done_;
}

std::optional<v0::Picture> BackgroundRender::picture() const {
  {
    const std::lock_guard lock(mutex_);
    if (result_) return result_;
  }
  return render_.picture();
}

BackgroundRender::Messages BackgroundRender::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

int guarded(const std::function<void()>& work) {
  const auto fail = [](int code, const char* message) {
    try {
      last_error() = valid_utf8(message);
    } catch (...) {
      last_error().clear();
    }
    return code;
  };
  try {
    work();
    return AJAR_OK;
  } catch (const v0::Error& error) {
    return fail(code_of(error.kind()), error.what());
  } catch (const UsageError& error) {
    return fail(AJAR_USAGE, error.what());
  } catch (const SceneError& error) {
    return fail(AJAR_SCENE, error.what());
  } catch (const IoError& error) {
    return fail(AJAR_FILE, error.what());
  } catch (const std::bad_alloc&) {
    return fail(AJAR_MEMORY, "there is not enough memory");
  } catch (const std::length_error&) {
    return fail(AJAR_MEMORY, "there is not enough memory");
  } catch (const std::exception& error) {
    return fail(AJAR_OTHER, error.what());
  } catch (...) {
    return fail(AJAR_OTHER, "unknown error");
  }
}

void give_text(const std::string& text, char** out) {
  char*& place = given(out, "json");
  auto copy = std::make_unique<char[]>(text.size() + 1);
  std::memcpy(copy.get(), text.c_str(), text.size() + 1);
  place = copy.release();
}

}  // namespace ajar::c

const char* ajar_last_error(void) { return ajar::c::last_error().c_str(); }

void ajar_text_free(char* text) { delete[] text; }
