#include "ew/io/kretz.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <new>
#include <numbers>

#include "dicom/dicom_fields.h"
#include "ew/core/figures.h"
#include "ew/core/numbers.h"
#include "ew/core/parallel.h"
#include "files/grey_samples.h"
#include "files/image_header.h"

namespace ew {
namespace {
using namespace detail;
namespace fs = std::filesystem;

constexpr std::string_view kMagic = "KRETZFILE 1.0   ";

/// Items of the file by group and element.
using Items = std::map<std::uint32_t, Bytes>;

template <class T>
T little(Bytes bytes, std::size_t at) {
  std::array<std::uint8_t, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes.data() + at, sizeof(T));
  if (std::endian::native == std::endian::big) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

Result<Items> itemsOf(Bytes file, const fs::path& name) {
  Items items;
  std::size_t at = kMagic.size();
  while (file.size() - at >= 8) {
    const std::uint32_t group = little<std::uint16_t>(file, at), element = little<std::uint16_t>(file, at + 2);
    const std::size_t length = little<std::uint32_t>(file, at + 4);
    at += 8;
    if (group == 0xFFFFu && element == 0xFFFFu) return items;
    if (length > file.size() - at)
      return failure(ErrorCode::truncated,
                     say<"%1 is too short: an item of %2 bytes has %3; get the file again.">(quoted(name), length, file.size() - at),
                     {{"file", name.string()}});
    items.try_emplace(group << 16 | element, file.subspan(at, length));
    at += length;
  }
  return items;
}

class Reader {
 public:
  Reader(const fs::path& file, Items items) : file_(file), items_(std::move(items)) {}

  [[nodiscard]] bool has(std::uint32_t tag) const { return items_.contains(tag); }
  [[nodiscard]] Bytes bytes(std::uint32_t tag) const {
    const auto found = items_.find(tag);
    return found == items_.end() ? Bytes() : found->second;
  }
  [[nodiscard]] std::vector<double> doubles(std::uint32_t tag) const {
    const Bytes all = bytes(tag);
    std::vector<double> values;
    for (std::size_t at = 0; at + 8 <= all.size(); at += 8) values.push_back(little<double>(all, at));
    return values;
  }
  [[nodiscard]] Result<double> number(std::uint32_t tag, const Message& name, double lowest, double highest) const {
    const auto values = doubles(tag);
    if (values.empty() || !(values[0] >= lowest && values[0] <= highest))
      return badField(file_, name, values.empty() ? say<"nothing">() : verbatim(textOf(values[0])),
                      say<"a number from %1 to %2">(textOf(lowest), textOf(highest)));
    return values[0];
  }
  [[nodiscard]] Result<int> count(std::uint32_t tag, const Message& name) const {
    const Bytes all = bytes(tag);
    const int value = all.size() < 2 ? 0 : little<std::uint16_t>(all, 0);
    if (value < 1) return badField(file_, name, all.size() < 2 ? say<"nothing">() : verbatim("0"), say<"a whole number above 0">());
    return value;
  }
  [[nodiscard]] const Items& items() const { return items_; }

 private:
  const fs::path& file_;
  Items items_;
};

/// The sampled region: beams (fastest along the beam, then across beams, then across planes).
struct Torus {
  glm::ivec3 counts{0};
  double step_mm = 0.0;
  double start_mm = 0.0;
  double axisDepth_mm = 0.0;
  std::vector<double> theta_rad;  ///< from the middle, ascending or descending
  std::vector<double> phi_rad;
  Bytes samples;
};

/// A table of angles, and where a value lies in it.
class AngleTable {
 public:
  explicit AngleTable(const std::vector<double>& angles) : angles_(angles), rises_(angles.size() < 2 || angles.back() > angles.front()) {}
  /// Fractional index; NaN outside.
  [[nodiscard]] double indexOf(double angle) const {
    const std::size_t last = angles_.size() - 1;
    const auto less = [&](double a, double b) { return rises_ ? a < b : b < a; };
    if (less(angle, angles_.front()) || less(angles_.back(), angle)) return std::numeric_limits<double>::quiet_NaN();
    const auto above = static_cast<std::size_t>(std::lower_bound(angles_.begin(), angles_.end(), angle, less) - angles_.begin());
    if (above == 0) return 0.0;
    if (above > last) return static_cast<double>(last);
    return static_cast<double>(above - 1) + (angle - angles_[above - 1]) / (angles_[above] - angles_[above - 1]);
  }

