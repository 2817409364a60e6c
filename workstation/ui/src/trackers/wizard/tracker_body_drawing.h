#pragma once

#include <QImage>
#include <QWidget>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/tracking/hand.h"

namespace ew::ui {

/// The mannequin from the front with the places that are touched while a tracker is aligned: which is next, which were taken, which one
/// does not fit to the others. Each state has a sign of its own besides its colour.
class TrackerBodyDrawing final : public QWidget {
  Q_OBJECT

 public:
  enum class Mark { offered, next, taken, bad };
  struct Place {
    std::string id;
    QString name;
    glm::dvec3 at_mm{0.0};  ///< world
    Mark mark = Mark::offered;
  };

  explicit TrackerBodyDrawing(QWidget* parent = nullptr);

  /// @param points_mm corners of the mannequin's surface, world
  void setBody(const std::vector<glm::vec3>& points_mm);
  /// Shows the part of the body around these places; without any the whole of it.
  void lookAt(const std::vector<glm::dvec3>& places_mm);
  void setPlaces(std::vector<Place> places);
  /// Where the probe's face is now by what is known, world; empty: unknown.
  void setProbe(const std::optional<glm::dvec3>& at_mm);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void chosen(const QString& id);  ///< a place was clicked

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] QPointF pixelOf(const glm::dvec3& at_mm) const;
  [[nodiscard]] double scale() const;
  void paintBody();

  std::vector<glm::vec3> body_;
  std::vector<Place> places_;
  std::optional<glm::dvec3> probe_;
  glm::dvec2 low_{-200.0, -400.0}, high_{200.0, 350.0};  ///< x and z of what is shown, mm
  QImage shade_;
};

}  // namespace ew::ui
