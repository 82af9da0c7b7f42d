#include "renderer/scene/ply_header.h"

#include <array>
#include <charconv>
#include <optional>
#include <sstream>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<TypeName, 16> kTypeNames{{{"char", PlyType::kInt8},
                                               {"int8", PlyType::kInt8},
                                               {"uchar", PlyType::kUint8},
                                               {"uint8", PlyType::kUint8},
                                               {"short", PlyType::kInt16},
                                               {"int16", PlyType::kInt16},
                                               {"ushort", PlyType::kUint16},
                                               {"uint16", PlyType::kUint16},
                                               {"int", PlyType::kInt32},
                                               {"int32", PlyType::kInt32},
                                               {"uint", PlyType::kUint32},
                                               {"uint32", PlyType::kUint32},
                                               {"float", PlyType::kFloat32},
                                               {"float32", PlyType::kFloat32},
                                               {"double", PlyType::kFloat64},
                                               {"float64", PlyType::kFloat64}}};

PlyType type_named(const std::string& name, const ImportContext& context) {
    for (const TypeName& known : kTypeNames)
        if (known.name == name) return known.type;
    fail(context.file,
         "its PLY header names the type '{}'; expected char, uchar, short, ushort, int, uint, "
         "float or double",
         name);
}

std::vector<std::string> words(std::string_view line) {
    std::istringstream stream{std::string(line)};
    std::vector<std::string> result;
    for (std::string word; stream >> word;) result.push_back(word);
    return result;
}

PlyElement parse_element(const std::vector<std::string>& w, const ImportContext& context) {
    PlyElement element;
    if (w.size() == 3) {
        element.name = w[1];
        const auto [end, error] =
            std::from_chars(w[2].data(), w[2].data() + w[2].size(), element.count);
        if (error == std::errc() && end == w[2].data() + w[2].size()) return element;
    }
    fail(context.file, "its PLY header has an 'element' line that is not 'element NAME COUNT'");
}

PlyProperty parse_property(const std::vector<std::string>& w, const ImportContext& context) {
    if (w.size() == 3) return {w[2], type_named(w[1], context), false, PlyType::kUint8};
    if (w.size() == 5 && w[1] == "list") {
        const PlyType count_type = type_named(w[2], context);
        if (count_type == PlyType::kFloat32 || count_type == PlyType::kFloat64)
            fail(context.file, "its PLY header counts a list in {}; expected an integer type",
                 w[2]);
        return {w[4], type_named(w[3], context), true, count_type};
    }
    fail(context.file,
         "its PLY header has a 'property' line that is neither 'property TYPE NAME' nor 'property "
         "list TYPE TYPE NAME'");
}

PlyFormat parse_format(const std::vector<std::string>& w, const ImportContext& context) {
    const std::string name = w.size() >= 2 ? w[1] : "";
    if (name == "ascii") return PlyFormat::kAscii;
    if (name == "binary_little_endian") return PlyFormat::kLittleEndian;
    if (name == "binary_big_endian") return PlyFormat::kBigEndian;
    fail(context.file,
         "its PLY format is '{}'; expected ascii, binary_little_endian or binary_big_endian", name);
}

/// A count that the rest of the file cannot hold would only ask for memory.
void check_counts(const PlyHeader& header, std::size_t file_size, const ImportContext& context) {
    const std::uint64_t left = file_size - header.body_offset;
    for (const PlyElement& element : header.elements) {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += header.format == PlyFormat::kAscii
                         ? 1
                         : size_of(property.is_list ? property.count_type : property.type);
        if (least == 0 && element.count > 0)
            fail(context.file, "its PLY element '{}' has no properties", element.name);
        if (least > 0 && element.count > left / least)
            fail(context.file, "its PLY header promises {} of '{}', which its {} bytes cannot hold",
                 element.count, element.name, left);
    }
}

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader parse_ply_header(std::string_view bytes, const ImportContext& context) {
    PlyHeader header;
    std::optional<PlyFormat> format;
    if (!bytes.starts_with("ply\n") && !bytes.starts_with("ply\r"))
        fail(context.file, "does not begin with 'ply'; it is no PLY file");
    std::size_t begin = 0;
    while (begin < bytes.size()) {
        const std::size_t newline = bytes.find('\n', begin);
        if (newline == std::string_view::npos) break;
        const std::vector<std::string> w = words(bytes.substr(begin, newline - begin));
        begin = newline + 1;
        if (w.empty() || w[0] == "ply" || w[0] == "comment" || w[0] == "obj_info") continue;
        if (w[0] == "end_header") {
            if (!format) fail(context.file, "its PLY header has no 'format' line");
            header.format = *format;
            header.body_offset = begin;
            check_counts(header, bytes.size(), context);
            return header;
        }
        if (w[0] == "format")
            format = parse_format(w, context);
        else if (w[0] == "element")
            header.elements.push_back(parse_element(w, context));
        else if (w[0] == "property" && !header.elements.empty())
            header.elements.back().properties.push_back(parse_property(w, context));
        else
            fail(context.file,
                 "its PLY header has a line that begins with '{}'; expected format, element, "
                 "property or end_header",
                 w[0].substr(0, 40));
    }
    fail(context.file, "its PLY header never ends; a line 'end_header' is missing");
}

}  // namespace foverig::scene_import
