#include "bench/volumes/bench_paper.h"

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "bench/tools/bench_parts.h"
#include "ew/core/order_statistics.h"
#include "ew/core/volume.h"
#include "ew/io/image_file.h"
#include "ew/io/safe_file.h"
#include "ew/phantom/virtual_scanner.h"
#include "ew/registration/elastic.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using registration::Elastic2dOptions;

constexpr double kPixel_mm = 0.4, kDepth_mm = 100.0, kWidth_mm = 100.0;
constexpr double kFrame_mm = 0.8;  ///< between frames of a sweep

/// Organs of many sizes and brightnesses in a block below y = 0; all reach through it along x, none straight.
constexpr const char* kPatient = R"({"format": 1, "name": "block with organs", "mannequin": "body.json",
  "box": {"lowest_mm": [-70, -5, -70], "highest_mm": [70, 115, 70]},
  "tissues": [
    {"name": "parenchyma", "echo_level": 125, "speckle": 1, "texture": {"level": 18, "scale_mm": [9, 6, 9]}},
    {"name": "bright", "echo_level": 165, "speckle": 1, "texture": {"level": 14, "scale_mm": [6, 4, 6]}},
    {"name": "dark", "echo_level": 85, "speckle": 1, "texture": {"level": 14, "scale_mm": [7, 5, 7]}},
    {"name": "blood", "echo_level": 15, "speckle": 0.6, "attenuation_db_per_cm_mhz": 0.2},
    {"name": "wall", "echo_level": 190, "speckle": 1}],
  "background": "parenchyma", "organs": [
    {"name": "vessel 1", "tissue": "blood", "shape": {"ellipsoid": {"centre_mm": [0, 34, -22], "radii_mm": [90, 5, 7]}}},
    {"name": "vessel 1 wall", "tissue": "wall", "shape": {"ellipsoid": {"centre_mm": [0, 34, -22], "radii_mm": [92, 6, 8]}}},
    {"name": "vessel 2", "tissue": "blood", "shape": {"ellipsoid": {"centre_mm": [0, 72, 6], "radii_mm": [80, 6, 5]}}},
    {"name": "vessel 3", "tissue": "blood", "shape": {"ellipsoid": {"centre_mm": [10, 52, 36], "radii_mm": [60, 4, 4]}}},
    {"name": "vessel 4", "tissue": "blood", "shape": {"ellipsoid": {"centre_mm": [-10, 84, -38], "radii_mm": [60, 5, 6]}}},
    {"name": "lobe", "tissue": "bright", "shape": {"ellipsoid": {"centre_mm": [5, 50, 2], "radii_mm": [45, 14, 19]}}},
    {"name": "lobe 2", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [-8, 28, 24], "radii_mm": [40, 11, 15]}}},
    {"name": "lobe 3", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [4, 76, -20], "radii_mm": [50, 12, 14]}}},
    {"name": "lobe 4", "tissue": "bright", "shape": {"ellipsoid": {"centre_mm": [0, 82, 34], "radii_mm": [50, 10, 14]}}},
    {"name": "fascia", "tissue": "wall", "shape": {"ellipsoid": {"centre_mm": [0, 12, 0], "radii_mm": [300, 1.2, 300]}}}]})";
constexpr const char* kBody =
    R"({"format": 1, "name": "block", "body": {"ellipsoid": {"centre_mm": [0, 2000, 0], "radii_mm": [2000, 2000, 2000]}}})";

/// Recipes are read from files; these are gone once they are read.
Result<std::shared_ptr<const Patient>> block() {
  std::error_code ignored;
  const fs::path folder = fs::temp_directory_path(ignored) / ("echoweave-paper-" + std::to_string(::getpid()));
  fs::create_directories(folder, ignored);
  auto written = writeFileSafely(folder / "body.json", kBody);
  if (written) written = writeFileSafely(folder / "patient.json", kPatient);
  auto patient = written ? readPatient(folder / "patient.json") : Result<std::shared_ptr<const Patient>>(passOn(written.error()));
  fs::remove_all(folder, ignored);
  return patient;
}

