#pragma once
// `foverig expose ...` as a program of its own beside the test, as a person runs it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace foverig::test {

/// Whether this kernel has a device of "2833:0021", on USB or made through uhid.
inline bool kernel_has(const std::string& usb_id) {
    namespace fs = std::filesystem;
    const auto line_of = [](const fs::path& file) {
        std::string line;
        std::getline(std::ifstream(file) >> std::ws, line);
        return line;
    };
    std::error_code gone;  // while it is looked at
    for (fs::directory_iterator at("/sys/bus/usb/devices", gone), end; at != end;
         at.increment(gone)) {
        if (line_of(at->path() / "idVendor") + ":" + line_of(at->path() / "idProduct") == usb_id) {
            return true;
        }
    }
    std::string name = ":" + usb_id + ".";  // 0003:2833:0021.0001
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
    for (fs::directory_iterator at("/sys/bus/hid/devices", gone), end; at != end;
         at.increment(gone)) {
        if (at->path().filename().string().find(name) != std::string::npos) return true;
    }
    return false;
}

class Exposed {
  public:
    /// Returns once the kernel has taken the device. With `record` as a file's name the bytes that
    /// went over are there after `stop`.
    explicit Exposed(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {FOVERIG_PROGRAM, "expose"});
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        int ends[2] = {-1, -1};
        EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
        pid_ = ::fork();
        if (pid_ == 0) {
            ::dup2(ends[1], STDOUT_FILENO);
            ::execv(argv[0], argv.data());
            ::_exit(127);
        }
        ::close(ends[1]);
        out_ = ends[0];
        read_until('\n');
        EXPECT_NE(said_.find("Ctrl-C"), std::string::npos) << "foverig expose: " << said_;
    }
    Exposed(Exposed&& other) noexcept
        : pid_(std::exchange(other.pid_, -1)),
          out_(std::exchange(other.out_, -1)),
          said_(std::move(other.said_)) {}
    ~Exposed() {
        if (pid_ > 0) stop(SIGKILL);
        if (out_ >= 0) ::close(out_);
    }

    /// The exit code, or minus the signal. The kernel takes a device's nodes away some time after
    /// its program's end: returns when they are gone, or the next test would find them.
    int stop(int signal = SIGINT) {
        ::kill(pid_, signal);
        read_until('\0');
        int status = 0;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        const std::string id = usb_id();
        constexpr int kTries = 12'000;  // ten minutes of the virtual machine's, whose clock leaps
        int tries = 0;
        while (kernel_has(id) && ++tries < kTries) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        EXPECT_LT(tries, kTries) << "the kernel keeps " << id << ", whose program has ended";
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    const std::string& said() const { return said_; }

  private:
    /// From its first line: "dk2 is a device of this machine's kernel, 2833:0021 through usbip".
    std::string usb_id() const {
        std::smatch id;
        const bool found = std::regex_search(said_, id, std::regex("[0-9a-f]{4}:[0-9a-f]{4}"));
        EXPECT_TRUE(found) << said_;
        return found ? id.str() : "";
    }
    void read_until(char last) {
        for (char c = 0; ::read(out_, &c, 1) == 1;) {
            said_ += c;
            if (c == last) return;
        }
    }

    pid_t pid_ = -1;
    int out_ = -1;
    std::string said_;
};

/// A file name in the virtual machine's memory.
inline std::string fresh_file(const std::string& name) {
    const std::string file = "/dev/shm/" + name;
    std::filesystem::remove(file);
    return file;
}

}  // namespace foverig::test
