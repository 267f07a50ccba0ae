// Recordings of ROS 2 in SQLite (.db3), as rosbag2_storage_sqlite3 writes them.
#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "bag_reader.h"

struct sqlite3;
struct sqlite3_stmt;

namespace ariadne::io::ros {

class SqliteBag : public BagReader {
 public:
  /// Throws core::Error when it cannot be opened, BagDamage when it is no recording.
  explicit SqliteBag(const std::filesystem::path& path);

  std::optional<BagMessage> next() override;
  std::string_view payload() override;
  double fraction() const override;
  std::string place() const override;

 private:
  using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;
  using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;
  void requireTable(const char* name);
  Statement prepare(const char* query);
  bool step(Statement& statement);

  Database database_;
  Statement messages_;  ///< all but their data
  Statement payload_;   ///< the data of one
  std::map<std::int64_t, BagTopic> topics_;
  std::int64_t row_ = 0;
  std::int64_t last_row_ = 0;
};

}  // namespace ariadne::io::ros
