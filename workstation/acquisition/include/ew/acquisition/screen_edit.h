#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ew/acquisition/screen.h"

namespace ew {

/// What a person takes hold of to correct an outline.
enum class OutlineGrip {
  apex,
  left,  ///< the sides and edges, each in its middle
  right,
  nearEdge,
  farEdge,
  upperLeft,  ///< corners, of straight sides alone
  upperRight,
  lowerRight,
  lowerLeft,
  whole  ///< moves everything
};

struct GripPosition {
  OutlineGrip grip = OutlineGrip::whole;
  glm::dvec2 at_px{0.0};
};
/// Apex, sides and edges of a fan; corners, sides and edges of straight sides; the middle of both.
[[nodiscard]] std::vector<GripPosition> gripsOf(const FanOutline& outline);

/// The outline with a grip put elsewhere. The apex moves under what it is the apex of: the far corners and the middle of the near edge stay
/// where they are, as well as one radius for both corners allows. A side turns about the apex, an edge keeps it as its centre. Straight
/// sides and edges move without turning. A fan keeps sides that do not cross, and a far edge beyond the near one.
[[nodiscard]] FanOutline withGripAt(const FanOutline& outline, OutlineGrip grip, glm::dvec2 to_px);

/// An outline of a shape that fills about the same part of the image: to begin with. A sector is asked for as convex: the near edge
/// decides which of both it is.
[[nodiscard]] FanOutline withShape(const FanOutline& outline, FanShape shape);
/// The same where none was found: most of the image.
[[nodiscard]] FanOutline outlineToBeginWith(FanShape shape, int width_px, int height_px);

/// A box of text as a person sees it.
struct TextBox {
  PixelRect rect = {};
  bool counts = true;       ///< false: found, and taken for no text by the person, or not confirmed
  bool isAdded = false;     ///< drawn by the person
  bool isPossible = false;  ///< found in a scan that hardly moves: counts once the person confirms it
  bool operator==(const TextBox&) const = default;
};

/// What was found in a recording and what a person says about it, step by step. Not for several threads.
class ScreenEdit {
 public:
  explicit ScreenEdit(ScreenAnalysis found) : found_(std::move(found)) {}

  [[nodiscard]] const ScreenAnalysis& found() const { return found_; }
  /// As writeScreen() and corrected() take it.
  [[nodiscard]] const ScreenCorrection& correction() const { return correction_; }
  /// @error as corrected()
  [[nodiscard]] Result<ScreenGeometry> geometry() const { return corrected(found_, correction_); }

  [[nodiscard]] const std::optional<FanOutline>& outline() const { return correction_.outline ? correction_.outline : found_.outline; }
  void setOutline(const FanOutline& outline) { correction_.outline = outline; }
  void setDepth_mm(std::optional<double> depth_mm) { correction_.depth_mm = depth_mm; }
  void setTick_mm(std::optional<double> tick_mm) { correction_.tick_mm = tick_mm; }

  [[nodiscard]] std::vector<TextBox> boxes() const;
  void addBox(const PixelRect& rect);
  /// The smallest box there: a found one counts, or does not any more; an added one goes. False: there is none.
  bool toggleBoxAt(glm::dvec2 p_px);

  /// How the images lie; what was said of outline and boxes, in pixels that lie elsewhere now, goes. True: there was something.
  bool setTurned(const Orientation& turned);

  /// What was found anew, in another look at the same recording: what the person said stays.
  void lookedAgain(ScreenAnalysis found) { found_ = std::move(found); }
  /// What the person said of outline and boxes goes; depth and ticks stay, which nobody can find.
  void backToFound();

 private:
  ScreenAnalysis found_;
  ScreenCorrection correction_;
};

}  // namespace ew
