// Who does which run, as files in a folder that several processes and machines may share. A claim
// is a hard link of its owner's file, so it appears with its content or not at all, also on NFS. A
// dead owner's claim is not deleted but outdone by the next number, so that two that find it dead
// cannot both win.
#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <string>

namespace ariadne::batch {

/// Hard links in a folder that say which runs are somebody's: several runners and machines share
/// the work without a daemon.
class Claims {
 public:
  /// An owner on another machine is taken for dead when it gave no sign of life for `patience`.
  explicit Claims(std::filesystem::path folder,
                  std::chrono::seconds patience = std::chrono::seconds(180));
  /// Gives back what is still claimed.
  ~Claims();
  Claims(const Claims&) = delete;
  Claims& operator=(const Claims&) = delete;

  /// "node7.3fa2c1-1234-567": machine, process and when it was started.
  const std::string& owner() const { return owner_; }
  /// Whether the run is ours now; false when a live owner has it. Throws core::Error.
  bool take(const std::string& key);
  /// @param done its result is stored: nobody will ask for it again
  void giveBack(const std::string& key, bool done);
  /// A sign of life, every ten seconds; to be called more often than that.
  void refresh();
  /// Calls f(owner) for each that is dead here, or anywhere for a day, then forgets it.
  template <class F>
  void buryDead(F&& f) {
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "owners")) {
      const std::string name = entry.path().filename().string();
      if (!isLongDead(name)) continue;
      f(name);
      std::error_code ignored;
      std::filesystem::remove(entry.path(), ignored);
    }
  }

 private:
  std::filesystem::path ownerFile(const std::string& owner) const;
  std::filesystem::path claimFile(const std::string& key, int number) const;
  bool isHere(const std::string& owner) const;
  double silence_s(const std::string& owner) const;
  bool isAlive(const std::string& owner) const;
  bool isLongDead(const std::string& owner) const;

  std::filesystem::path folder_;
  std::chrono::seconds patience_;
  std::string host_;
  std::string owner_;
  std::chrono::steady_clock::time_point refreshed_;
  std::map<std::string, int> own_;  ///< number of each claim
};

/// Of this machine, as claims name it.
std::string hostName();

/// The host's name and what tells it from others of that name, and its containers from each other:
/// process numbers mean something only where this is the same.
std::string machineName();

}  // namespace ariadne::batch
