#include "renderer/scene/gltf_accessor.h"

#include <algorithm>
#include <cstring>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

template <class T>
T raw(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

std::uint64_t component_size(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::uint32_t unsigned_value(const unsigned char* bytes, int type) {
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *bytes;
    if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return raw<std::uint16_t>(bytes);
    return raw<std::uint32_t>(bytes);
}

bool is_unsigned(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

constexpr unsigned char kZeros[64] = {};

}  // namespace

std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int index,
                                          const ImportContext& context) {
    const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(index));
    const std::vector<unsigned char>& data =
        model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        fail(context.file, "bufferViews[{}] covers bytes {} to {}, but its buffer holds {}", index,
             view.byteOffset,
             static_cast<double>(view.byteOffset) + static_cast<double>(view.byteLength),
             data.size());
    return {data.data() + view.byteOffset, view.byteLength};
}

GltfAccessor::GltfAccessor(const tinygltf::Model& model, int number, int components,
                           const ImportContext& context)
    : number_(number) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
    type_ = accessor.componentType;
    normalized_ = accessor.normalized;
    const std::uint64_t size = component_size(type_) * static_cast<std::uint64_t>(components);
    if (size == 0)
        fail(context.file, "accessors[{}] has component type {}, which glTF does not have", number,
             type_);
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != components)
        fail(context.file, "accessors[{}] holds {} numbers an element; expected {}", number,
             tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)),
             components);
    if (accessor.bufferView >= 0) {
        const std::uint64_t stride =
            model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView)).byteStride;
        stride_ = stride == 0 ? size : stride;
        bytes_ = checked_range(model, accessor.bufferView, accessor.byteOffset, accessor.count,
                               stride_, size, context);
    } else if (accessor.count > context.settings.max_triangles) {
        // Nothing backs the count of an accessor without a view.
        fail(context.file, "accessors[{}] promises {} elements and has no bufferView", number,
             accessor.count);
    }
    count_ = accessor.count;
    if (accessor.sparse.isSparse) read_sparse(model, context);
}

std::span<const unsigned char> GltfAccessor::checked_range(const tinygltf::Model& model, int view,
                                                           std::uint64_t offset,
                                                           std::uint64_t count,
                                                           std::uint64_t stride, std::uint64_t size,
                                                           const ImportContext& context) const {
    const std::span<const unsigned char> bytes = view_bytes(model, view, context);
    if (stride < size)
        fail(context.file, "bufferViews[{}] has a byteStride of {}; its elements have {} bytes",
             view, stride, size);
    const bool fits = count == 0 || (offset <= bytes.size() && size <= bytes.size() - offset &&
                                     (count - 1) <= (bytes.size() - offset - size) / stride);
    if (!fits)
        fail(context.file,
             "accessors[{}] wants {} elements of {} bytes from byte {} on, but its bufferView "
             "holds {} bytes",
             number_, count, size, offset, bytes.size());
    return bytes.subspan(count == 0 ? 0 : static_cast<std::size_t>(offset));
}

void GltfAccessor::read_sparse(const tinygltf::Model& model, const ImportContext& context) {
    const auto& sparse = model.accessors[static_cast<std::size_t>(number_)].sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        !is_unsigned(sparse.indices.componentType))
        fail(context.file,
             "accessors[{}].sparse has a negative number or indices that are not unsigned",
             number_);
    const auto count = static_cast<std::uint64_t>(sparse.count);
    const std::uint64_t index_size = component_size(sparse.indices.componentType);
    const int components = tinygltf::GetNumComponentsInType(
        static_cast<std::uint32_t>(model.accessors[static_cast<std::size_t>(number_)].type));
    const std::uint64_t value_size = component_size(type_) * static_cast<std::uint64_t>(components);
    const auto indices = checked_range(model, sparse.indices.bufferView,
                                       static_cast<std::uint64_t>(sparse.indices.byteOffset), count,
                                       index_size, index_size, context);
    const auto values = checked_range(model, sparse.values.bufferView,
                                      static_cast<std::uint64_t>(sparse.values.byteOffset), count,
                                      value_size, value_size, context);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint32_t element =
            unsigned_value(indices.data() + i * index_size, sparse.indices.componentType);
        if (element >= count_)
            fail(context.file, "accessors[{}].sparse replaces element {} of {}", number_, element,
                 count_);
        sparse_.emplace_back(element, values.data() + i * value_size);
    }
    std::sort(sparse_.begin(), sparse_.end());
}

const unsigned char* GltfAccessor::element(std::size_t i) const {
    if (!sparse_.empty()) {
        const auto found = std::lower_bound(
            sparse_.begin(), sparse_.end(), i,
            [](const auto& entry, std::size_t want) { return entry.first < want; });
        if (found != sparse_.end() && found->first == i) return found->second;
    }
    return bytes_.empty() ? kZeros : bytes_.data() + i * stride_;
}

double GltfAccessor::value(std::size_t i, int c) const {
    const unsigned char* bytes = element(i) + static_cast<std::size_t>(c) * component_size(type_);
    const auto scaled = [this](double v, double full) {
        return normalized_ ? std::max(v / full, -1.0) : v;
    };
    switch (type_) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return double{raw<float>(bytes)};
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return scaled(raw<std::int8_t>(bytes), 127.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return scaled(*bytes, 255.0);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return scaled(raw<std::int16_t>(bytes), 32767.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return scaled(raw<std::uint16_t>(bytes), 65535.0);
        default:
            return scaled(raw<std::uint32_t>(bytes), 4294967295.0);
    }
}

bool GltfAccessor::holds_indices() const {
    return is_unsigned(type_);
}

std::uint32_t GltfAccessor::index_at(std::size_t i) const {
    return unsigned_value(element(i), type_);
}

}  // namespace foverig::scene_import