/// A linear probe as wide as the block's middle: one line a pixel.
Probe wideProbe() {
  Probe probe;
  probe.id = probe.name = "wide linear";
  probe.kind = ProbeKind::linear;
  probe.width_mm = kWidth_mm;
  probe.lines = static_cast<int>(kWidth_mm / kPixel_mm);
  probe.carrier_hz = 3.5e6;
  probe.aperture_mm = 20.0;
  probe.elevationalThickness_mm = 2.0;
  probe.elevationalFocus_mm = 50.0;
  probe.elevationalAperture_mm = 8.0;
  probe.nearField_mm = 1.0;
  probe.maxDepth_mm = probe.defaultDepth_mm = kDepth_mm;
  return probe;
}

/// Motion in the plane of the frames (y and z of the block), of the given peak.
class InPlaneWarp final : public Deformation {
 public:
  explicit InPlaneWarp(double peak_mm) : peak_mm_(peak_mm) {}
  [[nodiscard]] glm::dvec2 at(double z, double y) const {  // along z, along y
    constexpr double k = 2.0 * std::numbers::pi / 100.0;
    const double lateral = 0.75 * std::sin(k * (y + 8.0)) * std::cos(0.6 * k * (z - 10.0)) + 0.25 * std::sin(1.3 * k * z + 1.0);
    const double axial = 0.6 * std::sin(0.9 * k * (z + 20.0)) * std::cos(0.5 * k * (y - 30.0)) - 0.2 * std::cos(1.2 * k * y);
    return peak_mm_ * glm::dvec2(lateral, axial);
  }
  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest) const override {
    const glm::dvec2 u = at(rest.z, rest.y);
    return {rest.x, rest.y + u.y, rest.z + u.x};
  }
  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved) const override {
    glm::dvec3 p = moved;
    for (int n = 0; n < 60; ++n) {
      const glm::dvec3 off = moved - this->moved(p);
      p += off;
      if (glm::length(off) < 1e-4) break;
    }
    return p;
  }
  [[nodiscard]] double reach_mm() const override { return 1.3 * peak_mm_; }

 private:
  double peak_mm_;
};

/// Envelope averaged over the pixel's depth, then log compressed.
GreyImage imageOf(const Image<float>& envelope, double sampleSpacing_mm, double dynamicRange_db) {
  const int rows = static_cast<int>(kDepth_mm / kPixel_mm);
  Image<float> coarse(envelope.width, rows);
  for (int y = 0; y < rows; ++y) {
    const int first = std::clamp(static_cast<int>(std::lround(y * kPixel_mm / sampleSpacing_mm)), 0, envelope.height - 1);
    const int last = std::clamp(static_cast<int>(std::lround((y + 1) * kPixel_mm / sampleSpacing_mm)), first + 1, envelope.height);
    for (int x = 0; x < envelope.width; ++x) {
      float sum = 0.0F;
      for (int s = first; s < last; ++s) sum += viewOf(envelope).at(x, s);
      viewOf(coarse).at(x, y) = sum / static_cast<float>(last - first);
    }
  }
  GreyImage image;
  compressEnvelope(coarse, dynamicRange_db, image);
  return image;
}

class Recorder {
 public:
  static Result<Recorder> make(std::uint64_t seed, double gain_db) {
    auto patient = block();
    if (!patient) return passOn(patient.error());
    FormationOptions formation;
    formation.depth_mm = kDepth_mm;
    formation.dynamicRange_db = 60.0;
    formation.gain_db = gain_db;
    formation.looks = 2;
    auto scanner = makeVirtualScanner(*patient, wideProbe(), formation, seed);
    if (!scanner) return passOn(scanner.error());
    return Recorder(std::move(*scanner));
  }
  /// The frame whose plane is x = x_mm: its lines side by side along z.
  [[nodiscard]] GreyImage frameAt(double x_mm, const Deformation& deformation, std::uint64_t number) {
    glm::dmat4 pose(1.0);
    pose[0] = {0.0, 0.0, 1.0, 0.0};
    pose[1] = {0.0, 1.0, 0.0, 0.0};
    pose[2] = {-1.0, 0.0, 0.0, 0.0};
    pose[3] = {x_mm, 2.0, 0.0, 1.0};
    Image<float> envelope;
    scanner_->envelope(Transform<frame::World, frame::Probe>{pose}, deformation, number, *scratch_, envelope);
    return imageOf(envelope, scanner_->grid().sampleSpacing_mm, scanner_->options().dynamicRange_db);
  }

