#include "body_drawing.h"

#include <spdlog/spdlog.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QElapsedTimer>
#include <QMetaObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QThread>
#include <utility>

#include "ew/core/contract.h"
#include "ew/core/guarded.h"
#include "ew/core/quiet_work.h"

namespace ew {
namespace {

// Of later versions than what QOpenGLFunctions name.
constexpr unsigned int kReadFramebuffer = 0x8CA8;
constexpr unsigned int kBgra = 0x80E1;
constexpr std::uint32_t kOpaque = 0xFF000000;
constexpr int kGivesWay = 5;  ///< nice: a third of what the scan gets where both want the processor

/// What Mesa, and what systems without a driver of their own, call drawing by the processor.
bool isSoftwareRenderer(const QByteArray& name) {
  for (const char* each : {"llvmpipe", "softpipe", "swrast", "Software", "GDI Generic", "SwiftShader", "Basic Render"})
    if (name.contains(each)) return true;
  return false;
}

/// What fails is left out; nobody else hears of it.
void attempt(const std::function<void()>& work) {
  static_cast<void>(guarded(work, [](const Thrown& thrown) {
    spdlog::error("A change or a drawing of the body failed: {}", thrown.reason.english());
    return Error{ErrorCode::internal, thrown.reason, {}};
  }));
}

}  // namespace

BodyDrawing::BodyDrawing(std::function<void()> tell) : tell_(std::move(tell)) {
  window_->SetReadyForRendering(false);
  window_->SetMultiSamples(0);
  asked_->SetClientData(this);
  asked_->SetCallback([](vtkObject*, unsigned long event, void* self, void* answer) {
    const auto& drawing = *static_cast<BodyDrawing*>(self);
    if (event == vtkCommand::WindowMakeCurrentEvent && drawing.context_) drawing.context_->makeCurrent(drawing.surface_.get());
    if (event == vtkCommand::WindowIsCurrentEvent)
      *static_cast<bool*>(answer) = drawing.context_ && QOpenGLContext::currentContext() == drawing.context_.get();
  });
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, asked_);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, asked_);
  scene_ = std::make_unique<bridge::Scene3D>(*window_);
}

BodyDrawing::~BodyDrawing() {
  if (thread_) {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    thread_->wait();
  } else {
    endOpenGL();
  }
  scene_.reset();
  window_->RemoveObserver(asked_);
}

void BodyDrawing::begin() {
  if (std::exchange(isTried_, true)) return;
  auto context = std::make_unique<QOpenGLContext>();
  if (!context->create()) return;
  surface_ = std::make_unique<QOffscreenSurface>();
  surface_->setFormat(context->format());
  surface_->create();
  if (!context->makeCurrent(surface_.get())) return;
  context->doneCurrent();
  context_ = std::move(context);
  if (!QOpenGLContext::supportsThreadedOpenGL()) return;
  thread_.reset(QThread::create([this] { run(); }));
  context_->moveToThread(thread_.get());
  thread_->start();
}

void BodyDrawing::beginOpenGL() {
  if (std::exchange(isBegun_, true)) return;
  const bool isSoftware = isSoftwareRenderer(reinterpret_cast<const char*>(context_->functions()->glGetString(GL_RENDERER)));
  {
    const std::lock_guard lock(mutex_);
    isSoftware_ = isSoftware;
  }
  window_->SetReadyForRendering(true);
  window_->InitializeFromCurrentContext();
  window_->SetForceMaximumHardwareLineWidth(1.0F);
  window_->SetOwnContext(0);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMapped(1);
}

/// What OpenGL has of the scene goes while its context is there.
void BodyDrawing::endOpenGL() {
  if (!context_ || !context_->makeCurrent(surface_.get())) return;
  scene_.reset();
  if (isBegun_) window_->Finalize();
  window_->SetReadyForRendering(false);
  context_->doneCurrent();
}

bool BodyDrawing::isSoftware() const {
  const std::lock_guard lock(mutex_);
  return isSoftware_;
}

bool BodyDrawing::isDrawing() const {
  const std::lock_guard lock(mutex_);
  return next_.edges || isDrawing_ || ended_;
}

std::optional<BodyDrawing::Ended> BodyDrawing::takeEnded() {
  const std::lock_guard lock(mutex_);
  return std::exchange(ended_, {});
}

