#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "ew/annotation/body_mark.h"
#include "scan/still_image.h"

class QPainter;
class QRectF;

namespace ew::ui {

/// The body mark of the image: which drawing it is and where the probe lies on it. It follows the probe that made the image; on an
/// image that stands still the probe may be put elsewhere by hand, and that image keeps it.
class ImageBodyMark final : public QObject {
  Q_OBJECT

 public:
  explicit ImageBodyMark(Session& session, QObject* parent = nullptr);

  void setMarks(std::vector<annotation::BodyMark> marks);
  void setBody(const annotation::MarkSubject& body);
  /// Ids of marks that are offered before all others, in that order.
  void setFirst(std::vector<std::string> ids);
  /// The same marks and body as another one; of an image that was not made yet, the same choice.
  void beginLike(const ImageBodyMark& other);
  /// Which drawing was chosen and where the probe was put changes places with that of another one, as Calipers::exchange has it.
  void exchange(ImageBodyMark& other);

  /// What is offered for this body, then all others.
  [[nodiscard]] std::vector<const annotation::BodyMark*> offered() const;
  /// What the menu shows as chosen; `byHand` is that of the image.
  [[nodiscard]] annotation::MarkChoice choice() const;
  void setShown(bool shown);                ///< kept for the next start
  void follow(const ImageBodyMark& other);  ///< is shown as that one is
  /// @param mark id; empty: the one that shows the probe best
  void choose(const std::string& mark, const std::string& variant = {});
  /// Only on an image that stands still; empty: it follows the probe again.
  void putByHand(const std::optional<annotation::ProbeGlyph>& glyph);
  [[nodiscard]] bool standsStill() const { return session_.isFrozen() || session_.isPlaying(); }

  /// Null when there is none to show or it is hidden.
  [[nodiscard]] const annotation::BodyMark* mark() const { return isShown_ ? mark_ : nullptr; }
  [[nodiscard]] const std::optional<annotation::ProbeGlyph>& glyph() const { return glyph_; }
  /// Length of the probe's face as a share of the drawing's width.
  [[nodiscard]] double faceShare() const;
  [[nodiscard]] QString drawing() const;  ///< file; empty without a mark

 Q_SIGNALS:
  void changed();

 private:
  void look();

  Session& session_;
  std::vector<annotation::BodyMark> marks_;
  annotation::MarkSubject body_;
  std::vector<std::string> first_;
  bool isShown_ = true;
  std::string chosen_, variant_;
  OfImages<std::optional<annotation::ProbeGlyph>> byHand_;
  const annotation::BodyMark* mark_ = nullptr;
  std::optional<annotation::ProbeGlyph> glyph_;
  std::string drawn_;  ///< what of it was last told: mark and variant
};

/// Drawing and probe in a square, on a dark ground that keeps it legible over the image. Nothing without a mark.
void paintMark(QPainter& painter, const ImageBodyMark& mark, const QRectF& box);

inline constexpr int kMark_px = 96;  ///< side of the square, on the scan and on saved images

}  // namespace ew::ui