 private:
  explicit Recorder(std::unique_ptr<VirtualScanner> scanner) : scanner_(std::move(scanner)), scratch_(scanner_->makeScratch()) {}
  std::unique_ptr<VirtualScanner> scanner_;
  std::unique_ptr<VirtualScanner::Scratch> scratch_;
};

/// Frames at x from first to last as a volume: i along x, j down the beam, k along the lines.
Result<Volume> sweptVolume(Recorder& recorder, double first_mm, double last_mm, const Deformation& deformation, Progress& progress) {
  Volume volume;
  const int frames = static_cast<int>(std::lround((last_mm - first_mm) / kFrame_mm)) + 1;
  for (int n = 0; n < frames; ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The figures were cancelled.">());
    progress.report(say<"Recording virtual sweeps">(), static_cast<double>(n) / frames);
    const GreyImage frame = recorder.frameAt(first_mm + n * kFrame_mm, deformation, static_cast<std::uint64_t>(n));
    if (n == 0) {
      volume.grid.dims = {frames, frame.height, frame.width};
      volume.grid.spacing_mm = {kFrame_mm, kPixel_mm, kPixel_mm};
      volume.grid.origin_mm = {first_mm, 2.0, -0.5 * (frame.width - 1) * kPixel_mm};
      volume.echo.resize(volume.grid.voxelCount());
    }
    for (int k = 0; k < frame.width; ++k)
      for (int j = 0; j < frame.height; ++j) volume.echo[volume.grid.indexOf(n, j, k)] = viewOf(frame).at(k, j);
  }
  volume.coverage.assign(volume.echo.size(), static_cast<std::uint8_t>(Coverage::measured));
  return volume;
}

/// Bilinear; black where the field leads outside.
GreyImage seenThrough(const GreyImage& moving, const std::vector<glm::vec2>& displacement_mm, double pixel_mm) {
  GreyImage out(moving.width, moving.height);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x);
      const double mx = x + static_cast<double>(displacement_mm[n].x) / pixel_mm,
                   my = y + static_cast<double>(displacement_mm[n].y) / pixel_mm;
      if (mx < 0.0 || my < 0.0 || mx > moving.width - 1 || my > moving.height - 1) continue;
      const int ix = std::min(static_cast<int>(mx), moving.width - 2), iy = std::min(static_cast<int>(my), moving.height - 2);
      const double fx = mx - ix, fy = my - iy;
      const auto v = viewOf(moving);
      const double top = (1.0 - fx) * v.at(ix, iy) + fx * v.at(ix + 1, iy),
                   bottom = (1.0 - fx) * v.at(ix, iy + 1) + fx * v.at(ix + 1, iy + 1);
      out.pixels[n] = static_cast<std::uint8_t>(std::lround((1.0 - fy) * top + fy * bottom));
    }
  }
  return out;
}

json rowOf(const std::string& name, const json& factor, double correlation, const registration::Elastic2dResult& found, double cpu_s,
           const PlanarTruth& truth, double pixel_mm) {
  json row{{"name", name},
           {"factor", factor},
           {"correlation", correlation},
           {"error_mm", nullptr},
           {"error95_mm", nullptr},
           {"smallest_jacobian", found.smallestJacobian},
           {"cpu_s", cpu_s},
           {"verdict", registration::nameOf(found.verdict)}};
  if (!truth) return row;
  std::vector<double> errors;
  double sum = 0.0;
  for (int y = 0; y < found.rows; ++y) {
    for (int x = 0; x < found.columns; ++x) {
      const glm::dvec2 p = pixel_mm * glm::dvec2(x, y), u = truth(p), mate = (p + u) / pixel_mm;
      if (mate.x < 0.0 || mate.y < 0.0 || mate.x > found.columns - 1 || mate.y > found.rows - 1) continue;
      const std::size_t n = static_cast<std::size_t>(y) * static_cast<std::size_t>(found.columns) + static_cast<std::size_t>(x);
      errors.push_back(glm::length(glm::dvec2(found.displacement_mm[n]) - u));
      sum += errors.back();
    }
  }
  if (errors.empty()) return row;
  row["error_mm"] = sum / static_cast<double>(errors.size());
  row["error95_mm"] = quantileOf(errors, 0.95);
  return row;
}

