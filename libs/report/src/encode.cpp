#include "encode.h"

#include "ariadne/io/png.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::report {

void writePng(const std::filesystem::path& file, const Surface& surface) {
  cairo_surface_flush(surface.get());
  io::Picture picture;
  picture.width = static_cast<std::uint32_t>(cairo_image_surface_get_width(surface.get()));
  picture.height = static_cast<std::uint32_t>(cairo_image_surface_get_height(surface.get()));
  picture.format = io::Picture::Format::cairo_rgb;
  picture.pixels = cairo_image_surface_get_data(surface.get());
  picture.stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  io::writeWhole(file, io::encodePng(picture));
}

}  // namespace ariadne::report
