#pragma once
#include <cstdint>
#include <string>

namespace ajar {

/// Memory of the machine, bytes; 0 if unknown.
std::uint64_t physical_memory_bytes();

/// Memory that this process can still have without a process being killed, bytes: free or swappable
/// memory, within the limits of the control group (as batch schedulers set them) and of the process
/// (`ulimit -v`); 0 if unknown.
std::uint64_t available_memory_bytes();

/// True if `bytes` more fit, with a reserve for omissions of estimates, or if the available memory
/// is unknown.
bool fits_into_memory(std::uint64_t bytes, std::uint64_t available);

/// "needs 12.9 GB of memory, and 3.2 GB are free here", for the end of a sentence; empty if `bytes`
/// can be had. To be asked before large memory is: a machine that promises more than it has ends
/// programs without a word.
std::string memory_shortage(std::uint64_t bytes);

/// "3.2 GB", "120 MB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace ajar
