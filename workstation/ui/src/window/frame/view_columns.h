#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>
#include <functional>

#include "window/layout/window_layout.h"

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
/// the two. Columns that take turns have one width, so that the scan stays where it is.
class ViewColumns final : public QObject {
  Q_OBJECT

 public:
  /// @param columns  holds panel, body, scan and stages, in this order
  /// @param canvas   of the 3D view, which gets its mouse events
  ViewColumns(QSplitter& columns, QWidget& panel, QWidget& body, QWidget& scan, QWidget& canvas, QObject* parent = nullptr);

  static constexpr int kNarrow_px = 1200;
  static constexpr double kBodyShare = 0.33;

  /// Gives the columns that are shown their widths.
  void follow(const WindowLayout& layout, bool showsScan, bool isStaged);
  /// A double click in this view means the scan, which it is a part of.
  void watch(QWidget& view);
  /// Nothing but the scan; told to whoever lays out the window.
  void setScanOnly(bool scanOnly) { scanOnly_ = scanOnly; }
  [[nodiscard]] bool isScanOnly() const { return scanOnly_; }
  [[nodiscard]] bool isNarrow() const;
  void swap();
  /// Gives every column its width.
  void arrange();

  /// Called before the first press of what may become a double click, and when it became one: what the press did is to be taken back.
  std::function<void()> onPress, takeBackPress;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] double share() const;
  [[nodiscard]] bool hasBoth() const;
  QSplitter& columns_;
  QWidget& panel_;
  QWidget& body_;
  QWidget& scan_;
  QWidget& canvas_;
  WindowLayout layout_;
  int panel_px_ = 0;  ///< as the layout or the user has it
  int body_px_ = 0;   ///< 0: a share
  bool staged_ = false;
  bool scanOnly_ = false;
  bool showsScan_ = true;
  bool swapped_ = false;
};

}  // namespace ew::ui
