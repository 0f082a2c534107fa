#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ajar {

/// States of a stream, and the function that sets each in a process that is about to be started;
/// "full" comes first.
inline std::vector<std::pair<std::string, std::function<void()>>> lost_streams(int descriptor) {
  const auto become = [descriptor](int file) {
    dup2(file, descriptor);
    close(file);
  };
  return {{"full", [=] { become(open("/dev/full", O_WRONLY)); }},
          {"closed", [=] { close(descriptor); }},
          {"a pipe without a reader", [=] {
             int ends[2];
             if (pipe(ends) != 0) _exit(97);
             close(ends[0]);
             become(ends[1]);
           }}};
}

}  // namespace ajar
