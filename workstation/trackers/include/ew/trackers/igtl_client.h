#pragma once

#include <memory>
#include <string>

#include "ew/tracking/tracker_device.h"

namespace ew {

/// An OpenIGTLink server that sends poses: PLUS, Slicer, a tracker's own program.
struct IgtlSettings {
  std::string host = "localhost";
  int port = 18944;
  bool checksSums = true;  ///< messages whose CRC is wrong are refused
  /// Speaks header version 2 first, so that PLUS answers in it and says why a pose is none. Servers of protocol 1 and 2 may not understand
  /// it.
  bool speaksVersion3 = false;
  bool operator==(const IgtlSettings&) const = default;
};

/// How patient a client is. The defaults are what a person expects; tests shorten them.
struct IgtlTiming {
  double silentAfter_s = 0.5;     ///< without a pose: told
  double asksAfter_s = 1.0;       ///< connected without any pose: TDATA is asked for, as some servers want it
  double asksEvery_s = 5.0;       ///< and again
  double anewAfter_s = 15.0;      ///< without any byte: the connection is opened anew, since the server may be gone without a word
  double stepLostAfter_s = 10.0;  ///< bytes, but no message in them: the same
  double gaveUpConnect_s = 3.0;   ///< for one address of a name
  double firstPause_s = 0.5;      ///< between attempts; doubled after each that failed
  double longestPause_s = 5.0;
  bool operator==(const IgtlTiming&) const = default;
};

/// Readings of every tool the server sends, by name: TRANSFORM, POSITION, QTRANS, TDATA and QTDATA of header versions 1 to 3, in the
/// tracker's own coordinates. One thread. It connects, and connects again after every fault, until it is stopped; another address is
/// another client. A tool that was heard of and is missing while the server goes on talking is outOfView: PLUS leaves out what it does not
/// see.
[[nodiscard]] std::unique_ptr<TrackerDevice> makeIgtlClient(const IgtlSettings& settings, const IgtlTiming& timing = {});

}  // namespace ew
