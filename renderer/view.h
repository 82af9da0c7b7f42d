#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "renderer/hd.h"

namespace foverig {

/// Borrowed array, passed to kernels by value. `View<const T>` is read-only. Never owns.
template <class T>
struct View {
    T* data = nullptr;
    std::size_t size = 0;

    RIG_HD T& operator[](std::size_t i) const { return data[i]; }
    RIG_HD bool empty() const { return size == 0; }
    RIG_HD T* begin() const { return data; }
    RIG_HD T* end() const { return data + size; }
    // NOLINTNEXTLINE(google-explicit-constructor): what may be written may be read
    RIG_HD operator View<const T>() const requires(!std::is_const_v<T>) { return {data, size}; }
};

template <class T>
View<const T> view_of(const std::vector<T>& v) {
    return {v.data(), v.size()};
}
template <class T>
View<T> view_of(std::vector<T>& v) {
    return {v.data(), v.size()};
}

}  // namespace foverig