/// Mean absolute difference of columns 1 mm apart across `seam`, over the same beside it.
double seamVisibility(const GreyImage& image, int seam) {
  constexpr int kApart = 2;  // columns to either side
  const auto step = [&](int left) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
      sum += std::abs(static_cast<double>(viewOf(image).at(left, y)) - viewOf(image).at(left + kApart, y));
    return sum;
  };
  double nearby = 0.0;
  int count = 0;
  for (int d = 10; d <= 19; ++d)
    for (const int left : {seam - d, seam + d}) {
      if (left < 0 || left + kApart >= image.width) continue;
      nearby += step(left);
      ++count;
    }
  return nearby > 0.0 ? step(seam - 1) * count / nearby : 1.0;
}

std::string number(const json& value, int decimals) { return value.is_number() ? fixedText(value.get<double>(), decimals) : "-"; }

std::string page(const json& report) {
  const auto image = [](const std::string& file, const std::string& words) {
    return "<figure><img src=\"" + file + "\" alt=\"" + words + "\"><figcaption>" + words + "</figcaption></figure>";
  };
  std::string out =
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>Figures 6 to 8</title><style>"
      "body{font:14px/1.5 system-ui,sans-serif;margin:24px;max-width:1100px;background:#111;color:#ddd}"
      "figure{display:inline-block;margin:8px;vertical-align:top;max-width:340px}img{width:100%;image-rendering:auto}"
      "figcaption{font-size:12px;color:#aaa}table{border-collapse:collapse}td,th{padding:2px 12px;text-align:right;border-bottom:1px solid "
      "#333}"
      "td:first-child,th:first-child{text-align:left}</style></head><body><h1>The paper's figures 6 to 8</h1>"
      "<p>Aiger and Cohen-Or 1998, made again from a virtual patient whose motion is known. Simulated images, not for diagnosis.</p>";
  const json& eight = report["figure8"];
  out += "<h2>Figure 8: one resolution against the pyramid</h2><p>Motion up to " + number(eight["peak_mm"], 1) + " mm, mean " +
         number(eight["mean_motion_mm"], 2) + " mm. Correlation of grey levels, error against the known motion.</p>";
  out += image("figure-8-fixed.png", "(a) fixed") + image("figure-8-moving.png", "(b) moving");
  for (std::size_t n = 1; n < eight["rows"].size(); ++n)
    out += image("figure-8-" + std::to_string(n) + ".png",
                 eight["rows"][n]["name"].get<std::string>() + " (" + number(eight["rows"][n]["correlation"], 3) + ")");
  out += "<table><tr><th></th><th>correlation</th><th>error mm</th><th>95 % mm</th><th>smallest Jacobian</th><th>s</th></tr>";
  for (const json& row : eight["rows"])
    out += "<tr><td>" + row["name"].get<std::string>() + "</td><td>" + number(row["correlation"], 3) + "</td><td>" +
           number(row["error_mm"], 3) + "</td><td>" + number(row["error95_mm"], 2) + "</td><td>" + number(row["smallest_jacobian"], 2) +
           "</td><td>" + number(row["cpu_s"], 3) + "</td></tr>";
  const json& seven = report["figure7"];
  out += "</table><h2>Figures 6 and 7: two subvolumes side by side</h2><p>The right one was recorded after the tissue had moved by up to " +
         number(seven["motion_mm"], 1) + " mm. The tangent slices correlate " + number(seven["correlation_before"], 3) + " before and " +
         number(seven["correlation_after"], 3) + " after; error of the motion found there " + number(seven["error_mm"], 2) + " mm.</p>";
  out += image("figure-6-first.png", "6 (a) the first subvolume") + image("figure-6-second.png", "6 (b) the second") +
         image("figure-7-pasted.png", "7 (a) neither blended nor warped: seam " + number(seven["seam"]["pasted"], 2)) +
         image("figure-7-blended.png", "7 (b) blended: seam " + number(seven["seam"]["blended"], 2)) +
         image("figure-7-warped.png", "7 (c) warped and blended: seam " + number(seven["seam"]["warped"], 2));
  return out + "</body></html>\n";
}

}  // namespace

