#pragma once
// Devices that umockdev shows to the real hidapi and libusb: a /sys and /dev of its own, and ioctls
// that the test answers. Without the preloaded library there is nothing to see: tests skip.
#include <gtest/gtest.h>
#include <umockdev.h>

#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace foverig::test {

class MockBed {
  public:
    MockBed() : bed_(umockdev_testbed_new()) {}
    ~MockBed() { g_object_unref(bed_); }
    MockBed(const MockBed&) = delete;
    MockBed& operator=(const MockBed&) = delete;

    UMockdevTestbed* get() const { return bed_; }
    /// `description` as umockdev-record writes it.
    void add(const std::string& description) {
        GError* error = nullptr;
        ASSERT_TRUE(umockdev_testbed_add_from_string(bed_, description.c_str(), &error))
            << error->message;
    }

  private:
    UMockdevTestbed* bed_;
};

/// Answers the ioctls of one node; `handle` is called on umockdev's thread.
class IoctlNode {
  public:
    IoctlNode() : base_(umockdev_ioctl_base_new()) {
        g_signal_connect(base_, "handle-ioctl", G_CALLBACK(&IoctlNode::called), this);
    }
    virtual ~IoctlNode() { g_object_unref(base_); }
    IoctlNode(const IoctlNode&) = delete;
    IoctlNode& operator=(const IoctlNode&) = delete;

    void attach(const MockBed& bed, const std::string& node) {
        GError* error = nullptr;
        ASSERT_TRUE(umockdev_testbed_attach_ioctl(bed.get(), node.c_str(), base_, &error))
            << error->message;
    }
    static void detach(const MockBed& bed, const std::string& node) {
        umockdev_testbed_detach_ioctl(bed.get(), node.c_str(), nullptr);
    }

  protected:
    virtual void handle(UMockdevIoctlClient* client, unsigned long request,
                        UMockdevIoctlData* argument) = 0;

  private:
    static gboolean called(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
        static_cast<IoctlNode*>(self)->handle(client, umockdev_ioctl_client_get_request(client),
                                              umockdev_ioctl_client_get_arg(client));
        return TRUE;
    }

    UMockdevIoctlBase* base_;
};

/// What a pointer at `offset` of `data` leads to.
inline UMockdevIoctlData* follow(UMockdevIoctlData* data, std::size_t offset, std::size_t size) {
    return umockdev_ioctl_data_resolve(data, offset, size, nullptr);
}

inline void write_to(UMockdevIoctlData* data, std::size_t offset,
                     std::span<const std::byte> bytes) {
    std::vector<guint8> copy(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) copy[i] = static_cast<guint8>(bytes[i]);
    umockdev_ioctl_data_update(data, offset, copy.data(), static_cast<gint>(copy.size()));
}

inline std::vector<std::byte> read_from(UMockdevIoctlData* data) {
    const auto bytes =
        std::as_bytes(std::span(data->data, static_cast<std::size_t>(data->data_len)));
    return {bytes.begin(), bytes.end()};
}

}  // namespace foverig::test
