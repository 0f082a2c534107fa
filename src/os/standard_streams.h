#pragma once
#include <string_view>

/// Messages on stderr, results on stdout. A render goes on whatever becomes of its readers: a
/// closed terminal, a full disk, a pipe without a reader.
namespace ajar {

/// Writes to stderr, for people and for programs that follow a render. Unwritable text is dropped:
/// also where a reader has stopped reading, after waiting for it for a second. Raises nothing;
/// thread-safe, but several calls may be mixed with those of other threads.
void say(std::string_view text);
/// Prints on stdout, for scripts: results such as the place of a file.
void say_on_stdout(std::string_view text);

/// Writes the result of a command to stdout. A reader that closes the pipe early (`| head`) is no
/// error. Raises IoError if it cannot be written.
void print_result(std::string_view text);

/// To be called first: gives descriptors 0, 1 and 2, if they are closed, to nothing. Else the next
/// file that is opened would take their place, and messages would be written into it.
void reserve_standard_streams();

}  // namespace ajar