Result<json> paperRows(const GreyImage& fixed, const GreyImage& moving, double pixel_mm, const PlanarTruth& truth,
                       std::vector<GreyImage>* warped, Progress& progress) {
  json rows = json::array();
  const glm::dvec2 pixel(pixel_mm);
  const auto run = [&](const Elastic2dOptions& options, double& cpu_s) {
    const double before = threadTime_s();
    auto found = registration::registerElastic2d(viewOf(fixed), viewOf(moving), pixel, options, progress);
    cpu_s = threadTime_s() - before;
    return found;
  };
  const auto keep = [&](const std::string& name, const json& factor, const registration::Elastic2dResult& found, double cpu_s) {
    rows.push_back(rowOf(name, factor, found.correlationAfter, found, cpu_s, truth, pixel_mm));
    if (warped != nullptr) warped->push_back(seenThrough(moving, found.displacement_mm, pixel_mm));
  };
  double cpu_s = 0.0;
  Elastic2dOptions single;
  single.factors = {6.0};
  single.singleResolution = true;
  const auto one = run(single, cpu_s);
  if (!one) return passOn(one.error());
  registration::Elastic2dResult nothing;
  nothing.columns = fixed.width;
  nothing.rows = fixed.height;
  nothing.displacement_mm.assign(fixed.pixels.size(), glm::vec2(0.0F));
  nothing.correlationAfter = one->correlationBefore;
  nothing.verdict = registration::Verdict::cannotTell;
  keep("nothing done", nullptr, nothing, 0.0);
  keep("single resolution, factor 6", 6, *one, cpu_s);
  // After each level: the pyramid broken off there, which is the same computation.
  for (const std::vector<double>& factors : {std::vector<double>{48.0}, {48.0, 24.0}, {48.0, 24.0, 6.0}}) {
    Elastic2dOptions options;
    options.factors = factors;
    const auto found = run(options, cpu_s);
    if (!found) return passOn(found.error());
    keep((factors.size() == 1 ? "pyramid, factor " : "refined at factor ") + fixedText(factors.back(), 0), factors.back(), *found, cpu_s);
  }
  const auto chosen = run({}, cpu_s);
  if (!chosen) return passOn(chosen.error());
  keep("levels chosen by size and speckle", nullptr, *chosen, cpu_s);
  return rows;
}

