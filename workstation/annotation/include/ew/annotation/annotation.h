#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/history.h"

namespace ew::annotation {

/// What a person writes on an image.
enum class AnnotationKind {
  text,   ///< words, their left end in the middle of their height at `at_mm`
  arrow,  ///< from `tail_mm` to its tip at `at_mm`
};

inline constexpr double kFarthest_mm = 1e6;       ///< of a coordinate, either way
inline constexpr std::size_t kLongestText = 200;  ///< bytes
inline constexpr std::size_t kMostAnnotations = 500;
inline constexpr double kShortestArrow_mm = 0.5;  ///< a shorter one was no drag

/// One text or arrow. Places lie in the plane of the image, as those of calipers do: mm of the probe frame, x lateral, y depth. Thus it
/// stays at its tissue whatever the size, zoom and orientation of the image.
struct Annotation {
  int number = 0;  ///< 1, 2, ...; never given again in one list
  AnnotationKind kind = AnnotationKind::text;
  glm::dvec2 at_mm{0.0};
  glm::dvec2 tail_mm{0.0};  ///< of an arrow; of a text as `at_mm`
  std::string text;         ///< of a text: one line, not empty
  bool operator==(const Annotation&) const = default;
};

/// All annotations of an image at one moment: a value that never changes.
struct Annotations {
  std::vector<Annotation> all;  ///< in the order they were made
  int nextNumber = 1;
  [[nodiscard]] const Annotation* find(int number) const;  ///< null when there is none
  bool operator==(const Annotations&) const = default;
};

/// Of an annotation, what is taken and moved.
enum class AnnotationPart {
  whole,  ///< a text, or an arrow by its shaft
  tip,
  tail,
};

/// The annotations of an image with undo and redo. Not for several threads at once; the states are.
class AnnotationList : public EntryHistory<Annotations> {
 public:
  using EntryHistory::EntryHistory;

  /// Returns its number, or 0 and no step when the place is not finite, the list is full, or of the text nothing is left once blanks and
  /// ends of lines at both ends are taken away. Ends of lines within become blanks; what is longer than kLongestText is cut at a letter.
  int addText(glm::dvec2 at_mm, std::string_view text);
  /// Returns its number, or 0 and no step when it is shorter than kShortestArrow_mm or not finite, or the list is full.
  int addArrow(glm::dvec2 tail_mm, glm::dvec2 tip_mm);
  /// False, and no step, when there is no such annotation or part, `by_mm` is not finite, or an arrow would become too short.
  bool move(int number, AnnotationPart part, glm::dvec2 by_mm, Change change = Change::begins);
  /// An empty text removes it. False when there is no such text, or it says so already.
  bool setText(int number, std::string_view text);
  /// The last word of a text, or the text with it when it is the only one; an arrow as a whole.
  bool removeLastWord(int number);
};

/// What of the annotations lies at a point.
struct AnnotationFound {
  int number = 0;
  AnnotationPart part = AnnotationPart::whole;
  double distance_mm = 0.0;
};
/// How wide and high a text is drawn, mm of the image's plane: whoever draws it knows.
struct TextSize {
  glm::dvec2 size_mm{0.0};
  double alongX = 1.0;  ///< +1: it is written towards +x of the plane; -1: the image shows +x at its left
};
using TextSizeOf = std::function<TextSize(const Annotation& text)>;
/// The annotation nearest to `p_mm` within reach: of two at the same distance the newer one, which is drawn on top; an end of an arrow
/// rather than its shaft. A text is reached within its box.
[[nodiscard]] std::optional<AnnotationFound> annotationNear(const Annotations& annotations, glm::dvec2 p_mm, double reach_mm,
                                                            const TextSizeOf& sizeOf);

/// Where texts begin that nobody has put anywhere: a share of the image's width and height from its upper left corner, whatever it shows.
struct HomePosition {
  glm::dvec2 share{0.04, 0.08};
  bool operator==(const HomePosition&) const = default;
};
/// The nearest place within the image; the usual one for what is not a number.
[[nodiscard]] HomePosition limited(const HomePosition& home);

}  // namespace ew::annotation
