#include "ariadne/cluster/slices.h"

#include <fmt/format.h>

namespace ariadne::cluster {

std::vector<std::size_t> openSlices(const batch::Plan& plan, const batch::Store& store,
                                    std::size_t slices, const std::vector<Slice>& active,
                                    const std::set<std::string>& again) {
  const auto runs = batch::distinctRuns(plan);
  std::vector<bool> covered(runs.size(), false);
  for (const Slice& s : active)
    for (std::size_t i = s.slice - 1; i < runs.size(); i += s.slices)
      if (s.waits || again.count(runs[i]->key) == 0) covered[i] = true;
  std::vector<bool> open(slices, false);
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!covered[i] && !open[i % slices] && !store.has(runs[i]->key)) open[i % slices] = true;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < slices; ++i)
    if (open[i]) numbers.push_back(i + 1);
  return numbers;
}

std::string rangesText(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += fmt::format("{}{}", i == 0 ? "" : ",", numbers[i]);
    if (last > i) text += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace ariadne::cluster
