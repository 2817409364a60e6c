#include "hand_controller_thread.h"

#ifdef EW_WITH_SDL2
#include <SDL2/SDL.h>
#endif

namespace ew {

#ifdef EW_WITH_SDL2
namespace {

constexpr double kTick_s = 0.008;

struct CloseController {
  void operator()(SDL_GameController* controller) const { SDL_GameControllerClose(controller); }
};
using OpenController = std::unique_ptr<SDL_GameController, CloseController>;

/// SDL's joysticks belong to the thread that asks for their events.
std::mutex& gameControllerThread() {
  static std::mutex thread;
  return thread;
}

double shareOf(Sint16 value) { return std::clamp(value / 32767.0, -1.0, 1.0); }

class GameController final : public AxisDeviceThread {
 public:
  ~GameController() override { GameController::stop(); }

 protected:
  void run() override {
    while (!ends()) {
      const std::unique_lock owner(gameControllerThread(), std::try_to_lock);
      if (owner && begin()) {
        listen();
        SDL_QuitSubSystem(kSubsystems);
        continue;
      }
      if (!owner) rest({LinkState::connecting, say<"Another part of the program uses the game controller.">(), {}});
      pause(1.0);
    }
    SDL_TLSCleanup();  // the thread is not SDL's, which keeps an error's words for each that called it
  }

 private:
  static constexpr Uint32 kSubsystems = SDL_INIT_GAMECONTROLLER | SDL_INIT_EVENTS;

  bool begin() {
    // No window of SDL's has the keyboard, and its handlers of signals are not ours.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetMainReady();
    if (SDL_InitSubSystem(kSubsystems) == 0) return true;
    rest({LinkState::connecting, say<"Game controllers cannot be read (%1).">(verbatim(SDL_GetError())), {}});
    return false;
  }

  void listen() {
    OpenController controller;
    rest(lookedFor());
    while (!ends()) {
      SDL_PumpEvents();
      SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // what is down now is asked for instead
      if (controller && SDL_GameControllerGetAttached(controller.get()) == SDL_FALSE) {
        controller.reset();
        rest(lookedFor());
      }
      if (!controller) {
        controller = firstController();
        if (controller) {
          const char* name = SDL_GameControllerName(controller.get());
          putStatus({LinkState::connected, say<"The game controller moves the probe.">(), name != nullptr ? name : ""});
        }
      }
      if (controller) read(controller.get());
      pause(kTick_s);
    }
  }

  static AxisStatus lookedFor() {
    return {LinkState::connecting, say<"No game controller is plugged in; plug one in or switch it on.">(), {}};
  }

  static OpenController firstController() {
    const int count = SDL_NumJoysticks();
    for (int index = 0; index < count; ++index)
      if (SDL_IsGameController(index) == SDL_TRUE)
        if (SDL_GameController* opened = SDL_GameControllerOpen(index); opened != nullptr) return OpenController(opened);
    return nullptr;
  }

  void read(SDL_GameController* controller) {
    const auto axis = [&](SDL_GameControllerAxis which) { return shareOf(SDL_GameControllerGetAxis(controller, which)); };
    const auto isDown = [&](SDL_GameControllerButton which) { return SDL_GameControllerGetButton(controller, which) != 0; };
    const double shoulders =
        (isDown(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER) ? 1.0 : 0.0) - (isDown(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) ? 1.0 : 0.0);
    std::vector<bool> buttons;
    for (int button = 0; button < SDL_CONTROLLER_BUTTON_MAX; ++button)
      buttons.push_back(isDown(static_cast<SDL_GameControllerButton>(button)));
    put({axis(SDL_CONTROLLER_AXIS_LEFTX), axis(SDL_CONTROLLER_AXIS_LEFTY), axis(SDL_CONTROLLER_AXIS_RIGHTX),
         axis(SDL_CONTROLLER_AXIS_RIGHTY), axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT) - axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT), shoulders},
        std::move(buttons));
  }
};

}  // namespace

std::unique_ptr<AxisDevice> makeGameController() { return std::make_unique<GameController>(); }
#else
namespace {

class NoGameController final : public AxisDeviceThread {
 public:
  ~NoGameController() override { NoGameController::stop(); }

 protected:
  void run() override {
    rest({LinkState::connecting,
          say<"This EchoWeave was built without game controllers; install libsdl2-dev and build it again to use one.">(),
          {}});
    while (!ends()) pause(1.0);
  }
};

}  // namespace

std::unique_ptr<AxisDevice> makeGameController() { return std::make_unique<NoGameController>(); }
#endif

}  // namespace ew
