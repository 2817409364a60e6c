#include "body/body_canvas.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPaintEvent>
#include <QPainter>
#include <utility>

#include "ew/core/contract.h"

namespace ew::ui {
namespace {

// Of later versions than what QOpenGLFunctions name.
constexpr unsigned int kReadFramebuffer = 0x8CA8;
constexpr unsigned int kBgra = 0x80E1;
constexpr std::uint32_t kOpaque = 0xFF000000;

/// What Mesa, and what systems without a driver of their own, call drawing by the processor.
bool isSoftwareRenderer(const QByteArray& name) {
  for (const char* each : {"llvmpipe", "softpipe", "swrast", "Software", "GDI Generic", "SwiftShader", "Basic Render"})
    if (name.contains(each)) return true;
  return false;
}

}  // namespace

BodyCanvas::BodyCanvas(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  window_->SetReadyForRendering(false);
  window_->SetMultiSamples(0);
  asked_->SetClientData(this);
  asked_->SetCallback([](vtkObject*, unsigned long event, void* self, void* answer) {
    const auto& canvas = *static_cast<BodyCanvas*>(self);
    if (event == vtkCommand::WindowMakeCurrentEvent && canvas.context_) canvas.context_->makeCurrent(canvas.surface_.get());
    if (event == vtkCommand::WindowIsCurrentEvent)
      *static_cast<bool*>(answer) = canvas.context_ && QOpenGLContext::currentContext() == canvas.context_.get();
  });
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, asked_);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, asked_);
}

BodyCanvas::~BodyCanvas() {
  if (context_ && context_->makeCurrent(surface_.get())) {
    window_->Finalize();
    context_->doneCurrent();
  }
  window_->SetReadyForRendering(false);
  window_->RemoveObserver(asked_);
}

void BodyCanvas::begin() {
  if (std::exchange(isTried_, true)) return;
  auto context = std::make_unique<QOpenGLContext>();
  if (!context->create()) return;
  surface_ = std::make_unique<QOffscreenSurface>();
  surface_->setFormat(context->format());
  surface_->create();
  if (!context->makeCurrent(surface_.get())) return;
  context_ = std::move(context);
  isSoftware_ = isSoftwareRenderer(reinterpret_cast<const char*>(context_->functions()->glGetString(GL_RENDERER)));
  window_->SetReadyForRendering(true);
  window_->InitializeFromCurrentContext();
  window_->SetForceMaximumHardwareLineWidth(1.0F);
  window_->SetOwnContext(0);
  window_->OpenGLInitContext();
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMapped(1);
  context_->doneCurrent();
}

QSize BodyCanvas::size_px() const { return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1}); }

void BodyCanvas::draw(const std::function<void()>& render) {
  EW_EXPECTS(isValid());
  context_->makeCurrent(surface_.get());
  window_->SetSize(size_px().width(), size_px().height());
  render();
  takePixels();
  context_->doneCurrent();
  update();
  Q_EMIT drawn();
}

void BodyCanvas::takePixels() {
  const int width = window_->GetSize()[0], height = window_->GetSize()[1];
  if (image_.size() != QSize(width, height)) image_ = QImage(width, height, QImage::Format_RGB32);
  upwards_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  vtkOpenGLState& state = *window_->GetState();
  state.PushReadFramebufferBinding();
  window_->GetRenderFramebuffer()->Bind(kReadFramebuffer);
  window_->GetRenderFramebuffer()->ActivateReadBuffer(0);
  context_->functions()->glReadPixels(0, 0, width, height, kBgra, GL_UNSIGNED_BYTE, upwards_.data());
  state.PopReadFramebufferBinding();
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* from = upwards_.data() + static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width);
    auto* to = reinterpret_cast<std::uint32_t*>(image_.scanLine(y));
    for (int x = 0; x < width; ++x) to[x] = from[x] | kOpaque;  // what was drawn through lets nothing through here
  }
}

void BodyCanvas::paintEvent(QPaintEvent* event) {
  if (isValid() && image_.size() != size_px() && drawAgain) drawAgain();
  QPainter painter(this);
  if (image_.size() != size_px()) return painter.fillRect(event->rect(), Qt::black);
  image_.setDevicePixelRatio(devicePixelRatioF());
  painter.drawImage(QPoint(0, 0), image_);
}

void BodyCanvas::resizeEvent(QResizeEvent*) { window_->SetSize(size_px().width(), size_px().height()); }

void BodyCanvas::showEvent(QShowEvent*) { begin(); }

}  // namespace ew::ui
