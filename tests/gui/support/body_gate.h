#pragma once

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QElapsedTimer>
#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPointer>
#include <QTest>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "ew/body/body_canvas.h"
#include "time_limit.h"

namespace ew::test {

/// Holds whatever a canvas draws next until it is let go, and keeps when it was. Where OpenGL knows one thread only nothing is held: it
/// would be for ever.
class BodyGate {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit BodyGate(BodyCanvas& canvas) : canvas_(&canvas) {
    events_->SetClientData(this);
    events_->SetCallback([](vtkObject*, unsigned long event, void* gate, void*) {
      event == vtkCommand::StartEvent ? static_cast<BodyGate*>(gate)->pass() : static_cast<BodyGate*>(gate)->leave();
    });
    canvas.renderWindow().AddObserver(vtkCommand::StartEvent, events_);
    canvas.renderWindow().AddObserver(vtkCommand::EndEvent, events_);
    QObject::connect(&canvas, &BodyCanvas::drawn, &listener_, [this] { drawn_.push_back(std::chrono::steady_clock::now()); });
  }
  ~BodyGate() {
    letGo();
    if (!canvas_) return;
    QElapsedTimer clock;
    clock.start();
    while (canvas_->isDrawing() && static_cast<double>(clock.elapsed()) < kPatience_ms) QTest::qWait(5);
    canvas_->renderWindow().RemoveObserver(events_);
  }
  BodyGate(const BodyGate&) = delete;
  BodyGate& operator=(const BodyGate&) = delete;

  /// On any thread.
  void letGo() {
    {
      const std::lock_guard lock(mutex_);
      isOpen_ = true;
    }
    changed_.notify_all();
  }
  /// When each drawing began.
  [[nodiscard]] std::vector<Time> begun() const {
    const std::lock_guard lock(mutex_);
    return begun_;
  }
  [[nodiscard]] int passed() const { return static_cast<int>(begun().size()); }
  [[nodiscard]] int ended() const {
    const std::lock_guard lock(mutex_);
    return ended_;
  }
  /// When drawn() told so.
  [[nodiscard]] const std::vector<Time>& drawn() const { return drawn_; }

 private:
  void pass() {
    std::unique_lock lock(mutex_);
    begun_.push_back(std::chrono::steady_clock::now());
    changed_.wait(lock, [this] { return isOpen_; });
  }
  void leave() {
    const std::lock_guard lock(mutex_);
    ++ended_;
  }

  QPointer<BodyCanvas> canvas_;
  QObject listener_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool isOpen_ = !QOpenGLContext::supportsThreadedOpenGL();
  int ended_ = 0;
  std::vector<Time> begun_, drawn_;
  vtkNew<vtkCallbackCommand> events_;
};

/// Takes away what the canvas draws into: from here on its context cannot be made current.
inline void breakContext(BodyCanvas& canvas) {
  QSurface* surface = nullptr;
  vtkNew<vtkCallbackCommand> begun;
  begun->SetClientData(&surface);
  begun->SetCallback(
      [](vtkObject*, unsigned long, void* found, void*) { *static_cast<QSurface**>(found) = QOpenGLContext::currentContext()->surface(); });
  canvas.renderWindow().AddObserver(vtkCommand::StartEvent, begun);
  canvas.drawNow(bridge::Scene3D::Edges::quick);
  canvas.renderWindow().RemoveObserver(begun);
  if (surface != nullptr && surface->surfaceClass() == QSurface::Offscreen) static_cast<QOffscreenSurface*>(surface)->destroy();
}

}  // namespace ew::test
