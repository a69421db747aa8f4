// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/offscreen_renderer.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>
#include <vtk_glew.h>

#include <algorithm>

#include "glisson/core/error.h"

namespace glisson::scene {
namespace {

constexpr const char* kRemedy =
    "Drawing without a screen needs EGL: install libegl1 and libgl1-mesa-dri, or set "
    "LIBGL_ALWAYS_SOFTWARE=1 when the graphics driver has none.";

/// An OpenGL context that belongs to no window. The EGL display is the process's and stays initialised.
class EglContext {
 public:
  EglContext() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display != nullptr)
      display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
      throw Error(std::string("No EGL display could be opened. ") + kRemedy);
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
      throw Error(std::string("EGL offers no desktop OpenGL. ") + kRemedy);
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &found) == EGL_FALSE || found == 0)
      throw Error(std::string("EGL offers no 8-bit colour buffer. ") + kRemedy);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) throw Error(std::string("EGL offers no OpenGL 3.2. ") + kRemedy);
  }
  ~EglContext() { eglDestroyContext(display_, context_); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const {
    // The API is a thread's state: bind it again on whichever thread this is.
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      throw Error(std::string("The EGL context could not be made current on this thread. ") + kRemedy);
  }
  void release() const { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  bool is_current() const { return eglGetCurrentContext() == context_; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// Current for the length of a scope.
class CurrentScope {
 public:
  explicit CurrentScope(const EglContext& context) : context_(context) { context_.make_current(); }
  ~CurrentScope() { context_.release(); }
  CurrentScope(const CurrentScope&) = delete;
  CurrentScope& operator=(const CurrentScope&) = delete;

 private:
  const EglContext& context_;
};

/// Debian's GLEW knows GLX only: it loads every entry point and then complains that there is no X display.
/// That one complaint is no failure here, so the initialisation is done by this class.
class EglRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static EglRenderWindow* New();
  vtkTypeMacro(EglRenderWindow, vtkGenericOpenGLRenderWindow)

      void set_context(const EglContext* context) {
    context_ = context;
  }
  void MakeCurrent() override {
    if (context_ != nullptr && !context_->is_current()) context_->make_current();
  }
  bool IsCurrent() override { return context_ != nullptr && context_->is_current(); }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void Frame() override {}  // there is nothing to show it on

 protected:
  EglRenderWindow() = default;
  ~EglRenderWindow() override = default;
  void OpenGLInitContext() override {
    ContextCreationTime.Modified();
    if (Initialized) return;
    glewExperimental = GL_TRUE;
    const GLenum result = glewInit();
    GlewInitValid = (result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY) && GLEW_VERSION_3_2 != 0;
    if (!GlewInitValid) throw Error(std::string("OpenGL 3.2 is not available. ") + kRemedy);
    Initialized = true;
    float range[2] = {1.0F, 1.0F};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    MaximumHardwareLineWidth = range[1];
  }

 private:
  const EglContext* context_ = nullptr;
};
vtkStandardNewMacro(EglRenderWindow);

}  // namespace

struct OffscreenRenderer::Impl {
  EglContext context;
  vtkSmartPointer<EglRenderWindow> window = vtkSmartPointer<EglRenderWindow>::New();
};

OffscreenRenderer::OffscreenRenderer(int width, int height) {
  require(width > 0 && height > 0, "a picture has at least one pixel");
  impl_ = std::make_unique<Impl>();
  const CurrentScope current(impl_->context);
  impl_->window->set_context(&impl_->context);
  impl_->window->SetMultiSamples(0);
  impl_->window->SetOffScreenRendering(1);
  impl_->window->SetReadyForRendering(true);
  impl_->window->SetSize(width, height);
  impl_->window->OpenGLInit();
}

OffscreenRenderer::~OffscreenRenderer() {
  const CurrentScope current(impl_->context);
  while (impl_->window->GetRenderers()->GetNumberOfItems() > 0)
    impl_->window->RemoveRenderer(impl_->window->GetRenderers()->GetFirstRenderer());
  impl_->window->Finalize();
  impl_->window->set_context(nullptr);
}

void OffscreenRenderer::resize(int width, int height) {
  require(width > 0 && height > 0, "a picture has at least one pixel");
  const CurrentScope current(impl_->context);
  impl_->window->SetSize(width, height);
}

Picture OffscreenRenderer::render(vtkRenderer& renderer) {
  const CurrentScope current(impl_->context);
  EglRenderWindow& window = *impl_->window;
  if (window.GetRenderers()->GetFirstRenderer() != &renderer) {
    while (window.GetRenderers()->GetNumberOfItems() > 0)
      window.RemoveRenderer(window.GetRenderers()->GetFirstRenderer());
    window.AddRenderer(&renderer);
  }
  window.Render();

  const int width = window.GetSize()[0], height = window.GetSize()[1];
  const std::unique_ptr<unsigned char[]> rgba(window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0));
  if (!rgba) throw Error(std::string("The rendered picture could not be read back. ") + kRemedy);
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(3 * columns * rows);
  for (std::size_t row = 0; row < rows; ++row)  // OpenGL's rows run from the bottom
    for (std::size_t column = 0; column < columns; ++column)
      for (std::size_t channel = 0; channel < 3; ++channel)
        (*bytes)[3 * (row * columns + column) + channel] =
            rgba[4 * ((rows - 1 - row) * columns + column) + 2 - channel];
  return {width, height, 3, bytes};
}

}  // namespace glisson::scene
