#pragma once

namespace ajar {

/// What becomes of the samples from which it is decided what chains make.
enum class PilotUse {
  Cross,    ///< they stay, and each half of the replicates has the decisions of the other half's
  Discard,  ///< they do not stay
  Keep      ///< they stay; biased, as published, if there is anything to decide
};

/// The best without bias.
inline PilotUse pilot_use_of(int replicates) {
  constexpr int kTwoHalves = 4;
  return replicates < kTwoHalves ? PilotUse::Discard : PilotUse::Cross;
}

}  // namespace ajar
