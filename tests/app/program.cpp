#include "tests/app/program.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace fs = std::filesystem;

namespace cydonia::test {
namespace {

std::string contents(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

// In the child: never returns.
[[noreturn]] void become(const Start& start, const std::vector<std::string>& arguments,
                         const fs::path& out, const fs::path& err) {
    if (chdir(start.folder.c_str()) != 0) _exit(126);
    if (!freopen("/dev/null", "r", stdin) || !freopen(out.c_str(), "w", stdout) ||
        !freopen(err.c_str(), "w", stderr)) {
        _exit(126);
    }
    for (const auto& [name, value] : start.environment) {
        setenv(name.c_str(), value.c_str(), 1);
    }
    if (start.max_memory > 0) {
        const rlimit limit{start.max_memory, start.max_memory};
        setrlimit(RLIMIT_AS, &limit);
    }
    std::vector<char*> argv;
    std::string program = CYDONIA_PROGRAM;
    argv.push_back(program.data());
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "cydonia-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code none;
    fs::remove_all(path_, none);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

fs::path TemporaryFolder::write_script(const std::string& name,
                                       const std::string& body) const {
    const fs::path file = write(name, "#!/bin/sh\n" + body + "\n");
    fs::permissions(file, fs::perms::owner_all);
    return file;
}

Outcome run(const Start& start, const std::vector<std::string>& arguments) {
    return run_and_signal(start, arguments, 0, [] { return true; });
}

Outcome run_and_signal(const Start& start, const std::vector<std::string>& arguments,
                       int signal, const std::function<bool()>& when) {
    const TemporaryFolder texts;
    const pid_t child = fork();
    if (child == 0) become(start, arguments, texts / "out", texts / "err");

    int status = 0;
    bool sent = signal == 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (!sent && when()) {
            kill(child, signal);
            sent = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_TRUE(sent) << "the program ended before the signal was sent";
    Outcome outcome;
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    outcome.out = contents(texts / "out");
    outcome.err = contents(texts / "err");
    return outcome;
}

std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files;
    if (!fs::exists(folder)) return files;
    // A program at work may take files away while they are listed.
    std::error_code gone;
    for (fs::recursive_directory_iterator at(folder, gone), end; !gone && at != end;
         at.increment(gone)) {
        std::error_code none;
        if (at->is_regular_file(none))
            files.push_back(at->path().lexically_relative(folder).generic_string());
    }
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> temporary_files(const fs::path& folder) {
    std::vector<std::string> files = files_below(folder);
    std::erase_if(files, [](const std::string& file) {
        const std::string name = fs::path(file).filename();
        return name.find(".tmp") == std::string::npos &&
               name.find(".part.") == std::string::npos && !name.ends_with(".pov-state");
    });
    return files;
}

}  // namespace cydonia::test
