#include "ew/phantom/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/core/contract.h"
#include "ew/core/word_table.h"
#include "patient/anatomy.h"

namespace ew {
namespace {

using phantom::CentreLine;
using phantom::MeasurementKind;
using phantom::MeasurementRequest;
using phantom::TubePlace;

constexpr double kScan_mm = 0.2;        // nothing thinner is looked for along a line
constexpr double kFarthest_mm = 500.0;  // a surface further from the middle is none
constexpr double kTruthReserve = 1.5;   // how far a first-order distance may exceed the true one (see sampleDistance)

/// A moment of the body, and whoever waits for what is measured in it.
struct Moment {
  const Deformation& motion;
  Progress& progress;
};

/// Thrown where a distance is asked for after the wish to cancel: lines, rays and cubes are nested several deep above it. Leaves this file
/// as an Error.
struct Stopped {};

/// Some shapes as they are at a moment: their union, displaced.
class Solid {
 public:
  Solid(const Patient& patient, const std::vector<std::string>& names, const Moment& moment)
      : motion_(moment.motion), progress_(moment.progress) {
    for (const std::string& name : names) shapes_.push_back(patient.shapes.at(name).get());
  }
  /// Of where the tissue rests that is at p now; negative inside.
  [[nodiscard]] double distance_mm(const glm::dvec3& p_mm) const {
    if (++asked_ % kAsksPerQuestion == 0 && progress_.cancelRequested()) throw Stopped();
    const glm::dvec3 rest = motion_.rest(p_mm);
    double nearest = std::numeric_limits<double>::infinity();
    for (const phantom::Shape* shape : shapes_) nearest = std::min(nearest, shape->distance_mm(rest));
    return nearest;
  }
  [[nodiscard]] bool holds(const glm::dvec3& p_mm) const { return distance_mm(p_mm) < 0.0; }
  [[nodiscard]] Bounds bounds() const {
    Bounds all = shapes_.front()->bounds();
    for (const phantom::Shape* shape : shapes_) {
      all.lowest_mm = glm::min(all.lowest_mm, shape->bounds().lowest_mm);
      all.highest_mm = glm::max(all.highest_mm, shape->bounds().highest_mm);
    }
    return {all.lowest_mm - motion_.reach_mm(), all.highest_mm + motion_.reach_mm()};
  }
  [[nodiscard]] double reach_mm() const { return motion_.reach_mm(); }

 private:
  static constexpr int kAsksPerQuestion = 16;