 private:
  const std::vector<double>& angles_;
  bool rises_;
};

/// Which angles of the file: of the beams in a plane, or of the planes.
enum class Fan { beams, planes };

Message soleAngle(bool ofBeams, const std::string& off_deg) {
  return ofBeams ? say<"Of the beam angles (C300/0002) there is one alone, %1 degrees off; it was laid straight ahead.">(off_deg)
                 : say<"Of the plane angles (C300/0001) there is one alone, %1 degrees off; it was laid straight ahead.">(off_deg);
}

Message unevenAngles(bool ofBeams, const std::string& off_deg) {
  return ofBeams ? say<"The beam angles (C300/0002) are not the same on both sides (%1 degrees off); straight ahead is pi / 2 here, other "
                       "readers take the middle of the table.">(off_deg)
                 : say<"The plane angles (C300/0001) are not the same on both sides (%1 degrees off); straight ahead is pi / 2 here, other "
                       "readers take the middle of the table.">(off_deg);
}

/// From straight ahead, in radians.
Result<std::vector<double>> anglesOf(const Reader& in, const fs::path& file, Fan fan, int wanted, std::vector<Message>& notes) {
  const bool ofBeams = fan == Fan::beams;
  const std::uint32_t tag = ofBeams ? 0xC3000002u : 0xC3000001u;
  const Message name = ofBeams ? say<"beam angles (C300/0002)">() : say<"plane angles (C300/0001)">();
  std::vector<double> angles = in.doubles(tag);
  if (angles.size() != static_cast<std::size_t>(wanted))
    return badField(file, name, say<"%1 angles">(angles.size()), say<"%1, one a sample of that axis">(wanted));
  constexpr double right_rad = std::numbers::pi / 2.0;
  bool rises = true, falls = true;
  for (std::size_t n = 0; n < angles.size(); ++n) {
    angles[n] -= right_rad;
    if (!(std::abs(angles[n]) < 1.55))
      return badField(file, name, verbatim(textOf(angles[n] + right_rad)), say<"angles within 89 degrees of pi / 2">());
    if (n > 0) {
      rises = rises && angles[n] > angles[n - 1];
      falls = falls && angles[n] < angles[n - 1];
    }
  }
  if (!rises && !falls) return badField(file, name, say<"angles that go to and fro">(), say<"angles that rise or fall throughout">());
  if (angles.size() == 1) {
    // One beam or plane has no width: no voxel but those straight ahead would ever lie in it.
    if (std::abs(angles.front()) > 1e-6) notes.push_back(soleAngle(ofBeams, textOf(angles.front() * 180.0 / std::numbers::pi)));
    angles.front() = 0.0;
    return angles;
  }
  const double off_deg = (angles.front() + angles.back()) * 90.0 / std::numbers::pi;
  if (std::abs(off_deg) > 0.1) notes.push_back(unevenAngles(ofBeams, textOf(std::round(off_deg * 100.0) / 100.0)));
  return angles;
}

glm::dvec3 placeOf(const Torus& torus, double r_mm, double theta_rad, double phi_rad, double hand) {
  const double depth_mm = r_mm * std::cos(theta_rad), R_mm = torus.axisDepth_mm;
  return {r_mm * std::sin(theta_rad), R_mm * (1.0 - std::cos(phi_rad)) + depth_mm * std::cos(phi_rad),
          hand * (depth_mm - R_mm) * std::sin(phi_rad)};
}

Result<Grid> gridOf(const Torus& torus, double spacing_mm, double hand, const fs::path& file, const ReaderLimits& limits) {
  glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-std::numeric_limits<double>::infinity());
  const double end_mm = torus.start_mm + torus.step_mm * (torus.counts.x - 1);
  auto thetas = torus.theta_rad, phis = torus.phi_rad;
  // The box touches the region at its ends or straight ahead.
  for (auto* const angles : {&thetas, &phis})
    if (angles->front() * angles->back() < 0.0) angles->push_back(0.0);
  for (const double theta : thetas)
    for (const double phi : phis)
      for (const double r : {torus.start_mm, end_mm}) {
        const glm::dvec3 p = placeOf(torus, r, theta, phi, hand);
        lowest = glm::min(lowest, p);
        highest = glm::max(highest, p);
      }
  Grid grid;
  grid.spacing_mm = glm::dvec3(spacing_mm);
  double voxels = 1.0;
  std::array<double, 3> sizes{};
  for (int axis = 0; axis < 3; ++axis) {
    sizes[static_cast<std::size_t>(axis)] = std::ceil((highest[axis] - lowest[axis]) / spacing_mm - 1e-9) + 1.0;
    voxels *= sizes[static_cast<std::size_t>(axis)];
  }
  if (!(2.0 * voxels <= static_cast<double>(limits.maxBytes)) || *std::max_element(sizes.begin(), sizes.end()) > 1e9)
    return failure(ErrorCode::tooLarge,
                   say<"At %1 mm the volume of %2 would need %3 bytes of memory, but the limit is %4; choose a coarser spacing.">(
                       figureText(spacing_mm), quoted(file), figureText(std::round(2.0 * voxels)), limits.maxBytes),
                   {{"file", file.string()}, {"ask", "spacing"}});
  for (int axis = 0; axis < 3; ++axis) grid.dims[axis] = static_cast<int>(sizes[static_cast<std::size_t>(axis)]);
  grid.origin_mm = lowest;
  if (auto usable = checkGrid(grid); !usable) return passOn(usable.error());
  return grid;
}

Result<Volume> converted(const Torus& torus, const Grid& grid, double hand, int threads, const fs::path& file, Progress& progress) {
  Volume volume;
  volume.grid = grid;
  volume.echo.resize(grid.voxelCount());
  volume.coverage.resize(grid.voxelCount());
  const AngleTable theta(torus.theta_rad), phi(torus.phi_rad);
  const glm::ivec3 n = torus.counts;
  const auto strideJ = static_cast<std::size_t>(n.x), strideK = strideJ * static_cast<std::size_t>(n.y);
  const auto level = [&](double i, double j, double k) {
    const int i0 = std::min(static_cast<int>(i), std::max(0, n.x - 2)), j0 = std::min(static_cast<int>(j), std::max(0, n.y - 2)),
              k0 = std::min(static_cast<int>(k), std::max(0, n.z - 2));
    const double fi = i - i0, fj = j - j0, fk = k - k0;
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const int ci = std::min(i0 + (corner & 1), n.x - 1), cj = std::min(j0 + (corner >> 1 & 1), n.y - 1),
                ck = std::min(k0 + (corner >> 2), n.z - 1);
      const double weight = ((corner & 1) != 0 ? fi : 1.0 - fi) * ((corner & 2) != 0 ? fj : 1.0 - fj) * ((corner & 4) != 0 ? fk : 1.0 - fk);
      sum += weight *
             torus.samples[static_cast<std::size_t>(ck) * strideK + static_cast<std::size_t>(cj) * strideJ + static_cast<std::size_t>(ci)];
    }
    return sum;
  };
  const auto slice = [&](int kOut) {
    const double z = hand * (grid.origin_mm.z + kOut * grid.spacing_mm.z);
    for (int jOut = 0; jOut < grid.dims.y; ++jOut) {
      const double y = grid.origin_mm.y + jOut * grid.spacing_mm.y;
      const double fromAxis_mm = std::hypot(z, y - torus.axisDepth_mm), at = phi.indexOf(std::atan2(z, y - torus.axisDepth_mm));
      if (std::isnan(at)) continue;
      const double depth_mm = torus.axisDepth_mm + fromAxis_mm;
      for (int iOut = 0; iOut < grid.dims.x; ++iOut) {
        const double x = grid.origin_mm.x + iOut * grid.spacing_mm.x;
        const double r = (std::hypot(x, depth_mm) - torus.start_mm) / torus.step_mm;
        const double across = theta.indexOf(std::atan2(x, depth_mm));
        if (!(r >= 0.0) || r > n.x - 1 || std::isnan(across)) continue;
        const std::size_t index = grid.indexOf(iOut, jOut, kOut);
        volume.echo[index] = static_cast<std::uint8_t>(std::lround(level(r, across, at)));
        volume.coverage[index] = static_cast<std::uint8_t>(Coverage::measured);
      }
    }
  };
  if (!forEachTask(grid.dims.z, threads, progress, say<"Converting beams">(), slice)) return stopped(file);
  return volume;
}

