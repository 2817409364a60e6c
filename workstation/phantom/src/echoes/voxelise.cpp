#include <cmath>
#include <cstring>
#include <new>
#include <span>
#include <stdexcept>
#include <type_traits>

#include "echoes/echo_levels.h"
#include "echoes/reflecting_surfaces.h"
#include "echoes/tissue_painter.h"
#include "echoes/voxelise_problems.h"
#include "ew/core/large_pages.h"
#include "ew/core/parallel.h"
#include "ew/phantom/speckle.h"
#include "ew/phantom/voxel_pieces.h"
#include "patient/anatomy.h"

namespace ew {
namespace {

using phantom::Organ;

constexpr int kBlock = phantom::kPaintedBlock;
constexpr int kStrip = 48;  // rows of a piece of work: small enough to be cancelled within 0.1 s, large enough for the speckle's margin
constexpr double kLevelsPerDecibel = 255.0 / 60.0;  // 60 dB of dynamic range over the grey scale
constexpr double kMeanDecibel = -2.507;             // of the power of speckle: 10 log10(e^-gamma)
constexpr double kDeepestNull_db = -18.0;           // speckle nulls go to -infinity dB; a screen shows none below this
constexpr double kBorderSpeckle = 0.5;              // a reflecting surface is rough: part of its echo is still speckle
constexpr double kScattered = 0.18;                 // what a glinting surface still sends back when the beam grazes it
constexpr std::uint64_t kTextureSeed = 0x7465787475726521ull;

/// What one point sends back before speckle: mean grey level, how much speckle, and the strongest border.
struct Look {
  double level = 0.0;
  double speckle = 0.0;
  double borderLevel = 0.0;
  double borderWeight = 0.0;
};

class Painter {
 public:
  Painter(const Patient& patient, const VoxeliseOptions& options) : patient_(patient), options_(options) {}

  /// @param near, distances_mm as OrganFinder has them
  [[nodiscard]] Look lookAt(const glm::dvec3& p_mm, double skin_mm, const std::vector<const Organ*>& near,
                            const std::vector<double>& distances_mm) const {
    Look look;
    double remaining = 1.0;
    for (std::size_t n = 0; n < distances_mm.size(); ++n) {
      const Organ& organ = *near[n];
      if (organ.border) addBorder(organ, p_mm, distances_mm[n], remaining, look);
      const double part = phantom::partInside(distances_mm[n], options_.spacing_mm);
      if (part <= 0.0) continue;
      addTissue(patient_.tissues[organ.tissue], organ.tissue, p_mm, skin_mm, remaining * part, look);
      remaining *= 1.0 - part;
      if (remaining < phantom::kNothingLeft) return look;
    }
    addTissue(patient_.tissues[patient_.backgroundTissue], patient_.backgroundTissue, p_mm, skin_mm, remaining, look);
    return look;
  }

  [[nodiscard]] std::uint8_t greyOf(const Look& look, double speckle_db, const glm::dvec3& p_mm) const {
    const double swing = kLevelsPerDecibel * (std::max(speckle_db, kDeepestNull_db) - kMeanDecibel);
    double grey = look.level + look.speckle * swing;
    if (look.borderWeight > 0.0) {
      const double uneven = 0.82 + 0.18 * valueNoise(options_.seed ^ kTextureSeed, p_mm / 9.0);
      const double border = look.borderLevel * uneven + kBorderSpeckle * swing;
      if (border > grey) grey += look.borderWeight * (border - grey);
    }
    return static_cast<std::uint8_t>(std::clamp(grey + 0.5, 0.0, 255.0));
  }

 private:
  void addTissue(const Tissue& tissue, std::size_t number, const glm::dvec3& p_mm, double skin_mm, double weight, Look& look) const {
    double level = tissue.echoLevel;
    if (tissue.texture.level > 0.0) {
      const glm::dvec3 place(p_mm.x, tissue.texture.followsTheSkin ? skin_mm : p_mm.y, p_mm.z);
      level += tissue.texture.level * valueNoise(options_.seed + kTextureSeed * (number + 1), place / tissue.texture.scale_mm);
    }
    look.level += weight * level;
    look.speckle += weight * tissue.speckle;
  }

