#include "devices/byte_pool.h"

#include <mutex>
#include <utility>

namespace foverig {

struct BytePool::Spares {
    std::mutex mutex;
    std::vector<std::vector<std::byte>> idle;
    std::size_t made = 0;

    std::vector<std::byte> take() {
        const std::lock_guard lock(mutex);
        if (idle.empty()) {
            if (++made > idle.capacity()) idle.reserve(2 * made);  // for when all come back
            return {};
        }
        auto bytes = std::move(idle.back());
        idle.pop_back();
        return bytes;
    }
    void put(std::vector<std::byte> bytes) noexcept {
        const std::lock_guard lock(mutex);
        idle.push_back(std::move(bytes));
    }
};

BytePool::Held& BytePool::Held::operator=(Held other) noexcept {
    std::swap(bytes_, other.bytes_);
    std::swap(home_, other.home_);
    return *this;
}

void BytePool::Held::give_back() noexcept {
    if (const auto home = std::exchange(home_, nullptr)) home->put(std::move(bytes_));
}

std::vector<std::byte> BytePool::Held::release() && {
    home_.reset();
    return std::move(bytes_);
}

BytePool::BytePool() : spares_(std::make_shared<Spares>()) {}

BytePool::Held BytePool::copy_of(Bytes head, Bytes rest) {
    Held held(spares_->take());
    held.home_ = spares_;
    held.bytes_.reserve(head.size() + rest.size());
    held.bytes_.assign(head.begin(), head.end());
    held.bytes_.insert(held.bytes_.end(), rest.begin(), rest.end());
    return held;
}

}  // namespace foverig
