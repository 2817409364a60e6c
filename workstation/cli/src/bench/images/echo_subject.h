#pragma once

#include <memory>
#include <random>
#include <vector>

#include "bench/images/echo_measures.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/frame.h"
#include "ew/library/case.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_scanner.h"
#include "ew/scanning/subject.h"

namespace ew {

/// A drawn case as both engines see it.
struct EchoSubject {
  std::string id;
  ScanSubject subject;                     ///< as the window scans it
  std::shared_ptr<const TissueMaps> bare;  ///< its maps without reflecting surfaces' strengths: scatterers alone
  std::shared_ptr<const Patient> patient;
  glm::dmat4 worldToPatient{1.0};
  std::array<bool, 256> isUneven{};  ///< by label
  Probe probe;
  Scene scene;  ///< what is compared: see benchEchoes
  std::vector<Transform<frame::World, frame::Probe>> anchors;

  [[nodiscard]] EchoTruth truth() const;
};
/// @error badUsage (no drawn case), notFound (its probe), as readContents, readPatient; cancelled
[[nodiscard]] Result<EchoSubject> readEchoSubject(const Case& opened, Progress& progress);

/// Poses of a case: its anchors, then anchors slid up to 12 mm along the skin, tilted and turned; the face stays on the skin.
[[nodiscard]] std::vector<Transform<frame::World, frame::Probe>> echoPoses(const EchoSubject& subject, int count, std::uint64_t seed);

/// Forms live echoes of one quality as they are compared.
class LiveEngine {
 public:
  LiveEngine(const EchoSubject& subject, const Probe& probe, Quality quality, bool loses);
  [[nodiscard]] EchoFrame frameAt(const Transform<frame::World, frame::Probe>& probeToWorld);

 private:
  const EchoSubject& subject_;
  FrameMaker maker_{0};
};

/// The forward model with the settings that live echoes are compared by.
class ForwardEngine {
 public:
  /// @error as makeVirtualScanner
  [[nodiscard]] static Result<ForwardEngine> of(const EchoSubject& subject, const Probe& probe, bool loses, std::uint64_t seed = 1);
  [[nodiscard]] EchoFrame frameAt(const Transform<frame::World, frame::Probe>& probeToWorld);
  [[nodiscard]] const VirtualScanner& scanner() const { return *scanner_; }
  [[nodiscard]] double last_ms() const { return last_ms_; }

 private:
  std::unique_ptr<VirtualScanner> scanner_;
  std::unique_ptr<VirtualScanner::Scratch> scratch_;
  glm::dmat4 worldToPatient_{1.0};
  double last_ms_ = 0.0;
};

}  // namespace ew