  void addBorder(const Organ& organ, const glm::dvec3& p_mm, double d, double remaining, Look& look) const {
    const double t = d / organ.border->width_mm;
    if (t * t >= 1.0) return;
    double weight = remaining * (1.0 - t * t) * (1.0 - t * t);
    if (organ.border->shine != phantom::Shine::allRound) {
      constexpr double kStep_mm = 0.5;
      glm::dvec3 normal;
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = kStep_mm;
        normal[axis] = organ.shape->distance_mm(p_mm + step) - d;
      }
      const glm::dvec3 towardsProbe(p_mm.x - patient_.beamAxis_mm.x, p_mm.y - patient_.beamAxis_mm.y, 0.0);
      const double lengths = std::sqrt(glm::dot(normal, normal) * glm::dot(towardsProbe, towardsProbe));
      const double square = lengths > 0.0 ? glm::dot(normal, towardsProbe) / lengths : 0.0;
      if (organ.border->shine == phantom::Shine::front)
        weight *= std::max(0.0, square);
      else
        weight *= kScattered + (1.0 - kScattered) * square * square;
    }
    if (weight * organ.border->echoLevel <= look.borderWeight * look.borderLevel) return;
    look.borderWeight = weight;
    look.borderLevel = organ.border->echoLevel;
  }

  const Patient& patient_;
  const VoxeliseOptions& options_;
};

/// Fills a volume piece by piece: strips of a slab, cut into blocks for which only the organs nearby are asked.
class VolumePainter {
 public:
  VolumePainter(const Patient& patient, const VoxeliseOptions& options, const Progress& progress, VoxelPatient& made)
      : patient_(patient),
        options_(options),
        progress_(progress),
        made_(made),
        grid_(made.volume.grid),
        finder_(patient, options.spacing_mm),
        painter_(patient, options),
        maps_(patient, options.spacing_mm),
        strips_((grid_.dims.y + kStrip - 1) / kStrip) {
    if (made.maps) feetOfPiece_.resize(static_cast<std::size_t>(pieces()));
  }

