#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace foverig::test {

/// Another process that has a file open: sleep(1), which inherits it.
class OtherProgram {
  public:
    explicit OtherProgram(const std::string& path) {
        const int file = ::open(path.c_str(), O_RDWR);
        EXPECT_GE(file, 0) << path;
        std::string name = "sleep", seconds = "60";
        char* arguments[] = {name.data(), seconds.data(), nullptr};
        EXPECT_EQ(posix_spawnp(&pid_, "sleep", nullptr, nullptr, arguments, environ), 0);
        ::close(file);
    }
    ~OtherProgram() {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

    int pid() const { return pid_; }

  private:
    pid_t pid_ = 0;
};

}  // namespace foverig::test
