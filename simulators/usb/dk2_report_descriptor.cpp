#include "simulators/usb/dk2_report_descriptor.h"

#include <span>

#include "simulators/usb/descriptors.h"

namespace foverig::usb {
namespace {

constexpr unsigned kInput = 0x81, kFeature = 0xB1;

/// A row of numbers, 8 or 16 bits each.
struct Field {
    unsigned bits, count;
};

void append(std::vector<std::byte>& out, std::initializer_list<unsigned> values) {
    const auto bytes = bytes_of(values);
    out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Each number is constant, variable, absolute and of usage "byte count".
void append(std::vector<std::byte>& out, const Field& field, unsigned kind) {
    append(out, {0x09, 0x3B, 0x15, 0x00});
    if (field.bits == 16) {
        append(out, {0x27, 0xFF, 0xFF, 0x00, 0x00});
    } else {
        append(out, {0x26, 0xFF, 0x00});
    }
    append(out, {0x75, field.bits, 0x95, field.count, kind, 0x03});
}

void append_report(std::vector<std::byte>& out, unsigned id, unsigned kind,
                   std::initializer_list<Field> fields) {
    append(out, {0x85, id});
    for (const Field& field : fields) append(out, field, kind);
}

/// `bytes` behind id and command id.
void append_feature(std::vector<std::byte>& out, unsigned id, unsigned bytes) {
    append_report(out, id, kFeature, {{16, 1}, {8, bytes}});
}

void begin_collection(std::vector<std::byte>& out, unsigned usage) {
    append(out, {0x06, 0x00, 0xFF, 0x09, usage, 0xA1, 0x02, 0x05, 0x01});
}

}  // namespace

std::vector<std::byte> dk2_report_descriptor() {
    std::vector<std::byte> out = bytes_of({0x05, 0x03, 0x09, 0x05, 0xA1, 0x01});

    begin_collection(out, 1);  // as the DK1 had it
    append_report(out, 1, kInput,
                  {{8, 1}, {16, 1}, {16, 1}, {16, 1}, {8, 16}, {8, 16}, {8, 16}, {16, 3}});
    constexpr unsigned kDk1Features[]{4, 66, 5, 3, 1, 2, 2, 53, 12};  // of reports 2 to 10
    for (unsigned id = 2; const unsigned bytes : kDk1Features) append_feature(out, id++, bytes);
    append(out, {0xC0});

    begin_collection(out, 2);
    append_report(out, 11, kInput, {{16, 1}, {8, 61}});
    constexpr unsigned kDk2Features[]{10, 11, 49, 27, 9, 3, 13, 20, 21, 15, 61};  // of 12 to 22
    for (unsigned id = 12; const unsigned bytes : kDk2Features) append_feature(out, id++, bytes);
    append(out, {0xC0, 0xC0});
    return out;
}

}  // namespace foverig::usb