Result<Bytes> samplesOf(const Reader& in, const fs::path& file, const glm::ivec3& counts, const KretzOptions& options,
                        std::vector<Message>& notes) {
  const std::size_t wanted = samplesIn(counts);
  for (const std::uint32_t packed : {0x00021000u, 0x00021100u, 0x00021200u})
    if (in.has(packed))
      return failure(
          ErrorCode::unsupported,
          say<"%1 is a Kretz file with wavelet compression, which is not published; export it uncompressed, or as Cartesian volume.">(
              quoted(file)),
          {{"file", file.string()}});
  const Bytes one = in.bytes(0xD0000001u), several = in.bytes(0xD6000001u);
  if (one.empty() && several.empty())
    return failure(
        ErrorCode::unsupported,
        say<"%1 is a Kretz file without an uncompressed grey volume; export it uncompressed, or as Cartesian volume.">(quoted(file)),
        {{"file", file.string()}});
  const std::size_t steps = several.size() / wanted;
  if (!several.empty() && (one.empty() || options.timeStep)) {
    if (steps < 1 || several.size() % wanted != 0)
      return badField(file, verbatim("D600/0001"), say<"%1 bytes">(several.size()), say<"a multiple of %1">(wanted));
    if (steps > 1 && !options.timeStep)
      return failure(ErrorCode::missingCalibration,
                     say<"%1 holds %2 volumes one after the other; choose one by its number, 1 to %3.">(quoted(file), steps, steps),
                     {{"file", file.string()}, {"ask", "time-step"}, {"steps", std::to_string(steps)}});
    const int step = options.timeStep.value_or(1);
    if (step < 1 || static_cast<std::size_t>(step) > steps)
      return failure(ErrorCode::badUsage, say<"%1 holds %2 volumes, no number %3; choose one that is there.">(quoted(file), steps, step),
                     {{"file", file.string()}, {"ask", "time-step"}});
    if (steps > 1) notes.push_back(say<"Volume %1 of %2 was read.">(step, steps));
    return several.subspan((static_cast<std::size_t>(step) - 1) * wanted, wanted);
  }
  if (!several.empty()) notes.push_back(say<"The file also holds %1 volumes over time; its still one was read.">(steps));
  if (one.size() != wanted)
    return failure(one.size() < wanted ? ErrorCode::truncated : ErrorCode::badHeader,
                   say<"%1 promises %2 samples and holds %3; get the file again.">(quoted(file), wanted, one.size()),
                   {{"file", file.string()}, {"promised", std::to_string(wanted)}, {"found", std::to_string(one.size())}});
  return one;
}

