#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <optional>

#include "scan/frame_timer.h"
#include "scan/scan_contents.h"

namespace ew::ui {

/// The last seconds of a scan: its ring of images, and which of them is frozen.
class CineLoop final : public QObject {
  Q_OBJECT

 public:
  /// @param scan,frames must live longer
  CineLoop(ScanContents& scan, FrameTimer& frames);

  /// Since the scan was let run last, another probe was taken or a recording was shown. It rests while frozen.
  [[nodiscard]] const CineRing& ring() const { return scan_.cine; }
  /// Frozen, shows another image of the ring: the same pixels, formed again. Where many before it have to be formed as well (persistence,
  /// M-mode), that goes on between other events, and the present image stays meanwhile; who asks for another one by then gets that.
  void show(std::size_t frame);
  /// Which image of the ring is frozen, or wanted; empty while it runs, and when the ring is empty.
  [[nodiscard]] std::optional<std::size_t> frame() const { return scan_.cineFrame; }
  [[nodiscard]] bool isForming() const { return formOn_.isActive(); }

  /// The latest image is the frozen one.
  void freezeLatest();
  /// The scan runs on: as a machine does, the next loop is of the next scan.
  void runOn();
  /// What was seen cannot be formed again.
  void forget();
  /// Forms the wanted image of the ring: now where that is quick, else between other events.
  void form();
  void stop() { formOn_.stop(); }

 Q_SIGNALS:
  void changed();   ///< which image of the ring is wanted, or the ring itself while frozen
  void replaced();  ///< by the ring of another image
  void formed();    ///< the wanted image is the one that is shown

 private:
  void formOn();
  void showFormed(std::size_t which);

  ScanContents& scan_;
  FrameTimer& frames_;
  QTimer formOn_;
};

}  // namespace ew::ui
