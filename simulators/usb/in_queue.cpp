#include "simulators/usb/in_queue.h"

#include <algorithm>

namespace foverig::usb {

std::optional<InQueue::Ended> InQueue::submit(const Submit& submit, HostTime now) {
    waiting_.push_back(submit);
    last_asked_ = now;
    return meet();
}

std::optional<InQueue::Ended> InQueue::push(std::vector<std::byte> data, HostTime now) {
    kept_.push_back({now, std::move(data)});
    const bool listens = !waiting_.empty() || last_asked_ >= now - kListens;
    while (!kept_.empty() && (!listens || kept_.front().since < now - kOldest)) {
        ++unheard_;
        kept_.pop_front();
    }
    return meet();
}

bool InQueue::unlink(std::uint32_t sequence) {
    return std::erase_if(waiting_, [sequence](const Submit& submit) {
               return submit.sequence == sequence;
           }) > 0;
}

std::optional<InQueue::Ended> InQueue::meet() {
    if (waiting_.empty() || kept_.empty()) return std::nullopt;
    Ended ended{.submit = waiting_.front(), .status = kGood, .data = std::move(kept_.front().data)};
    waiting_.pop_front();
    kept_.pop_front();
    if (ended.data.size() > ended.submit.length) {
        ended.data.resize(ended.submit.length);
        ended.status = kTooLong;
    }
    return ended;
}

}  // namespace foverig::usb