  std::vector<const phantom::Shape*> shapes_;
  const Deformation& motion_;
  Progress& progress_;
  mutable unsigned asked_ = 0;
};

/// The place between two where `holds` changes.
glm::dvec3 borderBetween(const Solid& solid, glm::dvec3 first, glm::dvec3 second) {
  const bool inside = solid.holds(first);
  for (int n = 0; n < 40; ++n) {
    const glm::dvec3 middle = 0.5 * (first + second);
    (solid.holds(middle) == inside ? first : second) = middle;
  }
  return 0.5 * (first + second);
}

/// Where a line enters and leaves a solid, in order, as lengths along it.
struct Crossing {
  double along_mm = 0.0;
  bool entering = true;
};
std::vector<Crossing> crossingsOf(const Solid& solid, const glm::dvec3& from, const glm::dvec3& to) {
  std::vector<Crossing> found;
  const double length = glm::distance(from, to);
  const int steps = static_cast<int>(std::ceil(length / kScan_mm));
  const auto placeAt = [&](int n) { return from + (to - from) * (static_cast<double>(n) / steps); };
  bool inside = solid.holds(from);
  for (int n = 1; n <= steps; ++n) {
    const bool now = solid.holds(placeAt(n));
    if (now == inside) continue;
    found.push_back({glm::distance(from, borderBetween(solid, placeAt(n - 1), placeAt(n))), now});
    inside = now;
  }
  return found;
}

/// From a place inside along a direction to where the solid ends.
std::optional<glm::dvec3> borderFrom(const Solid& solid, const glm::dvec3& middle, const glm::dvec3& direction) {
  double gone = 0.0;
  while (gone < kFarthest_mm) {
    const double depth = -solid.distance_mm(middle + direction * gone);
    if (!(depth > 0.0))
      return gone == 0.0
                 ? std::nullopt
                 : std::optional(borderBetween(solid, middle + direction * std::max(0.0, gone - kScan_mm), middle + direction * gone));
    // Never more than the safe part of the distance, except that a step at the border must get across it.
    gone += std::max(depth / kTruthReserve - kScan_mm, kScan_mm);
  }
  return std::nullopt;
}

tl::unexpected<Error> notMeasurable(const MeasurementRequest& request, const Message& why) {
  return failure(ErrorCode::badField,
                 say<"The measurement \"%1\" cannot be taken: %2; move its places or change the anatomy.">(request.name, why),
                 {{"measurement", request.name}});
}

using Taken = Result<TrueMeasurement>;

TrueMeasurement lengthBetween(const glm::dvec3& from, const glm::dvec3& to) {
  TrueMeasurement taken;
  taken.value = glm::distance(from, to);
  taken.unit = "mm";
  taken.points_mm = {from, to};
  return taken;
}

Taken distanceOf(const Patient& patient, const MeasurementRequest& request, const Moment& moment) {
  const Deformation& motion = moment.motion;
  const glm::dvec3 from = motion.moved(*request.from_mm), to = motion.moved(*request.to_mm);
  const glm::dvec3 way = glm::normalize(to - from);
  const auto placeAt = [&](const Crossing& crossing) { return from + way * crossing.along_mm; };
  if (!request.gap.empty()) {
    const Solid left(patient, {request.gap[0]}, moment), entered(patient, {request.gap[1]}, moment);
    const auto first = crossingsOf(left, from, to), second = crossingsOf(entered, from, to);
    const auto entry = std::find_if(second.begin(), second.end(), [](const Crossing& each) { return each.entering; });
    if (entry == second.end()) return notMeasurable(request, say<"its line does not enter %1">(request.gap[1]));
    const auto exit = std::find_if(first.rbegin(), first.rend(),
                                   [&](const Crossing& each) { return !each.entering && each.along_mm <= entry->along_mm + 1e-6; });
    if (exit == first.rend()) return notMeasurable(request, say<"its line does not leave %1 before it enters the other">(request.gap[0]));
    return lengthBetween(placeAt(*exit), placeAt(*entry));
  }
  if (request.of.empty() && request.fromSurface.empty()) return lengthBetween(from, to);
  const bool same = !request.of.empty();
  const Solid begins(patient, same ? request.of : std::vector{request.fromSurface}, moment);
  const Solid ends(patient, same ? request.of : std::vector{request.toSurface}, moment);
  const auto first = crossingsOf(begins, from, to), last = crossingsOf(ends, from, to);
  if (first.empty() || last.empty() || !(last.back().along_mm > first.front().along_mm))
    return notMeasurable(request, say<"its line does not cross the two surfaces one after the other">());
  return lengthBetween(placeAt(first.front()), placeAt(last.back()));
}

/// A place on a centre line and the direction in which it runs there.
struct OnLine {
  glm::dvec3 at{0.0};
  glm::dvec3 tangent{0.0, 0.0, 1.0};
};

/// A centre line by its length, as it is at a moment.
class Track {
 public:
  Track(const CentreLine& line, const Deformation& motion) : motion_(motion) {
    points_.emplace_back(line.points_mm.front());
    lengths_.push_back(0.0);
    for (const glm::dvec4& point : line.points_mm) {
      const double step = glm::distance(points_.back(), glm::dvec3(point));
      if (step < 1e-9) continue;
      points_.emplace_back(point);
      lengths_.push_back(lengths_.back() + step);
    }
  }
  [[nodiscard]] double length_mm() const { return lengths_.back(); }
  [[nodiscard]] OnLine at(double along_mm) const {
    constexpr double kHalf_mm = 1.0;  // the polyline has corners; the curve it stands for has none
    const glm::dvec3 before = motion_.moved(restingAt(along_mm - kHalf_mm)), after = motion_.moved(restingAt(along_mm + kHalf_mm));
    const double span = glm::distance(before, after);
    return {motion_.moved(restingAt(along_mm)), span > 0.0 ? (after - before) / span : glm::dvec3(0, 0, 1)};
  }
  [[nodiscard]] double nearest_mm(const glm::dvec3& rest_mm) const {
    double best = 0.0, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n + 1 < points_.size(); ++n) {
      const glm::dvec3 way = points_[n + 1] - points_[n];
      const double t = std::clamp(glm::dot(rest_mm - points_[n], way) / glm::dot(way, way), 0.0, 1.0);
      const double far = glm::distance(rest_mm, points_[n] + way * t);
      if (far >= nearest) continue;
      nearest = far;
      best = lengths_[n] + t * (lengths_[n + 1] - lengths_[n]);
    }
    return best;
  }

