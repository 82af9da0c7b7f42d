#pragma once
#include <bit>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace foverig {

/// First in, first out. Grows where it must and keeps what it grew to, so that a queue which has
/// seen its worst allocates nothing.
template <class T>
class Ring {
  public:
    /// For `room` at once without having to grow.
    explicit Ring(std::size_t room = 0) : slots_(room == 0 ? 0 : std::bit_ceil(room)) {}

    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }

    /// The oldest is number 0.
    const T& operator[](std::size_t i) const {
        assert(i < size_);
        return slots_[place(i)];
    }
    const T& front() const { return (*this)[0]; }

    T& push_back(T item) {
        if (size_ == slots_.size()) grow();
        return slots_[place(size_++)] = std::move(item);
    }
    T pop_front() {
        assert(size_ > 0);
        T item = std::move(slots_[first_]);
        first_ = place(1);
        --size_;
        return item;
    }
    void clear() {
        while (!empty()) (void)pop_front();
    }
    /// All of them, oldest first; the ring is empty then.
    std::vector<T> take() {
        std::vector<T> taken;
        taken.reserve(size_);
        while (!empty()) taken.push_back(pop_front());
        return taken;
    }

  private:
    std::size_t place(std::size_t i) const { return (first_ + i) & (slots_.size() - 1); }
    void grow() {
        std::vector<T> larger(slots_.empty() ? 8 : 2 * slots_.size());
        for (std::size_t i = 0; i < size_; ++i) larger[i] = std::move(slots_[place(i)]);
        slots_ = std::move(larger);
        first_ = 0;
    }

    std::vector<T> slots_;  // none, or a power of two
    std::size_t first_ = 0, size_ = 0;
};

}  // namespace foverig
