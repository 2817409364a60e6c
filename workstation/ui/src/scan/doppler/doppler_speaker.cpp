#include "scan/doppler/doppler_speaker.h"

#ifdef EW_WITH_SDL2
#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>
#endif

#include <QSettings>
#include <algorithm>
#include <cmath>
#include <deque>

#include "ew/imaging/spectrogram.h"
#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr double kMostQueued_s = 0.15;
constexpr double kLead_s = 0.05;   // before the first sound, so that a late frame leaves no hole
constexpr double kLoudness = 0.5;  // of a sample whose power is that of black, as those of a carotid are about
const auto kVolumeSetting = QStringLiteral("dopplerVolume");
const auto kMutedSetting = QStringLiteral("dopplerMuted");

}  // namespace

#ifdef EW_WITH_SDL2
/// With a callback of its own: the thread of SDL's own queue has a stack of 64 KiB, which the thread-local data of this program leave no
/// room on, so that no such thread can be made.
class DopplerSpeaker::Output {
 public:
  [[nodiscard]] static std::unique_ptr<Output> open(int rate_hz) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetMainReady();
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return nullptr;
    std::unique_ptr<Output> made(new Output);
    SDL_AudioSpec wanted{};
    wanted.freq = rate_hz;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = 1024;
    wanted.callback = &Output::fill;
    wanted.userdata = made.get();
    made->device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    if (made->device_ == 0) return nullptr;
    SDL_PauseAudioDevice(made->device_, 0);
    return made;
  }
  ~Output() {
    if (device_ != 0) SDL_CloseAudioDevice(device_);
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  [[nodiscard]] std::size_t queued() const {
    const Locked locked(device_);
    return waiting_.size();
  }
  void queue(std::span<const glm::vec2> sound) {
    const Locked locked(device_);
    waiting_.insert(waiting_.end(), sound.begin(), sound.end());
  }
  void clear() {
    const Locked locked(device_);
    waiting_.clear();
  }

 private:
  Output() = default;
  /// The callback does not run meanwhile.
  class Locked {
   public:
    explicit Locked(SDL_AudioDeviceID device) : device_(device) { SDL_LockAudioDevice(device_); }
    ~Locked() { SDL_UnlockAudioDevice(device_); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;

   private:
    SDL_AudioDeviceID device_;
  };
  static void SDLCALL fill(void* of, Uint8* bytes, int size) {
    auto& waiting = static_cast<Output*>(of)->waiting_;
    const std::span sound(reinterpret_cast<glm::vec2*>(bytes), static_cast<std::size_t>(size) / sizeof(glm::vec2));
    const std::size_t there = std::min(sound.size(), waiting.size());
    std::copy_n(waiting.begin(), there, sound.begin());
    std::fill(sound.begin() + static_cast<std::ptrdiff_t>(there), sound.end(), glm::vec2(0.0F));
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(there));
  }

  SDL_AudioDeviceID device_ = 0;
  std::deque<glm::vec2> waiting_;
};
#else
class DopplerSpeaker::Output {
 public:
  [[nodiscard]] static std::unique_ptr<Output> open(int /*rate_hz*/) { return nullptr; }
  [[nodiscard]] std::size_t queued() const { return 0; }
  void queue(std::span<const glm::vec2> /*sound*/) {}
  void clear() {}
};
#endif

glm::vec2 limitedSound(const glm::vec2& sound, double loudness) {
  // Loudness is heard by its logarithm, so that the middle of the slider is a middle loudness.
  const auto factor = static_cast<float>(loudness * loudness);
  return {std::tanh(factor * sound.x), std::tanh(factor * sound.y)};
}

DopplerSpeaker::DopplerSpeaker(Session& session, QObject* parent)
    : QObject(parent),
      session_(session),
      volume_(std::clamp(QSettings().value(kVolumeSetting, 0.5).toDouble(), 0.0, 1.0)),
      isMuted_(QSettings().value(kMutedSetting, false).toBool()) {
  connect(&session_, &Session::imageChanged, this, &DopplerSpeaker::play);
  connect(&session_, &Session::frozenChanged, this, &DopplerSpeaker::play);
  connect(&session_, &Session::subjectReplaced, this, &DopplerSpeaker::fallSilent);
}

DopplerSpeaker::~DopplerSpeaker() = default;

void DopplerSpeaker::setVolume(double volume) {
  if (volume == volume_) return;
  volume_ = std::clamp(volume, 0.0, 1.0);
  QSettings().setValue(kVolumeSetting, volume_);
  Q_EMIT changed();
}

void DopplerSpeaker::setMuted(bool isMuted) {
  if (isMuted == isMuted_) return;
  isMuted_ = isMuted;
  QSettings().setValue(kMutedSetting, isMuted_);
  if (isMuted_) fallSilent();
  Q_EMIT changed();
}

double DopplerSpeaker::queued_s() const { return output_ ? static_cast<double>(output_->queued()) / sound_.rate_hz() : 0.0; }

bool DopplerSpeaker::open() {
  if (output_ || hasFailed_) return output_ != nullptr;
  output_ = Output::open(static_cast<int>(sound_.rate_hz()));
  hasFailed_ = output_ == nullptr;
  if (hasFailed_) Q_EMIT changed();
  return output_ != nullptr;
}

void DopplerSpeaker::fallSilent() {
  sound_.clear();
  if (output_) output_->clear();
}

void DopplerSpeaker::play() {
  const Spectrogram* spectrogram = session_.subject() ? session_.seen().spectrogram() : nullptr;
  if (spectrogram == nullptr || session_.isFrozen() || session_.isPlaying() || isMuted_) return fallSilent();
  const std::uint64_t number = session_.shownState().number;
  const auto samples = session_.seen().dopplerSamples();
  if (number == played_ || samples.empty() || !open()) return;
  played_ = number;
  const SpectrumSetting& setting = spectrogram->setting();
  sound_.configure(setting.prf_hz, setting.baseline);
  // As bright as it is loud: gain turns both.
  const auto factor = static_cast<float>(kLoudness / std::sqrt(setting.black));
  scaled_.clear();
  for (const std::complex<float>& sample : samples) scaled_.push_back(factor * sample);
  const auto due = sound_.add(scaled_);
  limited_.clear();
  const std::size_t queued = output_->queued();
  if (queued == 0) limited_.assign(static_cast<std::size_t>(kLead_s * sound_.rate_hz()), glm::vec2(0.0F));
  for (const glm::vec2& each : due) limited_.push_back(limitedSound(each, volume_));
  const auto most = static_cast<std::size_t>(kMostQueued_s * sound_.rate_hz());
  const std::size_t room = most > queued ? most - queued : 0;
  output_->queue(std::span(limited_).first(std::min(room, limited_.size())));
}

}  // namespace ew::ui
