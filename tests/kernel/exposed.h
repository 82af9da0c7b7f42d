#pragma once
// `foverig expose ...` as a program of its own beside the test, as a person runs it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace foverig::test {

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

    /// The exit code, or minus the signal.
    int stop(int signal = SIGINT) {
        ::kill(pid_, signal);
        read_until('\0');
        int status = 0;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    const std::string& said() const { return said_; }

  private:
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
