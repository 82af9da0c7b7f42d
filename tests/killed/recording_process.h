#pragma once
// `foverig record` as a program of its own, started by a person at a terminal.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace foverig::test {

/// What a child said on its terminal; the child ends with this.
class ProcessAtTerminal {
  public:
    explicit ProcessAtTerminal(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), FOVERIG_PROGRAM);
        std::vector<char*> argv;
        for (std::string& argument : arguments) argv.push_back(argument.data());
        argv.push_back(nullptr);
        pid_ = ::forkpty(&terminal_, nullptr, nullptr, nullptr);
        if (pid_ == 0) {
            ::execv(argv[0], argv.data());
            ::_exit(127);
        }
    }
    ~ProcessAtTerminal() {
        if (pid_ > 0) end(SIGKILL);
        ::close(terminal_);
    }
    ProcessAtTerminal(const ProcessAtTerminal&) = delete;
    ProcessAtTerminal& operator=(const ProcessAtTerminal&) = delete;

    /// False: it said no more, and ended.
    bool read_more() {
        char bytes[4096];
        const ssize_t count = ::read(terminal_, bytes, sizeof bytes);
        if (count > 0) said_.append(bytes, static_cast<std::size_t>(count));
        return count > 0;
    }
    /// The exit code, or minus the signal. What it said until then is read.
    int end(int signal = 0) {
        if (signal != 0) ::kill(pid_, signal);
        while (read_more()) {
        }
        int status = 0;
        ::waitpid(std::exchange(pid_, -1), &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    const std::string& said() const { return said_; }

  private:
    pid_t pid_ = -1;
    int terminal_ = -1;
    std::string said_;
};

class RecordingProcess {
  public:
    explicit RecordingProcess(const std::string& file)
        : process_({"record", "--clock", "wall", "--seconds", "600", "--out", file}) {}

    /// Until what time of the recording everything had been given to the recorder, as it said last.
    double produced_s() const {
        constexpr const char* kWord = "recorded ";
        const std::string& said = process_.said();
        // The newest may be cut: a whole one has its unit.
        for (auto at = said.rfind(kWord); at != std::string::npos && at > 0;
             at = said.rfind(kWord, at - 1)) {
            if (said.find(" s ", at) != std::string::npos)
                return std::strtod(said.c_str() + at + std::char_traits<char>::length(kWord),
                                   nullptr);
        }
        return 0.0;
    }
    bool wait_until_produced(double seconds) {
        while (produced_s() < seconds) {
            if (!process_.read_more()) return false;
        }
        return true;
    }
    int kill() { return process_.end(SIGKILL); }
    const std::string& said() const { return process_.said(); }

  private:
    ProcessAtTerminal process_;
};

}  // namespace foverig::test