namespace {

Result<void> checkPaperOptions(const PaperBenchOptions& options) {
  for (const auto& [value, low, high, name] :
       {std::tuple{options.peak_mm, 0.5, 12.0, "peak"}, std::tuple{options.seamPeak_mm, 0.5, 12.0, "seam peak"},
        std::tuple{options.sweep_mm, 8.0, 60.0, "sweep"}}) {
    if (!(value >= low && value <= high))
      return failure(ErrorCode::badUsage,
                     say<"The %1 must lie between %2 and %3 mm.">(std::string(name), fixedText(low, 1), fixedText(high, 1)));
  }
  return {};
}

using ImagesByName = std::vector<std::pair<std::string, GreyImage>>;

Result<void> writeImages(const ImagesByName& images, const PaperPlace& placeOf) {
  if (!placeOf) return {};
  for (const auto& [name, image] : images) {
    const auto place = placeOf(name);
    if (!place) return passOn(place.error());
    if (auto written = writeImage(viewOf(image), kPixel_mm, *place); !written) return written;
  }
  return {};
}

Result<void> writePages(const json& report, const PaperPlace& placeOf) {
  if (!placeOf) return {};
  for (const auto& [name, text] : {std::pair{"paper.json", report.dump(2) + "\n"}, std::pair{"paper.html", page(report)}}) {
    const auto place = placeOf(name);
    if (!place) return passOn(place.error());
    if (auto written = writeFileSafely(*place, text); !written) return written;
  }
  return {};
}

/// What rests at p is found at p + u(p) in the moving image: u is the truth on the fixed one.
Result<json> figureEight(const PaperBenchOptions& options, Recorder& first, Recorder& second, const PaperPlace& placeOf,
                         Progress& progress) {
  const InPlaneWarp warp(options.peak_mm);
  const GreyImage fixed = first.frameAt(0.0, restingBody(), 1), moving = second.frameAt(0.0, warp, 2);
  const double left_mm = -0.5 * (fixed.width - 1) * kPixel_mm;
  const PlanarTruth truth = [&](const glm::dvec2& p) { return warp.at(p.x + left_mm, p.y + 2.0); };
  std::vector<GreyImage> seen;
  auto rows = paperRows(fixed, moving, kPixel_mm, truth, &seen, progress);
  if (!rows) return passOn(rows.error());
  ImagesByName images{{"figure-8-fixed.png", fixed}, {"figure-8-moving.png", moving}};
  for (std::size_t n = 1; n < seen.size(); ++n) images.emplace_back("figure-8-" + std::to_string(n) + ".png", seen[n]);
  if (auto written = writeImages(images, placeOf); !written) return passOn(written.error());
  return json{{"pixel_mm", kPixel_mm}, {"peak_mm", options.peak_mm}, {"mean_motion_mm", (*rows)[0]["error_mm"]}, {"rows", *rows}};
}

/// Mean distance between where points of the tangent plane went and where they were found, mm.
double errorOnTangentPlane_mm(const registration::Deformation& fixedToMoving, const InPlaneWarp& moved) {
  double error_mm = 0.0;
  int points = 0;
  for (double y = 12.0; y < 92.0; y += 4.0) {
    for (double z = -40.0; z < 41.0; z += 4.0, ++points) {
      const glm::dvec3 p(0.0, y, z);
      error_mm += glm::length(registration::movingPoint(fixedToMoving, p) - moved.moved(p));
    }
  }
  return error_mm / points;
}

/// A plane across the seam: x to the right, y down.
Grid planeAcross(double sweep_mm, const Grid& volume) {
  const int half = static_cast<int>(sweep_mm / kPixel_mm);
  Grid across;
  across.dims = {2 * half + 1, volume.dims.y, 1};
  across.spacing_mm = glm::dvec3(kPixel_mm);
  across.origin_mm = {-kPixel_mm * half, volume.origin_mm.y, -18.0};
  return across;
}

GreyImage imageOfPlane(const Volume& plane) {
  GreyImage out(plane.grid.dims.x, plane.grid.dims.y);
  out.pixels = plane.echo;
  return out;
}

/// Two planes across the seam in one image, blended over `half_mm` to either side of the middle; 0: pasted.
GreyImage joinedAcross(const Volume& left, const Volume& right, double half_mm) {
  // The second view's mean is brought to the first's in the overlap: figure 7 is about geometry.
  double sumLeft = 0.0, sumRight = 0.0;
  for (std::size_t n = 0; n < left.echo.size(); ++n) {
    if (left.coverageAt(n) == Coverage::absent || right.coverageAt(n) == Coverage::absent) continue;
    sumLeft += left.echo[n];
    sumRight += right.echo[n];
  }
  const double scale = sumRight > 0.0 ? sumLeft / sumRight : 1.0;
  GreyImage out(left.grid.dims.x, left.grid.dims.y);
  const int seam = out.width / 2;
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const std::size_t n = left.grid.indexOf(x, y, 0);
      const double at_mm = (x - seam) * kPixel_mm;
      double share = half_mm > 0.0 ? std::clamp(0.5 + at_mm / (2.0 * half_mm), 0.0, 1.0) : (at_mm < 0.0 ? 0.0 : 1.0);
      if (left.coverageAt(n) == Coverage::absent) share = 1.0;
      if (right.coverageAt(n) == Coverage::absent) share = 0.0;
      out.pixels[n] = static_cast<std::uint8_t>(std::clamp((1.0 - share) * left.echo[n] + share * scale * right.echo[n] + 0.5, 0.0, 255.0));
    }
  }
  return out;
}

