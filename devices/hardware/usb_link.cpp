#include "devices/hardware/usb_link.h"

#include <fmt/format.h>
#include <libusb-1.0/libusb.h>

#include <algorithm>

#include "devices/hardware/usb_node.h"

namespace foverig::hardware {
namespace {

constexpr int kInterface = 0;
constexpr unsigned char kFrames = 0x81;  // bulk IN
constexpr unsigned kControlTimeout_ms = 1000;
constexpr suseconds_t kWait_us = 50'000;     // how soon the reader sees that it should stop
constexpr int kMostHaltsInARow = 8;          // beyond it the device is not well
constexpr int kMostWaitsForCancelled = 100;  // a kernel gives cancelled transfers back at once
constexpr auto kToDevice = static_cast<std::uint8_t>(static_cast<int>(LIBUSB_ENDPOINT_OUT) |
                                                     static_cast<int>(LIBUSB_REQUEST_TYPE_VENDOR) |
                                                     static_cast<int>(LIBUSB_RECIPIENT_INTERFACE));
constexpr auto kToHost = static_cast<std::uint8_t>(kToDevice | LIBUSB_ENDPOINT_IN);

void handle_events(libusb_context* context) {
    timeval wait{.tv_sec = 0, .tv_usec = kWait_us};
    libusb_handle_events_timeout_completed(context, &wait, nullptr);
}

void fill(libusb_transfer* transfer, libusb_device_handle* device, std::span<unsigned char> buffer,
          libusb_transfer_cb_fn completed, void* owner) {
    libusb_fill_bulk_transfer(transfer, device, kFrames, buffer.data(),
                              static_cast<int>(buffer.size()), completed, owner, 0);
}

}  // namespace

void UsbLink::Close::operator()(libusb_context* context) const {
    libusb_exit(context);
}
void UsbLink::Close::operator()(libusb_device_handle* device) const {
    libusb_close(device);  // gives the interface back too
}
void UsbLink::Close::operator()(libusb_transfer* transfer) const {
    libusb_free_transfer(transfer);
}

Result<std::unique_ptr<Link>> UsbLink::open(const FoundDevice& device) {
    if (const auto problem = opening_problem(device.path)) return *problem;
    libusb_context* made = nullptr;
    if (const int code = libusb_init(&made); code != 0) {
        return Error{ErrorCode::io,
                     fmt::format("libusb does not start: {}", libusb_strerror(code))};
    }
    Context context(made);
    Handle handle(open_node(context.get(), device.path));
    if (!handle) {
        return Error{ErrorCode::closed, fmt::format("{} was unplugged just now", device.path)};
    }
    if (const int code = libusb_claim_interface(handle.get(), kInterface); code != 0) {
        return claim_problem(device.path, code);
    }
    // Whoever had it before may have left it halted. Where it cannot be cleared, transfers tell.
    (void)libusb_clear_halt(handle.get(), kFrames);
    return std::unique_ptr<Link>(new UsbLink(std::move(context), std::move(handle), device.path));
}

UsbLink::UsbLink(Context context, Handle device, std::string path)
    : context_(std::move(context)), path_(std::move(path)), device_(std::move(device)) {
    for (Slot& slot : slots_) slot.transfer.reset(libusb_alloc_transfer(0));
}

UsbLink::~UsbLink() {
    const auto busy = [this] {
        const std::lock_guard lock(mutex_);
        return any_in_flight();
    };
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
        cancel_all();
    }
    for (int i = 0; i < kMostWaitsForCancelled && busy(); ++i) handle_events(context_.get());
}

bool UsbLink::any_in_flight() const {
    return std::any_of(slots_.begin(), slots_.end(), [](const Slot& s) { return s.in_flight; });
}

void UsbLink::cancel_all() {
    for (Slot& slot : slots_) {
        if (slot.in_flight) libusb_cancel_transfer(slot.transfer.get());
    }
}

Error UsbLink::failed(int code) const {
    return {code == LIBUSB_ERROR_NO_DEVICE ? ErrorCode::closed : ErrorCode::io,
            fmt::format("{} gives no more frames ({})", path_, libusb_strerror(code))};
}

