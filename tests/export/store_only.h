#pragma once

#include "orthanc.h"
// after the system's headers, and DCMTK's configuration first
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/scp.h>

#include <atomic>

namespace ew::test {

inline bool hasStorescp() { return ::access("/usr/bin/storescp", X_OK) == 0; }

/// DCMTK's storescp: takes objects into a folder and knows no questions, as gateways do.
class Storescp {
 public:
  /// @param option of its command line, or null
  explicit Storescp(const std::filesystem::path& folder, const char* option = nullptr) : folder_(folder), port_(freePort()) {
    std::filesystem::create_directories(folder);
    process_ = ::fork();
    if (process_ == 0) {
      const std::string log = folder.string() + ".log", port = std::to_string(port_);
      if (std::freopen(log.c_str(), "a", stdout) == nullptr || std::freopen(log.c_str(), "a", stderr) == nullptr) ::_exit(126);
      if (option != nullptr)
        ::execl("/usr/bin/storescp", "storescp", option, "-od", folder.c_str(), port.c_str(), nullptr);
      else
        ::execl("/usr/bin/storescp", "storescp", "-od", folder.c_str(), port.c_str(), nullptr);
      ::_exit(127);
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(kPatience_ms);
    while (!listensAt(port_) && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ~Storescp() {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Storescp(const Storescp&) = delete;
  Storescp& operator=(const Storescp&) = delete;

  [[nodiscard]] DicomArchive address() const {
    DicomArchive archive;
    archive.host = "127.0.0.1";
    archive.port = port_;
    archive.aeTitle = "GATEWAY";
    return archive;
  }
  [[nodiscard]] std::vector<std::filesystem::path> kept() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) files.push_back(entry.path());
    return files;
  }

 private:
  std::filesystem::path folder_;
  int port_;
  pid_t process_ = 0;
};

/// An archive that agrees to be asked, stores everything, and answers no question.
class RefusesQuestions final : public DcmSCP {
 public:
  enum class How { says, hangsUp };

  explicit RefusesQuestions(How how) : how_(how), port_(freePort()) {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    OFList<OFString> syntaxes;
    syntaxes.push_back(UID_LittleEndianExplicitTransferSyntax);
    syntaxes.push_back(UID_LittleEndianImplicitTransferSyntax);
    for (const char* each : {UID_UltrasoundImageStorage, UID_UltrasoundMultiframeImageStorage, UID_ComprehensiveSRStorage,
                             UID_FINDStudyRootQueryRetrieveInformationModel})
      addPresentationContext(each, syntaxes);
    setPort(static_cast<Uint16>(port_));
    setAETitle("REFUSES");
    setConnectionBlockingMode(DUL_NOBLOCK);
    setConnectionTimeout(1);
    listening_ = std::thread([this] { listen(); });
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(kPatience_ms);
    while (!listensAt(port_) && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ~RefusesQuestions() override {
    isOver_ = true;
    listening_.join();
  }

  [[nodiscard]] DicomArchive address() const {
    DicomArchive archive;
    archive.host = "127.0.0.1";
    archive.port = port_;
    archive.aeTitle = "REFUSES";
    return archive;
  }
  [[nodiscard]] int stored() const { return stored_; }

 private:
  OFBool stopAfterCurrentAssociation() override { return isOver_ ? OFTrue : OFFalse; }
  OFBool stopAfterConnectionTimeout() override { return isOver_ ? OFTrue : OFFalse; }
  OFCondition handleIncomingCommand(T_DIMSE_Message* message, const DcmPresentationContextInfo& context) override {
    DcmDataset* data = nullptr;
    OFCondition status = EC_IllegalCall;
    if (message->CommandField == DIMSE_C_STORE_RQ) {
      status = handleSTORERequest(message->msg.CStoreRQ, context.presentationContextID, data);
      stored_ += status.good() ? 1 : 0;
    } else if (message->CommandField == DIMSE_C_FIND_RQ) {
      auto& request = message->msg.CFindRQ;
      status = receiveFINDRequest(request, context.presentationContextID, data);
      if (status.good() && how_ == How::says)
        status = sendFINDResponse(context.presentationContextID, request.MessageID, request.AffectedSOPClassUID, nullptr, 0xC001, nullptr);
      else
        status = EC_IllegalCall;  // the association is aborted
    }
    delete data;
    return status;
  }

  How how_;
  int port_;
  std::atomic<bool> isOver_{false};
  std::atomic<int> stored_{0};
  std::thread listening_;
};

}  // namespace ew::test
