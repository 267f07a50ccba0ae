#include <sys/wait.h>
#include <unistd.h>

#include "ariadne/batch/claims.h"
#include "stand_in.h"

using ariadne::batch::Claims;
namespace fs = std::filesystem;

namespace {

class Claiming : public TemporaryFolder {
 protected:
  /// A claim by an owner of that name.
  void claimAs(const std::string& owner, const std::string& key, int number) {
    fs::create_directories(folder / "owners");
    ariadne::io::writeWhole(folder / "owners" / owner, owner);
    ariadne::io::writeWhole(folder / (key + "." + std::to_string(number)), owner);
  }
  void makeOld(const std::string& owner, std::chrono::seconds age) {
    fs::last_write_time(folder / "owners" / owner, fs::file_time_type::clock::now() - age);
  }
};

}  // namespace

TEST_F(Claiming, OneIsTakenOnce) {
  Claims claims(folder);
  EXPECT_TRUE(claims.take("a"));
  EXPECT_FALSE(claims.take("a"));
  claims.giveBack("a", false);
  EXPECT_TRUE(claims.take("a"));
  claims.giveBack("a", true);
  EXPECT_FALSE(fs::exists(folder / "a.1"));
}

TEST_F(Claiming, OfProcessesAtOnceOneWins) {
  constexpr int kProcesses = 8;
  int ready[2], asked[2], give_back[2];
  ASSERT_EQ(::pipe(ready), 0);
  ASSERT_EQ(::pipe(asked), 0);
  ASSERT_EQ(::pipe(give_back), 0);
  for (int i = 0; i < kProcesses; ++i)
    if (::fork() == 0) {
      int won = 0;
      {
        Claims claims(folder);
        char go = 0;
        if (::read(ready[0], &go, 1) != 1) ::_exit(100);
        for (int key = 0; key < 20; ++key) won += claims.take(std::to_string(key)) ? 1 : 0;
        // All have asked before one gives back.
        if (::write(asked[1], "a", 1) != 1 || ::read(give_back[0], &go, 1) != 1) ::_exit(100);
      }
      ::_exit(won);
    }
  ::usleep(100000);
  ASSERT_EQ(::write(ready[1], "goooooooo", kProcesses), kProcesses);
  ::close(asked[1]);  // so that reading ends should a process die
  int count = 0;
  for (char one = 0; count < kProcesses && ::read(asked[0], &one, 1) == 1;) ++count;
  ASSERT_EQ(::write(give_back[1], "gggggggg", kProcesses), kProcesses);
  EXPECT_EQ(count, kProcesses);
  int won = 0;
  for (int i = 0; i < kProcesses; ++i) {
    int status = 0;
    ::wait(&status);
    won += WEXITSTATUS(status);
  }
  EXPECT_EQ(won, 20);
}

TEST_F(Claiming, TheDeadAreOutdone) {
  Claims claims(folder);
  claimAs(ariadne::batch::machineName() + "-1-99", "a",
          1);  // process 1 was started at another time
  EXPECT_TRUE(claims.take("a"));
  EXPECT_TRUE(fs::exists(folder / "a.2"));
  claims.giveBack("a", true);
  EXPECT_FALSE(fs::exists(folder / "a.1"));
  EXPECT_FALSE(fs::exists(folder / "a.2"));
}

TEST_F(Claiming, OnOtherMachinesSilenceIsDeath) {
  Claims claims(folder);
  claimAs("elsewhere-77-99", "a", 1);
  EXPECT_FALSE(claims.take("a"));
  makeOld("elsewhere-77-99", std::chrono::seconds(100));
  EXPECT_FALSE(claims.take("a"));
  makeOld("elsewhere-77-99", std::chrono::seconds(200));
  EXPECT_TRUE(claims.take("a"));
}

TEST_F(Claiming, TheDeadAreBuriedOnce) {
  Claims claims(folder);
  const std::string here = ariadne::batch::machineName() + "-1-99";
  claimAs(here, "a", 1);
  claimAs("elsewhere-77-99", "b", 1);
  std::vector<std::string> buried;
  claims.buryDead([&](const std::string& owner) { buried.push_back(owner); });
  EXPECT_EQ(buried, std::vector<std::string>{here});
  claims.buryDead([&](const std::string& owner) { buried.push_back(owner); });
  EXPECT_EQ(buried.size(), 1U);
}
