#include "bench/all_entry.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/images/echo_entry.h"
#include "bench/images/flow_entry.h"
#include "bench/images/frame_entry.h"
#include "bench/images/slicing_entry.h"
#include "bench/tools/bench_entry.h"
#include "bench/tools/bench_options.h"
#include "bench/volumes/reconstruct_entry.h"
#include "bench/volumes/register_entry.h"
#include "bench/volumes/stitch_entry.h"

namespace ew::cli {
namespace {

/// Asks once what several benches have, and hands it to each before it runs.
class AllEntry final : public BenchEntry {
 public:
  void addOptions(CLI::App& app) override {
    addSides(app, sides_);
    slicing_.addOwnOptions(app);
    addFrameSize(app, size_px_);
    addPoses(app, poses_);
    echoes_.addOwnOptions(app);
    reconstruct_.addOwnOptions(app);
    register_.addOwnOptions(app, "--pair-side");
    stitch_.addOwnOptions(app, "--view-side");
    addDrawSeed(app, seed_);
    addRepetitions(app, repetitions_);
    addNoPeers(app, noPeers_);
  }

  [[nodiscard]] Result<void> announce(Run& run) override { return register_.announce(run); }

  [[nodiscard]] Result<void> measure(Run& run, BenchResults& results, Progress& progress) override {
    share();
    struct Part {
      BenchEntry& entry;
      double begin, end;  // of the progress
    };
    for (const Part& each : {Part{frame_, 0.0, 0.25}, Part{slicing_, 0.25, 0.5}, Part{reconstruct_, 0.5, 0.7}, Part{register_, 0.7, 0.9},
                             Part{echoes_, 0.9, 0.93}, Part{flow_, 0.93, 0.95}, Part{stitch_, 0.95, 1.0}}) {
      PartOfProgress part(progress, each.begin, each.end);
      if (auto measured = each.entry.measure(run, results, part); !measured) return measured;
    }
    return {};
  }

 private:
  void share() {
    slicing_.sides = frame_.sides = sides_;
    frame_.size_px = echoes_.size_px = flow_.size_px = size_px_;
    slicing_.poses = frame_.poses = poses_;
    echoes_.options.poses = poses_.value_or(echoes_.options.poses);
    register_.options.seed = stitch_.options.seed = echoes_.options.seed = seed_;
    slicing_.repetitions = frame_.repetitions = reconstruct_.repetitions = register_.repetitions = stitch_.repetitions = repetitions_;
    slicing_.noPeers = frame_.noPeers = register_.noPeers = noPeers_;
  }

  SlicingEntry slicing_;
  FrameEntry frame_;
  EchoEntry echoes_;
  FlowEntry flow_;
  ReconstructEntry reconstruct_;
  RegisterEntry register_;
  StitchEntry stitch_;
  std::vector<std::string> sides_;
  glm::ivec2 size_px_ = frame_.size_px;
  std::optional<int> poses_, repetitions_;
  std::uint64_t seed_ = 1;
  bool noPeers_ = false;
};

}  // namespace

void addAllBenches(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection, {"all", "All of it, on one page", {"bench all --html bench --report bench.json"}, /*isOneOfMany=*/true},
                std::make_shared<AllEntry>());
}

}  // namespace ew::cli
