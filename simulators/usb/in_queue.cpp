#include "simulators/usb/in_queue.h"

#include <algorithm>

namespace foverig::usb {

std::optional<InQueue::Ended> InQueue::submit(const Submit& submit, HostTime now) {
    waiting_.push_back(submit);
    last_asked_ = now;
    return meet();
}

std::optional<InQueue::Ended> InQueue::push(std::vector<std::byte> data, HostTime now) {
    data_.push_back(std::move(data));
    if (waiting_.empty() && last_asked_ < now - kListens) {
        unheard_ += data_.size();
        data_.clear();
    }
    return meet();
}

bool InQueue::unlink(std::uint32_t sequence) {
    return std::erase_if(waiting_, [sequence](const Submit& submit) {
               return submit.sequence == sequence;
           }) > 0;
}

std::optional<InQueue::Ended> InQueue::meet() {
    if (waiting_.empty() || data_.empty()) return std::nullopt;
    Ended ended{.submit = waiting_.front(), .status = kGood, .data = std::move(data_.front())};
    waiting_.pop_front();
    data_.pop_front();
    if (ended.data.size() > ended.submit.length) {
        ended.data.resize(ended.submit.length);
        ended.status = kTooLong;
    }
    return ended;
}

}  // namespace foverig::usb
