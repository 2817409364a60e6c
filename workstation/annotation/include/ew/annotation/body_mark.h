#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/frames.h"
#include "ew/core/result.h"

namespace ew::annotation {

inline constexpr int kBodyMarkFormat = 1;  ///< `format` of a body mark; a file with a larger one is refused with newerFormat

/// The side of the patient that a drawing shows. Head up: of the front the patient's right is at the left of the drawing, of the right side
/// the front is at the right of it, of the left side at the left.
enum class MarkView { front, back, right, left };

/// Another drawing of the same place, which a person chooses: how a fetus lies.
struct MarkVariant {
  std::string id;  ///< "breech"
  Words title;
  std::filesystem::path drawing;
  bool operator==(const MarkVariant&) const = default;
};

/// A small drawing of a region, and where on it a place of the body lies: resources/body_marks/*.json,
/// resources/schemas/body-mark.schema.json. Drawings are square SVG files, drawn to scale after the mannequin seen from that side without
/// perspective.
struct BodyMark {
  std::string id;  ///< file name without ending: "flank-right"
  Words title;
  MarkView view = MarkView::front;
  glm::dvec3 centre_mm{0.0};            ///< world: what is in the middle of the drawing; its depth does not count
  double side_mm = 400.0;               ///< how much of the body the drawing is wide and high
  std::filesystem::path drawing;        ///< whole path of the SVG file
  std::vector<MarkVariant> variants;    ///< in the order they are offered, behind the drawing itself
  std::vector<std::string> regions;     ///< of cases (Case::region) for which it is offered by itself; empty: chosen by hand alone
  std::vector<std::string> mannequins;  ///< file names without ending of those it was drawn after; empty: any
  bool operator==(const BodyMark&) const = default;

  /// The drawing of that variant; the mark's own when it is empty or not known.
  [[nodiscard]] const std::filesystem::path& drawingOf(std::string_view variant) const;
};

/// @param folder where the drawings lie, which must be there
/// @error badField (also a drawing that is not there or leads out of the folder), newerFormat
[[nodiscard]] Result<BodyMark> bodyMarkFromJson(const nlohmann::json& document, const std::string& id, const std::filesystem::path& folder,
                                                const Message& where);
/// @error notFound, notReadable, tooLarge (above 4 MiB), badHeader (not JSON), otherwise as bodyMarkFromJson
[[nodiscard]] Result<BodyMark> readBodyMark(const std::filesystem::path& file);
/// Every mark of a folder, by id; a file that cannot be read is an error, not a gap.
[[nodiscard]] Result<std::vector<BodyMark>> readBodyMarks(const std::filesystem::path& folder);
/// Null when there is none.
[[nodiscard]] const BodyMark* bodyMarkOf(const std::vector<BodyMark>& marks, std::string_view id);

/// A bar for the probe's face with a dot at its marked end.
struct ProbeGlyph {
  glm::dvec2 place{0.5};   ///< of the middle of the face: share of the drawing's width and height from its upper left corner
  double angle_rad = 0.0;  ///< from the middle to the dot: 0 to the right of the drawing, +pi/2 down; above -pi, up to pi
  bool operator==(const ProbeGlyph&) const = default;
};
/// The nearest place within the drawing and the same angle in its range; the usual glyph for what is not a number.
[[nodiscard]] ProbeGlyph limited(const ProbeGlyph& glyph);

/// Where a place of the world lies on the drawing, as ProbeGlyph::place; beside the drawing below 0 or above 1.
[[nodiscard]] glm::dvec2 placeOn(const BodyMark& mark, const Point<frame::World>& p_world);
/// Cosine of the angle between the beam in the middle of the probe and the direction in which the drawing looks: 1 seen from behind the
/// probe, 0 on the outline, below 0 on the far side.
[[nodiscard]] double facing(const BodyMark& mark, const Transform<frame::World, frame::Probe>& probeToWorld);

inline constexpr double kFarSide = -0.35;  ///< facing() from which on a probe counts as on the far side: some 20 degrees behind the outline

/// Where the probe is on the drawing. Its angle is that of the face once the probe was rolled, by the shortest way, to look straight into
/// the drawing: so a bar across the flank lies across on the drawing of the front too, and a probe that is tilted or rocked does not
/// change its angle. Empty beside the drawing and on the far side.
[[nodiscard]] std::optional<ProbeGlyph> glyphFor(const BodyMark& mark, const Transform<frame::World, frame::Probe>& probeToWorld);

/// Whose marks are offered.
struct MarkSubject {
  std::string region;     ///< of the case; empty: not known
  std::string mannequin;  ///< file name without ending; empty: not known
};
/// Those whose region and mannequin it is, in their order; all of that mannequin when it has none of that region.
[[nodiscard]] std::vector<const BodyMark*> marksFor(const std::vector<BodyMark>& marks, const MarkSubject& body);

/// The mark that shows the probe best: the one it faces most squarely, of two from the same side the one that shows less of the body. The
/// present one stays until another is clearly better, so that nothing flickers on the outline. Where none shows the probe, the present one
/// if it is among them, else the first. Null when there is none at all.
/// @param offered as marksFor gives them @param present id of the mark that is shown; empty: none
[[nodiscard]] const BodyMark* markFor(const std::vector<const BodyMark*>& offered,
                                      const Transform<frame::World, frame::Probe>& probeToWorld, std::string_view present = {});

/// How a person wants the mark of an image: kept with it.
struct MarkChoice {
  bool isShown = true;
  std::string mark;                  ///< id; empty: as markFor says
  std::string variant;               ///< id; empty: the drawing itself
  std::optional<ProbeGlyph> byHand;  ///< put there by hand; empty: it follows the probe
  bool operator==(const MarkChoice&) const = default;
};

}  // namespace ew::annotation
