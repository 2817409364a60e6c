#pragma once

#include "ew/registration/rigid.h"
#include "ew/stitching/equalise_views.h"

/// What the chain asks of libraries that a build may lack: a tree in which a part of them does not stand yet builds all the same, and says
/// so where that part is asked for. CMakeLists.txt finds out.
namespace ew::stitching::images {

inline tl::unexpected<Error> lacking(const char* what) {
  return failure(ErrorCode::unsupported, std::string("This build cannot ") + what + "; use landmarks or places by hand, or another build.");
}

#ifdef EW_WITHOUT_RIGID
inline Result<registration::RigidResult> refine(const registration::Input&, const registration::Input&, const glm::dmat4&,
                                                const registration::RefineOptions&, Progress&, const registration::OnLevel&) {
  return lacking("register volumes by their images");
}
inline Result<registration::PartialResult> search(const registration::Input&, const registration::Input&,
                                                  const registration::PartialOptions&, Progress&, const registration::OnLevel&) {
  return lacking("search for the place of a volume");
}
inline std::uint64_t forecastSearch_bytes(const Grid&, const Grid&, const registration::PartialOptions&) { return 0; }
#else
using registration::matchPartial;
using registration::refineRigid;
inline Result<registration::RigidResult> refine(const registration::Input& fixed, const registration::Input& moving,
                                                const glm::dmat4& start, const registration::RefineOptions& options, Progress& progress,
                                                const registration::OnLevel& onLevel) {
  return refineRigid(fixed, moving, start, options, progress, onLevel);
}
inline Result<registration::PartialResult> search(const registration::Input& fixed, const registration::Input& moving,
                                                  const registration::PartialOptions& options, Progress& progress,
                                                  const registration::OnLevel& onLevel) {
  return matchPartial(fixed, moving, options, progress, onLevel);
}
inline std::uint64_t forecastSearch_bytes(const Grid& fixed, const Grid& moving, const registration::PartialOptions& options) {
  return registration::forecastPartial_bytes(fixed, moving, options);
}
#endif

#ifdef EW_WITHOUT_EQUALISE
/// Views stay as they are.
inline Result<EqualisedViews> equalise(std::span<const View> views, const EqualiseViewsOptions&, Progress&) {
  EqualisedViews as;
  as.corrections.resize(views.size());
  as.notes.emplace_back("This build cannot equalise gain.");
  return as;
}
#else
inline Result<EqualisedViews> equalise(std::span<const View> views, const EqualiseViewsOptions& options, Progress& progress) {
  return equaliseViews(views, options, progress);
}
#endif

}  // namespace ew::stitching::images
