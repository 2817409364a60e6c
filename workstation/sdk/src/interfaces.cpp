#include "ew/sdk/case_parts.h"
#include "ew/sdk/host.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/plugin.h"
#include "ew/sdk/scan.h"
#include "ew/sdk/window.h"
#include "ew/sdk/workspaces.h"

#include <utility>

namespace ew::sdk {

// Out of line, so that a vtable has one home per library and RTTI compares equal across the plugin's border.
VolumeWriter::~VolumeWriter() = default;
Volumes::~Volumes() = default;
void Volumes::showMade(Volume volume, const std::string& title, const std::vector<std::filesystem::path>&) {
  show(std::move(volume), title);
}
std::optional<DisplayVolume> Volumes::shown() const { return std::nullopt; }
void Volumes::wasKept(const std::shared_ptr<const Volume>&) {}
Files::~Files() = default;
Cases::~Cases() = default;
std::optional<Case> Cases::forPractice() const { return current(); }
Result<void> Cases::makeOwn() { return {}; }
Result<void> Cases::saveCopy() {
  return failure(ErrorCode::badUsage, say<"There is no window that could ask where the case is to be saved.">());
}
std::optional<Cases::Scan> Cases::scan() const { return std::nullopt; }
Cases::Choices Cases::choices() const { return {}; }
Result<void> Cases::open(const std::filesystem::path&) {
  return failure(ErrorCode::badUsage, say<"There is no window in which a case could be opened.">());
}
Jobs::~Jobs() = default;
void Jobs::startSaving(const std::string& title, std::function<Result<void>(Progress&)> work,
                       std::function<void(const Result<void>&)> done) {
  start(title, std::move(work), std::move(done));
}
PanelDocument::~PanelDocument() = default;
std::string PanelDocument::unsaved() const { return {}; }
// By value, for those who do it keep what they are given.
// NOLINTBEGIN(performance-unnecessary-value-param)
Panels::~Panels() = default;
void Panels::add(const std::string& id, const std::string& title, StagePanel::Make make, const std::string& workspace) {
  addStaged({.id = id, .title = title, .make = std::move(make), .workspace = workspace});
}
void Panels::setShown(const std::string&, bool) {}
void Panels::bringToFront(const std::string&) {}
Scan::~Scan() = default;
std::optional<Scanned> Scan::scanned() const { return std::nullopt; }
std::vector<ScanMeasurement> Scan::measurements() const { return {}; }
Ticket Scan::onMeasured(std::function<void()>) { return nullptr; }
Ticket Scan::askForPoint(const std::string&, std::function<void(const Point<frame::Probe>&)>, std::function<void()>) { return nullptr; }
Ticket Scan::askForStroke(StrokeRequest) { return nullptr; }
Result<void> Scan::placeProbe(const Transform<frame::World, frame::Probe>&) {
  return failure(ErrorCode::badUsage, say<"Nothing is scanned; open a case or a volume first.">());
}
Result<void> Scan::showLabels(std::optional<Volume>) {
  return failure(ErrorCode::badUsage, say<"Nothing is scanned; open a case or a volume first.">());
}
Workspaces::~Workspaces() = default;
Overlays::~Overlays() = default;
Ticket Overlays::showInBody(const BodyAids&) { return nullptr; }
std::shared_ptr<HandlesOverlay> Overlays::showHandles(const BodyHandles&, HandlesMoved) {
  class Unseen final : public HandlesOverlay {
    void show(BodyHandles) override {}
  };
  return std::make_shared<Unseen>();
}
Ticket Overlays::askForBodyPoint(const std::string&, std::function<void(const Point<frame::World>&)>, std::function<void()>) {
  return nullptr;
}
CaseParts::~CaseParts() = default;
Ticket CaseParts::onAsked(const std::string&, AskCallback) { return nullptr; }
Window::~Window() = default;
Ticket Window::holdUnsaved(UnsavedWork work) { return onClosing(std::move(work.sentence)); }
std::optional<std::filesystem::path> Window::askSaveFile(const SaveFile&) { return std::nullopt; }
Commands::~Commands() = default;
Log::~Log() = default;
Host::~Host() = default;
Plugin::~Plugin() = default;
// NOLINTEND(performance-unnecessary-value-param)

}  // namespace ew::sdk
