#pragma once

namespace ew {

/// What the vector code of attenuate() needs for each row: constants of the call and one float a line of what came before.
struct AttenuationRows {
  static constexpr float kUnknown = -1e30F;       ///< in perSample_db: the grey level decides
  static constexpr float kNoGainLevel = 8.0F;     ///< grey levels up to this are black for want of range and gain nothing
  static constexpr float kFullGainLevel = 40.0F;  ///< grey levels from this on gain all

  const float* perSample_db = nullptr;   ///< by label
  const float* onEntering_db = nullptr;  ///< by label
  float* loss = nullptr;                 ///< dB so far, by line
  float* waiting = nullptr;              ///< dB of interfaces that are still to come in, by line
  float* smooth = nullptr;               ///< grey level averaged along the line
  float* seen = nullptr;                 ///< 1 once the line has met tissue: what is black before is no fluid but no contact or no data
  float greyPerDb = 4.25F;
  float largestEnhancement_db = 9.0F;
  float smoothing = 0.0F;
  float release = 0.0F;
  float interfaceFrom = 175.0F;
  float interfaceSlope = 0.025F;
  float interfaceStep_db = 0.0F;
  float fluidLevel = 8.0F;
  float fluidSlope = 0.25F;
  float expectedStep_db = 0.0F;
};

}  // namespace ew
