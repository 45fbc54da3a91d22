// Grey pictures from PNG files. libpng's errors come as exceptions through a callback.
#include <png.h>

#include <algorithm>
#include <cstring>

#include "bozzetto/base/file.hpp"
#include "bozzetto/io/grey_image.hpp"

namespace bozzetto {
namespace {

constexpr png_uint_32 kLargestSide = 4096;
constexpr std::size_t kLargestFile = std::size_t{256} << 20;

[[noreturn]] void onError(png_structp png, png_const_charp text) {
  throw Error(*static_cast<const std::string*>(png_get_error_ptr(png)) + ": " + text);
}
void onWarning(png_structp, png_const_charp) {}

struct Reader {
  std::string name;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &name, onError, onWarning);
  png_infop info = png_create_info_struct(png);
  explicit Reader(std::string title) : name(std::move(title)) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void takeBytes(png_structp png, png_bytep data, png_size_t count) {
  const auto part = static_cast<ByteReader*>(png_get_io_ptr(png))->take(count);
  std::memcpy(data, part.data(), count);
}

// Whatever the file holds comes out as 16 bits of red, green, blue and opacity.
void expand(Reader& reader) {
  png_set_expand(reader.png);
  png_set_expand_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 0xffff, PNG_FILLER_AFTER);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
}

// Rec. 709 luminance of the file's own numbers, × opacity.
float greyOf(const png_byte* pixel) {
  const auto channel = [&](int n) {
    return static_cast<float>(pixel[2 * n] << 8 | pixel[2 * n + 1]) / 65535.0f;
  };
  return (0.2126f * channel(0) + 0.7152f * channel(1) + 0.0722f * channel(2)) * channel(3);
}

}  // namespace

GreyImage readGreyPng(const std::filesystem::path& path) {
  const Bytes bytes = readFile(path, kLargestFile);
  ByteReader in(bytes, path.native());
  Reader reader(path.string());
  png_set_read_fn(reader.png, &in, takeBytes);
  png_set_user_limits(reader.png, kLargestSide, kLargestSide);
  png_set_chunk_malloc_max(reader.png, 1 << 24);
  png_read_info(reader.png, reader.info);
  GreyImage image;
  image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  expand(reader);
  const std::size_t row = png_get_rowbytes(reader.png, reader.info);
  const auto rows = static_cast<std::size_t>(image.height);
  std::vector<png_byte> pixels(row * rows);
  std::vector<png_bytep> starts(rows);
  for (std::size_t y = 0; y < rows; ++y) starts[y] = pixels.data() + y * row;
  png_read_image(reader.png, starts.data());
  image.grey.reserve(rows * static_cast<std::size_t>(image.width));
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x)
      image.grey.push_back(greyOf(starts[y] + 8 * x));
  return image;
}

}  // namespace bozzetto