Message conversionNote(bool mirrored, const std::string& spacing_mm) {
  return joined({mirrored ? say<"The beams were converted to voxels of %1 mm: x lateral, y away from the probe, z against x cross y, from "
                                "the centre of the beams' arc.">(spacing_mm)
                          : say<"The beams were converted to voxels of %1 mm: x lateral, y away from the probe, z along x cross y, from "
                                "the centre of the beams' arc.">(spacing_mm),
                 say<"Readers of this format disagree about the side of z; if left and right planes are swapped, import it mirrored.">()});
}

Result<KretzVolume> readBytes(Bytes bytes, const fs::path& file, const KretzOptions& options, Progress& progress,
                              const ReaderLimits& limits) {
  if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
    return failure(ErrorCode::badHeader, say<"%1 is not a Kretz file; check what kind of file it is.">(quoted(file)),
                   {{"file", file.string()}});
  auto items = itemsOf(bytes, file);
  if (!items) return passOn(items.error());
  const Reader in(file, *std::move(items));
  KretzVolume made;
  for (const auto& [tag, value] : in.items()) {
    const std::uint32_t group = tag >> 16;
    if (value.empty() || (group != 0x0110u && group != 0x0120u && group != 0x0130u && group != 0x0140u)) continue;
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "(%04X,%04X)", group, tag & 0xFFFFu);
    made.removed.fields.push_back(tag == 0x01100002u ? say<"%1 patient text">(std::string(name.data()))
                                                     : say<"%1 text of the examination">(std::string(name.data())));
  }
  Torus torus;
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = in.count(0xC0000001u + static_cast<std::uint32_t>(axis), axis == 0   ? say<"samples along a beam (C000/0001)">()
                                                                                : axis == 1 ? say<"beams (C000/0002)">()
                                                                                            : say<"planes (C000/0003)">());
    if (!count) return passOn(count.error());
    torus.counts[axis] = *count;
  }
  const auto samples = samplesOf(in, file, torus.counts, options, made.notes);
  if (!samples) return passOn(samples.error());
  torus.samples = *samples;
  if (in.has(0xD0000101u) || in.has(0xD0000201u))
    made.notes.push_back(say<"The file also holds a colour or power Doppler volume, which was left out.">());
  const auto step_m = in.number(0xC1000001u, say<"distance of samples (C100/0001)">(), 1e-6, 0.1);
  const bool beams = in.has(0xC3000001u) || in.has(0xC3000002u);
  if (!beams) {
    // Cartesian files have the same step along every axis.
    if (!step_m) return passOn(step_m.error());
    made.volume.grid.dims = torus.counts;
    made.volume.grid.spacing_mm = glm::dvec3(*step_m * 1000.0);
    if (auto usable = checkGrid(made.volume.grid); !usable) return passOn(usable.error());
    made.volume.echo.assign(torus.samples.begin(), torus.samples.end());
    made.notes.push_back(say<"The volume is Cartesian already, %1 mm in every direction; its origin is its first voxel, and which way it "
                             "lies in the patient is not in the file.">(textOf(*step_m * 1000.0)));
    return made;
  }
  if (!step_m) return passOn(step_m.error());
  const auto start_steps = in.number(0xC2000001u, say<"radius of the first sample (C200/0001)">(), 0.0, 1e6);
  if (!start_steps) return passOn(start_steps.error());
  const auto axis_steps = in.number(0xC2000002u, say<"radius of the planes (C200/0002)">(), -1e6, 1e6);
  if (!axis_steps) return passOn(axis_steps.error());
  auto theta = anglesOf(in, file, Fan::beams, torus.counts.y, made.notes);
  if (!theta) return passOn(theta.error());
  auto phi = anglesOf(in, file, Fan::planes, torus.counts.z, made.notes);
  if (!phi) return passOn(phi.error());
  torus.step_mm = *step_m * 1000.0;
  torus.start_mm = *start_steps * torus.step_mm;
  torus.axisDepth_mm = -*axis_steps * torus.step_mm;
  torus.theta_rad = *std::move(theta);
  torus.phi_rad = *std::move(phi);
  const double steepest = std::max(std::abs(torus.theta_rad.front()), std::abs(torus.theta_rad.back()));
  if (!(torus.start_mm * std::cos(steepest) > torus.axisDepth_mm))
    return badField(file, verbatim("C200/0002"), verbatim(textOf(*axis_steps)),
                    say<"an axis of the planes that lies behind the first samples">());
  if (options.spacing_mm != 0.0 && !(options.spacing_mm > 1e-3 && options.spacing_mm < 1e3))
    return failure(ErrorCode::badUsage, say<"The spacing must lie between 0.001 and 1000 mm.">(), {{"ask", "spacing"}});
  const double spacing_mm = options.spacing_mm > 0.0 ? options.spacing_mm : torus.step_mm;
  const double hand = options.mirrored ? -1.0 : 1.0;
  const auto grid = gridOf(torus, spacing_mm, hand, file, limits);
  if (!grid) return passOn(grid.error());
  auto volume = converted(torus, *grid, hand, options.threads, file, progress);
  if (!volume) return passOn(volume.error());
  made.volume = *std::move(volume);
  made.notes.push_back(conversionNote(options.mirrored, figureText(spacing_mm)));
  made.notes.push_back(say<"The layout of Kretz files is not published by its maker; distances are as good as what is known of it.">());
  return made;
}

}  // namespace

