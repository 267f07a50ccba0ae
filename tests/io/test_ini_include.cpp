// INIs that include others.
#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

using namespace ariadne;

namespace {

class IniIncludes : public TemporaryFolder {
 protected:
  void write(const char* name, const std::string& text) { io::writeWhole(folder / name, text); }
  std::string read(const char* name) const {
    const auto file = folder / name;
    std::string all;
    for (const auto& e : io::parseIniFile(io::readIniText(file), file).entries)
      all += e.section + "." + e.key + "=" + e.value + " ";
    return all;
  }
  std::string problemOf(const char* name) const {
    try {
      read(name);
    } catch (const core::UsageError& e) {
      return e.what();
    }
    return "";
  }
};

}  // namespace

TEST_F(IniIncludes, ItsOwnSettingsComeLastAndCount) {
  write("base.ini", "[a]\nx = 1\ny = 2\n[b]\nz = 3\n");
  write("own.ini", "# about\ninclude = base.ini  # the rest\n[a]\nx = 7\n[c]\nv = 4\n");
  EXPECT_EQ(read("own.ini"), "a.y=2 b.z=3 a.x=7 c.v=4 ");
  write("third.ini", "include = \"own.ini\"\n");
  EXPECT_EQ(read("third.ini"), read("own.ini"));
}

TEST_F(IniIncludes, OfSeveralTheLaterCounts) {
  write("a.ini", "[a]\nx = 1\ny = 2\n");
  write("b.ini", "[a]\ny = 3\nz = 4\n");
  write("own.ini", "include = a.ini\ninclude = b.ini\n[a]\nz = 5\n");
  EXPECT_EQ(read("own.ini"), "a.x=1 a.y=3 a.z=5 ");
}

TEST_F(IniIncludes, FromTheFolderOfTheIncludingOne) {
  std::filesystem::create_directories(folder / "inner");
  write("base.ini", "[a]\nx = 1\n");
  write("inner/own.ini", "include = ../base.ini\n");
  EXPECT_EQ(read("inner/own.ini"), "a.x=1 ");
}

TEST_F(IniIncludes, PlacesOfErrorsAreThoseOfTheFileThatHasThem) {
  write("base.ini", "\n[a]\nx = 1\n");
  write("own.ini", "include = base.ini\n");
  const auto document = io::parseIniFile(io::readIniText(folder / "own.ini"), folder / "own.ini");
  EXPECT_EQ(document.entries.at(0).where, (folder / "base.ini").string() + ":3");
  EXPECT_EQ(document.name, (folder / "own.ini").string());
}

TEST_F(IniIncludes, SaysWhatIsWrong) {
  const std::string own = (folder / "own.ini").string();
  write("own.ini", "include = none.ini\n");
  EXPECT_EQ(problemOf("own.ini").find(own + ":1: include = none.ini: cannot read "), 0U)
      << problemOf("own.ini");
  write("own.ini", "include = own.ini\n");
  EXPECT_NE(problemOf("own.ini").find("does it go in a circle?"), std::string::npos);
  write("own.ini", "include =\n");
  EXPECT_EQ(problemOf("own.ini"), own + ":1: include takes the name of an INI");
  write("own.ini", "[a]\ninclude = a.ini\n");
  EXPECT_EQ(read("own.ini"), "a.include=a.ini ") << "within a section it is a key as any other";
}
