#pragma once

#include <QWidget>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ew/scanning/body_side.h"

namespace ew::ui {

class ImageAnnotations;
class BodyMarkView;
class Calipers;
class Jobs;
class ImageTile;
class ScanView;
class Session;
class ImageBodyMark;

/// One, two or four images of the scan. One of them is in hand: the window's session, calipers, texts and body mark are its own, and it
/// is the only one that may run. The others stand still (ImageTile). Taking another one in hand lets the two change places, with
/// everything that belongs to each, so that every image has its own console, cine loop, measurements and undo.
class ImageGrid final : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kMost = 4;

  /// What the image in hand is shown and made with; all outlive the grid but `scan`, which becomes a part of it.
  struct InHand {
    Session& session;
    Calipers& calipers;
    ImageAnnotations& annotated;
    ImageBodyMark& mark;
    Jobs& jobs;
    ScanView& scan;
  };
  explicit ImageGrid(const InHand& inHand, QWidget* parent = nullptr);
  ~ImageGrid() override;
  void setMarkView(const BodyMarkView& view) { markView_ = &view; }

  /// @param images 1, 2 or 4; any other changes nothing. Images that have no room then are kept, and seen again when they have.
  void setCount(int images);
  [[nodiscard]] int count() const { return count_; }
  void stepCount() { setCount(count_ == 1 ? 2 : count_ == 2 ? 4 : 1); }
  /// Place of the image in hand, from 0: left to right, then down.
  [[nodiscard]] int active() const { return active_; }
  enum class Then {
    stands,  ///< it is frozen as it was left, to be measured; where there is none yet it runs
    goesOn   ///< it runs when the one that is left ran
  };
  /// The image in hand is frozen; the one at `place` comes into the hand.
  void take(int place, Then then);
  /// As the key L/R of a machine: a running scan goes on in the next image, a frozen one stands.
  void takeNext() { take((active_ + 1) % count_, Then::goesOn); }

  /// All images at the scale of the one that shows most.
  void setSameScale(bool same);
  [[nodiscard]] bool hasSameScale() const { return hasSameScale_; }

  /// An image that is shown, with what lies on it.
  struct Shown {
    int place = 0;
    const Session* session = nullptr;
    const Calipers* calipers = nullptr;
    const ImageAnnotations* annotated = nullptr;
    const ImageBodyMark* mark = nullptr;
    ScanView* view = nullptr;
    std::optional<BodySide> side;
    /// What people call it: its number, and the patient's side. Empty when it is the only one.
    QString name;
  };
  /// Those that there are, by their places.
  [[nodiscard]] std::vector<Shown> shown() const;
  /// Of the image with this number (Calipers::image), shown or not; empty: none has it, or there is one alone.
  [[nodiscard]] QString nameOf(std::uint64_t image) const;
  /// Null: it is in hand, or had no turn yet.
  [[nodiscard]] ImageTile* kept(int place) const { return kept_[static_cast<std::size_t>(place)]; }
  /// Why another image cannot be taken in hand now; empty: it can.
  std::function<QString()> whyNot;
  void refreshIcons();
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override { return {640, 640}; }

 Q_SIGNALS:
  void changed();  ///< how many there are, which is in hand, or what the others show
  void leaving();  ///< another one comes into the hand: what is half written or plays ends
  void said(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  [[nodiscard]] QRect cell(int place) const;
  void showNames();
  void fitScale();
  void forget();         ///< another patient
  void followSubject();  ///< that was edited
  [[nodiscard]] Shown shownAt(int place) const;

  InHand inHand_;
  const BodyMarkView* markView_ = nullptr;
  std::array<ImageTile*, kMost> kept_{};
  int count_ = 1;
  int active_ = 0;
  bool hasSameScale_ = false;
};

}  // namespace ew::ui
