#pragma once

#include <vtkNew.h>

class vtkCallbackCommand;
class vtkOpenGLFramebufferObject;
class vtkRenderWindow;
class vtkRenderer;

namespace ew::bridge {

/// What the lowest layer of a render window shows, kept beside the window: as long as nothing in that layer changes, its pixels are copied
/// in place of being drawn, and only the layers above are. Without multisampling, so that the pixels are the same.
class LayerStore {
 public:
  /// @param above renders next after `layer`. Both belong to the window and live longer
  LayerStore(vtkRenderWindow& window, vtkRenderer& layer, vtkRenderer& above);
  ~LayerStore();
  LayerStore(const LayerStore&) = delete;
  LayerStore& operator=(const LayerStore&) = delete;

  /// To be called before each rendering of the window. @param isNew the layer shows something else than before
  void prepare(bool isNew);

 private:
  void keep();
  void putBack();

  vtkRenderWindow& window_;
  vtkRenderer& layer_;
  vtkRenderer& above_;
  vtkNew<vtkOpenGLFramebufferObject> kept_;
  vtkNew<vtkCallbackCommand> drawn_, begun_;
  int width_ = 0, height_ = 0;  ///< of what is kept; 0: nothing is
};

}  // namespace ew::bridge
