#pragma once

#include <QObject>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "ew/imaging/doppler_sound.h"

namespace ew::ui {

class Session;

/// Lets a sample volume be heard while the scan runs. The sound output of the computer is opened when there is something to hear for the
/// first time; frozen, muted and in other modes it is silent.
class DopplerSpeaker final : public QObject {
  Q_OBJECT

 public:
  /// @param session must live longer
  explicit DopplerSpeaker(Session& session, QObject* parent = nullptr);
  ~DopplerSpeaker() override;

  [[nodiscard]] double volume() const { return volume_; }  ///< 0..1; remembered
  void setVolume(double volume);
  [[nodiscard]] bool isMuted() const { return isMuted_; }  ///< remembered
  void setMuted(bool isMuted);
  /// False once an output was looked for in vain.
  [[nodiscard]] bool hasOutput() const { return !hasFailed_; }
  /// Sound that waits to be heard.
  [[nodiscard]] double queued_s() const;

 Q_SIGNALS:
  void changed();

 private:
  class Output;
  void play();
  void fallSilent();
  /// @return whether there is an output
  bool open();

  Session& session_;
  DopplerSound sound_;
  std::unique_ptr<Output> output_;
  bool hasFailed_ = false;
  double volume_ = 0.5;
  bool isMuted_ = false;
  std::uint64_t played_ = 0;  ///< number of the image whose samples were heard last
  std::vector<std::complex<float>> scaled_;
  std::vector<glm::vec2> limited_;
};

/// A sample of sound with its peaks rounded off: within -1..1 whatever came in.
/// @param loudness 0..1, of which half is a quarter of the amplitude
[[nodiscard]] glm::vec2 limitedSound(const glm::vec2& sound, double loudness);

}  // namespace ew::ui
