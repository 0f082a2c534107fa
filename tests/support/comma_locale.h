#pragma once
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

#include "support/temporary_file.h"

namespace ajar::test {

/// While it lives, this process writes numbers as Germans do, "1.234,5", as graphical toolkits make
/// their programs: in C, and in C++'s streams.
class CommaLocale {
 public:
  CommaLocale() : before_(std::locale::global(std::locale(std::locale::classic(), new Numbers))) {
    // Few machines have such a locale; most can make one.
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + folder_.path() + "/de_DE.UTF-8' > /dev/null 2>&1";
    std::filesystem::create_directory(folder_.path());
    if (std::system(command.c_str()) != 0) return;
    ::setenv("LOCPATH", folder_.path().c_str(), 1);
    is_whole_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr &&
                std::string(std::localeconv()->decimal_point) == ",";
  }
  ~CommaLocale() {
    std::setlocale(LC_ALL, "C");
    ::unsetenv("LOCPATH");
    std::locale::global(before_);
    std::filesystem::remove_all(folder_.path());
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  /// False where C has no such locale.
  bool is_whole() const { return is_whole_; }

 private:
  struct Numbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  TemporaryFile folder_{"locale"};
  std::locale before_;
  bool is_whole_ = false;
};

}  // namespace ajar::test
