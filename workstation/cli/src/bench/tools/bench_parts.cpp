#include "bench/tools/bench_parts.h"

#include <time.h>
#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ew/core/figures.h"
#include "ew/core/large_pages.h"
#include "ew/core/simd.h"
#include "run/report.h"

namespace ew {

BenchField::BenchField(int side) : side_(side) {
  std::mt19937 random(20240607);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (Term& term : terms_)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      term.perVoxel[axis] = 2.0 * std::numbers::pi / (7.0 + 33.0 * unit(random));
      term.phase[axis] = 2.0 * std::numbers::pi * unit(random);
      term.table[axis].resize(static_cast<std::size_t>(side));
      for (std::size_t n = 0; n < term.table[axis].size(); ++n)
        term.table[axis][n] = static_cast<float>(std::cos(term.perVoxel[axis] * static_cast<double>(n) + term.phase[axis]));
    }
}

double BenchField::at(const glm::dvec3& p_voxel) const {
  double sum = kMean;
  for (const Term& term : terms_) {
    double product = kAmplitude;
    for (int axis = 0; axis < 3; ++axis)
      product *= std::cos(term.perVoxel[static_cast<std::size_t>(axis)] * p_voxel[axis] + term.phase[static_cast<std::size_t>(axis)]);
    sum += product;
  }
  return sum;
}

double BenchField::meanAt(const glm::dvec3& p_voxel, const glm::dvec3& sigma_voxel) const {
  double sum = kMean;
  for (const Term& term : terms_)
    for (const double signY : {-1.0, 1.0})
      for (const double signZ : {-1.0, 1.0}) {
        const glm::dvec3 wave(term.perVoxel[0], signY * term.perVoxel[1], signZ * term.perVoxel[2]);
        const double along = glm::dot(wave, sigma_voxel);
        sum += 0.25 * kAmplitude * std::exp(-0.5 * along * along) *
               std::cos(glm::dot(wave, p_voxel) + term.phase[0] + signY * term.phase[1] + signZ * term.phase[2]);
      }
  return sum;
}

Result<Volume> BenchField::volume(Progress& progress) const {
  Volume made;
  made.grid.dims = glm::ivec3(side_);
  made.echo = zerosInLargePages(made.grid.voxelCount());
  const auto side = static_cast<std::size_t>(side_);
  std::uint8_t* voxel = made.echo.data();
  for (std::size_t k = 0; k < side; ++k) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    for (std::size_t j = 0; j < side; ++j) {
      std::array<float, kTerms> factor{};
      for (std::size_t t = 0; t < kTerms; ++t) factor[t] = static_cast<float>(kAmplitude) * terms_[t].table[1][j] * terms_[t].table[2][k];
      for (std::size_t i = 0; i < side; ++i) {
        float sum = static_cast<float>(kMean) + 0.5F;
        for (std::size_t t = 0; t < kTerms; ++t) sum += factor[t] * terms_[t].table[0][i];
        *voxel++ = static_cast<std::uint8_t>(sum);
      }
    }
  }
  return made;
}

BenchSlicer peerSlicer(Quality quality, const Volume& volume, int width, int height) {
  struct State {
    vtkNew<vtkImageData> volume;
    vtkNew<vtkImageReslice> reslice;
    vtkNew<vtkMatrix4x4> axes;
  };
  auto state = std::make_shared<State>();
  vtkNew<vtkUnsignedCharArray> voxels;
  // VTK takes a mutable pointer; the reslice filter only reads.
  voxels->SetArray(const_cast<unsigned char*>(volume.echo.data()), static_cast<vtkIdType>(volume.echo.size()), 1);
  const glm::ivec3 dims = volume.grid.dims;
  state->volume->SetDimensions(dims.x, dims.y, dims.z);
  state->volume->GetPointData()->SetScalars(voxels);
  vtkImageReslice* reslice = state->reslice;
  reslice->SetInputData(state->volume);
  reslice->SetOutputDimensionality(2);
  reslice->SetOutputExtent(0, width - 1, 0, height - 1, 0, 0);
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->SetOptimization(1);
  reslice->SetBorder(1);
  reslice->SetBackgroundLevel(0.0);
  if (quality == Quality::weave) reslice->SetInterpolationModeToNearestNeighbor();
  if (quality == Quality::linear) reslice->SetInterpolationModeToLinear();
  if (quality == Quality::cubic) reslice->SetInterpolationModeToCubic();
  reslice->SetEnableSMP(false);
  reslice->SetNumberOfThreads(1);
  reslice->SetResliceAxes(state->axes);
  return [state](const Transform<frame::Voxel, frame::Image>& plane) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) state->axes->SetElement(row, column, plane.matrix[column][row]);
    state->reslice->Update();
    return static_cast<const std::uint8_t*>(state->reslice->GetOutput()->GetScalarPointer());
  };
}

glm::dquat rockingTurn(double time_s) {
  return glm::angleAxis(0.6 + 0.25 * std::sin(2.1 * time_s), glm::normalize(glm::dvec3(0.8, 0.3, 0.5 + 0.2 * std::sin(time_s))));
}

namespace {
double cpuTime_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
}  // namespace

double threadTime_s() { return cpuTime_s(CLOCK_THREAD_CPUTIME_ID); }

bool runsOnThisThreadAlone(const std::function<void()>& work) {
  work();  // pools start on first use
  const double process = cpuTime_s(CLOCK_PROCESS_CPUTIME_ID), thread = threadTime_s();
  work();
  const double spentByAll = cpuTime_s(CLOCK_PROCESS_CPUTIME_ID) - process, spentHere = threadTime_s() - thread;
  return spentByAll < 1.1 * spentHere + 1e-4;
}

std::string machineName() { return processorName() + ", kernels on " + simdInUse(); }

nlohmann::json peakOf(const MemoryWatch& watch) { return watch.isKnown() ? nlohmann::json(watch.peak_mib()) : nlohmann::json(); }

nlohmann::json heldOf(const MemoryWatch& watch) { return watch.isKnown() ? nlohmann::json(watch.held_mib()) : nlohmann::json(); }

std::string memoryIn(const nlohmann::json& row, const char* key, int decimals) {
  return row.contains(key) && row[key].is_number() ? fixedText(row[key].get<double>(), decimals) : std::string();
}

}  // namespace ew
