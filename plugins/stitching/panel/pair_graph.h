#pragma once

#include <QWidget>
#include <vector>

#include "panel/stitch_results.h"

namespace ew::stitching {

class ProjectDocument;
class StitchLook;
class StitchSession;

/// The subvolumes as nodes on a ring, the pairs as edges: drawn through, dashed or crossed out by verdict. A click chooses an edge or a
/// node; the arrow keys go from pair to pair.
class PairGraph final : public QWidget {
  Q_OBJECT

 public:
  explicit PairGraph(StitchSession& session, QWidget* parent = nullptr);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// Where things are drawn, for tests.
  [[nodiscard]] QPointF nodeAt(std::size_t volume) const;
  [[nodiscard]] QPointF middleOfEdge(std::size_t a, std::size_t b) const;
  Q_INVOKABLE QPointF middleOfPair(int a, int b) const { return middleOfEdge(static_cast<std::size_t>(a), static_cast<std::size_t>(b)); }
  void chooseNext(int step);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] int nodeUnder(const QPointF& at) const;
  [[nodiscard]] const StitchResults::PairLine* edgeUnder(const QPointF& at) const;
  const ProjectDocument& document_;
  const StitchResults& results_;
  StitchLook& look_;
  std::vector<StitchResults::PairLine> lines_;
  QPointF pointer_{-1, -1};
};

}  // namespace ew::stitching
