#!/usr/bin/env bash
# OpenIGTLink 1.11.0 (Debian libopenigtlink 1.11.0-4): a time stamp loses time each
# time it is packed and unpacked. Half a second, which the wire format holds exactly
# (fraction 0x80000000), is sent as 0x7fffffff and received as 0.499999987 s; handing
# the received stamp on moves it back again, at every hop, without ever settling.
# Surprised: whoever finds a tracker pose for an ultrasound frame by equal stamps,
# compares a recording with what was sent, or puts relays between scanner and display.
# Expected: the same nanosecond comes back, as the wire's step of 2^-32 s (0.23 ns) is
# finer than the class's step of 1 ns; plain rounding shows it below, for the same values.
# Source: OpenIGTLink protocol 3.0, "Time Stamp Field in Header" (32 bits of seconds, 32
# bits of their fraction) and igtlTimeStamp.h (seconds and nanoseconds).
# Needs a C++ compiler, as anything that uses this library does.
set -euo pipefail

packages=(libopenigtlink-dev=1.11.0-4 libopenigtlink1.11=1.11.0-4)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

get=(apt-get -qq -o APT::Sandbox::User=root)
"${get[@]}" download "${packages[@]}" >/dev/null 2>&1 || {
  # The machine's package lists are missing or old: read fresh ones into this folder.
  mkdir -p lists/partial cache/archives/partial
  get+=(-o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache")
  "${get[@]}" update
  "${get[@]}" download "${packages[@]}" >/dev/null
}
for deb in *.deb; do dpkg -x "$deb" .; done
version=$(dpkg-deb -f libopenigtlink1.11_*.deb Version)
echo "OpenIGTLink $version"
[ "$version" = 1.11.0-4 ] || { echo "That is another version." >&2; exit 1; }

cat > hops.cxx <<'CXX'
#include <igtlTimeStamp.h>
#include <igtlTransformMessage.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace {

struct Hop { igtlUint32 wire, received; };

// One message from a sender to a receiver, with this many nanoseconds past 7 s.
Hop sendAndReceive(igtlUint32 nanoseconds) {
  auto stamp = igtl::TimeStamp::New();
  stamp->SetTime(igtlUint32(7), nanoseconds);
  igtl::Matrix4x4 pose;
  igtl::IdentityMatrix(pose);
  auto sent = igtl::TransformMessage::New();
  sent->SetDeviceName("Probe");
  sent->SetMatrix(pose);
  sent->SetTimeStamp(stamp);
  sent->Pack();

  auto header = igtl::MessageHeader::New();
  header->InitPack();
  std::memcpy(header->GetPackPointer(), sent->GetPackPointer(), header->GetPackSize());
  header->Unpack();
  unsigned second = 0, fraction = 0;
  header->GetTimeStamp(&second, &fraction);
  auto arrived = igtl::TimeStamp::New();
  header->GetTimeStamp(arrived);
  if (second != 7 || arrived->GetSecond() != 7) std::printf("The second changed as well.\n");
  return {fraction, arrived->GetNanosecond()};
}

// The same way to the wire and back, by rounding to the nearest step both times.
Hop rounded(igtlUint32 nanoseconds) {
  const double steps = 4294967296.0;
  const auto wire = igtlUint32(std::llround(nanoseconds / 1e9 * steps));
  return {wire, igtlUint32(std::llround(wire / steps * 1e9))};
}

}  // namespace

int main() {
  bool asDescribed = true;
  std::printf("%11s  %-22s  %-22s  %s\n", "sent ns", "library: wire, back",
              "rounding: wire, back", "after 1000 hops");
  for (igtlUint32 sent : {500000000u, 250000000u, 40000000u, 123456789u}) {
    const Hop once = sendAndReceive(sent), exact = rounded(sent);
    igtlUint32 last = sent;
    bool everySlower = true;
    for (int hop = 0; hop < 1000; ++hop) {
      const igtlUint32 next = sendAndReceive(last).received;
      everySlower = everySlower && next < last;
      last = next;
    }
    std::printf("%11u  %08x %12u   %08x %12u   %u (%d ns)\n", sent, once.wire, once.received,
                exact.wire, exact.received, last, int(last) - int(sent));
    asDescribed = asDescribed && everySlower && exact.received == sent;
  }
  const Hop half = sendAndReceive(500000000u);
  asDescribed = asDescribed && half.wire == 0x7fffffffu && half.received == 499999987u;
  std::puts(asDescribed ? "As described: no stamp comes back as sent, and each hop takes more."
                        : "Changed: time stamps no longer drift the way described here.");
  return asDescribed ? 0 : 1;
}
CXX

g++ -std=c++17 -w -I usr/include/openigtlink hops.cxx -L usr/lib -lOpenIGTLink -o hops
LD_LIBRARY_PATH="$work/usr/lib" ./hops
