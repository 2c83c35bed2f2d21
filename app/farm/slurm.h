#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cydonia::slurm {

// Slurm's own programs, started without a shell. All throw failure(), which names the
// package to install if a program is missing, or quotes what the program said.

// Submits a script, which starts when the jobs `after` have succeeded; returns its job
// id. Logs go to `folder`.
std::string submit(const std::filesystem::path& script,
                   const std::filesystem::path& folder,
                   const std::vector<std::string>& after);
void cancel(const std::vector<std::string>& jobs);

// A job, or a task of an array, as the queue shows it.
struct Task {
    std::string job;     // "12", "13_4", "13_[5-9]"
    std::string state;   // "PENDING", "RUNNING", "FAILED" ...
    std::string node;    // empty until it runs
    std::string reason;  // why it waits

    bool of(const std::string& id) const;
    bool is_queued() const;  // waits or runs
    bool has_failed() const;
};

// Tasks that the queue still shows; those that have ended leave it after some minutes.
std::vector<Task> tasks_of(const std::vector<std::string>& jobs);

}  // namespace cydonia::slurm
