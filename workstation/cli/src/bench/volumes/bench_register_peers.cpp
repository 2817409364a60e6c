#include "bench/volumes/bench_register_peers.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "ew/io/safe_file.h"

extern char** environ;

namespace ew {
namespace {
namespace fs = std::filesystem;

std::optional<fs::path> findProgram(const std::string& program) {
  const char* path = std::getenv("PATH");
  if (path == nullptr) return std::nullopt;
  const std::string all(path);
  for (std::size_t begin = 0; begin <= all.size();) {
    const std::size_t end = std::min(all.find(':', begin), all.size());
    if (end > begin) {
      const fs::path candidate = fs::path(all.substr(begin, end - begin)) / program;
      if (::access(candidate.c_str(), X_OK) == 0 && fs::is_regular_file(candidate)) return candidate;
    }
    begin = end + 1;
  }
  return std::nullopt;
}

/// The line of a program's words that says what went wrong, as far as one can tell.
std::string complaintIn(const fs::path& log) {
  const auto words = readTextFile(log);
  if (!words) return {};
  for (std::size_t begin = 0; begin < words->size();) {
    const std::size_t end = std::min(words->find('\n', begin), words->size());
    const std::string line = words->substr(begin, end - begin);
    for (const char* sign : {"Description:", "ERROR", "Error:", "error:"})
      if (line.find(sign) != std::string::npos && line.size() > 12) return " (" + line.substr(0, 200) + ")";
    begin = end + 1;
  }
  return {};
}

/// Runs a program to its end, its words into a file; gives its processor time.
Result<double> runProgram(const std::vector<std::string>& words, const fs::path& log, Progress& progress) {
  const auto program = findProgram(words.front());
  if (!program) return failure(ErrorCode::notFound, say<"%1 is not installed; install it to compare with it.">(words.front()));
  std::vector<char*> arguments;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::vector<std::string> settings;
  for (char** variable = environ; *variable != nullptr; ++variable) settings.emplace_back(*variable);
  for (const char* one : {"ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS=1", "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"}) {
    std::erase_if(settings, [&](const std::string& setting) {
      return setting.compare(0, setting.find('=') + 1, one, std::string(one).find('=') + 1) == 0;
    });
    settings.emplace_back(one);
  }
  std::vector<char*> environment;
  for (auto& setting : settings) environment.push_back(setting.data());
  environment.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  pid_t process = 0;
  const int problem = posix_spawn(&process, program->c_str(), &files, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&files);
  if (problem != 0) return failure(ErrorCode::internal, say<"%1 could not be started; check its installation.">(words.front()));
  int status = 0;
  rusage used{};
  while (true) {
    const pid_t ended = ::wait4(process, &status, WNOHANG, &used);
    if (ended == process) break;
    if (ended < 0) return failure(ErrorCode::internal, say<"%1 was lost track of.">(words.front()));
    if (progress.cancelRequested()) {
      ::kill(process, SIGKILL);
      ::wait4(process, &status, 0, &used);
      return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    return failure(ErrorCode::internal, say<"%1 failed on this pair%2.">(words.front(), complaintIn(log)));
  const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string elastixParameters(const std::string& metric) {
  return "(FixedInternalImagePixelType \"float\")\n(MovingInternalImagePixelType \"float\")\n"
         "(FixedImageDimension 3)\n(MovingImageDimension 3)\n(UseDirectionCosines \"true\")\n"
         "(Registration \"MultiResolutionRegistration\")\n(NumberOfResolutions 4)\n"
         "(FixedImagePyramid \"FixedSmoothingImagePyramid\")\n(MovingImagePyramid \"MovingSmoothingImagePyramid\")\n"
         "(Interpolator \"LinearInterpolator\")\n(ResampleInterpolator \"FinalBSplineInterpolator\")\n(FinalBSplineInterpolationOrder "
         "1)\n(Resampler \"DefaultResampler\")\n"
         "(Transform \"BSplineTransform\")\n(FinalGridSpacingInPhysicalUnits 8)\n(GridSpacingSchedule 4 4 2 1)\n(MaximumStepLength "
         "1)\n(HowToCombineTransforms \"Compose\")\n"
         "(Metric \"" +
         metric +
         "\")\n(NumberOfHistogramBins 32)\n"
         "(Optimizer \"AdaptiveStochasticGradientDescent\")\n(MaximumNumberOfIterations 500)\n(AutomaticParameterEstimation \"true\")\n"
         "(ImageSampler \"RandomCoordinate\")\n(NumberOfSpatialSamples 3000)\n(NewSamplesEveryIteration \"true\")\n"
         "(CheckNumberOfSamples \"false\")\n(RequiredRatioOfValidSamples 0.03)\n(ErodeMask \"false\")\n(DefaultPixelValue 0)\n"
         "(WriteResultImage \"false\")\n(ResultImageFormat \"mha\")\n";
}

Result<PeerRun> runElastix(const RegisterPeer& peer, const fs::path& fixed, const fs::path& moving, const fs::path& folder,
                           Progress& progress) {
  const bool mutual = peer.setting.find("mutual") != std::string::npos;
  if (auto written = writeFileSafely(folder / "parameters.txt",
                                     elastixParameters(mutual ? "AdvancedMattesMutualInformation" : "AdvancedNormalizedCorrelation"));
      !written)
    return passOn(written.error());
  const auto registered = runProgram({"elastix", "-f", fixed.string(), "-m", moving.string(), "-p", (folder / "parameters.txt").string(),
                                      "-out", folder.string(), "-threads", "1"},
                                     folder / "words.txt", progress);
  if (!registered) return passOn(registered.error());
  const auto written = runProgram(
      {"transformix", "-def", "all", "-tp", (folder / "TransformParameters.0.txt").string(), "-out", folder.string(), "-threads", "1"},
      folder / "words.txt", progress);
  if (!written) return passOn(written.error());
  auto field = readVectorField(folder / "deformationField.mha");
  if (!field) return passOn(field.error());
  return PeerRun{std::move(*field), *registered};
}

/// Smoothness is weighed by hand: what the measures count differs by orders of magnitude.
Result<PeerRun> runPlastimatch(const RegisterPeer& peer, const fs::path& fixed, const fs::path& moving, const fs::path& folder,
                               Progress& progress) {
  const bool mutual = peer.setting.find("mutual") != std::string::npos;
  const auto stage = [&](const std::string& coarser, const std::string& grid_mm, const std::string& iterations) {
    return "[STAGE]\nxform=bspline\noptim=lbfgsb\nimpl=plastimatch\nthreading=single\nmetric=" + std::string(mutual ? "mi" : "mse") +
           "\nregularization=analytic\nregularization_lambda=" + (mutual ? "0.0001" : "0.5") + "\nmax_its=" + iterations +
           "\nres=" + coarser + " " + coarser + " " + coarser + "\ngrid_spac=" + grid_mm + " " + grid_mm + " " + grid_mm + "\n";
  };
  const std::string command = "[GLOBAL]\nfixed=" + fixed.string() + "\nmoving=" + moving.string() +
                              "\nvf_out=" + (folder / "field.mha").string() + "\n\n" + stage("4", "24", "60") + stage("2", "16", "50") +
                              stage("1", "8", "30");
  if (auto written = writeFileSafely(folder / "command.txt", command); !written) return passOn(written.error());
  const auto registered = runProgram({"plastimatch", "register", (folder / "command.txt").string()}, folder / "words.txt", progress);
  if (!registered) return passOn(registered.error());
  auto field = readVectorField(folder / "field.mha");
  if (!field) return passOn(field.error());
  return PeerRun{std::move(*field), *registered};
}

}  // namespace

std::vector<RegisterPeer> registerPeers() {
  return {{"elastix", "B-splines of 8 mm, normalised correlation"},
          {"elastix", "B-splines of 8 mm, mutual information"},
          {"plastimatch", "B-splines of 8 mm, squared differences"},
          {"plastimatch", "B-splines of 8 mm, mutual information"}};
}

bool isInstalled(const std::string& program) { return findProgram(program).has_value(); }

Result<PeerRun> runPeer(const RegisterPeer& peer, const fs::path& fixed, const fs::path& moving, const fs::path& folder,
                        Progress& progress) {
  return peer.program == "elastix" ? runElastix(peer, fixed, moving, folder, progress)
                                   : runPlastimatch(peer, fixed, moving, folder, progress);
}

}  // namespace ew