  [[nodiscard]] int pieces() const { return (grid_.dims.z + kBlock - 1) / kBlock * strips_; }
  void paintPiece(int piece);
  /// The pieces that an earlier run has not left.
  [[nodiscard]] std::vector<int> missingPieces();
  /// Of the surfaces, once all pieces are painted. @return false when cancelled
  [[nodiscard]] bool spread(Progress& progress) {
    return spreadSurfaces(maps_.surfaces(), feetOfPiece_, options_.threads, progress, *made_.maps);
  }
  [[nodiscard]] bool outOfMemory() const { return outOfMemory_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  /// Speckle of a strip of a slab.
  struct Strip {
    glm::ivec3 first;
    glm::ivec3 size;
    std::vector<float> power{};
    [[nodiscard]] const float* at(const glm::ivec3& voxel) const {
      const glm::ivec3 in = voxel - first;
      return power.data() + sampleIndex(size, in.x, in.y, in.z);
    }
  };
  [[nodiscard]] Strip stripOf(int piece) const;
  /// Calls `row` with every row of voxels of a piece in each of the volumes that are painted.
  template <class Row>
  void forRowsOf(int piece, const Row& row);
  [[nodiscard]] bool recall(int piece, std::vector<std::uint8_t>& bytes);
  void keep(int piece, const std::vector<phantom::SurfaceFoot>& feet);

  /// What is known around a block or voxel at hand.
  struct Around {
    std::vector<const Organ*> near{};
    std::vector<double> distances_mm{};
    std::vector<phantom::SurfaceFoot> feet{};  ///< of the piece
  };
  void paintBlock(const glm::ivec3& first, const Strip& strip, Around& around);
  void paintRow(int begin, int end, int j, int k, const float* speckle, Around& around);
  void map(const glm::ivec3& voxel, const glm::dvec3& p_mm, double skin_mm, Around& around);

  const Patient& patient_;
  const VoxeliseOptions& options_;
  const Progress& progress_;
  VoxelPatient& made_;
  const Grid& grid_;
  phantom::OrganFinder finder_;
  Painter painter_;
  phantom::TissuePainter maps_;
  std::vector<std::vector<phantom::SurfaceFoot>> feetOfPiece_{};
  Decibel decibel_;
  int strips_;  ///< of a slab
  std::atomic<bool> stopped_{false};
  std::atomic<bool> outOfMemory_{false};
};

VolumePainter::Strip VolumePainter::stripOf(int piece) const {
  Strip strip{.first = {0, (piece % strips_) * kStrip, (piece / strips_) * kBlock}, .size = {}};
  strip.size = glm::min(glm::ivec3(grid_.dims.x, kStrip, kBlock), grid_.dims - strip.first);
  return strip;
}

template <class Row>
void VolumePainter::forRowsOf(int piece, const Row& row) {
  const Strip strip = stripOf(piece);
  std::vector<std::uint8_t>* painted[] = {&made_.volume.echo, &made_.volume.coverage, &made_.labels,
                                          made_.maps ? &made_.maps->level : nullptr};
  for (std::vector<std::uint8_t>* values : painted) {
    if (values == nullptr) continue;
    for (int k = strip.first.z; k < strip.first.z + strip.size.z; ++k)
      for (int j = strip.first.y; j < strip.first.y + strip.size.y; ++j)
        row(std::span(values->data() + grid_.indexOf(0, j, k), static_cast<std::size_t>(grid_.dims.x)));
  }
}

bool VolumePainter::recall(int piece, std::vector<std::uint8_t>& bytes) {
  if (!options_.pieces->recall(piece, bytes)) return false;
  std::size_t voxels = 0;
  forRowsOf(piece, [&](std::span<std::uint8_t> row) { voxels += row.size(); });
  // How many feet there are stands at the end, so that what was cut off is not taken for less.
  constexpr std::size_t kFoot = sizeof(phantom::SurfaceFoot);
  std::uint64_t count = 0;
  if (bytes.size() < voxels + sizeof(count)) return false;
  std::memcpy(&count, bytes.data() + bytes.size() - sizeof(count), sizeof(count));
  if (count > (bytes.size() - voxels) / kFoot || bytes.size() != voxels + count * kFoot + sizeof(count)) return false;
  if (!made_.maps && count > 0) return false;
  const std::uint8_t* from = bytes.data();
  forRowsOf(piece, [&](std::span<std::uint8_t> row) {
    std::copy_n(from, row.size(), row.data());
    from += row.size();
  });
  if (!made_.maps) return true;
  auto& feet = feetOfPiece_[static_cast<std::size_t>(piece)];
  feet.resize(count);
  if (count > 0) std::memcpy(feet.data(), from, count * kFoot);
  return true;
}

void VolumePainter::keep(int piece, const std::vector<phantom::SurfaceFoot>& feet) {
  static_assert(std::is_trivially_copyable_v<phantom::SurfaceFoot>);
  std::vector<std::uint8_t> bytes;
  forRowsOf(piece, [&](std::span<std::uint8_t> row) { bytes.insert(bytes.end(), row.begin(), row.end()); });
  const std::size_t voxels = bytes.size();
  const std::uint64_t count = feet.size();
  const std::size_t feetBytes = feet.size() * sizeof(phantom::SurfaceFoot);
  bytes.resize(voxels + feetBytes + sizeof(count));
  if (count > 0) std::memcpy(bytes.data() + voxels, feet.data(), feetBytes);
  std::memcpy(bytes.data() + voxels + feetBytes, &count, sizeof(count));
  options_.pieces->keep(piece, bytes);
}

std::vector<int> VolumePainter::missingPieces() {
  std::vector<int> missing;
  std::vector<std::uint8_t> bytes;
  for (int piece = 0; piece < pieces(); ++piece)
    if (options_.pieces == nullptr || progress_.cancelRequested() || !recall(piece, bytes)) missing.push_back(piece);
  if (options_.pieces != nullptr) options_.pieces->recalled(1.0 - static_cast<double>(missing.size()) / pieces());
  return missing;
}

void VolumePainter::paintPiece(int piece) {
  Strip strip = stripOf(piece);
  Around around;
  try {
    SpeckleScratch scratch;
    specklePower(options_.seed, strip.first, strip.size, scratch, strip.power);
    around.near.reserve(patient_.organs.size());
    around.distances_mm.reserve(patient_.organs.size());
    for (int j = strip.first.y; j < strip.first.y + strip.size.y && !stopped_; j += kBlock) {
      for (int i = 0; i < grid_.dims.x && !stopped_; i += kBlock) paintBlock({i, j, strip.first.z}, strip, around);
      if (progress_.cancelRequested()) stopped_ = true;
    }
    around.feet.shrink_to_fit();
    if (options_.pieces != nullptr && !stopped_) keep(piece, around.feet);
  } catch (const std::bad_alloc&) {
    outOfMemory_ = true;
    stopped_ = true;
  }
  if (made_.maps) feetOfPiece_[static_cast<std::size_t>(piece)] = std::move(around.feet);
}

void VolumePainter::paintBlock(const glm::ivec3& first, const Strip& strip, Around& around) {
  const glm::ivec3 last = glm::min(first + kBlock, grid_.dims);
  const glm::dvec3 centre = phantom::blockCentre_mm(grid_, first, kBlock);
  if (finder_.isOutside(centre, kBlock, made_.maps.has_value())) return;
  finder_.select(centre, kBlock, around.near);
  for (int k = first.z; k < last.z; ++k) {
    for (int j = first.y; j < last.y; ++j) {
      if (stopped_) return;
      if (progress_.cancelRequested()) stopped_ = true;  // at every row: an anatomy may take a millisecond for a voxel
      paintRow(first.x, last.x, j, k, strip.at({first.x, j, k}), around);
    }
  }
}

void VolumePainter::paintRow(int begin, int end, int j, int k, const float* speckle, Around& around) {
  for (int i = begin; i < end; ++i, ++speckle) {
    const glm::dvec3 p = grid_.origin_mm + options_.spacing_mm * glm::dvec3(i, j, k);
    const double skin = patient_.skin->distance_mm(p);
    if (skin >= 0.0 && !(made_.maps && maps_.bodyPart(skin) > 0.0)) continue;
    const int label = finder_.distancesAt(p, around.near, around.distances_mm);
    if (made_.maps) map({i, j, k}, p, skin, around);
    if (skin >= 0.0) continue;
    const std::size_t at = grid_.indexOf(i, j, k);
    const Look look = painter_.lookAt(p, skin, around.near, around.distances_mm);
    made_.volume.echo[at] = painter_.greyOf(look, static_cast<double>(decibel_.of(*speckle)), p);
    made_.volume.coverage[at] = static_cast<std::uint8_t>(Coverage::measured);
    made_.labels[at] = static_cast<std::uint8_t>(label);
  }
}

void VolumePainter::map(const glm::ivec3& voxel, const glm::dvec3& p_mm, double skin_mm, Around& around) {
  made_.maps->level[grid_.indexOf(voxel.x, voxel.y, voxel.z)] = maps_.levelAt(p_mm, skin_mm, around.near, around.distances_mm);
  auto foot = maps_.surfaces().nearest(p_mm, skin_mm, around.near, around.distances_mm);
  if (!foot) return;
  foot->voxel = voxel;
  around.feet.push_back(*foot);
}

}  // namespace

Grid voxelGridOf(const Patient& patient, double spacing_mm) { return phantom::voxelGridOver(patient.box, spacing_mm); }

double voxeliseForecast_bytes(const Patient& patient, double spacing_mm, bool maps) {
  const Grid grid = voxelGridOf(patient, spacing_mm);
  const double slice = static_cast<double>(grid.dims.x) * grid.dims.y;
  const double perThread = static_cast<double>(grid.dims.x) * kStrip * (kBlock * 4.0 + (kBlock + 4.0) * 8.0 + 8.0);
  const double bytes = slice * grid.dims.z * 3.0 + perThread * threadCount(0);
  if (!maps) return bytes;
  return bytes + slice * grid.dims.z * (3.0 + phantom::kSurfaceBytesPerVoxel) + phantom::spreadForecast_bytes(grid, 0);
}

Result<VoxelPatient> voxelise(const Patient& patient, const VoxeliseOptions& options, Progress& progress) {
  if (auto usable = phantom::checkVoxelSpacing(options.spacing_mm); !usable) return passOn(usable.error());
  const double forecast = voxeliseForecast_bytes(patient, options.spacing_mm, options.maps);
  const auto tooLarge = [&] { return phantom::tooLargeAt(options.spacing_mm, options.maxBytes, forecast); };
  if (forecast > static_cast<double>(options.maxBytes)) return tooLarge();

  VoxelPatient made;
  Volume& volume = made.volume;
  volume.grid = voxelGridOf(patient, options.spacing_mm);
  if (const auto usable = checkGrid(volume.grid); !usable) return passOn(usable.error());
  if (options.maps) made.maps.emplace().grid = volume.grid;
  try {
    std::vector<std::vector<std::uint8_t>*> taken{&volume.echo, &volume.coverage, &made.labels};
    if (made.maps) taken.insert(taken.end(), {&made.maps->level, &made.maps->surfaceDistance, &made.maps->surfaceKind});
    for (std::vector<std::uint8_t>* values : taken)
      if (!growInLargePages(*values, volume.grid.voxelCount(), progress)) return phantom::stoppedByUser();

    VolumePainter painter(patient, options, progress, made);
    PartOfProgress painting(progress, 0.0, made.maps ? 0.9 : 1.0), spreading(progress, 0.9, 1.0);
    const std::vector<int> missing = painter.missingPieces();
    const bool finished = forEachTask(static_cast<int>(missing.size()), options.threads, painting, say<"Building the virtual patient">(),
                                      [&](int n) { painter.paintPiece(missing[static_cast<std::size_t>(n)]); });
    if (painter.outOfMemory()) return tooLarge();
    if (!finished || painter.stopped()) return phantom::stoppedByUser();
    if (made.maps && !painter.spread(spreading)) return phantom::stoppedByUser();
  } catch (const std::bad_alloc&) {
    return tooLarge();
  } catch (const std::length_error&) {
    return tooLarge();
  }
  return made;
}

}  // namespace ew
