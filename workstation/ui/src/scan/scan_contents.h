#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "ew/scanning/cine.h"
#include "ew/scanning/post_processing.h"
#include "ew/scanning/scanner.h"

namespace ew::ui {

/// A wide image (imaging/panorama.h) in the directions of the fan's, and how it is shown.
struct WideImage {
  GreyImage grey;
  DisplayGeometry geometry;
  Detail detail;
  GreyImage whole;  ///< small
  DisplayGeometry wholeGeometry;
};

/// What is scanned and shown: an image and all that it is made with. The objects of a session share it; two sessions of one subject
/// exchange theirs, so that nothing is formed again. No clock, no hand, no signals.
struct ScanContents {
  /// Two, so that what one forms on its way to an image is not seen: the other one holds the present image.
  struct Forming {
    std::array<CineForming, 2> two;
    std::size_t shown = 0;
    bool isSeen = false;  ///< the present image was formed here
  };
  /// In place of the fan's image.
  struct Wide {
    WideImage shown;
    DisplayImage image;
    ScanState state;
  };

  Scanner scanner{0};
  ScanState live;                               ///< as the console has it, and the number of the last live image
  std::optional<ScanState> frozen;              ///< as it is shown
  ScanState asScanned;                          ///< what is frozen, before anybody changed how it is shown
  PostProcessing processing;                    ///< of what is frozen
  std::optional<ScanState> consoleWhileFrozen;  ///< once something of a frozen image was changed
  bool isProcessedAnew = false;                 ///< the frozen image is to be shown otherwise
  std::optional<ScanState> played;              ///< of a recording, in place of the console's and the hand's
  std::optional<Wide> wide;
  ScanState shown;  ///< what the latest image was made with
  DisplayImage image;
  int width_px = 0, height_px = 0;
  CineRing cine;
  std::optional<std::size_t> cineFrame;  ///< of the ring, which is frozen or wanted
  std::unique_ptr<Forming> forming;      ///< once another image than the last one was asked for
  std::size_t unsettledFrames = 0;       ///< due until persistence shows nothing of earlier images any more
  bool isOfThisScan = false;             ///< the image is one of the live scan of this subject, and may be shown once the pose is lost

  [[nodiscard]] const std::optional<ScanSubject>& subject() const { return scanner.subject(); }
  /// Neither frozen nor played: the next image is one of now.
  [[nodiscard]] bool isLive() const { return !frozen && !played; }
  [[nodiscard]] bool hasSize() const { return width_px > 0 && height_px > 0; }
  /// Whether the image has the size that is asked for.
  [[nodiscard]] bool isOfSize() const { return image.width() == width_px && image.height() == height_px; }
  /// What the console says.
  [[nodiscard]] const ScanState& console() const {
    return wide ? wide->state : played ? *played : consoleWhileFrozen ? *consoleWhileFrozen : live;
  }
  /// What is shown, but where the probe is while it runs.
  [[nodiscard]] const ScanState& settings() const { return wide ? wide->state : frozen ? *frozen : console(); }
  /// Who made the present image.
  [[nodiscard]] const Scanner& seen() const { return forming && forming->isSeen ? forming->two[forming->shown].scanner() : scanner; }
  /// The zoom of the console is that of the wide image, which is expected to be there.
  void takeWideSettings();
};

}  // namespace ew::ui
