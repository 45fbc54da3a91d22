// libpng stops here. Its errors come as long jumps or, as used here, as exceptions through a
// callback; its memory belongs to two small owners.
#include "bozzetto/render/png.hpp"

#include <png.h>

#include <algorithm>
#include <string>

#include "bozzetto/base/file.hpp"

namespace bozzetto {
namespace {

constexpr png_uint_32 kLargestSide = 16384;

[[noreturn]] void onError(png_structp png, png_const_charp text) {
  throw Error(*static_cast<const std::string*>(png_get_error_ptr(png)) + ": " + text);
}
void onWarning(png_structp, png_const_charp) {}

struct Writer {
  std::string name = "PNG";
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &name, onError, onWarning);
  png_infop info = png_create_info_struct(png);
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

struct Reader {
  std::string name;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &name, onError, onWarning);
  png_infop info = png_create_info_struct(png);
  explicit Reader(std::string_view title) : name(title) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void appendBytes(png_structp png, png_bytep data, png_size_t count) {
  static_cast<ByteWriter*>(png_get_io_ptr(png))->put(std::as_bytes(std::span(data, count)));
}

void takeBytes(png_structp png, png_bytep data, png_size_t count) {
  const auto part = static_cast<ByteReader*>(png_get_io_ptr(png))->take(count);
  std::transform(part.begin(), part.end(), data, [](std::byte b) { return png_byte(b); });
}

std::vector<png_byte> rowOf(const Image& image, int y, bool opaque) {
  std::vector<png_byte> row;
  row.reserve(std::size_t(image.width) * 4);
  for (int x = 0; x < image.width; ++x) {
    const Image::Pixel& pixel = image.at(x, y);
    row.insert(row.end(), pixel.begin(), pixel.end() - (opaque ? 1 : 0));
  }
  return row;
}

// Whatever the file holds comes out as 8 bits of red, green, blue and opacity.
void expandToRgba(Reader& reader) {
  png_set_expand(reader.png);
  png_set_strip_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
}

}  // namespace

Bytes encodePng(const Image& image, PngEffort effort) {
  if (image.pixels.empty()) throw Error("PNG: empty image");
  const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(),
                                  [](const Image::Pixel& p) { return p[3] == 255; });
  ByteWriter out;
  Writer writer;
  png_set_write_fn(writer.png, &out, appendBytes, nullptr);
  const bool small = effort == PngEffort::small;
  png_set_compression_level(writer.png, small ? 9 : 3);
  png_set_filter(writer.png, 0, small ? PNG_ALL_FILTERS : PNG_FILTER_SUB);
  png_set_IHDR(writer.png, writer.info, png_uint_32(image.width), png_uint_32(image.height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(writer.png, writer.info);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(writer.png, rowOf(image, y, opaque).data());
  }
  png_write_end(writer.png, writer.info);
  return out.take();
}

Image decodePng(std::span<const std::byte> bytes, std::string_view name) {
  ByteReader in(bytes, name);
  Reader reader(name);
  png_set_read_fn(reader.png, &in, takeBytes);
  png_set_user_limits(reader.png, kLargestSide, kLargestSide);
  png_read_info(reader.png, reader.info);
  expandToRgba(reader);
  // A row cannot be smaller than a thousandth of itself in the file: no huge image from few bytes.
  const auto width = png_get_image_width(reader.png, reader.info);
  const auto height = png_get_image_height(reader.png, reader.info);
  if (std::size_t{width} * height / 8 > bytes.size() * 1100) {
    throw Error(std::string(name) + ": " + std::to_string(bytes.size()) + " bytes cannot hold " +
                std::to_string(width) + " x " + std::to_string(height) + " pixels");
  }
  Image image(static_cast<int>(width), static_cast<int>(height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < image.height; ++y) rows.push_back(image.at(0, y).data());
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, nullptr);
  return image;
}

void writePng(const std::filesystem::path& path, const Image& image) {
  writeFile(path, encodePng(image));
}

Image readPng(const std::filesystem::path& path) {
  return decodePng(readFile(path), path.string());
}

}  // namespace bozzetto
