#include "renderer/scene/ply_body.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

template <class T>
double value_of(const std::array<char, 8>& raw) {
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return static_cast<double>(value);
}

}  // namespace

double PlyBody::next_ascii() {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
    if (at_ < bytes_.size() && bytes_[at_] == '+') ++at_;
    double value = 0.0;
    const char* begin = bytes_.data() + at_;
    const auto [end, error] = std::from_chars(begin, bytes_.data() + bytes_.size(), value);
    if (at_ >= bytes_.size())
        fail(context_.file, "ends before all numbers that its PLY header promises");
    if (error == std::errc::invalid_argument)
        fail(context_.file, "has something other than a number at byte {}", at_);
    at_ += static_cast<std::size_t>(end - begin);
    return error == std::errc::result_out_of_range ? std::numeric_limits<double>::infinity()
                                                   : value;
}

double PlyBody::next(PlyType type) {
    if (format_ == PlyFormat::kAscii) return next_ascii();
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size)
        fail(context_.file, "ends before all numbers that its PLY header promises");
    const bool swapped =
        (format_ == PlyFormat::kBigEndian) != (std::endian::native == std::endian::big);
    std::array<char, 8> raw{};
    for (std::size_t i = 0; i < size; ++i) raw[swapped ? size - 1 - i : i] = bytes_[at_ + i];
    at_ += size;
    switch (type) {
        case PlyType::kInt8:
            return value_of<std::int8_t>(raw);
        case PlyType::kUint8:
            return value_of<std::uint8_t>(raw);
        case PlyType::kInt16:
            return value_of<std::int16_t>(raw);
        case PlyType::kUint16:
            return value_of<std::uint16_t>(raw);
        case PlyType::kInt32:
            return value_of<std::int32_t>(raw);
        case PlyType::kUint32:
            return value_of<std::uint32_t>(raw);
        case PlyType::kFloat32:
            return value_of<float>(raw);
        case PlyType::kFloat64:
            return value_of<double>(raw);
    }
    return 0.0;
}

std::uint64_t PlyBody::next_count(const PlyProperty& list) {
    const double count = next(list.count_type);
    const std::size_t least = format_ == PlyFormat::kAscii ? 1 : size_of(list.type);
    if (!(count >= 0.0) || count > static_cast<double>((bytes_.size() - at_) / least + 1))
        fail(context_.file, "has a list of {} values where {} bytes are left", count,
             bytes_.size() - at_);
    return static_cast<std::uint64_t>(count);
}

void PlyBody::skip(const PlyProperty& property) {
    const std::uint64_t count = property.is_list ? next_count(property) : 1;
    for (std::uint64_t i = 0; i < count; ++i) next(property.type);
}

}  // namespace foverig::scene_import
