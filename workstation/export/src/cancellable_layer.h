#pragma once

#include <dcmtk/config/osconfig.h>
// after DCMTK's configuration
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmnet/dcmtrans.h>

#include <string>

#include "ew/core/progress.h"

namespace ew::exporting {

/// Makes connections whose every wait ends soon after the work was cancelled; DCMTK's own sit out their timeouts, which are whole seconds.
class CancellableLayer final : public DcmTransportLayer {
 public:
  /// @param timeout_s of one wait for the other side
  CancellableLayer(const Progress& progress, double timeout_s) : progress_(progress), timeout_s_(timeout_s) {}
  DcmTransportConnection* createConnection(DcmNativeSocketType openSocket, OFBool useSecureLayer) override;

 private:
  const Progress& progress_;
  double timeout_s_;
};

/// Whether anybody listens there: connects, and leaves again. To be asked before DCMTK connects, which cannot be cancelled meanwhile.
/// Looking a name up waits as long as the system's resolver does. @return empty, or why not
[[nodiscard]] std::string whyNotReached(const std::string& host, int port, double timeout_s, const Progress& progress);

}  // namespace ew::exporting
