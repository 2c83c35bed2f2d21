#include "app/pipeline/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "field/error.h"
#include "field/files.h"

namespace cydonia {

OutputFolder::OutputFolder(const std::filesystem::path& path, Claim claim) : path_(path) {
    make_folder(path / ".cache");
    // Writing a few bytes finds a full or read-only file system now, not after hours.
    write_text(path / ".cache" / "README",
               "Finished steps of Cydonia; may be deleted.\n");

    const std::string lock = (path / ".cache" / "lock").string();
    lock_ = open(lock.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock_ < 0) throw failure("{}: {}", lock, std::strerror(errno));
    if (flock(lock_, (claim == Claim::kShared ? LOCK_SH : LOCK_EX) | LOCK_NB) != 0) {
        close(lock_);
        throw failure("{}: another cydonia is at work in this folder", path.string());
    }
}

OutputFolder::~OutputFolder() { close(lock_); }

void OutputFolder::belongs_to(const std::string& scene) const {
    const std::filesystem::path file = path_ / ".cache" / "scene";
    std::error_code none;
    const std::string owner = std::filesystem::exists(file, none) ? read_text(file) : "";
    if (!owner.ends_with('\n'))
        return write_text(file, scene + "\n");  // there is none, or it is damaged
    if (owner != scene + "\n")
        throw bad_request(
            "{} holds the scene '{}'; name another folder with -o, or remove it",
            path_.string(), owner.substr(0, owner.find('\n')));
}

}  // namespace cydonia
