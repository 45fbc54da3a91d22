// How the clay is shown: values the view panels change.
#pragma once
#include <string>

#include "bozzetto/render/ladder.hpp"
#include "bozzetto/render/look.hpp"
#include "bozzetto/render/overlays.hpp"
#include "bozzetto/render/stereo.hpp"
#include "bozzetto/render/structure.hpp"
#include "bozzetto/scene/view.hpp"

namespace bozzetto::ui {

/// Places in world units.
struct Reference {
  ReferencePicture picture;
  std::string from;  ///< the file
};

struct ViewOptions {
  Look look;
  std::string matcapFrom;  ///< the file of look.matcapImage
  Stereo stereo;
  Structure structure = Structure::surface;
  bool smoothed = false;  ///< a smoothed copy of the clay is looked at
  ToolDisplay tool = ToolDisplay::transparent;
  bool ring = true;
  bool limit = false;  ///< of influence, around the tool's body
  bool grid = false;
  std::optional<Quality> quality;  ///< none: as the frames' times say

  std::vector<Reference> references;

  bool box = false;
  std::optional<WorkspaceBox> boxSize;  ///< none: around the clay
};

}  // namespace bozzetto::ui
