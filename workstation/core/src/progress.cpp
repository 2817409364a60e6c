#include "ew/core/progress.h"

namespace ew {
namespace {

class Silence final : public Progress {
 public:
  void report(const Message&, double) override {}
  [[nodiscard]] bool cancelRequested() const override { return false; }
};

}  // namespace

Progress::~Progress() = default;

Progress& noProgress() {
  static Silence silence;  // holds no state
  return silence;
}

}  // namespace ew
