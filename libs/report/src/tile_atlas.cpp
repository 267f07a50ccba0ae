#include "tile_atlas.h"

#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "ariadne/io/png.h"

namespace ariadne::report {

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  // The iterators read on to whole groups; let there be something to read.
  std::string whole = bytes;
  whole.append((3 - bytes.size() % 3) % 3, '\0');
  std::string text(Digits(whole.cbegin()), Digits(whole.cend()));
  const std::size_t padding = whole.size() - bytes.size();
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

std::vector<std::string> tilePictures(const std::vector<ReplayTile>& tiles) {
  std::vector<std::string> pictures;
  for (std::size_t first = 0; first < tiles.size(); first += kTilesPerPicture) {
    const std::size_t n = std::min(kTilesPerPicture, tiles.size() - first);
    io::Picture picture;
    picture.width = kReplayTile * kReplayTile;
    picture.height = static_cast<std::uint32_t>(n);
    picture.format = io::Picture::Format::two_bit_gray;
    picture.pixels = tiles[first].data();
    picture.stride = sizeof(ReplayTile);
    pictures.push_back("data:image/png;base64," + base64(io::encodePng(picture)));
  }
  return pictures;
}

}  // namespace ariadne::report
