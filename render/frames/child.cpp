#include "render/frames/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include "field/error.h"

namespace cydonia::render {
namespace {

constexpr std::chrono::milliseconds kPatience{
    100};  // longest wait before Ctrl-C takes effect
constexpr std::size_t kLongestLine = 64u << 10;

// Between fork and exec, where only async-signal-safe calls are allowed.
[[noreturn]] void become(char* const* command, const char* folder, int output,
                         pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(Child::kCannotStart);  // the parent died before prctl()

    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);

    const int nothing = open("/dev/null", O_RDONLY);
    const bool ready = nothing >= 0 && dup2(nothing, STDIN_FILENO) >= 0 &&
                       dup2(output, STDOUT_FILENO) >= 0 &&
                       dup2(output, STDERR_FILENO) >= 0 && chdir(folder) == 0;
    if (ready) {
        close_range(3, ~0u, CLOSE_RANGE_CLOEXEC);  // files that libraries left open
        execv(command[0], command);
    }
    _exit(Child::kCannotStart);
}

}  // namespace

Child::Child(const std::filesystem::path& program,
             const std::vector<std::string>& arguments,
             const std::filesystem::path& folder) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> command;
    for (std::string& word : words) command.push_back(word.data());
    command.push_back(nullptr);

    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw failure("cannot start {}: {}", program.string(), std::strerror(errno));
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) become(command.data(), folder.c_str(), ends[1], parent);
    const int error = errno;
    close(ends[1]);
    output_ = ends[0];
    if (process_ < 0) {
        close(output_);
        throw failure("cannot start {}: {}", program.string(), std::strerror(error));
    }
    setpgid(process_, process_);  // parent and child both set it: either may run first
    fcntl(output_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
    if (!ended_) {
        kill(-process_, SIGKILL);
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    }
    close(output_);
}

// Kills what the program left running while its process number is still reserved.
bool Child::has_ended() {
    siginfo_t info{};
    const int error =
        waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    if (error == 0 && info.si_pid == 0) return false;
    kill(-process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    if (error != 0)
        outcome_ = 1;  // SIGCHLD is ignored, so the exit code is lost
    else
        outcome_ = info.si_code == CLD_EXITED ? info.si_status : -info.si_status;
    return true;
}

void Child::read_what_is_there(std::string& output) {
    char block[1 << 14];
    ssize_t count;
    while ((count = ::read(output_, block, sizeof block)) > 0)
        output.append(block, static_cast<std::size_t>(count));
    if (count == 0) all_read_ = true;
}

bool Child::read(std::string& output, std::chrono::milliseconds patience) {
    if (ended_) return false;
    if (all_read_) {  // the pipe is closed: poll() would return at once
        std::this_thread::sleep_for(patience);
    } else {
        pollfd wait{output_, POLLIN, 0};
        poll(&wait, 1, static_cast<int>(patience.count()));
    }
    ended_ = has_ended();  // asked before reading, so that the last output is not missed
    read_what_is_there(output);
    return !ended_;
}

std::optional<int> outcome_of(const std::filesystem::path& program,
                              const std::vector<std::string>& arguments,
                              const std::filesystem::path& folder,
                              std::chrono::seconds time_limit,
                              const std::function<void(std::string& output)>& listen) {
    const auto deadline = std::chrono::steady_clock::now() + time_limit;
    Child child(program, arguments, folder);
    std::string output;
    while (child.read(output, kPatience)) {
        listen(output);
        if (std::chrono::steady_clock::now() > deadline) return std::nullopt;
    }
    if (!output.empty()) output += '\n';  // ends a last line without a new line
    listen(output);
    return child.outcome();
}

void take_lines(std::string& output, const std::function<void(std::string_view)>& take) {
    std::size_t begin = 0;
    for (auto end = output.find_first_of("\r\n"); end != output.npos;
         end = output.find_first_of("\r\n", begin)) {
        take(std::string_view(output).substr(begin, end - begin));
        begin = end + 1;
    }
    output.erase(0, begin);
    if (output.size() > kLongestLine) output.clear();
}

}  // namespace cydonia::render