double BodyDrawing::took_ms() const {
  const std::lock_guard lock(mutex_);
  return took_ms_;
}

void BodyDrawing::change(Change change) {
  {
    const std::lock_guard lock(mutex_);
    next_.changes.push_back(std::move(change));
  }
  goOn();
}

void BodyDrawing::resize(const QSize& size_px) {
  change([this, size_px](bridge::Scene3D& scene) {
    window_->SetSize(size_px.width(), size_px.height());
    static_cast<void>(scene.mmPerPixelAt(glm::dvec3(0.0)));  // asked now, its camera knows the size before what comes next moves it
  });
}

void BodyDrawing::draw(bridge::Scene3D::Edges edges) {
  EW_EXPECTS(canDraw());
  {
    const std::lock_guard lock(mutex_);
    next_.edges = edges;
  }
  goOn();
}

void BodyDrawing::wait() {
  if (!thread_) return doNow();
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return next_.isEmpty() && !isAtWork_; });
}

void BodyDrawing::goOn() {
  if (thread_) return changed_.notify_all();
  // Whoever asks has more to ask for in this turn, and may be painting.
  if (std::exchange(isPosted_, true)) return;
  QMetaObject::invokeMethod(
      &here_,
      [this] {
        isPosted_ = false;
        if (!thread_) doNow();
      },
      Qt::QueuedConnection);
}

void BodyDrawing::doNow() {
  if (!next_.isEmpty()) work(std::exchange(next_, {}));
}

void BodyDrawing::run() {
  const QuietWork quietly(kGivesWay);
  QThread* const application = surface_->thread();
  while (true) {
    Batch batch;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return ends_ || !next_.isEmpty(); });
      if (ends_) break;
      batch = std::exchange(next_, {});
      isAtWork_ = true;
      isDrawing_ = batch.edges.has_value();
    }
    work(batch);
    batch = {};  // what it holds may be large, and goes here
    {
      const std::lock_guard lock(mutex_);
      isAtWork_ = isDrawing_ = false;
    }
    changed_.notify_all();
  }
  endOpenGL();
  context_->moveToThread(application);
}

void BodyDrawing::work(const Batch& batch) {
  const bool isCurrent = batch.edges && context_ && context_->makeCurrent(surface_.get());
  QElapsedTimer clock;
  clock.start();
  // Each by itself: what one of them leaves out, the others are not to miss.
  for (const Change& each : batch.changes) attempt([&] { each(*scene_); });
  QImage made;  // without memory for it the last image stays
  if (isCurrent)
    attempt([&] {
      beginOpenGL();
      scene_->render(*batch.edges);
      made = pixels();
    });
  // For a change alone VTK makes it current where it has something to free.
  if (context_ && QOpenGLContext::currentContext() == context_.get()) context_->doneCurrent();
  if (!batch.edges) return;
  {
    const std::lock_guard lock(mutex_);
    if (!ended_) ended_ = Ended{};
    ended_->isDrawn = !made.isNull();
    ended_->hasContext = isCurrent;
    if (ended_->isDrawn) {
      ended_->image = std::move(made);
      ended_->sight = scene_->sight();
      took_ms_ = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    }
  }
  tell_();
}

QImage BodyDrawing::pixels() {
  const int width = window_->GetSize()[0], height = window_->GetSize()[1];
  QImage made(width, height, QImage::Format_RGB32);
  if (made.isNull()) return {};  // there is no memory for it: QImage does not throw
  upwards_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  vtkOpenGLState& state = *window_->GetState();
  state.PushReadFramebufferBinding();
  window_->GetRenderFramebuffer()->Bind(kReadFramebuffer);
  window_->GetRenderFramebuffer()->ActivateReadBuffer(0);
  context_->functions()->glReadPixels(0, 0, width, height, kBgra, GL_UNSIGNED_BYTE, upwards_.data());
  state.PopReadFramebufferBinding();
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* from = upwards_.data() + static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width);
    auto* to = reinterpret_cast<std::uint32_t*>(made.scanLine(y));
    for (int x = 0; x < width; ++x) to[x] = from[x] | kOpaque;  // what was drawn through lets nothing through here
  }
  return made;
}

}  // namespace ew
