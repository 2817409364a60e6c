#pragma once

#include <QWidget>
#include <array>

#include "scan/session.h"

class QPushButton;
class QSlider;

namespace ew::ui {

/// The eight TGC sliders (decibels, or the paper's DGC factors), each at the middle of its eighth of the depth, with the curve through
/// their handles. A slider whose depth the zoomed image does not show is not shown either.
class DgcColumn final : public QWidget {
  Q_OBJECT

 public:
  explicit DgcColumn(Session& session, QWidget* parent = nullptr);
  /// @param top, bottom widget y of depth 0 and of the full depth; bottom lies above top when the image stands upside down
  /// @param room_px     free beside the fan at every slider; where that is less than their width all are shorter, and lie on no image
  void place(double top, double bottom, int room_px);
  void refreshIcons();

  [[nodiscard]] static int wanted_px();  ///< its width
  [[nodiscard]] static int least_px();   ///< of its width, below which no slider can be worked
  [[nodiscard]] static int head_px();    ///< above the image's top: the name and the reset button

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// What a slider is told in: values are whole numbers of `perUnit` parts of the knob's unit.
  struct Scale {
    int lowest, highest, neutral;
    double perUnit;
  };
  [[nodiscard]] bool isInDecibels() const { return session_.console().gainLaw() == GainLaw::decibel; }
  [[nodiscard]] Scale scale() const;
  [[nodiscard]] const std::array<double, kDgcSliders>& values() const;
  void set(int slider, int value);
  void showKnobs();
  void showHeld(QSlider* slider);
  /// @param value in the knob's unit
  [[nodiscard]] double xOf(double value) const;

  Session& session_;
  bool showing_ = false;
  double top_ = 0.0, bottom_ = 0.0;
  std::array<QSlider*, kDgcSliders> sliders_{};
  int width_px_ = 0;  ///< of the sliders
  QPushButton* reset_ = nullptr;
};

}  // namespace ew::ui
