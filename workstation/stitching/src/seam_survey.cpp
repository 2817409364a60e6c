#include "seam_survey.h"

#include <cmath>

#include "ew/core/parallel.h"
#include "ew/stitching/distance.h"
#include "joiner.h"

namespace ew::stitching {
namespace {

/// The mean is taken over this many cells on either side: speckle goes, edges of tissue stay.
constexpr double kMeanReach_cells = 1.5;

std::uint8_t byteOf(float part) { return static_cast<std::uint8_t>(std::lround(ViewSurvey::kFull * static_cast<double>(part))); }

}  // namespace

Result<std::vector<float>> ViewSurvey::distanceFromBorder_mm(const Grid& cells, double limit_mm, int threads, Progress& progress) const {
  Volume covered;
  covered.grid = cells;
  covered.grid.dims = box.size();
  covered.coverage.resize(share.size());
  for (std::size_t c = 0; c < share.size(); ++c) covered.coverage[c] = share[c] > kFull / 2 ? 2 : 0;
  return stitching::distanceFromBorder_mm(covered, limit_mm, threads, progress);
}

Result<std::vector<ViewSurvey>> surveyViews(std::span<const View> views, const Grid& result, const glm::ivec3& ratio,
                                            const SeamOptions& options, Progress& progress) {
  const glm::ivec3 dims = cellGrid(result, ratio).dims;
  std::vector<ViewSurvey> surveys;
  const Message step = say<"Looking for seams">();
  for (const View& view : views) {
    const auto n = static_cast<double>(surveys.size());
    const auto all = static_cast<double>(views.size());
    const ViewSampler sampler(view, result, 1.0);
    ViewSurvey survey;
    const auto [lowest, highest] = sampler.reach();
    survey.box.begin = glm::clamp(lowest, glm::ivec3(0), result.dims) / ratio;
    survey.box.end = glm::min((glm::clamp(highest + 1, glm::ivec3(0), result.dims) + ratio - 1) / ratio, dims);
    survey.box.end = glm::max(survey.box.end, survey.box.begin);
    if (survey.box.count() == 0) survey.box.end = survey.box.begin;
    const CellBox& box = survey.box;
    survey.level.resize(box.count());
    survey.share.resize(box.count());
    survey.trust.resize(box.count());
    std::vector<float> sum(box.count());
    std::vector<float> weight(box.count());
    PartOfProgress part(progress, n / all, (n + 1.0) / all);
    const bool whole = forEachTask(box.size().z, options.threads, part, step, [&](int slice, int, const auto& stopped) {
      std::vector<CellLook> looks(static_cast<std::size_t>(box.size().x));
      const int k = box.begin.z + slice;
      for (int j = box.begin.y; j < box.end.y && !stopped(); ++j) {
        lookAlongCells(sampler, ratio, j, k, box.begin.x, box.end.x, looks.data());
        std::size_t cell = box.indexOf(box.begin.x, j, k);
        for (const CellLook& look : looks) {
          sum[cell] = look.level * look.share;
          weight[cell] = look.share;
          survey.share[cell] = byteOf(look.share);
          survey.trust[cell] = byteOf(look.trust);
          ++cell;
        }
      }
    });
    if (!whole || progress.cancelRequested()) return stitchingCancelled();
    std::vector<float> scratch;
    boxSum(sum, box, glm::dvec3(kMeanReach_cells), scratch);
    if (progress.cancelRequested()) return stitchingCancelled();
    boxSum(weight, box, glm::dvec3(kMeanReach_cells), scratch);
    for (std::size_t c = 0; c < sum.size(); ++c)
      if (weight[c] > 0.0F)
        survey.level[c] = static_cast<std::uint16_t>(std::lround(static_cast<double>(sum[c] / weight[c]) / ViewSurvey::kLevelUnit));
    surveys.push_back(std::move(survey));
  }
  return surveys;
}

}  // namespace ew::stitching
