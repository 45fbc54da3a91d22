#include "history/compression.hpp"

#include <zstd.h>

#include <memory>

namespace bozzetto::undo {
namespace {

struct Free {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

Bytes compressed(std::span<const std::byte> raw, int level) {
  static thread_local const std::unique_ptr<ZSTD_CCtx, Free> context(ZSTD_createCCtx());
  Bytes frame(ZSTD_compressBound(raw.size()));
  const std::size_t size =
      ZSTD_compressCCtx(context.get(), frame.data(), frame.size(), raw.data(), raw.size(), level);
  if (ZSTD_isError(size)) throw Error(std::string("zstd: ") + ZSTD_getErrorName(size));
  frame.resize(size);
  return frame;
}

Bytes decompressed(std::span<const std::byte> frame, std::size_t rawBytes,
                   const std::string& name) {
  static thread_local const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != rawBytes ||
      ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size()) {
    throw Error(name + ": not one zstd frame of " + std::to_string(rawBytes) + " bytes");
  }
  Bytes raw(rawBytes);
  const std::size_t got =
      ZSTD_decompressDCtx(context.get(), raw.data(), raw.size(), frame.data(), frame.size());
  if (got != rawBytes) throw Error(name + ": zstd frame does not decompress");
  return raw;
}

}  // namespace bozzetto::undo
