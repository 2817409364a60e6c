#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

class QSplitter;

namespace ew::ui {

class CaseInfo;

/// The 3D view, and below it what is known of the case. The case takes what its words need, at most half of the height.
class BodyColumn final : public QWidget {
  Q_OBJECT

 public:
  BodyColumn(QWidget* view3d, CaseInfo* info, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  QWidget* view3d_ = nullptr;
  CaseInfo* info_ = nullptr;
};

/// How the width is shared between the body and the scan. The scan is what is looked at: it takes two thirds until the user moves the
/// border, and the choice is remembered. In a window below kNarrow_px the body is a narrow column, and a double click in either view swaps
/// the two.
class ViewColumns final : public QObject {
  Q_OBJECT

 public:
  /// @param columns  holds panel, body, scan and stages, in this order
  /// @param canvas   of the 3D view, which gets its mouse events
  ViewColumns(QSplitter& columns, QWidget& panel, QWidget& body, QWidget& scan, QWidget& canvas, QObject* parent = nullptr);

  static constexpr int kNarrow_px = 1200;
  static constexpr double kBodyShare = 0.33;

  /// Width of the author's panels beside body and scan; what is staged there has them alone.
  void setPanelWidth(int panel_px);
  void setStaged(bool staged, int panel_px);
  /// A double click in this view means the scan, which it is a part of.
  void watch(QWidget& view);
  /// Which of the two a workspace keeps beside its panels.
  void setKept(bool body, bool scan);
  /// Nothing but the scan.
  void setScanOnly(bool scanOnly);
  [[nodiscard]] bool isScanOnly() const { return scanOnly_; }
  [[nodiscard]] bool isNarrow() const;
  [[nodiscard]] bool isSwapped() const { return swapped_; }
  void swap();
  /// Gives every column its width.
  void arrange();

  /// Called before the first press of what may become a double click, and when it became one: what the press did is to be taken back.
  std::function<void()> onPress, takeBackPress;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] double share() const;
  QSplitter& columns_;
  QWidget& panel_;
  QWidget& body_;
  QWidget& scan_;
  QWidget& canvas_;
  int panel_px_ = 0;
  bool staged_ = false;
  bool scanOnly_ = false;
  bool keepsBody_ = true, keepsScan_ = true;
  bool swapped_ = false;
};

}  // namespace ew::ui
