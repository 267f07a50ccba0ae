#include "topic_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ariadne::io::ros {

std::string listOf(const std::vector<std::string>& texts, std::size_t most) {
  if (texts.empty()) return "nothing";
  const auto end = texts.begin() + static_cast<std::ptrdiff_t>(std::min(most, texts.size()));
  std::string list = fmt::format("{}", fmt::join(texts.begin(), end, ", "));
  if (texts.size() > most) list += fmt::format(" and {} more", texts.size() - most);
  return list;
}

std::string listOfTopics(const Survey& survey, const std::function<bool(MessageKind)>& wanted) {
  std::vector<std::string> list;
  for (const auto& [name, info] : survey.topics)
    if (!wanted || wanted(kindOf(info.type)))
      list.push_back(fmt::format("{} {} ({})", name, info.type, info.messages));
  return listOf(list);
}

std::string topicName(const std::string& given) {
  return given.empty() || given[0] == '/' ? given : "/" + given;
}

std::string frameName(const std::string& given) {
  return !given.empty() && given[0] == '/' ? given.substr(1) : given;
}

}  // namespace ariadne::io::ros
