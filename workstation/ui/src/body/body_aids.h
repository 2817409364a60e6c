#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "ew/bridge/organ_surfaces.h"
#include "ew/core/volume.h"

namespace ew::ui {

class HostOverlays;
class Jobs;
class Session;
class View3D;

/// Brings what plugins ask to be shown in the body (sdk::BodyAids) into the 3D view. Organs' surfaces are made in a job and kept until
/// something else is scanned.
class BodyAidsView final : public QObject {
  Q_OBJECT

 public:
  BodyAidsView(HostOverlays& overlays, Session& session, View3D& view, Jobs& jobs, QObject* parent = nullptr);

 private:
  void follow();
  void makeOrgans(const std::vector<int>& wanted);

  HostOverlays& overlays_;
  Session& session_;
  View3D& view_;
  Jobs& jobs_;
  struct Made {
    std::shared_ptr<const Volume> labels;
    Grid placed;
    std::vector<int> wanted;
    std::shared_ptr<const bridge::OrganSurfaces> organs;  ///< null while they are made
  };
  std::shared_ptr<Made> made_;
};

}  // namespace ew::ui
