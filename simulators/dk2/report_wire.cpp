#include "simulators/dk2/report_wire.h"

#include <algorithm>

namespace foverig {

ReportWire::ReportWire(const Dk2Faults& faults, std::uint64_t seed)
    : faults_(faults), loss_(seed, 620), delay_(seed, 621) {}

// Two states after Gilbert: losses come in runs of `dropout_burst` on average, and their share of
// all reports is `dropout`.
bool ReportWire::lost() {
    if (faults_.dropout <= 0.0) return false;
    const double stay =
        faults_.dropout_burst > 1.0 ? 1.0 - 1.0 / faults_.dropout_burst : faults_.dropout;
    const double enter =
        faults_.dropout < 1.0 ? faults_.dropout * (1.0 - stay) / (1.0 - faults_.dropout) : 1.0;
    losing_ = loss_.uniform(index_) < (losing_ ? stay : enter);
    return losing_;
}

void ReportWire::send(std::vector<std::byte> bytes, HostTime at) {
    ++index_;
    if (lost()) return;
    if (faults_.host_delay > 0.0) {
        at += from_seconds(delay_.exponential(index_, 1e-3 * faults_.host_delay));
        // Reports wait in the host's queue in order.
        at = std::max(at, last_arrival_);
        last_arrival_ = at;
    }
    arriving_.push_back({at, std::move(bytes)});
}

std::optional<Packet> ReportWire::take(HostTime deadline) {
    if (arriving_.empty() || arriving_.front().arrival > deadline) return std::nullopt;
    Packet packet = std::move(arriving_.front());
    arriving_.pop_front();
    return packet;
}

std::optional<HostTime> ReportWire::first_arrival() const {
    if (arriving_.empty()) return std::nullopt;
    return arriving_.front().arrival;
}

}  // namespace foverig
