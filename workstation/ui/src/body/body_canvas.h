#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class QOffscreenSurface;
class QOpenGLContext;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;

namespace ew::ui {

/// Where the body is drawn: VTK draws aside, into memory of the graphics driver, and the widget paints the pixels as any other widget
/// does. A widget that is itself drawn by OpenGL would have the whole window put together by OpenGL with every image of the scan: without
/// a graphics processor that takes longer than the image.
class BodyCanvas final : public QWidget {
  Q_OBJECT

 public:
  explicit BodyCanvas(QWidget* parent);
  ~BodyCanvas() override;

  [[nodiscard]] vtkGenericOpenGLRenderWindow& renderWindow() const { return *window_; }
  /// Whether there is something to draw with: once the canvas was shown, and OpenGL is there.
  [[nodiscard]] bool isValid() const { return context_ != nullptr; }
  /// Whether everything is drawn by the processor.
  [[nodiscard]] bool isSoftware() const { return isSoftware_; }
  /// Draws by `render`, which renders the window, and shows it. Expects isValid().
  void draw(const std::function<void()>& render);
  /// Draws at once, where the canvas is to be painted in another size than it was drawn in.
  std::function<void()> drawAgain;

 Q_SIGNALS:
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void begin();
  void takePixels();
  [[nodiscard]] QSize size_px() const;

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkCallbackCommand> asked_;
  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;  ///< null: none could be made, or not yet
  bool isSoftware_ = false;
  bool isTried_ = false;
  QImage image_;
  std::vector<std::uint32_t> upwards_;  ///< the pixels as OpenGL has them, from the lowest row
};

}  // namespace ew::ui
