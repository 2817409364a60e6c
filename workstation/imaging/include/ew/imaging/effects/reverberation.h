#pragma once

#include <vector>

#include "ew/imaging/beam_grid.h"
#include "ew/imaging/scene.h"

namespace ew {

/// Memory of reverberate between frames.
struct ReverberationScratch {
  std::vector<int> interfaces;  ///< per line: sample of its strong interface, or -1
  std::vector<int> fromRight;   ///< the same, as the lines on the right see it
  std::vector<int> ends;        ///< per line: last sample of its echo
  std::vector<int> bounces;     ///< per line: how often it comes back, 0 where it is tilted
};

/// Echoes that bounce between the face and a strong interface come back once more at each multiple of its depth, weaker by a bounce; and
/// beyond a strong smooth interface the tissue before it appears once more, mirrored. In grey levels, with an interface at sample s0 and
/// g(s) what a line holds down to the end of the interface's echo, sample s behind it receives
///   g(s - n s0) - n loss_dbPerBounce greyPerDb,  n = 1..bounces, the n that leads into the interface's own period, and
///   g(2 s0 - s) - mirrorLoss_db greyPerDb,       down to firstSample,
/// added as powers (echoes do not interfere; error below 0.001 levels at 60 dB). The near field is repeated as well.
/// Source: the paths face-interface-face and interface-tissue-interface of Kremkau, Sonography: Principles and Instruments (chapter on
/// artifacts); the choice of lines is ours.
/// A strong interface is the first sample of a line at interfaceLevel or above, and beside it the brightest one down to three quarters of
/// that level. It must be seen by 9 lines side by side (all, when there are fewer), each within 6 samples of the next: less is speckle,
/// and a rough surface scatters. A surface that bulges towards the probe (a stone, a rib: chords over 8 lines lie more than a sample
/// behind it on average) scatters as well and is left out. Where it is steeper than a sample a line, its echo misses the face: it mirrors
/// but does not repeat.
/// Nothing is written where no line has a strong interface.
/// @param firstSample where an interface may lie at the earliest: behind the near field
/// @param echoes      all lines of the grid: whether an interface is smooth shows beside it
/// @return lines that have one
/// Cost on one core of a server of 2023 (AVX-512, shared): 0.12 ns a sample to find that there is none, 2 ns for each sample behind one.
int reverberate(const ReverberationEffect& effect, double greyPerDb, int firstSample, ImageView<float> echoes,
                ReverberationScratch& scratch);

}  // namespace ew
