#include "rawlog_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "rawlog_versions.h"

namespace ariadne::io {
namespace {

constexpr unsigned char kEndFlag = 0x88;
constexpr std::size_t kLongestName = 120;
constexpr std::size_t kLongestHeader = 4 + kLongestName + 4;
constexpr std::size_t kLongestText = 1 << 16;

struct ParsedHeader {
  std::string_view name;
  bool old_format = false;
  std::size_t size = 0;  ///< bytes, without the version
};

bool isName(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == ':' || c == '<' || c == '>';
  });
}

/// New: 0x80 | length, name. Old: length as a 32 bit number, name.
std::optional<ParsedHeader> parseHeader(std::string_view bytes) {
  if (bytes.empty()) return std::nullopt;
  const auto first = static_cast<unsigned char>(bytes[0]);
  ParsedHeader header;
  header.old_format = (first & 0x80) == 0;
  const std::size_t length = first & 0x7f;
  const std::size_t begin = header.old_format ? 4 : 1;
  if (length == 0 || length > kLongestName || bytes.size() < begin + length) return std::nullopt;
  if (header.old_format && (bytes[1] != 0 || bytes[2] != 0 || bytes[3] != 0)) return std::nullopt;
  header.name = bytes.substr(begin, length);
  header.size = begin + length;
  if (!isName(header.name)) return std::nullopt;
  return header;
}

/// Today's name of a class, without namespace.
std::string_view className(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  if (colon != name.npos) name = name.substr(colon + 1);
  if (name == "CSensorialFrame") return "CSensoryFrame";
  return name == "CMatrix" ? "CMatrixF" : name;
}

bool isEntry(std::string_view name) {
  const auto begins = [&](std::string_view prefix) {
    return name.substr(0, prefix.size()) == prefix;
  };
  return begins("CObservation") || begins("CAction") || name == "CSensoryFrame";
}

/// Where in `bytes` a header of an entry begins, looking at class names from `from` on.
std::optional<std::size_t> findEntry(std::string_view bytes, std::size_t from) {
  constexpr std::array<std::size_t, 2> kNamespaces = {0, std::string_view("mrpt::obs::").size()};
  for (std::size_t at = bytes.find('C', from); at != bytes.npos; at = bytes.find('C', at + 1)) {
    const char next = at + 1 < bytes.size() ? bytes[at + 1] : ' ';
    if (next != 'O' && next != 'A' && next != 'S') continue;
    for (const std::size_t space : kNamespaces)
      for (const std::size_t lead : {std::size_t{1}, std::size_t{4}}) {
        if (at < space + lead) continue;
        const std::size_t begin = at - space - lead;
        const auto header = parseHeader(bytes.substr(begin));
        if (header && header->old_format == (lead == 4) && header->name.size() > space &&
            isEntry(className(header->name)))
          return begin;
      }
  }
  return std::nullopt;
}

}  // namespace

void requireVersion(const ObjectHeader& object) {
  const int newest = newestKnown(object.name);
  if (object.version < 0)
    throw ArchiveDamage(fmt::format("{} of version {}", object.name, object.version));
  if (object.version > newest)
    throw NewerVersion(fmt::format(
        "{} of version {} is newer than this program, which knows up to {}, and than the "
        "MRPT installed here",
        object.name, object.version, newest));
}

bool looksLikeArchive(std::string_view beginning) { return parseHeader(beginning).has_value(); }

const char* ArchiveReader::bytes(std::size_t count) {
  const std::string_view here = file_.peek(count);
  if (here.size() < count)
    throw ArchiveDamage(file_.trouble().empty() ? "the file ends early" : file_.trouble());
  file_.skip(count);
  return here.data();
}

std::string ArchiveReader::text() {
  const auto size = number<std::uint32_t>();
  if (size > kLongestText) throw ArchiveDamage(fmt::format("a text claims {} bytes", size));
  return std::string(bytes(size), size);
}

ObjectHeader ArchiveReader::header() {
  const auto parsed = parseHeader(file_.peek(kLongestHeader));
  if (!parsed) {
    if (atEnd()) bytes(1);
    throw ArchiveDamage("no object where one should begin");
  }
  ObjectHeader object{std::string(className(parsed->name)), parsed->old_format, 0};
  file_.skip(parsed->size);
  if (object.name == "nullptr") return object;
  object.version = object.old_format ? number<std::int32_t>() : number<std::uint8_t>();
  return object;
}

ObjectHeader ArchiveReader::header(const char* name) {
  ObjectHeader object = header();
  if (object.name != name)
    throw ArchiveDamage(fmt::format("{} where {} should be", object.name, name));
  requireVersion(object);
  return object;
}

void ArchiveReader::end(const ObjectHeader& object) {
  if (object.old_format) return;
  if (number<std::uint8_t>() != kEndFlag)
    throw ArchiveDamage(fmt::format("{} does not end where it should", object.name));
}

std::string ArchiveReader::nextClass() {
  const auto parsed = parseHeader(file_.peek(kLongestHeader));
  return parsed ? std::string(className(parsed->name)) : "";
}

std::string_view ArchiveReader::beforeNextEntry() {
  constexpr std::size_t kMost = 4 << 20;
  for (std::size_t size = 1 << 16;; size *= 2) {
    const std::string_view here = file_.peek(size);
    if (const auto found = findEntry(here, 0)) return here.substr(0, *found);
    if (here.size() < size || size >= kMost) return here;
  }
}

void ArchiveReader::skipToNextEntry() {
  constexpr std::size_t kWindow = 1 << 16;
  // A header's beginning and end may lie in two windows: what was searched overlaps by one header.
  std::size_t from = 0;
  for (;;) {
    const std::string_view here = file_.peek(kWindow);
    if (const auto found = findEntry(here, from)) return file_.skip(*found);
    if (here.size() < kWindow) {
      const auto last = here.empty() ? 0 : static_cast<unsigned char>(here.back());
      file_.skip(here.size());
      if (!file_.trouble().empty()) throw ArchiveDamage(file_.trouble());
      if (last != kEndFlag) throw ArchiveDamage("the file ends early");
      return;
    }
    file_.skip(kWindow - 2 * kLongestHeader);
    from = 0;
  }
}

}  // namespace ariadne::io