 private:
  [[nodiscard]] glm::dvec3 restingAt(double along_mm) const {
    if (points_.size() < 2) return points_.front();
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), std::clamp(along_mm, 0.0, lengths_.back()));
    const auto n = std::clamp<std::size_t>(static_cast<std::size_t>(above - lengths_.begin()), 1, lengths_.size() - 1);
    const double t = (std::clamp(along_mm, 0.0, lengths_.back()) - lengths_[n - 1]) / (lengths_[n] - lengths_[n - 1]);
    return points_[n - 1] + (points_[n] - points_[n - 1]) * t;
  }

  const Deformation& motion_;
  std::vector<glm::dvec3> points_;
  std::vector<double> lengths_;
};

std::optional<TrueMeasurement> widthAcross(const Solid& solid, const glm::dvec3& middle, const glm::dvec3& direction) {
  const auto one = borderFrom(solid, middle, -direction), other = borderFrom(solid, middle, direction);
  if (!one || !other) return std::nullopt;
  return lengthBetween(*one, *other);
}

Taken diameterOf(const Patient& patient, const MeasurementRequest& request, const Moment& moment) {
  const Deformation& motion = moment.motion;
  const Solid solid(patient, request.of, moment);
  const CentreLine* line = patient.shapes.at(request.of.front())->centreLine();
  if (!line) {
    auto width = widthAcross(solid, motion.moved(*request.at_mm), request.direction);
    if (!width) return notMeasurable(request, say<"its place does not lie inside %1">(request.of.front()));
    return *width;
  }
  const Track track(*line, motion);
  const auto widthAt = [&](double along_mm) -> std::optional<TrueMeasurement> {
    const OnLine place = track.at(along_mm);
    const glm::dvec3 across = request.direction - place.tangent * glm::dot(request.direction, place.tangent);
    if (!(glm::length(across) > 1e-3)) return std::nullopt;
    return widthAcross(solid, place.at, glm::normalize(across));
  };
  if (request.place == TubePlace::given) {
    auto width = widthAt(track.nearest_mm(*request.at_mm));
    if (!width) return notMeasurable(request, say<"the centre line is not inside there, or runs along the direction">());
    return *width;
  }
  double from = 0.0, to = track.length_mm();
  if (request.from_mm && request.to_mm) {
    from = track.nearest_mm(*request.from_mm);
    to = track.nearest_mm(*request.to_mm);
    if (from > to) std::swap(from, to);
  }
  const double sign = request.place == TubePlace::largest ? 1.0 : -1.0;
  std::optional<TrueMeasurement> best;
  double bestAt = from;
  const auto consider = [&](double along_mm) {
    auto width = widthAt(along_mm);
    if (!width || (best && !(sign * width->value > sign * best->value))) return;
    best = std::move(width);
    bestAt = along_mm;
  };
  for (double along = from; along < to; along += 1.0) consider(along);
  consider(to);
  for (double step = 0.5; step > 0.01; step *= 0.5) {
    const double middle = bestAt;
    for (const double side : {-1.0, 1.0})
      if (middle + side * step >= from && middle + side * step <= to) consider(middle + side * step);
  }
  if (!best) return notMeasurable(request, say<"no part of the centre line lies inside">());
  return *best;
}

