#include "sqlite_bag.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>

#include "ariadne/core/error.h"

namespace ariadne::io::ros {
namespace {

constexpr int kLargestValue = 1 << 28;
constexpr std::size_t kMostTopics = 100'000;

std::string textOf(sqlite3_stmt* row, int column) {
  const auto* text = sqlite3_column_text(row, column);
  const int size = sqlite3_column_bytes(row, column);
  return text == nullptr
             ? ""
             : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
}

sqlite3* openDatabase(const std::filesystem::path& path) {
  sqlite3* made = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &made, SQLITE_OPEN_READONLY, nullptr);
  if (code != SQLITE_OK) {
    const std::string why = made == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(made);
    sqlite3_close(made);
    throw core::Error(fmt::format("cannot read {}: {}", path.string(), why));
  }
  return made;
}

}  // namespace

SqliteBag::SqliteBag(const std::filesystem::path& path)
    : database_(openDatabase(path), sqlite3_close),
      messages_(nullptr, sqlite3_finalize),
      payload_(nullptr, sqlite3_finalize) {
  // The file's own SQL (views, triggers) is not run, and what it claims is checked.
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(database_.get(), SQLITE_LIMIT_LENGTH, kLargestValue);
  requireTable("topics");
  requireTable("messages");
  Statement topics = prepare("SELECT id, name, type, serialization_format FROM topics");
  while (step(topics) && topics_.size() < kMostTopics)
    topics_.emplace(
        sqlite3_column_int64(topics.get(), 0),
        BagTopic{textOf(topics.get(), 1), textOf(topics.get(), 2), textOf(topics.get(), 3)});
  Statement last = prepare("SELECT max(id) FROM messages");
  if (step(last)) last_row_ = sqlite3_column_int64(last.get(), 0);
  messages_ = prepare("SELECT id, topic_id, timestamp FROM messages ORDER BY id");
  payload_ = prepare("SELECT data FROM messages WHERE id = ?1");
}

void SqliteBag::requireTable(const char* name) {
  Statement found = prepare("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?1");
  sqlite3_bind_text(found.get(), 1, name, -1, SQLITE_STATIC);
  if (!step(found))
    throw BagDamage(fmt::format("an SQLite database without a table '{}': no ROS 2 bag", name));
}

SqliteBag::Statement SqliteBag::prepare(const char* query) {
  sqlite3_stmt* made = nullptr;
  if (sqlite3_prepare_v2(database_.get(), query, -1, &made, nullptr) != SQLITE_OK)
    throw BagDamage(sqlite3_errmsg(database_.get()));
  return {made, sqlite3_finalize};
}

bool SqliteBag::step(Statement& statement) {
  const int code = sqlite3_step(statement.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  throw BagDamage(sqlite3_errmsg(database_.get()));
}

std::optional<BagMessage> SqliteBag::next() {
  if (!step(messages_)) {
    row_ = last_row_;
    return std::nullopt;
  }
  row_ = sqlite3_column_int64(messages_.get(), 0);
  const std::int64_t topic = sqlite3_column_int64(messages_.get(), 1);
  const auto found = topics_.find(topic);
  if (found == topics_.end())
    throw BagDamage(fmt::format("a message of topic {}, which is nowhere described", topic));
  return BagMessage{&found->second, sqlite3_column_int64(messages_.get(), 2)};
}

/// By a query of its own, so that SQLite passes over messages that nobody wants.
std::string_view SqliteBag::payload() {
  sqlite3_reset(payload_.get());
  sqlite3_bind_int64(payload_.get(), 1, row_);
  if (!step(payload_)) throw BagDamage("a message has no data");
  const void* bytes = sqlite3_column_blob(payload_.get(), 0);
  const int size = sqlite3_column_bytes(payload_.get(), 0);
  if (bytes == nullptr) return {};
  return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

double SqliteBag::fraction() const {
  if (last_row_ <= 0) return 1;
  return std::clamp(static_cast<double>(row_) / static_cast<double>(last_row_), 0.0, 1.0);
}

std::string SqliteBag::place() const { return fmt::format("the message after {}", row_); }

}  // namespace ariadne::io::ros
