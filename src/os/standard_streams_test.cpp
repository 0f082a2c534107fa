#include "os/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

#include "core/error.h"

namespace ajar {
namespace {

/// Lets a descriptor be another file until the end of a test.
class Redirected {
 public:
  Redirected(int descriptor, int file) : descriptor_(descriptor), before_(dup(descriptor)) {
    dup2(file, descriptor_);
  }
  ~Redirected() {
    dup2(before_, descriptor_);
    close(before_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  int descriptor_;
  int before_;
};

class StandardStreams : public ::testing::Test {
 protected:
  void SetUp() override {
    std::signal(SIGPIPE, SIG_IGN);
    ASSERT_EQ(pipe(ends_.data()), 0);
  }
  void TearDown() override {
    for (const int end : ends_) close(end);
    std::signal(SIGPIPE, SIG_DFL);
  }
  std::string read_some() const {
    std::string text(1 << 20, '\0');
    const ssize_t size = ::read(ends_[0], text.data(), text.size());
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return text;
  }
  std::array<int, 2> ends_{};
};

TEST_F(StandardStreams, AreWritten) {
  {
    const Redirected out(STDOUT_FILENO, ends_[1]);
    const Redirected err(STDERR_FILENO, ends_[1]);
    say("to people\n");
    say_on_stdout("to scripts\n");
    print_result("result\n");
  }
  EXPECT_EQ(read_some(), "to people\nto scripts\nresult\n");
}

TEST_F(StandardStreams, DropUnwritableText) {
  const int full = open("/dev/full", O_WRONLY);
  {
    const Redirected out(STDOUT_FILENO, full);
    const Redirected err(STDERR_FILENO, full);
    EXPECT_NO_THROW(say("nobody hears this"));
    EXPECT_NO_THROW(say_on_stdout("nor this"));
    EXPECT_THROW(print_result("but this is what was asked for"), IoError);
  }
  close(full);
}

TEST_F(StandardStreams, DropTextWhileThereIsNoReader) {
  const std::string more_than_fits(1 << 20, '.');
  {
    const Redirected err(STDERR_FILENO, ends_[1]);
    say(more_than_fits);
    say("dropped at once");
    EXPECT_LT(read_some().size(), more_than_fits.size());
    say("heard again");
  }
  EXPECT_EQ(read_some(), "heard again");
}

TEST_F(StandardStreams, ClosedPipeIsNoError) {
  close(ends_[0]);
  {
    const Redirected out(STDOUT_FILENO, ends_[1]);
    EXPECT_NO_THROW(print_result("result\n"));
  }
  ends_[0] = dup(ends_[1]);
}

}  // namespace
}  // namespace ajar
