#pragma once
// A desktop without a screen, for as long as a test lives: DISPLAY names it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

namespace foverig::test {

class Xvfb {
  public:
    /// `screen`: WIDTHxHEIGHTxDEPTH. The server chooses a display number that is free.
    explicit Xvfb(const char* screen = "1920x1080x24") {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
        server_ = fork();
        if (server_ == 0) {
            constexpr int kToParent = 3;
            if (ends[1] == kToParent)
                (void)fcntl(kToParent, F_SETFD, 0);
            else
                (void)dup2(ends[1], kToParent);
            const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
            (void)dup2(nothing, STDOUT_FILENO);
            (void)dup2(nothing, STDERR_FILENO);
            (void)prctl(PR_SET_PDEATHSIG, SIGTERM);  // whatever becomes of the test
            execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", screen, "-nolisten", "tcp",
                   "-noreset", nullptr);
            _exit(127);
        }
        (void)close(ends[1]);
        std::string number;
        char digit = 0;
        while (read(ends[0], &digit, 1) == 1 && digit != '\n') number += digit;
        (void)close(ends[0]);
        if (number.empty()) return;
        ready_ = true;
        (void)setenv("DISPLAY", (":" + number).c_str(), 1);
    }
    ~Xvfb() {
        if (server_ > 0) {
            (void)kill(server_, SIGTERM);
            (void)waitpid(server_, nullptr, 0);
        }
        (void)unsetenv("DISPLAY");
    }
    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;

    bool ready() const { return ready_; }

  private:
    pid_t server_ = -1;
    bool ready_ = false;
};

/// Each test has a desktop of its own.
class OnADesktop : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(desktop_.ready()) << "Xvfb does not start; scripts/install brings it";
    }
    Xvfb desktop_;
};

}  // namespace foverig::test
