#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "bench/tools/bench_parts.h"
#include "bench/volumes/bench_reconstruct.h"
#include "ew/acquisition/confidence.h"
#include "ew/io/safe_file.h"
#include "ew/library/case.h"
#include "ew/phantom/virtual_scanner.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr int kLines = 4, kSamples = 16;  // of a judged block: less and speckle decides what is lost
constexpr double kConfidenceDepth_mm = 65.0;
constexpr double kShadow_db = 15.0, kSight_db = 3.0;

/// A block of tissue below y = 0 with two stones, one that is little more than a scar, and a vessel.
constexpr const char* kConfidencePatient = R"({"format": 1, "name": "block with stones", "mannequin": "body.json",
  "box": {"lowest_mm": [-40, -5, -40], "highest_mm": [40, 75, 40]},
  "tissues": [{"name": "even", "echo_level": 150, "speckle": 1},
    {"name": "water", "echo_level": 0, "speckle": 0, "attenuation_db_per_cm_mhz": 0},
    {"name": "stone", "echo_level": 100, "speckle": 1, "attenuation_db_per_cm_mhz": 0, "reflection_db": 30},
    {"name": "scar", "echo_level": 175, "speckle": 1, "attenuation_db_per_cm_mhz": 0, "reflection_db": 18}],
  "background": "even", "organs": [
    {"name": "stone 1", "tissue": "stone", "shape": {"ellipsoid": {"centre_mm": [-9, 26, 0], "radii_mm": [4, 3, 40]}}},
    {"name": "stone 2", "tissue": "stone", "shape": {"ellipsoid": {"centre_mm": [13, 18, 0], "radii_mm": [3, 2, 40]}}},
    {"name": "scar", "tissue": "scar", "shape": {"ellipsoid": {"centre_mm": [-17, 20, 0], "radii_mm": [2.5, 2, 40]}}},
    {"name": "vessel", "tissue": "water", "shape": {"ellipsoid": {"centre_mm": [2, 34, 0], "radii_mm": [4, 4, 40]}}}]})";
constexpr const char* kConfidenceBody =
    R"({"format": 1, "name": "block", "body": {"ellipsoid": {"centre_mm": [0, 2000, 0], "radii_mm": [2000, 2000, 2000]}}})";

/// Recipes are read from files; these are gone once they are read.
Result<std::shared_ptr<const Patient>> blockWithStones() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::temp_directory_path(ignored) / ("echoweave-bench-" + std::to_string(::getpid()));
  fs::create_directories(folder, ignored);
  auto written = writeFileSafely(folder / "body.json", kConfidenceBody);
  if (written) written = writeFileSafely(folder / "patient.json", kConfidencePatient);
  auto patient = written ? readPatient(folder / "patient.json") : Result<std::shared_ptr<const Patient>>(passOn(written.error()));
  fs::remove_all(folder, ignored);
  return patient;
}

enum class Seen : std::uint8_t { undecided, inSight, inShadow };

/// A virtual frame and what the forward model took from each block of it.
struct VirtualFrame {
  GreyImage levels;          ///< (samples x lines)
  std::vector<Seen> blocks;  ///< rows of levels.width / kLines
};

Image<float> envelopeOf(const VirtualScanner& scanner, const Transform<frame::World, frame::Probe>& pose) {
  const auto scratch = scanner.makeScratch();
  Image<float> envelope;
  scanner.envelope(pose, restingBody(), 0, *scratch, envelope);
  return envelope;
}

double powerOf(const Image<float>& envelope, int line, int sample) {
  double sum = 0.0;
  for (int s = sample; s < sample + kSamples; ++s)
    for (int l = line; l < line + kLines; ++l)
      sum += std::pow(
          static_cast<double>(
              envelope.pixels[static_cast<std::size_t>(s) * static_cast<std::size_t>(envelope.width) + static_cast<std::size_t>(l)]),
          2.0);
  return sum;
}

Result<VirtualFrame> viewAt(double elevation_mm, const std::shared_ptr<const Patient>& patient, const Probe& probe) {
  FormationOptions formation;
  formation.depth_mm = kConfidenceDepth_mm;
  formation.penumbra = false;  // between shadow and sight there is nothing to judge by
  const auto recorded = makeVirtualScanner(patient, probe, formation, 1);
  formation.noise_db = -300.0;
  formation.tgc = {{0.0, 0.0}};
  const auto lossy = makeVirtualScanner(patient, probe, formation, 1);
  formation.attenuation = false;
  const auto lossless = makeVirtualScanner(patient, probe, formation, 1);
  for (const auto* scanner : {&recorded, &lossy, &lossless})
    if (!*scanner) return passOn(scanner->error());
  const Transform<frame::World, frame::Probe> pose{glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 2.0, elevation_mm))};
  VirtualFrame view;
  compressEnvelope(envelopeOf(**recorded, pose), formation.dynamicRange_db, view.levels);
  const Image<float> with = envelopeOf(**lossy, pose), without = envelopeOf(**lossless, pose);
  for (int s = 0; s + kSamples <= view.levels.height; s += kSamples)
    for (int l = 0; l + kLines <= view.levels.width; l += kLines) {
      const double depth_mm = (*recorded)->grid().depth_mm(s + 0.5 * kSamples);
      const double whole = powerOf(without, l, s), even_db = 2.0 * 0.5 * probe.carrier_hz * 1e-6 * depth_mm / 10.0;
      const double excess_db = 10.0 * std::log10(whole / std::max(1e-300, powerOf(with, l, s))) - even_db;
      const bool judged = whole > 1e-12 && depth_mm > 30.0 && depth_mm < kConfidenceDepth_mm - 5.0;
      view.blocks.push_back(!judged                  ? Seen::undecided
                            : excess_db > kShadow_db ? Seen::inShadow
                            : excess_db < kSight_db  ? Seen::inSight
                                                     : Seen::undecided);
    }
  return view;
}

