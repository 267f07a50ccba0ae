#include "ariadne/batch/claims.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "owner.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

double modified_s(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return -1e18;
  return static_cast<double>(status.st_mtim.tv_sec) +
         1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

[[noreturn]] void fail(const fs::path& file) {
  throw core::Error(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

/// The content comes a moment later, which matters where hard links cannot be had only.
bool createAlone(const fs::path& file, const std::string& content) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd < 0 && errno != EEXIST) fail(file);
  if (fd < 0) return false;
  const bool written =
      ::write(fd, content.data(), content.size()) == static_cast<ssize_t>(content.size());
  if (::close(fd) != 0 || !written) fail(file);
  return true;
}

}  // namespace

Claims::Claims(fs::path folder, std::chrono::seconds patience)
    : folder_(std::move(folder)), patience_(patience), host_(machineName()) {
  owner_ = host_ + "-" + io::writerMark();
  std::error_code error;
  fs::create_directories(folder_ / "owners", error);
  fs::remove(ownerFile(owner_), error);
  createAlone(ownerFile(owner_), owner_);
  refreshed_ = std::chrono::steady_clock::now();
}

Claims::~Claims() {
  std::error_code ignored;
  for (const auto& [key, number] : own_) fs::remove(claimFile(key, number), ignored);
  fs::remove(ownerFile(owner_), ignored);
}

fs::path Claims::ownerFile(const std::string& owner) const { return folder_ / "owners" / owner; }

fs::path Claims::claimFile(const std::string& key, int number) const {
  return folder_ / fmt::format("{}.{}", key, number);
}

bool Claims::isHere(const std::string& owner) const { return partsOf(owner).host == host_; }

double Claims::silence_s(const std::string& owner) const {
  // Now by the clock that stamps the files: a machine's own may be minutes off.
  const fs::path own = ownerFile(owner_);
  ::utimensat(AT_FDCWD, own.c_str(), nullptr, 0);
  return modified_s(own) - modified_s(ownerFile(owner));
}

bool Claims::isAlive(const std::string& owner) const {
  if (isHere(owner)) {
    const OwnerParts parts = partsOf(owner);
    return io::startOf(parts.pid) == parts.start;
  }
  return silence_s(owner) < static_cast<double>(patience_.count());
}

bool Claims::isLongDead(const std::string& owner) const {
  return isHere(owner) ? !isAlive(owner) : silence_s(owner) > 86400;
}

bool Claims::take(const std::string& key) {
  for (int number = 1;; ++number) {
    const fs::path file = claimFile(key, number);
    bool taken = ::link(ownerFile(owner_).c_str(), file.c_str()) == 0;
    if (!taken && errno != EEXIST) taken = createAlone(file, owner_);
    if (taken) {
      own_[key] = number;
      return true;
    }
    std::string other;
    try {
      other = io::readWhole(file);
    } catch (const core::Error&) {
      return false;  // given back just now
    }
    if (other == owner_ || other.empty() || isAlive(other)) return false;
  }
}

void Claims::giveBack(const std::string& key, bool done) {
  const auto found = own_.find(key);
  if (found == own_.end()) return;
  std::error_code ignored;
  // Older claims of dead owners go only when nobody can come to claim the run any more.
  for (int n = found->second; n >= (done ? 1 : found->second); --n)
    fs::remove(claimFile(key, n), ignored);
  own_.erase(found);
}

void Claims::refresh() {
  const auto now = std::chrono::steady_clock::now();
  if (now - refreshed_ < std::chrono::seconds(10)) return;
  refreshed_ = now;
  ::utimensat(AT_FDCWD, ownerFile(owner_).c_str(), nullptr, 0);
}

}  // namespace ariadne::batch