bool isKretz(const fs::path& file) {
  if (!checkIsFile(file)) return false;
  std::ifstream in(file, std::ios::binary);
  std::array<char, kMagic.size()> beginning{};
  in.read(beginning.data(), beginning.size());
  return in && std::string_view(beginning.data(), beginning.size()) == kMagic;
}

Result<KretzVolume> readKretz(const fs::path& file, const KretzOptions& options, Progress& progress, const ReaderLimits& limits) try {
  if (const auto status = checkIsFile(file); !status) return passOn(status.error());
  if (!isKretz(file) && isDicom(file)) {
    const auto dicom = readDicomFile(file, limits.maxBytes, progress);
    if (!dicom) return passOn(dicom.error());
    const Bytes inside = kretzInside(dicom->data);
    if (inside.empty())
      return failure(ErrorCode::unsupported, say<"%1 is a DICOM file without a Kretz volume in it; import it as images.">(quoted(file)),
                     {{"file", file.string()}});
    auto made = readBytes(inside, file, options, progress, limits);
    if (!made) return made;
    Removed outer = identifyingFields(dicom->data);
    outer.fields.insert(outer.fields.end(), made->removed.fields.begin(), made->removed.fields.end());
    made->removed = std::move(outer);
    return made;
  }
  const auto bytes = readWholeFile(file, limits.maxBytes);
  if (!bytes) return passOn(bytes.error());
  return readBytes(*bytes, file, options, progress, limits);
} catch (const std::bad_alloc&) {
  return failure(ErrorCode::tooLarge, say<"There is not enough memory for %1; close other programs.">(quoted(file)),
                 {{"file", file.string()}});
}

}  // namespace ew