/// Two unit vectors square to a unit vector and to one another.
std::pair<glm::dvec3, glm::dvec3> squareTo(const glm::dvec3& direction) {
  const glm::dvec3 aside = std::abs(direction.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 first = glm::normalize(glm::cross(direction, aside));
  return {first, glm::cross(direction, first)};
}

/// The place of a solid that lies furthest along a direction.
std::optional<glm::dvec3> furthest(const Solid& solid, const glm::dvec3& direction) {
  const Bounds box = solid.bounds();
  const glm::dvec3 centre = 0.5 * (box.lowest_mm + box.highest_mm);
  const double radius = 0.5 * glm::distance(box.lowest_mm, box.highest_mm);
  const auto square = squareTo(direction);
  const glm::dvec3 &u = square.first, &v = square.second;
  // How far along the direction a line parallel to it leaves the solid; a line that misses it leaves it nowhere.
  const auto leaves = [&](double a, double b) {
    const glm::dvec3 base = centre + u * a + v * b;
    double along = radius;
    while (along > -radius) {
      const double far = solid.distance_mm(base + direction * along);
      if (far < 0.0) {
        const glm::dvec3 border = borderBetween(solid, base + direction * along, base + direction * std::min(along + kScan_mm, radius));
        return glm::dot(border - centre, direction);
      }
      along -= std::max(far / kTruthReserve, 0.5 * kScan_mm);
    }
    return -std::numeric_limits<double>::infinity();
  };
  constexpr int kLines = 24;  // to either side
  double bestA = 0.0, bestB = 0.0, best = -std::numeric_limits<double>::infinity();
  const double spacing = radius / kLines;
  const auto consider = [&](double a, double b) {
    const double found = leaves(a, b);
    if (!(found > best)) return false;
    best = found;
    bestA = a;
    bestB = b;
    return true;
  };
  for (int i = -kLines; i <= kLines; ++i)
    for (int j = -kLines; j <= kLines; ++j)
      if (i * i + j * j <= kLines * kLines) consider(i * spacing, j * spacing);
  if (std::isinf(best)) return std::nullopt;
  for (double step = 0.5 * spacing; step > 0.005;) {
    const double a = bestA, b = bestB;
    bool better = false;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j) better = ((i != 0 || j != 0) && consider(a + i * step, b + j * step)) || better;
    if (!better) step *= 0.5;
  }
  return centre + u * bestA + v * bestB + direction * best;
}

Taken extentOf(const Patient& patient, const MeasurementRequest& request, const Moment& moment) {
  const Solid solid(patient, request.of, moment);
  const auto low = furthest(solid, -request.direction), high = furthest(solid, request.direction);
  if (!low || !high) return notMeasurable(request, say<"nothing of %1 is found">(request.of.front()));
  TrueMeasurement taken = lengthBetween(*low, *high);
  taken.value = glm::dot(*high - *low, request.direction);
  return taken;
}

Taken circumferenceOf(const Patient& patient, const MeasurementRequest& request, const Moment& moment) {
  const Deformation& motion = moment.motion;
  constexpr int kRays = 1440;
  const Solid solid(patient, request.of, moment);
  const glm::dvec3 middle = motion.moved(*request.at_mm);
  const auto [u, v] = squareTo(request.direction);
  std::vector<glm::dvec3> outline;
  for (int n = 0; n < kRays; ++n) {
    const double angle = 2.0 * 3.14159265358979323846 * n / kRays;
    const auto border = borderFrom(solid, middle, std::cos(angle) * u + std::sin(angle) * v);
    if (!border) return notMeasurable(request, say<"its place does not lie inside %1">(request.of.front()));
    outline.push_back(*border);
  }
  TrueMeasurement taken;
  taken.unit = "mm";
  int longest = 0;
  double length = 0.0;
  for (int n = 0; n < kRays; ++n) {
    const auto at = [&](int index) { return outline[static_cast<std::size_t>(index % kRays)]; };
    taken.value += glm::distance(at(n), at(n + 1));
    const double across = glm::distance(at(n), at(n + kRays / 2));
    if (across <= length) continue;
    length = across;
    longest = n;
  }
  for (const int quarter : {0, 2, 1, 3})  // the ends of the long axis, then of the short one
    taken.points_mm.push_back(outline[static_cast<std::size_t>((longest + quarter * kRays / 4) % kRays)]);
  return taken;
}

