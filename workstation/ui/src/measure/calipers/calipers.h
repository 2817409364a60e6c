#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/imaging/display.h"
#include "ew/measurement/caliper_drawing.h"
#include "ew/measurement/findings.h"
#include "ew/measurement/package.h"
#include "ew/measurement/strip.h"
#include "measure/calipers/measurement_work.h"
#include "measure/words/caliper_words.h"
#include "scan/still_image.h"

namespace ew::ui {

class Jobs;
class Session;

/// The measurements of the image that stands still: what was drawn on it, and what that measures. They belong to one image: another
/// one of the cine loop or of a recording has its own, and they are there again when it is. The scan that goes on, or the recording that is
/// closed, takes all of them away.
/// Those of the strip belong to moments of the scan, which the strip shows live or frozen: they stay with their echoes, and in the list
/// when those have left. What all of them measured is found together for results over several images, and stays until another patient
/// comes.
class Calipers final : public QObject {
  Q_OBJECT

 public:
  /// @param jobs look for the edges that outlines follow
  Calipers(Session& session, Jobs& jobs, QObject* parent = nullptr);

  /// Takes a tool into the hand, or puts it down when it is there already. A live image is frozen, what plays is paused.
  /// What an item of a package is measured with it stays for, when another tool is taken that gives the same.
  /// A tool of the strip leaves the image as it runs; a distance that is taken where there is only the strip is one of depth.
  void take(measurement::CaliperKind kind);
  /// Takes the tool that an item is usually measured with; what it draws is measured for the item. @param side of a sided one
  void takeFor(const measurement::PackageItem& item, const std::string& side);
  /// Pauses what plays: a point is set in an image that stands still.
  void hold() { Q_EMIT pauseAsked(); }
  /// The one that was used last: undo, keys and the tool at hand are its own.
  [[nodiscard]] const measurement::CaliperDrawing& drawing() const { return drawingIn(where_); }
  [[nodiscard]] const measurement::CaliperDrawing& drawingIn(Where where) const {
    return where == Where::strip ? strips_[session_.isPlaying() ? 1 : 0] : drawn_.now().drawing;
  }
  [[nodiscard]] Where where() const { return where_; }
  /// Of the image that is measured: never the same for two. Empty: none is.
  [[nodiscard]] std::optional<std::uint64_t> image() const;
  [[nodiscard]] std::uint64_t strip() const { return measurement::kStripImage + 2 * stripNumber_ + (session_.isPlaying() ? 1 : 0); }
  /// What is drawn changes places with that of another one, as their sessions' images do (Session::exchangeImage): before those. The
  /// tool is put down. Nobody is told before tellOfAll().
  void exchange(Calipers& other);
  void tellOfAll();
  /// The one way to change what is drawn: the one that was used last, or that of a place, which is used then.
  void change(const std::function<void(measurement::CaliperDrawing&)>& edit) { changeIn(where_, edit); }
  void changeIn(Where where, const std::function<void(measurement::CaliperDrawing&)>& edit);
  /// Chooses a line of the list.
  void choose(Where where, int number);
  void clear();  ///< of the image and of the strip

  /// Time and depth of the strip's pixels. As long as this image is shown.
  [[nodiscard]] measurement::StripPlane stripPlane() const;
  [[nodiscard]] bool hasStrip() const;
  /// Heart beats between the cursors of the heart rate that is chosen, and of those drawn from now on.
  void setBeats(int beats);
  [[nodiscard]] int beats() const;

  /// Whether an outline that is clicked follows the edge it goes around.
  void setFollowsEdges(bool follows);
  [[nodiscard]] bool followsEdges() const { return followsEdges_; }

  /// Whether points are drawn to crosses, edges and levels nearby.
  void setSnaps(bool snaps);
  [[nodiscard]] bool snaps() const { return snaps_; }

