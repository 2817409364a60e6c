#include "ew/annotation/body_mark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/core/find_entry.h"

namespace ew::annotation {
namespace {

/// The axes of a drawing in the world: to its right, down, and into it.
struct Axes {
  glm::dvec3 right, down, into;
};

Axes axesOf(MarkView view) {
  constexpr glm::dvec3 kLeft(1.0, 0.0, 0.0), kBack(0.0, 1.0, 0.0), kDown(0.0, 0.0, -1.0);
  switch (view) {
    case MarkView::back:
      return {-kLeft, kDown, -kBack};
    case MarkView::right:
      return {-kBack, kDown, kLeft};
    case MarkView::left:
      return {kBack, kDown, -kLeft};
    case MarkView::front:
      break;
  }
  return {kLeft, kDown, kBack};
}

constexpr double kStays = 0.15;            // how much better another mark has to be
constexpr double kLessOfTheBody_mm = 1e4;  // a decimetre less of the body counts as 0.01, far below that
constexpr double kOpposite = 1e-6;

/// Where `along`, at a right angle to `beam`, points to once the shortest rotation has brought `beam` to `into`; all of unit length.
glm::dvec3 rolled(glm::dvec3 along, glm::dvec3 beam, glm::dvec3 into) {
  const glm::dvec3 sum = beam + into;
  return along - glm::dot(into, along) / (1.0 + glm::dot(beam, into)) * sum;
}

template <class Item>
const Item* withId(const std::vector<Item>& items, std::string_view id) {
  return entryWith(items, &Item::id, id);
}

bool isAmong(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

const std::filesystem::path& BodyMark::drawingOf(std::string_view variant) const {
  const MarkVariant* found = variant.empty() ? nullptr : withId(variants, variant);
  return found != nullptr ? found->drawing : drawing;
}

const BodyMark* bodyMarkOf(const std::vector<BodyMark>& marks, std::string_view id) { return withId(marks, id); }

ProbeGlyph limited(const ProbeGlyph& glyph) {
  const ProbeGlyph usual;
  const auto within = [](double share, double otherwise) { return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : otherwise; };
  double angle_rad = std::isfinite(glyph.angle_rad) ? std::remainder(glyph.angle_rad, 2.0 * std::numbers::pi) : usual.angle_rad;
  if (angle_rad <= -std::numbers::pi) angle_rad = std::numbers::pi;
  return {{within(glyph.place.x, usual.place.x), within(glyph.place.y, usual.place.y)}, angle_rad};
}

glm::dvec2 placeOn(const BodyMark& mark, const Point<frame::World>& p_world) {
  const Axes axes = axesOf(mark.view);
  const glm::dvec3 from_mm = p_world.at - mark.centre_mm;
  return glm::dvec2(0.5) + glm::dvec2(glm::dot(from_mm, axes.right), glm::dot(from_mm, axes.down)) / mark.side_mm;
}

double facing(const BodyMark& mark, const Transform<frame::World, frame::Probe>& probeToWorld) {
  return glm::dot(glm::dvec3(probeToWorld.matrix[1]), axesOf(mark.view).into);
}

std::optional<ProbeGlyph> glyphFor(const BodyMark& mark, const Transform<frame::World, frame::Probe>& probeToWorld) {
  const double faces = facing(mark, probeToWorld);
  if (!(faces >= kFarSide) || 1.0 + faces < kOpposite) return std::nullopt;
  const glm::dvec2 place = placeOn(mark, {glm::dvec3(probeToWorld.matrix[3])});
  if (!(place.x >= 0.0 && place.x <= 1.0 && place.y >= 0.0 && place.y <= 1.0)) return std::nullopt;
  const Axes axes = axesOf(mark.view);
  const glm::dvec3 along = rolled(glm::dvec3(probeToWorld.matrix[0]), glm::dvec3(probeToWorld.matrix[1]), axes.into);
  return limited(ProbeGlyph{place, std::atan2(glm::dot(along, axes.down), glm::dot(along, axes.right))});
}

std::vector<const BodyMark*> marksFor(const std::vector<BodyMark>& marks, const MarkSubject& body) {
  std::vector<const BodyMark*> ofRegion, ofMannequin;
  for (const BodyMark& mark : marks) {
    if (!mark.mannequins.empty() && !body.mannequin.empty() && !isAmong(mark.mannequins, body.mannequin)) continue;
    ofMannequin.push_back(&mark);
    if (isAmong(mark.regions, body.region)) ofRegion.push_back(&mark);
  }
  return ofRegion.empty() ? ofMannequin : ofRegion;
}

const BodyMark* markFor(const std::vector<const BodyMark*>& offered, const Transform<frame::World, frame::Probe>& probeToWorld,
                        std::string_view present) {
  const BodyMark* best = nullptr;
  const BodyMark* shown = nullptr;
  double most = 0.0;
  for (const BodyMark* mark : offered) {
    const bool isPresent = !present.empty() && mark->id == present;
    if (isPresent) shown = mark;
    if (!glyphFor(*mark, probeToWorld)) continue;
    const double good = facing(*mark, probeToWorld) - mark->side_mm / kLessOfTheBody_mm + (isPresent ? kStays : 0.0);
    if (best == nullptr || good > most) {
      best = mark;
      most = good;
    }
  }
  if (best != nullptr) return best;
  if (shown != nullptr) return shown;
  return offered.empty() ? nullptr : offered.front();
}

}  // namespace ew::annotation
