#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cydonia::slurm {

// Slurm's own programs, started without a shell. All throw failure(): with the package to
// install where a program is not there, with its own words where it refuses.

// Hands in a script, to begin when the jobs `after` are done well; gives the job's id.
// Logs go below `folder`.
std::string submit(const std::filesystem::path& script,
                   const std::filesystem::path& folder,
                   const std::vector<std::string>& after);
void cancel(const std::vector<std::string>& jobs);

// A job, or a task of an array, as the queue shows it.
struct Task {
    std::string job;     // "12", "13_4", "13_[5-9]"
    std::string state;   // "PENDING", "RUNNING", "FAILED" ...
    std::string node;    // empty: none yet
    std::string reason;  // why it waits

    bool of(const std::string& id) const;
    bool is_queued() const;  // waits or runs
    bool has_failed() const;
};

// Those the queue still knows: ended ones leave it after some minutes.
std::vector<Task> tasks_of(const std::vector<std::string>& jobs);

}  // namespace cydonia::slurm