  struct Line {
    measurement::Measurement measurement;
    measurement::Measured measured;  ///< without figures: nothing can be measured yet
    Where where = Where::image;
    measurement::UncertaintyAt at = {};  ///< as it was measured with
    bool hasLeft = false;                ///< some of its echoes are not in the strip any more, or not yet
  };
  /// What is drawn, in its order; that of the strip behind that of the image.
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
  /// What is being drawn, with the pointer as its next point.
  [[nodiscard]] const std::optional<Line>& unfinished() const { return unfinished_; }
  [[nodiscard]] const measurement::UncertaintyAt& uncertainty(Where where = Where::image) const {
    return where == Where::strip ? stripAt_ : uncertaintyAt_;
  }

  /// All that was measured for this patient, and results over several images.
  [[nodiscard]] const measurement::Findings& findings() const { return findings_; }
  /// Of these, how many were not written to a file as they are now. What was measured for an item is none of them: it stands in its
  /// worksheet, which asks for itself.
  [[nodiscard]] std::size_t unsavedCount() const;
  [[nodiscard]] bool isUnsaved() const { return unsavedCount() > 0; }
  void setSaved(const measurement::Findings& written);
  /// All that was measured before the program ended, in place of what there is. Its images are shown as the frames of a recording, if they
  /// are: then the calipers are drawn on them.
  /// @param frames of each image the one that shows it; empty: none does
  void restore(const std::vector<ImageMeasurements>& images, const std::vector<StillImage>& frames,
               const std::vector<measurement::Combination>& combinations);
  /// How the points of an image are known, which need not be on the screen. @param image as image() or strip()
  [[nodiscard]] static measurement::UncertaintyAt uncertaintyIn(const ImageMeasurements& image);
  int combine(measurement::CombinationKind kind, std::vector<measurement::FigureRef> of);
  void removeCombination(int number);

 Q_SIGNALS:
  void changed();
  void linesChanged();  ///< what is drawn, or what it measures: not the pointer's way
  void pauseAsked();    ///< of a recording or the cine loop
  void said(const QString& sentence);

 private:
  struct Drawn {
    measurement::CaliperDrawing drawing = measurement::CaliperDrawing();
    std::uint64_t image = 0;
  };
  void putDown();
  void takeInto(measurement::CaliperKind kind, const measurement::CaliperDrawing::Purpose& purpose);
  void takeInStrip(measurement::CaliperKind kind, const measurement::CaliperDrawing::Purpose& purpose);
  void putDownOther();
  void followStrip();
  void forgetAll();    ///< of a patient
  void forgetDrawn();  ///< of a scan: what was measured stays
  void measureLines(Where where, const measurement::Measurements& shown, std::vector<Line>& now);
  [[nodiscard]] bool hasLeft(const measurement::Caliper& caliper) const;
  [[nodiscard]] measurement::CaliperDrawing& mine(Where where = Where::image) {
    return where == Where::strip ? strips_[session_.isPlaying() ? 1 : 0] : drawn_.now().drawing;
  }
  /// The tool stays in the hand.
  void turnTo(const StillImage& image);
  void look();
  void forget();
  void measureAll();
  void followEdge(int number);
  [[nodiscard]] static measurement::Measured measured(const measurement::Caliper& caliper, const measurement::UncertaintyAt& at);

  Session& session_;
  Jobs& jobs_;
  OfImages<Drawn> drawn_;
  std::uint64_t nextImage_ = 1;
  DisplayGeometry geometry_;
  measurement::UncertaintyAt uncertaintyAt_;
  std::vector<Line> lines_;
  std::optional<Line> unfinished_;
  std::array<measurement::CaliperDrawing, 2> strips_;  ///< of the scan, and of a recording that is shown: each has a clock of its own
  std::uint64_t stripNumber_ = 0, nextStrip_ = 0;      ///< each image beside others has a strip of its own
  bool hadStrip_ = false;
  bool wasPlaying_ = false;
  Where where_ = Where::image;
  measurement::UncertaintyAt stripAt_;
  measurement::Findings findings_;
  measurement::Findings saved_;  ///< as they were written last
  bool followsEdges_ = false;
  bool snaps_ = false;
};

}  // namespace ew::ui
