// The world's mistakes: files, recordings, arguments. Our own mistakes are assertions.
#pragma once
#include <stdexcept>
#include <string>

namespace bozzetto {

/// Thrown at io, scene, history and recording boundaries. The text names the file, the position,
/// what was found and what was expected, on one line; the command line prints it as it is.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown out of a long job whose Progress was asked to stop. Nothing of the job remains.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace bozzetto
