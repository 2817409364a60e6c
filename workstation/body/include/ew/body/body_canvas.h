#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>

#include "ew/bridge/scene3d.h"

class vtkGenericOpenGLRenderWindow;

namespace ew {

class BodyDrawing;

/// Where the body is drawn: VTK draws aside, on a thread of its own into memory of the graphics driver, and the widget paints the pixels
/// as any other widget does. A widget that is itself drawn by OpenGL would have the whole window put together by OpenGL with every image of
/// the scan: without a graphics processor that takes longer than the image. There are two scenes: one answers questions, as everything was
/// asked for; the other one is drawn, and follows when there is time.
class BodyCanvas final : public QWidget {
  Q_OBJECT
  Q_PROPERTY(bool drawing READ isDrawing)

 public:
  using Change = std::function<void(bridge::Scene3D&)>;

  explicit BodyCanvas(QWidget* parent);
  ~BodyCanvas() override;

  /// As everything was asked for by change(). It is never drawn.
  [[nodiscard]] const bridge::Scene3D& scene() const { return *scene_; }
  /// Where what is painted by now was drawn from, in logical pixels of the widget: what lies over it is painted by this. As scene() while
  /// nothing is drawn.
  [[nodiscard]] bridge::Sight sight() const;
  /// In scene() now, and in what is drawn before its next image. What `change` has captured is its own.
  void change(const Change& change);
  /// In what is drawn alone: looks that scene() has no question about.
  void changeLooks(Change change);

  /// Whether there is something to draw with: once the canvas was shown, and OpenGL works. Where it fails later, notDrawn() says so first.
  [[nodiscard]] bool isValid() const;
  [[nodiscard]] bool isSoftware() const;  ///< known once something is drawn
  /// Draws when there is time; drawn() tells when it is painted, notDrawn() that it never is. Of several that are asked for meanwhile the
  /// last alone is drawn. Expects isValid().
  void draw(bridge::Scene3D::Edges edges);
  /// The same, and waits for it. @return whether it was drawn
  bool drawNow(bridge::Scene3D::Edges edges);
  /// From draw() to what tells of its end.
  [[nodiscard]] bool isDrawing() const;
  /// Waits for what was asked for. @return whether the last drawing was drawn
  Q_INVOKABLE bool finish();
  /// Of those that are seen in `window`, a plugin's too.
  [[nodiscard]] static bool isAnyDrawing(const QWidget& window);
  [[nodiscard]] static bool finishAll(const QWidget& window);
  [[nodiscard]] double took_ms() const;  ///< the last drawing

  /// For tests, after drawNow().
  [[nodiscard]] vtkGenericOpenGLRenderWindow& renderWindow() const;

 Q_SIGNALS:
  void drawn();
  /// The last image stays. Without isValid() no other one comes.
  void notDrawn();
  /// On another screen, where the widget has other pixels: until somebody asks for a drawing the last image is stretched.
  void pixelsChanged();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  bool resizeScenes();
  void take();
  [[nodiscard]] QSize size_px() const;

  vtkNew<vtkGenericOpenGLRenderWindow> asked_;  ///< of scene_
  std::unique_ptr<bridge::Scene3D> scene_;
  QSize sized_px_;
  QImage image_;
  bridge::Sight sight_;                   ///< of image_
  bool isDrawn_ = false;                  ///< what was asked for last
  bool hasGivenUp_ = false;               ///< the context did not work where it was to be drawn
  std::unique_ptr<BodyDrawing> drawing_;  ///< ends first
};

}  // namespace ew
