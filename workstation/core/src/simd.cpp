#include "ew/core/simd.h"

#include <hwy/targets.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>

namespace ew {
namespace {

struct InstructionSet {
  std::string_view word;
  std::int64_t targets;  // what Highway calls those of this set
};
constexpr std::array kSets = {InstructionSet{"avx3", HWY_AVX3_DL | HWY_AVX3}, InstructionSet{"avx2", HWY_AVX2},
                              InstructionSet{"sse4", HWY_SSE4 | HWY_SSSE3}, InstructionSet{"scalar", HWY_SCALAR}};

// What Highway may choose from now; its own record of it cannot be read.
std::atomic<std::int64_t> allowed{0};

std::int64_t available() { return hwy::SupportedTargets() | HWY_SCALAR; }

/// Those of this processor that are `best` or worse.
std::int64_t from(std::size_t best) {
  std::int64_t targets = 0;
  for (std::size_t n = best; n < kSets.size(); ++n) targets |= kSets[n].targets;
  return targets & available();
}

std::string wordsHere() {
  std::string words = "best";
  for (const InstructionSet& set : kSets)
    if ((available() & set.targets) != 0) words += " " + std::string(set.word);
  return words;
}

std::string bestOf(std::int64_t targets) {
  for (const InstructionSet& set : kSets)
    if ((targets & set.targets) != 0 && (set.targets != HWY_SCALAR || targets == HWY_SCALAR)) return std::string(set.word);
  return "other";
}

}  // namespace

Result<void> useSimd(std::string_view word) {
  std::int64_t targets = available();
  if (!word.empty() && word != "best") {
    const auto found = std::find_if(kSets.begin(), kSets.end(), [word](const InstructionSet& set) { return set.word == word; });
    const Message asked = verbatim(std::string(word)), here = verbatim(wordsHere());
    if (found == kSets.end())
      return failure(ErrorCode::badUsage, say<"'%1' is no instruction set that can be chosen; choose one of: %2.">(asked, here));
    if ((available() & found->targets) == 0)
      return failure(ErrorCode::badUsage, say<"This processor has no %1; choose one of: %2.">(asked, here));
    targets = from(static_cast<std::size_t>(found - kSets.begin()));
  }
  allowed = targets;
  hwy::GetChosenTarget().Update(targets);
  return {};
}

std::string simdInUse() { return bestOf(allowed != 0 ? allowed.load() : available()); }

std::string bestSimd() { return bestOf(available()); }

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name") && line.find(':') != std::string::npos) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string simdOfEnvironment() {
  const char* word = std::getenv("ECHOWEAVE_SIMD");
  return word != nullptr ? word : "";
}

}  // namespace ew