/// Figures 6 and 7: two sweeps that meet at x = 0 and overlap by 4 mm to either side, the tissue warped between them.
Result<json> figureSeven(const PaperBenchOptions& options, Recorder& first, Recorder& second, const PaperPlace& placeOf,
                         Progress& progress) {
  constexpr double kOverlap_mm = 4.0;
  const InPlaneWarp moved(options.seamPeak_mm);
  PartOfProgress recordingFirst(progress, 0.2, 0.5), recordingSecond(progress, 0.5, 0.8), joining(progress, 0.8, 1.0);
  const auto a = sweptVolume(first, -options.sweep_mm, kOverlap_mm, restingBody(), recordingFirst);
  if (!a) return passOn(a.error());
  const auto b = sweptVolume(second, -kOverlap_mm, options.sweep_mm, moved, recordingSecond);
  if (!b) return passOn(b.error());
  registration::TangentWarpOptions warp;
  warp.slices.threads = 1;
  const auto found =
      registration::registerTangentSlices({&*a, {}}, {&*b, {}}, {}, glm::dvec3(0.0, 50.0, 0.0), glm::dvec3(1.0, 0.0, 0.0), warp, joining);
  if (!found) return passOn(found.error());
  const Grid across = planeAcross(options.sweep_mm, a->grid);
  const auto cut = [&](const Volume& volume, const registration::Deformation& deformation) -> Result<Volume> {
    return registration::warped(volume, deformation, across, 1, noProgress());
  };
  const auto left = cut(*a, {}), right = cut(*b, {}), warped = cut(*b, found->fixedToMoving);
  for (const auto* each : {&left, &right, &warped})
    if (!*each) return passOn(each->error());
  const GreyImage pasted = joinedAcross(*left, *right, 0.0), blended = joinedAcross(*left, *right, kOverlap_mm),
                  smooth = joinedAcross(*left, *warped, kOverlap_mm);
  if (auto written = writeImages({{"figure-6-first.png", imageOfPlane(*left)},
                                  {"figure-6-second.png", imageOfPlane(*right)},
                                  {"figure-7-pasted.png", pasted},
                                  {"figure-7-blended.png", blended},
                                  {"figure-7-warped.png", smooth}},
                                 placeOf);
      !written)
    return passOn(written.error());
  const int middle = across.dims.x / 2;
  return json{{"motion_mm", options.seamPeak_mm},
              {"found_mm", found->slices.largestMotion_mm},
              {"error_mm", errorOnTangentPlane_mm(found->fixedToMoving, moved)},
              {"correlation_before", found->slices.correlationBefore},
              {"correlation_after", found->slices.correlationAfter},
              {"fall_off_mm", found->fallOff_mm},
              {"smallest_jacobian", found->jacobian.smallest},
              {"seam",
               {{"pasted", seamVisibility(pasted, middle - 1)},
                {"blended", seamVisibility(blended, middle - 1)},
                {"warped", seamVisibility(smooth, middle - 1)}}}};
}

}  // namespace

Result<json> benchPaper(const PaperBenchOptions& options, const PaperPlace& placeOf, Progress& progress) {
  if (auto usable = checkPaperOptions(options); !usable) return passOn(usable.error());
  auto first = Recorder::make(options.seed, 0.0), second = Recorder::make(options.seed, 4.0);
  if (!first) return passOn(first.error());
  if (!second) return passOn(second.error());
  json report{{"machine", machineName()}, {"seed", options.seed}};
  PartOfProgress early(progress, 0.05, 0.2);
  auto eight = figureEight(options, *first, *second, placeOf, early);
  if (!eight) return passOn(eight.error());
  report["figure8"] = std::move(*eight);
  auto seven = figureSeven(options, *first, *second, placeOf, progress);
  if (!seven) return passOn(seven.error());
  report["figure7"] = std::move(*seven);
  if (auto written = writePages(report, placeOf); !written) return passOn(written.error());
  progress.report(say<"Figures of the paper">(), 1.0);
  return report;
}

std::vector<BenchSection> paperSections(const json& report) {
  BenchSection eight;
  eight.title = "The paper's figure 8: one resolution against the pyramid";
  eight.text = "Two virtual frames of one plane, the tissue moved by up to " + number(report["figure8"]["peak_mm"], 1) +
               " mm between them; correlation of grey levels, error against the known motion.";
  eight.table.columns = {"registration", "correlation", "error mm", "95 % mm", "smallest Jacobian", "s"};
  for (const json& row : report["figure8"]["rows"])
    eight.table.rows.push_back({row["name"].get<std::string>(), number(row["correlation"], 3), number(row["error_mm"], 3),
                                number(row["error95_mm"], 2), number(row["smallest_jacobian"], 2), number(row["cpu_s"], 3)});
  const json& seven = report["figure7"];
  BenchSection joined;
  joined.title = "The paper's figures 6 and 7: two subvolumes joined at their tangent slices";
  joined.text = "Seam: difference of columns 1 mm apart across the tangent plane over that beside it; 1 is no seam.";
  joined.table.columns = {"joined", "seam"};
  joined.table.rows = {{"neither blended nor warped", number(seven["seam"]["pasted"], 2)},
                       {"blended", number(seven["seam"]["blended"], 2)},
                       {"warped and blended", number(seven["seam"]["warped"], 2)}};
  return {eight, joined};
}

}  // namespace ew