struct Judge {
  std::vector<float> inSight, inShadow;

  void take(const VirtualFrame& view, const Image<float>& confidence) {
    std::size_t block = 0;
    for (int s = 0; s + kSamples <= view.levels.height; s += kSamples)
      for (int l = 0; l + kLines <= view.levels.width; l += kLines) {
        const Seen seen = view.blocks[block++];
        if (seen == Seen::undecided) continue;
        float sum = 0.0F;
        for (int v = s; v < s + kSamples; ++v)
          for (int u = l; u < l + kLines; ++u) sum += viewOf(confidence).at(u, v);
        (seen == Seen::inSight ? inSight : inShadow).push_back(sum / (kLines * kSamples));
      }
  }
  [[nodiscard]] double areaUnderCurve() {
    std::sort(inSight.begin(), inSight.end());
    double pairs = 0.0;
    for (const float shadowed : inShadow) {
      const auto [from, to] = std::equal_range(inSight.begin(), inSight.end(), shadowed);
      pairs += static_cast<double>(inSight.end() - to) + 0.5 * static_cast<double>(to - from);
    }
    return pairs / std::max(1.0, static_cast<double>(inSight.size()) * static_cast<double>(inShadow.size()));
  }
};

double meanOf(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value);
  return sum / std::max(1.0, static_cast<double>(values.size()));
}

struct Way {
  ConfidenceOptions options;
  std::vector<double> cpu_us;  ///< a frame
  ConfidenceScratch scratch;
};

std::vector<Way> ways() {
  std::vector<Way> all;
  all.push_back({{.method = ConfidenceMethod::beamwise}, {}, {}});
  const ConfidenceOptions usual;
  for (const auto& [lines, samples] : {std::pair{24, 32}, {48, 64}, {usual.lines, usual.samples}, {128, 192}, {192, 256}})
    all.push_back({{.method = ConfidenceMethod::randomWalk, .lines = lines, .samples = samples}, {}, {}});
  return all;
}

}  // namespace

Result<json> benchConfidence(const ReconstructBenchOptions& options, Progress& progress) {
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const auto patient = blockWithStones();
  if (!patient) return passOn(patient.error());
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">()); };
  json rows = json::array();
  double done = 0.0;
  const double steps = 2.0 * (options.views + options.repetitions);
  for (const char* id : {"linear-7.5", "convex-3.5"}) {
    const auto probe = readProbe(*resources / "probes" / (std::string(id) + ".json"));
    if (!probe) return passOn(probe.error());
    std::vector<VirtualFrame> views;
    for (int n = 0; n < options.views; ++n) {
      progress.report(say<"Forming virtual frames with known shadows">(), done++ / steps);
      if (progress.cancelRequested()) return stopped();
      auto view = viewAt(8.0 * (n - 0.5 * (options.views - 1)), *patient, *probe);  // beyond the slice's thickness: other speckle
      if (!view) return passOn(view.error());
      views.push_back(*std::move(view));
    }
    std::vector<Way> tried = ways();
    std::vector<Judge> judges(tried.size());
    std::vector<std::size_t> order(tried.size());
    for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
    std::mt19937 random(7);
    Image<float> confidence;
    for (int repetition = 0; repetition < options.repetitions; ++repetition) {
      progress.report(say<"Timing confidence maps">(), done++ / steps);
      std::shuffle(order.begin(), order.end(), random);
      for (const std::size_t n : order)
        for (const VirtualFrame& view : views) {
          if (progress.cancelRequested()) return stopped();
          const double start_s = threadTime_s();
          const auto mapped = confidenceOfLines(viewOf(view.levels), tried[n].options, tried[n].scratch, confidence);
          tried[n].cpu_us.push_back(1e6 * (threadTime_s() - start_s));
          if (!mapped) return passOn(mapped.error());
          if (repetition == 0) judges[n].take(view, confidence);
        }
    }
    for (std::size_t n = 0; n < tried.size(); ++n) {
      const ConfidenceOptions& used = tried[n].options;
      const bool walks = used.method == ConfidenceMethod::randomWalk;
      const std::string method = walks ? "random walk " + std::to_string(used.lines) + " x " + std::to_string(used.samples) : "beam-wise";
      rows.push_back({{"name", "confidence_" + std::string(id) + "/" + method},
                      {"probe", probe->name},
                      {"method", walks ? "randomwalk" : "beamwise"},
                      {"lines", walks ? used.lines : 0},
                      {"samples", walks ? used.samples : 0},
                      {"median_us", medianOf(tried[n].cpu_us)},
                      {"area_under_curve", judges[n].areaUnderCurve()},
                      {"mean_in_shadow", meanOf(judges[n].inShadow)},
                      {"mean_in_sight", meanOf(judges[n].inSight)}});
    }
  }
  return rows;
}

}  // namespace ew
