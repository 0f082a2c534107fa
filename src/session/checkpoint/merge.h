#pragma once
#include <string>
#include <vector>

#include "session/checkpoint/checkpoint.h"

namespace ajar {

/// A checkpoint with the name of its file.
struct NamedCheckpoint {
  std::string path;
  Checkpoint checkpoint;
};

/// Puts checkpoints of one picture together. Shares of the same seed add up to the whole, to the
/// bit, and can go on. Pictures of different seeds are independent estimates: their mean, weighted
/// by their samples, is better than each, and so are its replicates, which tell its error; it
/// cannot go on, but be merged with more.
///
/// Raises UsageError, which names the file, for what would be wrong: other scenes, methods or
/// settings; the same samples twice; shares that are missing, or have different samples; a pass
/// that was cut short. `force` allows checkpoints of other versions of the program.
Checkpoint merge(std::vector<NamedCheckpoint> parts, bool force);

}  // namespace ajar
