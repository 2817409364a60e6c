#include <numeric>

#include "ew/sdk/plugin.h"

namespace {

/// The mean of all covered voxels, in grey levels.
double meanEcho(const ew::Volume& volume) {
  double sum = 0.0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < volume.echo.size(); ++i) {
    if (volume.coverageAt(i) == ew::Coverage::absent) continue;
    sum += volume.echo[i];
    ++covered;
  }
  return covered == 0 ? 0.0 : sum / static_cast<double>(covered);
}

class MeanEcho final : public ew::sdk::Plugin {
 public:
  explicit MeanEcho(ew::sdk::Host& host) {
    host.commands().add("mean-echo", "mean-echo VOLUME",
                        [&host](const std::vector<std::string>& args, ew::Progress& progress) -> ew::Result<ew::sdk::Commands::Outcome> {
                          if (args.size() != 1)
                            return ew::failure(ew::ErrorCode::badUsage, ew::say<"Name one volume. Usage: echoweave mean-echo VOLUME.">());
                          auto volume = host.volumes().read(args.front(), progress);
                          if (!volume) return ew::passOn(volume.error());
                          ew::sdk::Commands::Outcome outcome;
                          outcome.quality.emplace_back("mean_grey", meanEcho(*volume));
                          return outcome;
                        });
  }
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new MeanEcho(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
