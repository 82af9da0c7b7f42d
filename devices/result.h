#pragma once
// Expected failures of devices, files and packets: a value or an error, never an exception.
// (std::expected needs C++23, which our nvcc and clang do not have.)
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace foverig {

/// Recordings hold them by number: a new one comes last.
enum class ErrorCode {
    invalid_data,
    io,
    not_found,
    busy,
    forbidden,
    unsupported,
    closed,
    not_asked  ///< nothing was sent: the device let an earlier request run out of time
};

struct Error {
    ErrorCode code = ErrorCode::invalid_data;
    std::string text;  ///< one sentence for a person: what, where, expected, what to do
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
    Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

    explicit operator bool() const { return std::holds_alternative<T>(state_); }
    const T& value() const& { return std::get<T>(state_); }
    T&& value() && { return std::get<T>(std::move(state_)); }
    const T& operator*() const& { return value(); }
    const T* operator->() const { return &value(); }
    const Error& error() const { return std::get<Error>(state_); }

  private:
    std::variant<T, Error> state_;
};

struct Done {};
using Status = Result<Done>;

}  // namespace foverig