void UsbLink::start(PacketQueue& packets) {
    const std::lock_guard lock(mutex_);
    packets_ = &packets;
    for (Slot& slot : slots_) {
        const auto completed = [](libusb_transfer* transfer) {
            auto* link = static_cast<UsbLink*>(transfer->user_data);
            const std::lock_guard callback_lock(link->mutex_);
            const auto done =
                std::find_if(link->slots_.begin(), link->slots_.end(),
                             [transfer](const Slot& s) { return s.transfer.get() == transfer; });
            link->take(*done);
        };
        fill(slot.transfer.get(), device_.get(), slot.buffer, completed, this);
        submit(slot);
    }
}

void UsbLink::submit(Slot& slot) {
    const int code = libusb_submit_transfer(slot.transfer.get());
    slot.in_flight = code == 0;
    if (code != 0) failure_ = failed(code);
}

void UsbLink::take(Slot& slot) {
    slot.in_flight = false;
    const libusb_transfer& done = *slot.transfer;
    switch (done.status) {
        case LIBUSB_TRANSFER_COMPLETED:
            if (!closing_) {
                const auto size = static_cast<std::size_t>(done.actual_length);
                packets_->push(std::as_bytes(std::span(slot.buffer)).first(size));
            }
            halts_in_a_row_ = 0;
            break;
        case LIBUSB_TRANSFER_OVERFLOW:  // longer than any frame: nothing of it can be used
            break;
        case LIBUSB_TRANSFER_STALL:
            if (halted_ || closing_) return;
            halted_ = true;
            packets_->push(Bytes{});
            cancel_all();
            return;
        case LIBUSB_TRANSFER_CANCELLED:
            return;
        default:
            failure_ = failed(done.status == LIBUSB_TRANSFER_NO_DEVICE ? LIBUSB_ERROR_NO_DEVICE
                                                                       : LIBUSB_ERROR_IO);
            return;
    }
    if (!closing_ && !halted_) submit(slot);
}

/// Not from a completed transfer's callback: a kernel wants nothing in flight meanwhile.
void UsbLink::clear_halt() {
    halted_ = false;
    if (++halts_in_a_row_ > kMostHaltsInARow) {
        failure_ = Error{ErrorCode::io, path_ + " halts again and again instead of giving frames"};
        return;
    }
    if (const int code = libusb_clear_halt(device_.get(), kFrames); code != 0) {
        failure_ = failed(code);
        return;
    }
    for (Slot& slot : slots_) submit(slot);
}

Status UsbLink::read(PacketQueue& packets) {
    if (packets_ == nullptr) start(packets);
    handle_events(context_.get());
    const std::lock_guard lock(mutex_);
    if (halted_ && !failure_ && !any_in_flight()) clear_halt();
    if (failure_) return *failure_;
    return Done{};
}

Status UsbLink::control_set(std::uint8_t request, std::uint16_t value, Bytes data) {
    std::vector<std::byte> bytes = to_vector(data);
    const int sent =
        libusb_control_transfer(device_.get(), kToDevice, request, value, kInterface,
                                reinterpret_cast<unsigned char*>(bytes.data()),
                                static_cast<std::uint16_t>(bytes.size()), kControlTimeout_ms);
    if (sent == static_cast<int>(bytes.size())) return Done{};
    return request_problem(path_, request, sent);
}

Result<std::vector<std::byte>> UsbLink::control_get(std::uint8_t request, std::uint16_t value,
                                                    std::size_t size) {
    std::vector<std::byte> bytes(size);
    const int got = libusb_control_transfer(device_.get(), kToHost, request, value, kInterface,
                                            reinterpret_cast<unsigned char*>(bytes.data()),
                                            static_cast<std::uint16_t>(size), kControlTimeout_ms);
    if (got < 0) return request_problem(path_, request, got);
    bytes.resize(static_cast<std::size_t>(got));
    return bytes;
}

}  // namespace foverig::hardware
