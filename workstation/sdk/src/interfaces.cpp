#include "ew/sdk/host.h"
#include "ew/sdk/plugin.h"

#include <utility>

namespace ew::sdk {

// Out of line, so that a vtable has one home per library and RTTI compares equal across the plugin's border.
VolumeWriter::~VolumeWriter() = default;
Volumes::~Volumes() = default;
Files::~Files() = default;
Cases::~Cases() = default;
Result<void> Cases::makeOwn() { return {}; }
std::optional<Cases::Scan> Cases::scan() const { return std::nullopt; }
Cases::Choices Cases::choices() const { return {}; }
Jobs::~Jobs() = default;
void Jobs::startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                       std::function<void(const Result<void>&)> done) {
  start(title, std::move(work), std::move(done));
}
PanelDocument::~PanelDocument() = default;
Panels::~Panels() = default;
void Panels::addStaged(StagedPanel panel) { add(panel.id, panel.title, std::move(panel.make)); }
Commands::~Commands() = default;
Log::~Log() = default;
Host::~Host() = default;
Plugin::~Plugin() = default;

}  // namespace ew::sdk
