#pragma once

#include <QWidget>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ew/scanning/body_side.h"

namespace ew::ui {

class AnnotatedPictures;
class BodyMarkView;
class Calipers;
class Jobs;
class KeptPicture;
class ScanView;
class Session;
class ShownMark;

/// One, two or four pictures of the scan. One of them is in hand: the window's session, calipers, texts and body mark are its own, and it
/// is the only one that may run. The others stand still (KeptPicture). Taking another one in hand lets the two change places, with
/// everything that belongs to each, so that every picture has its own console, cine loop, measurements and undo.
class PictureGrid final : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kMost = 4;

  /// What the picture in hand is shown and made with; all outlive the grid but `scan`, which becomes a part of it.
  struct InHand {
    Session& session;
    Calipers& calipers;
    AnnotatedPictures& annotated;
    ShownMark& mark;
    Jobs& jobs;
    ScanView& scan;
  };
  explicit PictureGrid(const InHand& inHand, QWidget* parent = nullptr);
  ~PictureGrid() override;
  void setMarkView(const BodyMarkView& view) { markView_ = &view; }

  /// @param pictures 1, 2 or 4; any other changes nothing. Pictures that have no room then are kept, and seen again when they have.
  void setCount(int pictures);
  [[nodiscard]] int count() const { return count_; }
  void stepCount() { setCount(count_ == 1 ? 2 : count_ == 2 ? 4 : 1); }
  /// Place of the picture in hand, from 0: left to right, then down.
  [[nodiscard]] int active() const { return active_; }
  enum class Then {
    stands,  ///< it is frozen as it was left, to be measured; where there is none yet it runs
    goesOn   ///< it runs when the one that is left ran
  };
  /// The picture in hand is frozen; the one at `place` comes into the hand.
  void take(int place, Then then);
  /// As the key L/R of a machine: a running scan goes on in the next picture, a frozen one stands.
  void takeNext() { take((active_ + 1) % count_, Then::goesOn); }

  /// All pictures at the scale of the one that shows most.
  void setSameScale(bool same);
  [[nodiscard]] bool hasSameScale() const { return hasSameScale_; }

  /// A picture that is shown, with what lies on it.
  struct Shown {
    int place = 0;
    const Session* session = nullptr;
    const Calipers* calipers = nullptr;
    const AnnotatedPictures* annotated = nullptr;
    const ShownMark* mark = nullptr;
    ScanView* view = nullptr;
    std::optional<BodySide> side;
    /// What people call it: its number, and the patient's side. Empty when it is the only one.
    QString name;
  };
  /// Those that there are, by their places.
  [[nodiscard]] std::vector<Shown> shown() const;
  /// Of the picture with this number (Calipers::picture), shown or not; empty: none has it, or there is one alone.
  [[nodiscard]] QString nameOf(std::uint64_t picture) const;
  /// Null: it is in hand, or had no turn yet.
  [[nodiscard]] KeptPicture* kept(int place) const { return kept_[static_cast<std::size_t>(place)]; }
  /// Why another picture cannot be taken in hand now; empty: it can.
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
  std::array<KeptPicture*, kMost> kept_{};
  int count_ = 1;
  int active_ = 0;
  bool hasSameScale_ = false;
};

}  // namespace ew::ui
