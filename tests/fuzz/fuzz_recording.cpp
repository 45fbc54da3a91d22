// Recordings from strangers: parsed or refused, and what parses is written and parsed again alike.
#include <cstdlib>

#include "bozzetto/base/error.hpp"
#include "bozzetto/sculptor/recording.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bozzetto;
  std::string text;
  try {
    text = toText(parseRecording({reinterpret_cast<const char*>(data), size}, "fuzz"));
  } catch (const Error&) {
    return 0;
  }
  if (toText(parseRecording(text, "again")) != text) std::abort();
  return 0;
}