/// The part of a cube of size h at p that the organs own: what organs of higher priority and the outside of the skin take is not theirs.
class OrganShare {
 public:
  OrganShare(const Patient& patient, const std::vector<std::string>& names) : patient_(patient), names_(names) {
    for (const phantom::Organ& organ : patient.organs) asked_.push_back(std::find(names.begin(), names.end(), organ.name) != names.end());
    drawn_ = std::none_of(asked_.begin(), asked_.end(), [](bool asked) { return asked; });
  }
  [[nodiscard]] double at(const glm::dvec3& rest_mm, double h) const {
    const auto part = [&](double distance_mm) { return std::clamp(0.5 - distance_mm / h, 0.0, 1.0); };
    if (drawn_) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::string& name : names_) nearest = std::min(nearest, patient_.shapes.at(name)->distance_mm(rest_mm));
      return part(nearest);
    }
    double remaining = part(patient_.skin->distance_mm(rest_mm)), owned = 0.0;
    for (std::size_t n = 0; n < patient_.organs.size() && remaining > 1e-6; ++n) {
      const phantom::Shape& shape = *patient_.organs[n].shape;
      if (shape.atLeast_mm(rest_mm) > h) continue;
      const double taken = remaining * part(shape.distance_mm(rest_mm));
      if (asked_[n]) owned += taken;
      remaining -= taken;
    }
    return owned;
  }

 private:
  const Patient& patient_;
  const std::vector<std::string>& names_;
  std::vector<bool> asked_;
  bool drawn_ = false;  ///< only helper shapes: nobody owns anything of them
};

Taken volumeOf(const Patient& patient, const MeasurementRequest& request, const Moment& moment) {
  const Deformation& motion = moment.motion;
  constexpr double kCubes = 4e5;
  constexpr int kBlock = 4;
  const Solid solid(patient, request.of, moment);
  Bounds box = solid.bounds();
  box.lowest_mm = glm::max(box.lowest_mm, patient.skin->bounds().lowest_mm);
  box.highest_mm = glm::min(box.highest_mm, patient.skin->bounds().highest_mm);
  const glm::dvec3 size = glm::max(box.highest_mm - box.lowest_mm, glm::dvec3(0.01));
  const double h = std::clamp(std::cbrt(size.x * size.y * size.z / kCubes), 0.1, 2.0);
  const glm::ivec3 blocks = glm::ivec3(glm::ceil(size / (h * kBlock))) + 1;
  const OrganShare share(patient, request.of);
  const double radius = 0.5 * std::sqrt(3.0) * kBlock * h;
  double sum = 0.0;
  for (int bk = 0; bk < blocks.z; ++bk)
    for (int bj = 0; bj < blocks.y; ++bj)
      for (int bi = 0; bi < blocks.x; ++bi) {
        const glm::dvec3 corner = box.lowest_mm + h * kBlock * (glm::dvec3(bi, bj, bk) - 0.25);
        const glm::dvec3 centre = corner + 0.5 * kBlock * h;
        if (solid.distance_mm(centre) > kTruthReserve * (radius + h) + solid.reach_mm()) continue;
        for (int n = 0; n < kBlock * kBlock * kBlock; ++n) {
          if (moment.progress.cancelRequested()) throw Stopped();
          const glm::dvec3 p = corner + h * (glm::dvec3(n % kBlock, n / kBlock % kBlock, n / kBlock / kBlock) + 0.5);
          sum += share.at(motion.rest(p), h);
        }
      }
  TrueMeasurement taken;
  taken.value = sum * h * h * h / 1000.0;
  taken.unit = "ml";
  return taken;
}

}  // namespace

Result<std::vector<TrueMeasurement>> measurementsOf(const Patient& patient, const BodyState& state, Progress& progress) try {
  const auto motion = bodyMotion(patient, state);
  const Moment moment{*motion, progress};
  std::vector<TrueMeasurement> all;
  for (const MeasurementRequest& request : patient.measurements) {
    auto taken = [&]() -> Taken {
      switch (request.kind) {
        case MeasurementKind::distance:
          return distanceOf(patient, request, moment);
        case MeasurementKind::diameter:
          return diameterOf(patient, request, moment);
        case MeasurementKind::extent:
          return extentOf(patient, request, moment);
        case MeasurementKind::circumference:
          return circumferenceOf(patient, request, moment);
        case MeasurementKind::volume:
          break;
      }
      return volumeOf(patient, request, moment);
    }();
    if (!taken) return passOn(taken.error());
    taken->name = request.name;
    taken->kind = wordIn(phantom::kMeasurementKindWords, request.kind);
    taken->plane = request.plane;
    all.push_back(std::move(*taken));
  }
  return all;
} catch (const Stopped&) {
  return failure(ErrorCode::cancelled, say<"Measuring the patient was stopped.">());
}

std::vector<StandardPlane> planesOf(const Patient& patient) { return patient.planes; }

}  // namespace ew
