// The small parts of a scene as bytes, and back; written down in NOTES.md. Decoders throw Error for
// anything encoders would not write; `name` opens the text.
#pragma once
#include <span>
#include <string>

#include "bozzetto/scene/document.hpp"

namespace bozzetto {

/// Scale, identity and settings.
struct SceneHead {
  FieldScale scale;
  SceneIdentity identity;
  std::map<std::string, std::string> settings;
};

Bytes encodeHead(const SceneHead& head);
SceneHead decodeHead(std::span<const std::byte> bytes, const std::string& name);

Bytes encodeView(const View& view);
View decodeView(std::span<const std::byte> bytes, const std::string& name);

Bytes encodeItem(const ShelfItem& item);
ShelfItem decodeItem(std::span<const std::byte> bytes, const std::string& name);

/// Empty, or bytes that begin as a PNG does and are no more than 16 MiB.
Bytes checkedThumbnail(std::span<const std::byte> bytes, const std::string& name);

}  // namespace bozzetto
