#pragma once

#include <QWidget>
#include <array>

#include "session.h"

class QComboBox;
class QPushButton;
class QSlider;

namespace ew::ui {

class FigureLabel;

/// The machine's front panel: eight DGC sliders, gain, depth, focus, zoom, quality, probe, freeze. It shows and sets the session's knobs.
class ConsolePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ConsolePanel(Session& session, QWidget* parent = nullptr);

  /// A step of the keyboard: depth by 10 mm, gain by 5 %, zoom by 0.5; held within the range.
  void stepDepth(int steps);
  void stepGain(int steps);
  void stepZoom(int steps);
  void resetDgc();
  void chooseQuality(Quality quality);
  void flip();
  void refreshIcons();

 private:
  struct Row {
    QSlider* slider = nullptr;
    FigureLabel* value = nullptr;
  };
  Row addRow(const QString& name, const QString& objectName, const QString& widest, const QString& tip);
  void addDgc();
  void addChoices();
  void showKnobs();
  void showProbes();
  template <class Change>
  void change(Change&& apply);

  Session& session_;
  bool showing_ = false;
  std::array<QSlider*, kDgcSliders> dgc_{};
  Row gain_, depth_, focus_, zoom_;
  QPushButton* reset_ = nullptr;
  QPushButton* weave_ = nullptr;
  QPushButton* linear_ = nullptr;
  QPushButton* flip_ = nullptr;
  QPushButton* freeze_ = nullptr;
  QComboBox* probe_ = nullptr;
};

}  // namespace ew::ui
