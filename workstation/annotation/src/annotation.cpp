#include "ew/annotation/annotation.h"

#include <algorithm>
#include <cmath>

#include "ew/core/find_entry.h"
#include "utf8.h"

namespace ew::annotation {
namespace {

bool isFinite(glm::dvec2 at) { return std::isfinite(at.x) && std::isfinite(at.y); }
bool isWithin(glm::dvec2 at_mm) { return isFinite(at_mm) && std::max(std::abs(at_mm.x), std::abs(at_mm.y)) <= kFarthest_mm; }

bool isLongEnough(const Annotation& arrow) { return glm::length(arrow.at_mm - arrow.tail_mm) >= kShortestArrow_mm; }

double distanceToLine_mm(glm::dvec2 p_mm, glm::dvec2 from_mm, glm::dvec2 to_mm) {
  const glm::dvec2 along = to_mm - from_mm;
  const double square = glm::dot(along, along);
  const double share = square > 0.0 ? std::clamp(glm::dot(p_mm - from_mm, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(p_mm - (from_mm + share * along));
}

double distanceToText_mm(glm::dvec2 p_mm, glm::dvec2 at_mm, const TextSize& size) {
  const double right = size.alongX * (p_mm.x - at_mm.x);  // from the left end of the text on
  const double outX = std::max({-right, right - size.size_mm.x, 0.0});
  const double outY = std::max(std::abs(p_mm.y - at_mm.y) - 0.5 * size.size_mm.y, 0.0);
  return std::hypot(outX, outY);
}

}  // namespace

const Annotation* Annotations::find(int number) const { return entryWith(all, &Annotation::number, number); }

int AnnotationList::addText(glm::dvec2 at_mm, std::string_view text) {
  std::string line = oneLine(text, kLongestText);
  if (line.empty() || !isWithin(at_mm) || now().all.size() >= kMostAnnotations) return 0;
  return add(Annotation{0, AnnotationKind::text, at_mm, at_mm, std::move(line)});
}

int AnnotationList::addArrow(glm::dvec2 tail_mm, glm::dvec2 tip_mm) {
  Annotation arrow{0, AnnotationKind::arrow, tip_mm, tail_mm, {}};
  if (!isWithin(tail_mm) || !isWithin(tip_mm) || !isLongEnough(arrow) || now().all.size() >= kMostAnnotations) return 0;
  return add(std::move(arrow));
}

bool AnnotationList::move(int number, AnnotationPart part, glm::dvec2 by_mm, Change change) {
  return edit(number, change, [&](Annotation& one) {
    Annotation moved = one;
    if (part != AnnotationPart::whole && one.kind != AnnotationKind::arrow) return false;
    if (part != AnnotationPart::tail) moved.at_mm += by_mm;
    if (part != AnnotationPart::tip) moved.tail_mm += by_mm;
    if (!isWithin(moved.at_mm) || !isWithin(moved.tail_mm)) return false;
    if (moved.kind == AnnotationKind::arrow && !isLongEnough(moved)) return false;
    one = std::move(moved);
    return true;
  });
}

bool AnnotationList::setText(int number, std::string_view text) {
  std::string line = oneLine(text, kLongestText);
  const Annotation* found = now().find(number);
  if (found == nullptr || found->kind != AnnotationKind::text || found->text == line) return false;
  if (line.empty()) return remove(number);
  return edit(number, Change::begins, [&](Annotation& one) { return one.text = std::move(line), true; });
}

bool AnnotationList::removeLastWord(int number) {
  const Annotation* found = now().find(number);
  if (found == nullptr) return false;
  const auto blank = found->text.find_last_of(' ');
  if (found->kind != AnnotationKind::text || blank == std::string::npos) return remove(number);
  return setText(number, found->text.substr(0, blank));
}

std::optional<AnnotationFound> annotationNear(const Annotations& annotations, glm::dvec2 p_mm, double reach_mm, const TextSizeOf& sizeOf) {
  std::optional<AnnotationFound> nearest;
  const auto offer = [&](const Annotation& one, AnnotationPart part, double distance_mm) {
    if (distance_mm > reach_mm) return;
    // A shaft reaches to both ends of its arrow: there the ends are meant.
    const bool isEnd = part != AnnotationPart::whole;
    const bool hasEnd = nearest && nearest->part != AnnotationPart::whole;
    if (!nearest || (isEnd && !hasEnd) || (isEnd == hasEnd && distance_mm <= nearest->distance_mm))
      nearest = AnnotationFound{one.number, part, distance_mm};
  };
  for (const Annotation& one : annotations.all) {
    if (one.kind == AnnotationKind::text) {
      offer(one, AnnotationPart::whole, distanceToText_mm(p_mm, one.at_mm, sizeOf(one)));
    } else {
      offer(one, AnnotationPart::whole, distanceToLine_mm(p_mm, one.tail_mm, one.at_mm));
      offer(one, AnnotationPart::tail, glm::length(p_mm - one.tail_mm));
      offer(one, AnnotationPart::tip, glm::length(p_mm - one.at_mm));
    }
  }
  return nearest;
}

HomePosition limited(const HomePosition& home) {
  const HomePosition usual;
  const auto within = [](double share, double otherwise) { return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : otherwise; };
  return {{within(home.share.x, usual.share.x), within(home.share.y, usual.share.y)}};
}

}  // namespace ew::annotation
