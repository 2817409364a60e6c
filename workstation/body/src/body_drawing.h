#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QObject>
#include <QSize>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "ew/bridge/scene3d.h"

class QOffscreenSurface;
class QOpenGLContext;
class QThread;
class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;

namespace ew {

/// A scene, drawn by OpenGL into an image on a thread of its own, which gives way to others. Where the system's OpenGL knows one thread
/// only, on the application's, in the turn of its event loop after the one in which it was asked for. All functions are called on the
/// thread of the application; `tell` comes on the drawing's.
class BodyDrawing {
 public:
  using Change = std::function<void(bridge::Scene3D&)>;

  /// @param tell a drawing has ended
  explicit BodyDrawing(std::function<void()> tell);
  ~BodyDrawing();  ///< waits for the image that is being drawn, if one is
  BodyDrawing(const BodyDrawing&) = delete;
  BodyDrawing& operator=(const BodyDrawing&) = delete;

  /// Makes the context, once. Nothing can be drawn before.
  void begin();
  [[nodiscard]] bool canDraw() const { return context_ != nullptr; }
  /// Whether everything is drawn by the processor; known with the first image.
  [[nodiscard]] bool isSoftware() const;

  /// Before the next image, after all earlier changes. What it has captured is its own: it runs while the application goes on.
  void change(Change change);
  void resize(const QSize& size_px);
  /// Of several that are asked for while one is drawn the last alone is drawn. Expects canDraw().
  void draw(bridge::Scene3D::Edges edges);
  /// Until all that was asked for is drawn.
  void wait();
  /// Whether an image is wanted, being drawn, or still to be taken. Changes alone are no drawing.
  [[nodiscard]] bool isDrawing() const;
  /// What has ended since somebody asked last.
  struct Ended {
    QImage image;            ///< the newest, opaque; null: there is none since
    bridge::Sight sight;     ///< where from that was drawn
    bool isDrawn = false;    ///< the last one that was asked for
    bool hasContext = true;  ///< false: OpenGL did not work where it was drawn, and will not the next time
  };
  [[nodiscard]] std::optional<Ended> takeEnded();
  /// How long the last image took.
  [[nodiscard]] double took_ms() const;

  /// For tests, between wait() and what is asked for next.
  [[nodiscard]] vtkGenericOpenGLRenderWindow& renderWindow() const { return *window_; }

 private:
  struct Batch {
    std::vector<Change> changes;
    std::optional<bridge::Scene3D::Edges> edges;  ///< empty: nothing is drawn
    [[nodiscard]] bool isEmpty() const { return changes.empty() && !edges; }
  };
  void run();
  void goOn();
  void doNow();
  void work(const Batch& batch);
  void beginOpenGL();
  void endOpenGL();
  [[nodiscard]] QImage pixels();

  std::function<void()> tell_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkCallbackCommand> asked_;
  std::unique_ptr<bridge::Scene3D> scene_;
  std::unique_ptr<QOffscreenSurface> surface_;
  std::unique_ptr<QOpenGLContext> context_;  ///< null: none could be made, or not yet
  bool isTried_ = false, isBegun_ = false;
  std::vector<std::uint32_t> upwards_;  ///< the pixels as OpenGL has them, from the lowest row

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Batch next_;
  bool isAtWork_ = false, isDrawing_ = false, ends_ = false, isSoftware_ = false;
  std::optional<Ended> ended_;
  double took_ms_ = 0.0;
  std::unique_ptr<QThread> thread_;  ///< null: on the application's
  QObject here_;                     ///< of the application's thread
  bool isPosted_ = false;
};

}  // namespace ew
