#include "layer_store.h"

#include <vtkCallbackCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

namespace ew::bridge {
namespace {

/// All of one framebuffer's colours into another one of the same size, whatever is bound and cut off at this moment.
void copyColours(vtkOpenGLState& state, vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to, int width, int height) {
  const vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.PushFramebufferBindings();
  from.Bind(GL_READ_FRAMEBUFFER);
  from.ActivateReadBuffer(0);
  to.Bind(GL_DRAW_FRAMEBUFFER);
  to.ActivateDrawBuffer(0);
  state.vtkglBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  state.PopFramebufferBindings();
}

}  // namespace

LayerStore::LayerStore(vtkRenderWindow& window, vtkRenderer& layer, vtkRenderer& above) : window_(window), layer_(layer), above_(above) {
  drawn_->SetClientData(this);
  drawn_->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<LayerStore*>(self)->keep(); });
  layer_.AddObserver(vtkCommand::EndEvent, drawn_);
  begun_->SetClientData(this);
  begun_->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<LayerStore*>(self)->putBack(); });
  above_.AddObserver(vtkCommand::StartEvent, begun_);
}

LayerStore::~LayerStore() {
  layer_.RemoveObserver(drawn_);
  above_.RemoveObserver(begun_);
  kept_->ReleaseGraphicsResources(&window_);
}

void LayerStore::prepare(bool isNew) {
  const int* size = window_.GetSize();
  const bool isGone = kept_->GetFBOIndex() == 0;  // with the OpenGL of its window
  if (isNew || isGone || size[0] != width_ || size[1] != height_) width_ = height_ = 0;
  layer_.SetDraw(width_ == 0);
}

void LayerStore::keep() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(&window_);
  width_ = height_ = 0;
  if (window == nullptr || window->GetMultiSamples() > 1) return;
  const int* size = window->GetSize();
  vtkOpenGLState& state = *window->GetState();
  state.PushFramebufferBindings();
  if (kept_->GetFBOIndex() == 0) {
    kept_->SetContext(window);
    kept_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, false, 0, 0);
  } else {
    kept_->Resize(size[0], size[1]);
  }
  state.PopFramebufferBindings();
  copyColours(state, *window->GetRenderFramebuffer(), *kept_, size[0], size[1]);
  width_ = size[0];
  height_ = size[1];
}

void LayerStore::putBack() {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(&window_);
  if (window == nullptr || layer_.GetDraw() != 0) return;
  copyColours(*window->GetState(), *kept_, *window->GetRenderFramebuffer(), width_, height_);
}

}  // namespace ew::bridge
