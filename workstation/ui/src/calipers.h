#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ew/imaging/display.h"
#include "ew/measurement/caliper_drawing.h"
#include "ew/measurement/package.h"
#include "still_picture.h"

namespace ew::ui {

class Jobs;
class Session;

/// The measurements of the picture that stands still: what was drawn on it, and what that measures. They belong to one picture: another
/// one of the cine loop or of a recording has its own, and they are there again when it is. The scan that goes on, or the recording that is
/// closed, takes all of them away.
class Calipers final : public QObject {
  Q_OBJECT

 public:
  /// @param jobs look for the edges that outlines follow
  Calipers(Session& session, Jobs& jobs, QObject* parent = nullptr);

  /// Takes a tool into the hand, or puts it down when it is there already. A live image is frozen, what plays is paused.
  /// What an item of a package is measured with it stays for, when another tool is taken that gives the same.
  void take(measurement::CaliperKind kind);
  /// Takes the tool that an item is usually measured with; what it draws is measured for the item. @param side of a sided one
  void takeFor(const measurement::PackageItem& item, const std::string& side);
  /// Pauses what plays: a point is set in a picture that stands still.
  void hold() { Q_EMIT pauseAsked(); }
  [[nodiscard]] const measurement::CaliperDrawing& drawing() const { return drawn_.now().drawing; }
  /// Of the picture that is measured: never the same for two. Empty: none is.
  [[nodiscard]] std::optional<std::uint64_t> picture() const;
  /// The one way to change what is drawn.
  void change(const std::function<void(measurement::CaliperDrawing&)>& edit);

  /// Whether an outline that is clicked follows the edge it goes around.
  void setFollowsEdges(bool follows);
  [[nodiscard]] bool followsEdges() const { return followsEdges_; }

  struct Line {
    measurement::Measurement measurement;
    measurement::Measured measured;  ///< without figures: nothing can be measured yet
  };
  /// What is drawn, in its order.
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
  /// What is being drawn, with the pointer as its next point.
  [[nodiscard]] const std::optional<Line>& unfinished() const { return unfinished_; }
  [[nodiscard]] const measurement::UncertaintyAt& uncertainty() const { return uncertaintyAt_; }

 Q_SIGNALS:
  void changed();
  void linesChanged();  ///< what is drawn, or what it measures: not the pointer's way
  void pauseAsked();    ///< of a recording or the cine loop
  void said(const QString& sentence);

 private:
  struct Drawn {
    measurement::CaliperDrawing drawing = measurement::CaliperDrawing();
    std::uint64_t picture = 0;
  };
  void takeInto(measurement::CaliperKind kind, const measurement::CaliperDrawing::Purpose& purpose);
  [[nodiscard]] measurement::CaliperDrawing& mine() { return drawn_.now().drawing; }
  /// The tool stays in the hand.
  void turnTo(const StillPicture& picture);
  void look();
  void forget();
  void measureAll();
  void followEdge(int number);
  [[nodiscard]] measurement::Measured measured(const measurement::Caliper& caliper) const;

  Session& session_;
  Jobs& jobs_;
  OfPictures<Drawn> drawn_;
  std::uint64_t nextPicture_ = 1;
  DisplayGeometry geometry_;
  measurement::UncertaintyAt uncertaintyAt_;
  std::vector<Line> lines_;
  std::optional<Line> unfinished_;
  bool followsEdges_ = false;
};

}  // namespace ew::ui
